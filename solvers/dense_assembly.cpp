#include "solvers/dense_assembly.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>

#include "core/error.hpp"
#include "quadrature/compensated_sum.hpp"
#include "solvers/cell_points.hpp"

namespace rfm {
namespace {

using Place = Contribution::Place;

constexpr int batch_points = 512;
constexpr int part_count = 8;  // sums of their own, added in order: the same for any threads

struct Sums {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right_hand_side;
  CompensatedSum constant;
};

// One integrand over a run of cells.
class DenseIntegrator {
 public:
  DenseIntegrator(const CompiledIntegrand& integrand, const GlobalSpaces& spaces,
                  const std::vector<int>& offsets, const CellPointIndex& index,
                  const DomainRule& rule, const FieldArguments& arguments, Sums& sums)
      : integrand_(integrand),
        spaces_(spaces),
        offsets_(offsets),
        index_(index),
        rule_(rule),
        arguments_(arguments),
        sums_(sums),
        values_(integrand, batch_points) {}

  void integrate(int first_cell, int last_cell) {
    for (int cell = first_cell; cell < last_cell; ++cell) add(cell);
    flush();
  }

 private:
  void add(int cell) {
    const Contribution& contribution = integrand_.contribution();
    IntegrandPoints points;
    if (contribution.place != Place::volume)
      index_.add_surface(contribution.place, index_.surface_range(contribution.place, cell),
                         contribution.numbers, points);
    else if (rule_.state(cell) == CellState::inside)
      index_.add_inside(cell, points);
    else if (rule_.state(cell) == CellState::cut)
      index_.add_cut(index_.cut_range(cell), points);
    for (int i = 0; i < points.size(); ++i) {
      if (points_.size() == batch_points) flush();
      for (int axis = 0; axis < 3; ++axis) {
        if (!points.coordinates[axis].empty())
          points_.coordinates[axis].push_back(points.coordinates[axis][i]);
        if (!points.normals[axis].empty()) points_.normals[axis].push_back(points.normals[axis][i]);
      }
      points_.weights.push_back(points.weights[i]);
    }
  }

  // M X of every slot, one row per function; w C of pairs of slots between them.
  void flush() {
    const int count = points_.size();
    if (count == 0) return;
    values_.evaluate(points_, arguments_.time, arguments_.parameters);
    using Array = Eigen::Map<const Eigen::ArrayXd>;
    std::vector<Eigen::MatrixXd> basis;
    for (const auto& [unknown, derivative] : integrand_.basis_derivatives()) {
      Eigen::MatrixXd& table = basis.emplace_back(spaces_[unknown]->size(), count);
      spaces_[unknown]->evaluate({points_.coordinates[0].data(), points_.coordinates[1].data(),
                                  points_.coordinates[2].data()},
                                 count, derivative, table.data());
    }
    std::vector<Eigen::MatrixXd> slots(integrand_.slot_count());
    for (std::size_t e = 0; e < integrand_.map().size(); ++e) {
      const auto& entry = integrand_.map()[e];
      const int unknown = integrand_.basis_derivatives()[entry.basis_derivative].unknown;
      Eigen::MatrixXd& slot = slots[entry.slot];
      if (slot.size() == 0) slot = Eigen::MatrixXd::Zero(offsets_.back(), count);
      slot.middleRows(offsets_[unknown], spaces_[unknown]->size()) +=
          basis[entry.basis_derivative] *
          Array(values_.map(static_cast<int>(e)), count).matrix().asDiagonal();
    }
    for (std::size_t e = 0; e < integrand_.stiffness().size(); ++e) {
      const int row = integrand_.stiffness()[e].row, column = integrand_.stiffness()[e].column;
      if (slots[row].size() == 0 || slots[column].size() == 0) continue;
      const Eigen::MatrixXd weighted =
          slots[row] * Array(values_.stiffness(static_cast<int>(e)), count).matrix().asDiagonal();
      sums_.matrix.noalias() += weighted * slots[column].transpose();
      if (integrand_.stiffness()[e].mirrored && row != column)
        sums_.matrix.noalias() += slots[column] * weighted.transpose();
    }
    if (values_.has_load())
      for (std::size_t m = 0; m < basis.size(); ++m) {
        const int unknown = integrand_.basis_derivatives()[m].unknown;
        sums_.right_hand_side.segment(offsets_[unknown], spaces_[unknown]->size()) +=
            basis[m] * Array(values_.load(static_cast<int>(m)), count).matrix();
      }
    sums_.constant.add(values_.constant(0, count));
    points_.clear();
  }

