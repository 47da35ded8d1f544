#include "solvers/collocation.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/tape.hpp"
#include "solvers/basis_values.hpp"
#include "solvers/cell_points.hpp"
#include "solvers/equations.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/linear_solver.hpp"
#include "solvers/solution.hpp"
#include "solvers/sparse_qr.hpp"

namespace rfm {
namespace {

using Place = Contribution::Place;
using Triplets = std::vector<Eigen::Triplet<double, std::int64_t>>;

// The rows of one residual of a form.
class ResidualRows {
 public:
  ResidualRows(const Form& form, const Form::ResidualRow& residual,
               std::span<const Structure> changes, std::span<const TensorProductSpace> spaces,
               const DomainRule& rule, const CollocationPoints* own)
      : place_(form.place()),
        own_(own),
        spaces_(spaces),
        rule_(rule),
        index_(rule),
        integrand_(contribution(form, residual), changes, rule.dimension()),
        basis_(spaces, integrand_.basis_derivatives()),
        value_({residual.value}, {0}, rule.dimension()),
        workspace_(value_) {
    for (const TensorProductSpace& space : spaces)
      offsets_.push_back(offsets_.back() + space.size());
  }

  void add(Triplets& entries, std::vector<double>& right_hand_side) {
    const Grid& grid = rule_.grid();
    for (int cell = 0; cell < grid.cell_count(); ++cell) {
      points_.clear();
      if (place_.place != Place::volume)
        index_.add_surface(place_.place, index_.surface_range(place_.place, cell), place_.numbers,
                           points_);
      else if (own_)
        add_own(cell);
      else if (rule_.state(cell) == CellState::inside)
        index_.add_inside(cell, points_);
      else if (rule_.state(cell) == CellState::cut)
        index_.add_cut(index_.cut_range(cell), points_);
      if (points_.size() > 0) add_cell(cell, entries, right_hand_side);
    }
  }

 private:
  static Contribution contribution(const Form& form, const Form::ResidualRow& residual) {
    Contribution part;
    part.place = form.place().place;
    part.numbers = form.place().numbers;
    part.where = form.place().where;
    for (const auto& [slot, slope] : residual.slopes) part.energy.add_load(slot, slope);
    return part;
  }

  void add_own(int cell) {
    for (int i = own_->begin[cell]; i < own_->begin[cell + 1]; ++i) {
      for (int axis = 0; axis < rule_.dimension(); ++axis)
        points_.coordinates[axis].push_back(own_->points.coordinates[axis][i]);
      points_.weights.push_back(own_->points.weights[i]);
    }
  }

  void add_cell(int cell, Triplets& entries, std::vector<double>& right_hand_side) {
    const int count = points_.size();
    for (double& weight : points_.weights) weight = std::sqrt(std::max(weight, 0.0));
    IntegrandValues values(integrand_, count);
    values.evaluate(points_, 0, {});
    basis_.evaluate(cell, points_, 0, count);
    const std::int64_t first_row = static_cast<std::int64_t>(right_hand_side.size());
    add_values(right_hand_side);
    for (int k = 0; k < static_cast<int>(spaces_.size()); ++k) {
      const TensorProductSpace& space = spaces_[k];
      functions_.resize(space.functions_per_cell());
      space.cell_functions(cell, functions_);
      for (int q = 0; q < count; ++q)
        for (int f = 0; f < static_cast<int>(functions_.size()); ++f) {
          if (functions_[f] < 0) continue;
          double sum = 0;
          for (int m = 0; m < static_cast<int>(integrand_.basis_derivatives().size()); ++m)
            if (integrand_.basis_derivatives()[m].unknown == k)
              sum += values.load(m)[q] * basis_.values(m)[f + q * basis_.padded_functions(k)];
          if (sum != 0) entries.emplace_back(first_row + q, offsets_[k] + functions_[f], sum);
        }
    }
  }

  // Minus the residual; weights are those of points that count.
  void add_values(std::vector<double>& right_hand_side) {
    for (int first = 0; first < points_.size(); first += Tape::block_size) {
      PointBlock block;
      block.count = std::min(Tape::block_size, points_.size() - first);
      for (int axis = 0; axis < rule_.dimension(); ++axis)
        block.coordinates[axis] = points_.coordinates[axis].data() + first;
      value_.evaluate(block, workspace_);
      for (int q = 0; q < block.count; ++q) {
        const double weight = points_.weights[first + q];
        const double value = weight > 0 ? weight * workspace_.coefficient(0)[q] : 0;
        if (!std::isfinite(value))
          throw ComputationError(
              fmt::format("a residual is not a number at the point ({:.6g}, {:.6g}, {:.6g})",
                          points_.coordinates[0][first + q],
                          rule_.dimension() > 1 ? points_.coordinates[1][first + q] : 0,
                          rule_.dimension() > 2 ? points_.coordinates[2][first + q] : 0));
        right_hand_side.push_back(-value);
      }
    }
  }

