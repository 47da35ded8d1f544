#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/equations.hpp"
#include "solvers/extraction.hpp"
#include "solvers/field_arguments.hpp"
#include "solvers/form.hpp"
#include "solvers/linear_solver.hpp"

namespace rfm {

struct NewtonOptions {
  int largest_iteration_count = 30;
  /// Relative size of a full step below which the solution is found: the error after it is about
  /// its square.
  double tolerance = 1e-9;
  /// Steps are halved until the residual falls; below this part of a step none is found.
  double smallest_damping = 1.0 / 1024;
  /// On the way from the start to the solution, the residual R is brought down in so many equal
  /// parts, R(u) = (1 − s) R(u₀) with s = 1/n, 2/n, …, 1: steps of the load where u₀ = 0.
  int load_steps = 1;
  /// Of collocation: the forms are linear by their values (solvers/linearity.hpp), so that one step
  /// is the solution if the residuals behind it are those that the step foretells.
  bool looks_linear = false;
  /// Of forms: extended or periodic splines, in which the solution is looked for; it must outlive
  /// the call.
  const SplineExtraction* extraction = nullptr;
  /// Of forms: the rule with more points, by which `Kernel` tells errors of quadrature from what
  /// holds a function softly.
  std::function<DomainRule()> finer_rule{};
};

/// One step of Newton's method.
struct NewtonIteration {
  /// ‖S R‖ before the step, S the scaling of the first tangent (the reciprocal square root of its
  /// diagonal): of an energy, about the error in its norm.
  double residual = 0;
  double step = 0;          ///< ‖S⁻¹ δ‖ / ‖S⁻¹ c‖ of the full step δ
  double damping = 1;       ///< the part of it that was taken
  bool indefinite = false;  ///< the Hessian of an energy was not positive definite
};

struct NewtonSolution {
  LinearSolution linear;  ///< of the last step, with the coefficients of the solution
  std::vector<NewtonIteration> iterations;
  /// Of collocation: what the equations leave free, as weights of the candidates by column. It has
  /// no part in the solution but for a few coefficients held at zero.
  Eigen::MatrixXd free{};
  /// Of collocation: the residuals that are left, as a part of those at the start.
  double remainder = 0;
  /// The order of convergence that the last three full steps show, log(s₃/s₂) / log(s₂/s₁), where
  /// there are three above rounding: 2 for Newton's method.
  std::optional<double> order() const;
};

/// Equations R(c) = 0, as their linearisation at any c.
struct NewtonEquations {
  /// The tangent, and minus the residual, at c.
  std::function<LinearSystem(const Eigen::VectorXd&)> at;
  /// The same where what the tangent does not count (`held`, solvers/form_symbols.hpp) stays as at
  /// the second state: along a step, residuals fall there only. Empty where nothing is held.
  std::function<LinearSystem(const Eigen::VectorXd&, const Eigen::VectorXd&)> beside{};
  /// The same with a rule of more points, for `Kernel`; may be empty.
  std::function<LinearSystem(const Eigen::VectorXd&)> finer{};
  /// What the equations may leave free, as columns of coefficients: candidates of `Kernel`.
  Eigen::MatrixXd candidates{};
  /// Minus the residual where the whole solution is zero, of the size of the loads; empty if it is
  /// not known. What is 10⁻¹² of it is rounding, at the start, too: a start that is the solution
  /// already has no coefficients by which to judge a step.
  Eigen::VectorXd loads{};
};

/// Those of a bundle at a time. `finer_rule` is that of `NewtonOptions`. The bundle must outlive
/// them.
NewtonEquations newton_equations(const Equations& equations, const FieldArguments& arguments = {},
                                 const std::function<DomainRule()>& finer_rule = {});

/// Newton's method from `start`, as that for forms below.
NewtonSolution solve_newton(const NewtonEquations& equations, const Eigen::VectorXd& start,
                            const LinearSolverOptions& linear_options = {},
                            const NewtonOptions& options = {});

/// Newton's method for the equations of `forms`: at each state their tangent and residual are
/// assembled, the linear system solved, and the step shortened until the residual falls. Starts at
/// `start`, or where all undetermined functions are zero. Quadratic where tangents are exact (all
/// but least squares with residuals that do not vanish) and the solution is regular.
/// Throws `ComputationError` when it does not converge, with the reason: a tangent that is
/// singular, a Hessian that is indefinite, values that are not numbers with their place, or a
/// residual that falls no further.
NewtonSolution solve_newton(std::span<const Structure> structures,
                            std::span<const TensorProductSpace> spaces, std::span<const Form> forms,
                            const DomainRule& rule, const LinearSolverOptions& linear_options = {},
                            const NewtonOptions& options = {},
                            const std::optional<Eigen::VectorXd>& start = {},
                            const FieldArguments& arguments = {});

}  // namespace rfm
