// Assembles and solves what scalar_problem.cpp has made ready.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "problems/flux_balance.hpp"
#include "problems/pinned_constant.hpp"
#include "problems/problem_forms.hpp"
#include "problems/residual_check.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/solution_jumps.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/assembly.hpp"
#include "solvers/energy.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/integrate.hpp"
#include "solvers/kernel.hpp"
#include "solvers/solution.hpp"

namespace rfm {
namespace {

// What a structure prescribes holds to rounding, unless functions of pieces or weights of data
// vanish where they must not.
void require_values(const std::vector<DirichletPlan>& plans, const ScalarSolution& solution) {
  double largest = 0;
  for (const DirichletPlan& plan : plans) {
    if (!plan.weakly.empty()) return;  // missed by as much as the grid is too coarse
    for (const PieceCondition& piece : plan.by_structure) {
      const Field& datum = piece.data[0];
      largest = std::max(
          largest,
          datum.is_constant()
              ? std::fabs(datum.constant())
              : maximum(datum, solution.rule, {Contribution::Place::boundary, {piece.primitive}}));
    }
  }
  if (!(largest > 0) || solution.boundary_residual <= 1e-2 * largest) return;
  // Data that vanish on the boundary but for rounding.
  double size = 0;
  for (const ScalarResults::Unknown& unknown : solution.results.unknowns)
    size = std::max(size, maximum(unknown.field, solution.rule));
  if (!(solution.boundary_residual <= 1e-12 * size))
    throw ComputationError(fmt::format(
        "values on the boundary, of up to {:.3g}, are missed by up to {:.3g} by the structure: the "
        "functions of its pieces are too different in size; enforce them weakly (enforce: weak)",
        largest, solution.boundary_residual));
}

// Residuals are least, but u may be another function (problems/flux_balance.hpp).
void warn_of_imbalance(const ScalarProblem& problem, ScalarSolution& solution) {
  constexpr double most = 1e-2;
  const std::optional<double> part = flux_imbalance(problem, solution);
  if (part && *part > most)
    solution.notes.push_back(fmt::format(
        "warning: sources and fluxes of this solution miss their balance by {:.1f}%: the grid is "
        "too coarse, or the boundary has a reentrant corner, where residuals lead to another "
        "function however fine the grid is (method: ritz, or enrich)",
        100 * *part));
}

// Whether u is what the structures are without undetermined functions, to rounding: then loads are
// rounding, and no residual is small beside them.
bool adds_nothing(const std::vector<Structure>& structures,
                  const std::vector<TensorProductSpace>& functions,
                  const ScalarSolution& solution) {
  constexpr double rounding = 1e-10;
  const std::vector<Field> fields =
      solution_fields(structures, functions, solution.linear.coefficients);
  double added = 0, given = 0;
  for (std::size_t c = 0; c < fields.size(); ++c) {
    const Field& data = structures[c].inhomogeneous();
    added = std::hypot(added, norms(fields[c] - data, solution.rule).h1());
    given = std::hypot(given, norms(data, solution.rule).h1());
  }
  return added <= rounding * given;
}

// Tangent, and minus the residual, where the solution is `fields`.
LinearSystem tangent_at(const std::vector<Form>& equations, const std::vector<Field>& fields,
                        const std::vector<Structure>& structures,
                        const std::vector<TensorProductSpace>& functions, const DomainRule& rule) {
  std::vector<Structure> changes;
  for (const Structure& structure : structures) changes.push_back(homogeneous_part(structure));
  std::vector<Contribution> parts;
  for (const Form& form : equations) parts.push_back(form.linearized(fields));
  return assemble(changes, functions, parts, rule);
}

// " (energy at plate.yaml:9:11)", of custom physics.
std::string place_of_equations(const Problem& problem) {
  if (!problem.physics.custom) return "";
  const DocumentNode* physics = problem.document.find("physics");
  for (const char* key : {"energy", "weak", "residuals"})
    if (const DocumentNode* node = physics ? physics->find(key) : nullptr)
      return fmt::format(" ({} at {})", key, node->place.text());
  return "";
}

// A failure at equations of one's own says where they stand, and at those that jump with the
// solution that they do.
template <class Solve>
void naming_equations(const ScalarProblem& problem, const Solve& solve) {
  try {
    solve();
  } catch (const ComputationError& error) {
    const std::string jumps = jumps_with_solution(problem);
    std::string text = error.what() + place_of_equations(problem.problem());
    if (!jumps.empty())
      text += fmt::format(
          ". The equations jump or have corners where the solution passes a value, by if, step, "
          "sign, abs, min or max in {}: where it stays at that value they hold nowhere, and steps "
          "go to and fro; a smooth passage, as (1 + tanh((u - c)/w))/2, has a solution",
          jumps);
    throw ComputationError(text);
  }
}

}  // namespace

int coefficient_count(std::span<const TensorProductSpace> spaces) {
  int count = 0;
  for (const TensorProductSpace& space : spaces) count += space.size();
  return count;
}

std::vector<Contribution> ScalarProblem::contributions(const Grid& grid) const {
  const int dimension = problem_.dimension;
  require_degrees(*this, grid, {1});
  std::vector<Contribution> list{volume_energy(coefficients_, dimension)};
  for (const PieceCondition& condition : conditions_)
    for (Contribution& natural : natural_energy(condition, coefficients_))
      list.push_back(std::move(natural));
  // The penalty of Nitsche's method scales as p²/h; 20 keeps the boundary residual small against
  // the error inside.
  const int degree = problem_.discretization.degree;
  double spacing = INFINITY;
  for (int axis = 0; axis < dimension; ++axis)
    spacing = std::min(
        spacing, has_global_functions() ? grid.box().length(axis) : grid.smallest_width(axis));
  const double penalty = 20.0 * degree * degree / spacing;
  for (const DirichletPlan& plan : plans_)
    for (const PieceCondition& condition : plan.weakly)
      list.push_back(nitsche_energy(condition, coefficients_, dimension, penalty));
  return list;
}

// ½ ∫ (∇u·K∇u + reaction u²): the whole function that u makes stationary, which the system of
// equations knows, less its other parts. They take derivatives on the boundary only, while those in
// the volume would cost half as much as assembly.
double ScalarProblem::stored_energy(const LinearSystem& system,
                                    const std::vector<Contribution>& parts,
                                    const ScalarSolution& solution) const {
  const Eigen::VectorXd& coefficients = solution.linear.coefficients;
  const Field& u = solution.results.unknowns[0].field;
  double energy = system.energy(coefficients);
  if (parts.size() == 1 && plans_[0].data.is_constant(0))
    energy += system.right_hand_side.dot(coefficients);  // the load of the source, and no other
  else if (!coefficients_.source.is_constant(0))
    energy += integrate(coefficients_.source * u, solution.rule);
  for (const Contribution& part : parts)
    if (part.place != Contribution::Place::volume)
      energy -= rfm::energy(part, {&u, 1}, solution.rule);
  return energy;
}

// Whether what seemed to be linear by its values is so at the solution, too.
bool ScalarProblem::is_solved(const std::vector<Form>& equations,
                              const std::vector<TensorProductSpace>& functions,
                              const LinearSystem& system, ScalarSolution& solution) const {
  const std::vector<Structure> structures = this->structures(solution.rule.grid());
  const Eigen::VectorXd& coefficients = solution.linear.coefficients;
  const LinearSystem there =
      tangent_at(equations, solution_fields(structures, functions, coefficients), structures,
                 functions, solution.rule);
  if (is_linear_at(system, coefficients, there.right_hand_side)) return true;
  solution.linearity = Linearity::none;
  return false;
}

ScalarSolution ScalarProblem::solve(const Grid& grid) const {
  Stopwatch quadrature;
  ScalarSolution solution{
      .rule = rule(grid), .grid = grid, .results = {}, .linear = {}, .seconds = {}};
  solution.seconds.quadrature = quadrature.seconds();
  if (misses_divergence_theorem(solution.rule))
    throw ComputationError(fmt::format(
        "the grid is too coarse for the domain: its measure {:.6g} and its boundary disagree by "
        "{:.2g} in the divergence theorem; use more cells",
        solution.rule.measure(), solution.rule.report().divergence_defect));

  if (interpolates()) {
    solution.results.dimension = problem_.dimension;
    solution.results.unknowns = {{problem_.physics.unknowns[0], plans_[0].data}};
    solution.boundary_residual = boundary_residual(solution);
    require_values(plans_, solution);
    return solution;
  }
  if (problem_.study.type == Study::Type::eigen) {
    naming_equations(*this, [&] { solve_eigen(solution); });
    return solution;
  }
  check_compatible(solution.rule);
  if (has_global_functions()) {
    solution.results.dimension = problem_.dimension;
    naming_equations(*this, [&] {
      uses_forms(*this) ? solve_global_forms(solution) : solve_global_energy(solution);
    });
    return solution;
  }
  const std::vector<TensorProductSpace> functions = spaces(solution.rule);
  const std::optional<SplineExtraction> extraction =
      this->extraction(functions, solution.rule, grid);
  solution.unknowns =
      extraction ? static_cast<int>(extraction->matrix.cols()) : coefficient_count(functions);
  const bool free_constant = fixed_up_to_constant();
  std::vector<Form> equations;
  std::vector<Contribution> parts;
  LinearSystem system;
  if (uses_forms(*this)) {
    equations = problem_forms(*this, solution.rule.grid());
    solution.linearity = linearity(equations, solution.rule);
    if (solution.linearity != Linearity::none)
      for (const Form& form : equations)
        parts.push_back(form.at(std::vector<Field>(form.slots().size(), 0.0)));
  } else {
    parts = contributions(solution.rule.grid());
  }
  const auto solve_system = [&] {
    if (!parts.empty()) {
      system = solve_linear(parts, functions, free_constant, solution);
      if (solution.linearity == Linearity::by_form ||
          is_solved(equations, functions, system, solution))
        return;
      parts.clear();
    }
    solve_forms(equations, functions, solution);
  };
  bool at_points =
      problem_.discretization.method == Discretization::Method::collocation || must_use_qr();
  naming_equations(*this, [&] {
    if (at_points)
      solve_at_points(equations, functions, solution);
    else if (may_use_qr())
      at_points = solve_least_squares(equations, functions, solve_system, solution);
    else
      solve_system();
  });
  if (!(solution.linear.relative_residual < 1e-6) &&
      !adds_nothing(structures(grid), functions, solution))
    throw ComputationError(
        fmt::format("the system of equations could not be solved (relative residual {:.1e})",
                    solution.linear.relative_residual));

  Stopwatch results;
  const std::vector<Structure> structures = this->structures(grid);
  std::vector<Field> fields = solution_fields(structures, functions, solution.linear.coefficients);
  const FreeFunctions candidates(structures, functions);
  if (!equations.empty() && !free_constant && candidates.coefficients().cols() > 0 && !at_points) {
    // Without what the equations, at the solution, do not see.
    const auto tangent = [&](const DomainRule& rule) {
      return parts.empty() ? tangent_at(equations, fields, structures, functions, rule)
                           : assemble(structures, functions, parts, rule);
    };
    const auto reduced = [&](LinearSystem of_all) {
      return extraction ? extraction->folded(of_all) : of_all;
    };
    const Kernel kernel(
        reduced(parts.empty() ? tangent(solution.rule) : std::move(system)),
        extraction ? extraction->reduced(candidates.coefficients()) : candidates.coefficients(),
        [&] { return reduced(tangent(finer_rule(grid))); });
    solution.mean_set_to_zero = kernel.size() > 0;
    fields = candidates.without(kernel.weights(), std::move(fields), solution.rule);
  }
  if (at_points && !free_constant && solution.free_at_points.cols() > 0) {
    solution.mean_set_to_zero = true;
    fields = candidates.without(solution.free_at_points, std::move(fields), solution.rule);
  }
  solution.results.dimension = problem_.dimension;
  for (int c = 0; c < unknown_count(); ++c)
    solution.results.unknowns.push_back({problem_.physics.unknowns[c], fields[c]});
  solution.energy =
      uses_forms(*this) ? energy_of_forms(*this, solution) : stored_energy(system, parts, solution);
  Field& u = solution.results.unknowns[0].field;
  if (free_constant) {
    u = u - integrate(u, solution.rule) / solution.rule.measure();
    solution.mean_set_to_zero = true;
  }
  solution.seconds.solve += results.seconds();

  if (!problem_.physics.custom)
    for (const Field& component : conductive_flux(coefficients_, u, problem_.dimension))
      solution.results.flux.push_back(with_solution(component, {&u, 1}));
  solution.boundary_residual = boundary_residual(solution);
  require_values(plans_, solution);
  const Discretization::Method method = problem_.discretization.method;
  if (method == Discretization::Method::least_squares ||
      method == Discretization::Method::collocation) {
    warn_of_imbalance(*this, solution);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(solution.linear.coefficients.size());
    warn_of_residuals(*this, solution_fields(structures, functions, zero), solution);
  }
  return solution;
}

}  // namespace rfm
