#include "solvers/newton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.hpp"
#include "solvers/equilibration.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/kernel.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

using Vector = Eigen::VectorXd;

// Steps and residuals smaller than this, relatively, are as much rounding as convergence.
constexpr double rounding = 1e-12;
// From here on a step is in the region of quadratic convergence, and residuals near rounding need
// not fall any more.
constexpr double small_step = 1e-6;

class Newton {
 public:
  Newton(const NewtonEquations& equations, const LinearSolverOptions& linear_options,
         const NewtonOptions& options)
      : equations_(equations), linear_options_(linear_options), options_(options) {}

  NewtonSolution solve(const Vector& start) {
    coefficients_ = start;
    system_ = equations_.at(coefficients_);
    set_scale();
    require_tangent();
    const Vector first_residual = system_.right_hand_side;
    loads_ = equations_.loads.size() > 0 && norm_of(equations_.loads) > norm_of(first_residual)
                 ? equations_.loads
                 : first_residual;
    for (int step = 1; step <= options_.load_steps; ++step) {
      remaining_ = (1 - double(step) / options_.load_steps) * first_residual;
      iterate();
    }
    require_balance();
    solution_.linear.coefficients = coefficients_;
    return std::move(solution_);
  }

 private:
  void set_scale() {
    if (system_.symmetric) {
      row_scale_ = column_scale_ = DiagonalScaling(system_.matrix).factors;
      return;
    }
    const Equilibration scaling(system_.matrix);
    row_scale_ = scaling.rows;
    column_scale_ = scaling.columns;
  }

  // Functions that the tangent leaves out are not moved, and their equations would not be looked
  // at: a start where the whole tangent vanishes, as of |∇u|⁴ at u = 0, would pass for a solution.
  void require_tangent() const {
    const LinearSystem system = beside_kernel(system_);
    const SparseMatrix& matrix = system.matrix;
    std::vector<bool> is_empty(static_cast<std::size_t>(matrix.rows()), true);
    for (Eigen::Index outer = 0; outer < matrix.outerSize(); ++outer)
      for (SparseMatrix::InnerIterator entry(matrix, outer); entry; ++entry)
        if (entry.value() != 0)
          is_empty[static_cast<std::size_t>(entry.row())] =
              is_empty[static_cast<std::size_t>(entry.col())] = false;
    if (is_empty.empty()) return;
    const double largest = system.right_hand_side.cwiseAbs().maxCoeff();
    bool vanishes = std::ranges::all_of(is_empty, [](bool empty) { return empty; });
    for (Eigen::Index row = 0; row < matrix.rows(); ++row)
      vanishes |= is_empty[static_cast<std::size_t>(row)] &&
                  std::fabs(system.right_hand_side[row]) > rounding * largest;
    if (vanishes)
      fail(
          "the tangent vanishes at the start, where the equations are not satisfied: it shows no "
          "way to go");
  }

  double norm_of(const Vector& residual) const { return row_scale_.cwiseProduct(residual).norm(); }

  double residual_of(const LinearSystem& system) const {
    return row_scale_.cwiseProduct(system.right_hand_side - remaining_).norm();
  }

  double size_of(const Vector& coefficients) const {
    double sum = 0;
    for (Eigen::Index i = 0; i < coefficients.size(); ++i)
      if (column_scale_[i] > 0) sum += std::pow(coefficients[i] / column_scale_[i], 2);
    return std::sqrt(sum);
  }

  void iterate() {
    const std::size_t first = solution_.iterations.size();
    double largest_residual =
        equations_.loads.size() > 0 ? row_scale_.cwiseProduct(equations_.loads).norm() : 0;
    for (int i = 0; i < options_.largest_iteration_count; ++i) {
      NewtonIteration& iteration = solution_.iterations.emplace_back();
      iteration.residual = residual_of(system_);
      largest_residual = std::max(largest_residual, iteration.residual);
      // Of functions that depend on one another coefficients never settle; their sum does.
      if (iteration.residual <= rounding * largest_residual) return;
      const Vector step = full_step(iteration);
      const double size = size_of(coefficients_ + step);
      iteration.step = size > 0 ? size_of(step) / size : 0;
      advance(step, iteration);
      if (iteration.damping == 1 && iteration.step <= options_.tolerance) return;
    }
    fail(fmt::format("no solution after {} steps", solution_.iterations.size() - first));
  }

  Vector full_step(NewtonIteration& iteration) {
    LinearSystem system = system_;
    system.right_hand_side -= remaining_;
    try {
      solution_.linear = rfm::solve(beside_kernel(std::move(system)), linear_options_);
    } catch (const ComputationError& error) {
      fail(error.what());
    }
    iteration.indefinite = solution_.linear.method == LinearSolution::Method::ldlt;
    return solution_.linear.coefficients;
  }

  // What the equations leave free is pinned.
  LinearSystem beside_kernel(LinearSystem system) const {
    if (equations_.candidates.cols() == 0) return system;
    const Kernel kernel = kernel_of(system);
    return kernel.pinned(std::move(system));
  }

  Kernel kernel_of(const LinearSystem& system) const {
    std::function<LinearSystem()> finer;
    if (equations_.finer) finer = [&] { return equations_.finer(coefficients_); };
    return Kernel(system, equations_.candidates, finer);
  }

  // Equations that were given up for what is free hold only if the loads balance.
  void require_balance() const {
    if (equations_.candidates.cols() == 0) return;
    const Kernel kernel = kernel_of(system_);
    const double missing = kernel.imbalance(system_.right_hand_side, loads_);
    if (!(missing < Kernel::largest_imbalance)) throw UnbalancedLoads(kernel.weights(), missing);
  }