  FormPlace place_;
  const CollocationPoints* own_;
  std::span<const TensorProductSpace> spaces_;
  const DomainRule& rule_;
  CellPointIndex index_;
  CompiledIntegrand integrand_;
  BasisValues basis_;
  Tape value_;
  Tape::Workspace workspace_;
  IntegrandPoints points_;
  std::vector<int> functions_;
  std::vector<int> offsets_{0};
};

}  // namespace

CollocationSystem collocate(std::span<const Form> forms, std::span<const Field> components,
                            std::span<const Structure> changes,
                            std::span<const TensorProductSpace> spaces, const DomainRule& rule,
                            std::span<const CollocationPoints> volume) {
  Triplets entries;
  std::vector<double> right_hand_side;
  std::size_t next = 0;
  for (const Form& form : forms)
    for (const Form::ResidualRow& residual : form.residual_rows(components)) {
      const CollocationPoints* own = nullptr;
      if (form.place().place == Place::volume && !volume.empty())
        own = &volume[std::min(next++, volume.size() - 1)];
      ResidualRows(form, residual, changes, spaces, rule, own).add(entries, right_hand_side);
    }
  Eigen::Index columns = 0;
  for (const TensorProductSpace& space : spaces) columns += space.size();
  CollocationSystem system;
  system.right_hand_side = Eigen::Map<const Eigen::VectorXd>(
      right_hand_side.data(), static_cast<Eigen::Index>(right_hand_side.size()));
  system.matrix.resize(system.right_hand_side.size(), columns);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

namespace {

// The lengths of the columns of a matrix.
Eigen::VectorXd lengths_of(const SparseMatrix& matrix) {
  Eigen::VectorXd lengths(matrix.cols());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    lengths[column] = matrix.col(column).norm();
  return lengths;
}

// To which residuals behind a step are foretold by it where they are linear.
constexpr double linear_precision = 1e-9;

// Combinations of the candidates C on which a matrix with columns of length 1 vanishes.
class UnseenFunctions {
 public:
  UnseenFunctions(const SparseMatrix& matrix, const Eigen::MatrixXd& candidates)
      : weights_(candidates.cols(), 0) {
    if (candidates.cols() == 0) return;
    const Eigen::VectorXd lengths = lengths_of(matrix);
    const Eigen::HouseholderQR<Eigen::MatrixXd> factors(lengths.asDiagonal() * candidates);
    // C B has orthonormal columns in units of the lengths.
    const Eigen::Index count = candidates.cols();
    const Eigen::MatrixXd back =
        factors.matrixQR().topRows(count).triangularView<Eigen::Upper>().solve(
            Eigen::MatrixXd::Identity(count, count));
    if (!back.allFinite()) return;
    const Eigen::JacobiSVD<Eigen::MatrixXd> parts(matrix * (candidates * back),
                                                  Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::Index unseen = (parts.singularValues().array() < nothing).count();
    weights_ = back * parts.matrixV().rightCols(unseen);
    pin(lengths.asDiagonal() * (candidates * weights_), lengths);
  }

  const Eigen::MatrixXd& weights() const { return weights_; }

  // With the equations that hold them.
  CollocationSystem held(CollocationSystem system) const {
    const Eigen::Index rows = system.matrix.rows(), more = weights_.cols();
    if (more == 0) return system;
    Triplets entries;
    for (Eigen::Index column = 0; column < system.matrix.cols(); ++column)
      for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry)
        entries.emplace_back(entry.row(), column, entry.value());
    for (Eigen::Index k = 0; k < more; ++k)
      entries.emplace_back(rows + k, pinned_[k].first, pinned_[k].second);
    system.matrix.resize(rows + more, system.matrix.cols());
    system.matrix.setFromTriplets(entries.begin(), entries.end());
    system.right_hand_side.conservativeResize(rows + more);
    system.right_hand_side.tail(more).setZero();
    return system;
  }

 private:
  // Lengths of A y / y that are rounding.
  static constexpr double nothing = 1e-11;

  // The largest entry that is left, in turn.
  void pin(Eigen::MatrixXd functions, const Eigen::VectorXd& lengths) {
    for (Eigen::Index k = 0; k < functions.cols(); ++k) {
      Eigen::Index row = 0, column = 0;
      functions.cwiseAbs().maxCoeff(&row, &column);
      pinned_.emplace_back(row, lengths[row]);
      const Eigen::VectorXd pivot = functions.col(column) / functions(row, column);
      const Eigen::RowVectorXd shares = functions.row(row);
      functions -= pivot * shares;
    }
  }

  Eigen::MatrixXd weights_;
  std::vector<std::pair<Eigen::Index, double>> pinned_;
};

// The step, and how it was found.
Eigen::VectorXd full_step(const CollocationSystem& system, LinearSolution& report) {
  if (system.matrix.rows() == system.matrix.cols()) {
    LinearSystem square;
    square.symmetric = false;
    square.matrix = system.matrix;
    square.right_hand_side = system.right_hand_side;
    report = rfm::solve(square);
    return report.coefficients;
  }
  report.method = LinearSolution::Method::qr;
  LeastSquaresSolution least = least_squares_solution(system.matrix, system.right_hand_side);
  report.smallest_eigenvalue = least.smallest_singular_value;
  return std::move(least.solution);
}

// Of residuals of the size of the loads, what is rounding.
constexpr double rounding = 1e-12;
// In the region of quadratic convergence.
constexpr double small_step = 1e-6;

}  // namespace

double residual_load(std::span<const Form> forms, std::span<const Structure> structures,
                     std::span<const TensorProductSpace> spaces, const DomainRule& rule,
                     std::span<const CollocationPoints> volume) {
  const bool has_data = std::ranges::any_of(structures, [](const Structure& structure) {
    return !structure.inhomogeneous().is_constant(0);
  });
  if (!has_data || std::ranges::all_of(forms, &Form::is_linear)) return 0;
  std::vector<Structure> changes;
  for (const Structure& structure : structures) changes.push_back(homogeneous_part(structure));
  try {
    return collocate(forms, std::vector<Field>(structures.size(), 0.0), changes, spaces, rule,
                     volume)
        .right_hand_side.norm();
  } catch (const ComputationError&) {  // not defined there, as a logarithm
    return 0;
  }
}

NewtonSolution solve_residuals(const ResidualProblem& problem, const NewtonOptions& options) {
  NewtonSolution solution;
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(problem.size);
  CollocationSystem system = problem.at(unknowns);
  const Eigen::VectorXd lengths = lengths_of(system.matrix);
  const auto size_of = [&](const Eigen::VectorXd& change) {
    return lengths.cwiseProduct(change).norm();
  };
  for (int i = 0; i < options.largest_iteration_count; ++i) {
    NewtonIteration& iteration = solution.iterations.emplace_back();
    iteration.residual = system.right_hand_side.norm();
    const UnseenFunctions unseen(system.matrix, problem.candidates);
    solution.free = unseen.weights();
    const Eigen::VectorXd step = full_step(unseen.held(system), solution.linear);
    const double load = std::max(problem.load, solution.iterations[0].residual);
    if (load > 0)
      solution.remainder = (system.right_hand_side - system.matrix * step).norm() / load;
    if (!problem.is_linear && iteration.residual <= rounding * problem.load) {
      solution.linear.coefficients = unknowns;
      return solution;
    }
    if (i == 0 && options.looks_linear && !problem.is_linear) {
      const Eigen::VectorXd foretold = system.right_hand_side - system.matrix * step;
      const double departure = (problem.at(step).right_hand_side - foretold).norm();
      if (departure <= linear_precision * iteration.residual) {
        solution.iterations.clear();
        solution.linear.coefficients = step;
        return solution;
      }
    }
    const double whole = size_of(unknowns + step);
    iteration.step = whole > 0 ? size_of(step) / whole : 0;
    if (problem.is_linear || iteration.step <= options.tolerance) {
      if (problem.is_linear) solution.iterations.clear();
      solution.linear.coefficients = unknowns + step;
      return solution;
    }
    for (;; iteration.damping /= 2) {
      if (iteration.damping < options.smallest_damping) {
        if (iteration.step < small_step) {  // and what there is of it, is rounding
          solution.linear.coefficients = unknowns;
          return solution;
        }
        throw ComputationError(
            "Gauss's and Newton's method does not converge: the residuals fall "
            "no further along the step");
      }
      const Eigen::VectorXd next = unknowns + iteration.damping * step;
      system = problem.at(next);
      if (system.right_hand_side.norm() <= iteration.residual * (1 + 1e-10)) {
        unknowns = next;
        break;
      }
    }
  }
  throw ComputationError(
      fmt::format("Gauss's and Newton's method does not converge: no solution after {} steps",
                  solution.iterations.size()));
}

NewtonSolution solve_collocation(std::span<const Structure> structures,
                                 std::span<const TensorProductSpace> spaces,
                                 std::span<const Form> forms, const DomainRule& rule,
                                 const NewtonOptions& options) {
  std::vector<Structure> changes;
  for (const Structure& structure : structures) changes.push_back(homogeneous_part(structure));
  ResidualProblem problem;
  problem.is_linear = std::ranges::all_of(forms, &Form::is_linear);
  for (const TensorProductSpace& space : spaces) problem.size += space.size();
  problem.at = [&](const Eigen::VectorXd& coefficients) {
    return collocate(forms, solution_fields(structures, spaces, coefficients), changes, spaces,
                     rule);
  };
  problem.load = residual_load(forms, structures, spaces, rule);
  problem.candidates = FreeFunctions(structures, spaces).coefficients();
  return solve_residuals(problem, options);
}

}  // namespace rfm