  const CompiledIntegrand& integrand_;
  const GlobalSpaces& spaces_;
  const std::vector<int>& offsets_;
  const CellPointIndex& index_;
  const DomainRule& rule_;
  const FieldArguments& arguments_;
  Sums& sums_;
  IntegrandValues values_;
  IntegrandPoints points_;
};

SparseMatrix lower_triangle(const Eigen::MatrixXd& full) {
  SparseMatrix lower(full.rows(), full.cols());
  lower.reserve(Eigen::VectorXi::LinSpaced(full.cols(), static_cast<int>(full.cols()), 1));
  for (Eigen::Index column = 0; column < full.cols(); ++column)
    for (Eigen::Index row = column; row < full.rows(); ++row)
      lower.insert(row, column) = 0.5 * (full(row, column) + full(column, row));
  lower.makeCompressed();
  return lower;
}

}  // namespace

LinearSystem assemble_dense(std::span<const Structure> structures, const GlobalSpaces& spaces,
                            std::span<const Contribution> contributions, const DomainRule& rule,
                            const FieldArguments& arguments) {
  std::vector<int> offsets{0};
  for (const auto& space : spaces) {
    if (!space || space->dimension() != rule.dimension())
      throw InvalidArgument("a space of functions and the rule differ in their dimensions");
    offsets.push_back(offsets.back() + space->size());
  }
  if (offsets.back() == 0)
    throw InvalidArgument("assembly needs a space for every undetermined function");
  std::vector<CompiledIntegrand> integrands;
  integrands.reserve(contributions.size());
  for (const Contribution& contribution : contributions) {
    integrands.emplace_back(contribution, structures, rule.dimension());
    for (const auto& [unknown, derivative] : integrands.back().basis_derivatives())
      if (unknown < 0 || unknown >= static_cast<int>(spaces.size()))
        throw InvalidArgument("a structure uses an undetermined function that has no space");
  }
  const CellPointIndex index(rule);
  const int cells = rule.grid().cell_count();
  std::vector<Sums> parts(part_count);
  tbb::parallel_for(0, part_count, [&](int part) {
    Sums& sums = parts[part];
    sums.matrix = Eigen::MatrixXd::Zero(offsets.back(), offsets.back());
    sums.right_hand_side = Eigen::VectorXd::Zero(offsets.back());
    const auto end_of = [&](int number) {
      return static_cast<int>(std::int64_t(cells) * number / part_count);
    };
    for (const CompiledIntegrand& integrand : integrands)
      DenseIntegrator(integrand, spaces, offsets, index, rule, arguments, sums)
          .integrate(end_of(part), end_of(part + 1));
  });
  LinearSystem system;
  system.symmetric = std::ranges::all_of(
      contributions, [](const Contribution& part) { return part.couplings.empty(); });
  CompensatedSum constant;
  constant.add(parts[0].constant.value());
  for (int part = 1; part < part_count; ++part) {
    parts[0].matrix += parts[part].matrix;
    parts[0].right_hand_side += parts[part].right_hand_side;
    constant.add(parts[part].constant.value());
  }
  system.matrix = system.symmetric ? lower_triangle(parts[0].matrix)
                                   : SparseMatrix(parts[0].matrix.sparseView());
  system.right_hand_side = std::move(parts[0].right_hand_side);
  system.constant = constant.value();
  return system;
}

}  // namespace rfm