  void advance(const Vector& step, NewtonIteration& iteration) {
    std::string cause;
    for (double damping = 1; damping >= options_.smallest_damping; damping /= 2) {
      const Vector next = coefficients_ + damping * step;
      try {
        LinearSystem system =
            equations_.beside ? equations_.beside(next, coefficients_) : equations_.at(next);
        const double residual = residual_of(system);
        const bool falls = residual <= (1 - 0.25 * damping) * iteration.residual ||
                           (damping == 1 && iteration.step < small_step);
        if (!falls) continue;
        iteration.damping = damping;
        coefficients_ = next;
        system_ = equations_.beside ? equations_.at(next) : std::move(system);
        return;
      } catch (const ComputationError& error) {
        cause = error.what();  // a state where the form is not defined: go less far
      }
    }
    fail(cause.empty() ? "the residual falls no further along the step" : cause);
  }

  [[noreturn]] void fail(const std::string& reason) const {
    if (!solution_.iterations.empty()) require_balance();  // residuals then fall to it at most
    std::string text = "Newton's method does not converge: " + reason;
    const bool indefinite = std::ranges::any_of(solution_.iterations, &NewtonIteration::indefinite);
    if (indefinite)
      text +=
          "; the Hessian of the energy is indefinite on the way, so that steps need not descend";
    text += " (residuals";
    const std::size_t count = solution_.iterations.size();
    for (std::size_t i = count > 6 ? count - 6 : 0; i < count; ++i)
      text += fmt::format(" {:.1e}", solution_.iterations[i].residual);
    throw ComputationError(text + "). A better start, load steps or a finer grid may help");
  }

  const NewtonEquations& equations_;
  LinearSolverOptions linear_options_;
  NewtonOptions options_;
  Vector coefficients_, row_scale_, column_scale_, remaining_, loads_;
  LinearSystem system_;
  NewtonSolution solution_;
};

}  // namespace

std::optional<double> NewtonSolution::order() const {
  std::vector<double> steps;
  for (const NewtonIteration& iteration : iterations)
    if (iteration.step > rounding) {
      if (iteration.damping < 1) steps.clear();
      if (iteration.damping == 1) steps.push_back(iteration.step);
    }
  // Small steps that fall no further are rounding, too.
  while (steps.size() > 1 && steps.back() < small_step &&
         steps.back() > 0.5 * steps[steps.size() - 2])
    steps.pop_back();
  if (steps.size() < 3) return std::nullopt;
  const double* last = steps.data() + steps.size() - 3;
  return std::log(last[2] / last[1]) / std::log(last[1] / last[0]);
}

NewtonSolution solve_newton(const NewtonEquations& equations, const Vector& start,
                            const LinearSolverOptions& linear_options,
                            const NewtonOptions& options) {
  if (options.load_steps < 1) throw InvalidArgument("there is at least one load step");
  return Newton(equations, linear_options, options).solve(start);
}

NewtonEquations newton_equations(const Equations& equations, const FieldArguments& arguments,
                                 const std::function<DomainRule()>& finer_rule) {
  NewtonEquations result;
  result.at = [&equations, arguments](const Vector& state) {
    return equations.linearized(state, arguments);
  };
  if (std::ranges::any_of(equations.terms().forms, &Form::holds_anything))
    result.beside = [&equations, arguments](const Vector& state, const Vector& held) {
      return equations.linearized(state, arguments, &held);
    };
  if (finer_rule)
    result.finer = [&equations, arguments, finer_rule,
                    finer = std::make_shared<std::optional<DomainRule>>()](const Vector& state) {
      if (!*finer) finer->emplace(finer_rule());
      return equations.with_rule(**finer).linearized(state, arguments);
    };
  const bool has_data = std::ranges::any_of(equations.structures(), [](const Structure& structure) {
    return !structure.inhomogeneous().is_constant(0);
  });
  if (has_data) try {
      result.loads = equations.loads_of_zero(arguments);
    } catch (const ComputationError&) {  // not defined there, as a logarithm
    }
  // For what equations leave free: the level of a pressure.
  result.candidates =
      equations.global_spaces().empty()
          ? FreeFunctions(equations.structures(), equations.spaces()).coefficients()
          : FreeFunctions(equations.structures(), equations.global_spaces()).coefficients();
  if (equations.extraction())
    result.candidates = equations.extraction()->reduced(result.candidates);
  return result;
}

NewtonSolution solve_newton(std::span<const Structure> structures,
                            std::span<const TensorProductSpace> spaces, std::span<const Form> forms,
                            const DomainRule& rule, const LinearSolverOptions& linear_options,
                            const NewtonOptions& options, const std::optional<Vector>& start,
                            const FieldArguments& arguments) {
  const SplineExtraction* extraction = options.extraction;
  const Equations equations(
      {structures.begin(), structures.end()}, {spaces.begin(), spaces.end()},
      {.stiffness = {}, .forms = {forms.begin(), forms.end()}}, rule,
      extraction ? std::optional<SplineExtraction>(*extraction) : std::nullopt);
  Vector first = Vector::Zero(equations.size());
  if (start) first = extraction ? Vector(extraction->reduced(*start)) : *start;
  NewtonSolution solution = solve_newton(newton_equations(equations, arguments, options.finer_rule),
                                         first, linear_options, options);
  if (extraction) solution.linear.coefficients = extraction->matrix * solution.linear.coefficients;
  return solution;
}

}  // namespace rfm
