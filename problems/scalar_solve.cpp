// Assembles and solves what scalar_problem.cpp has made ready.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "basis/tensor_polynomials.hpp"
#include "core/error.hpp"
#include "core/tape.hpp"
#include "problems/continuation.hpp"
#include "problems/problem_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/assembly.hpp"
#include "solvers/collocation.hpp"
#include "solvers/energy.hpp"
#include "solvers/extension.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/integrate.hpp"
#include "solvers/kernel.hpp"
#include "solvers/solution.hpp"

namespace rfm {
namespace {

// The system without its first well supported unknown, which is set to zero: what a kernel of
// constants leaves free.
void pin_one(LinearSystem& system) {
  Eigen::Index pinned = 0;
  const Eigen::VectorXd diagonal = system.matrix.diagonal();
  diagonal.maxCoeff(&pinned);
  for (Eigen::Index column = 0; column < system.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry)
      if (entry.row() == pinned || entry.col() == pinned)
        entry.valueRef() = entry.row() == entry.col() ? entry.value() : 0.0;
  system.right_hand_side[pinned] = 0;
}

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
  if (largest > 0 && !(solution.boundary_residual <= 1e-2 * largest))
    throw ComputationError(fmt::format(
        "values on the boundary, of up to {:.3g}, are missed by up to {:.3g} by the structure: the "
        "functions of its pieces are too different in size; enforce them weakly (enforce: weak)",
        largest, solution.boundary_residual));
}

// A form of an eigenproblem.
Contribution quadratic(const Form& form, const Problem& problem) {
  if (!form.is_linear())
    throw ProblemFileErrors({Mistake{"modes need an energy and a mass that are quadratic",
                                     problem.physics.custom->place}});
  return form.linear();
}

// What the equations leave free, as the level of a pressure or rigid motions, is pinned somehow.
LinearSolution solve_beside_kernel(const LinearSystem& system, const FreeFunctions& candidates,
                                   const std::vector<std::string>& unknowns,
                                   const LinearSolverOptions& options) {
  const Kernel kernel(system, candidates.coefficients());
  LinearSolution solution = rfm::solve(kernel.pinned(system), options);
  // Quadrature keeps the balance of loads to its own error, which is that of the solution.
  const double missing = kernel.incompatibility(system, solution.coefficients);
  if (!(missing < 1e-6))
    throw ComputationError(
        fmt::format("no steady solution exists: nothing fixes {}, and the loads on it do not "
                    "balance (by {:.1e} "
                    "of all loads)",
                    candidates.text(kernel.weights(), unknowns), missing));
  return solution;
}

bool wants_extension(const Problem& problem) {
  const DocumentNode* discretization = problem.document.find("discretization");
  const DocumentNode* basis = discretization ? discretization->find("basis") : nullptr;
  const DocumentNode* extension = basis ? basis->find("extension") : nullptr;
  return extension && extension->text == "true";
}

LinearSystem tangent_at(const std::vector<Form>& equations, const std::vector<Field>& fields,
                        const std::vector<Structure>& structures,
                        const std::vector<TensorProductSpace>& functions, const DomainRule& rule) {
  std::vector<Structure> changes;
  for (const Structure& structure : structures) changes.push_back(homogeneous_part(structure));
  std::vector<Contribution> parts;
  for (const Form& form : equations) parts.push_back(form.linearized(fields));
  return assemble(changes, functions, parts, rule);
}

// The coefficients at a stop of a continuation, from those at the one before.
Eigen::VectorXd solved_stop(const ContinuationStop& stop,
                            const std::vector<TensorProductSpace>& functions,
                            const DomainRule& rule, const LinearSolverOptions& linear,
                            const NewtonOptions& options,
                            const std::optional<Eigen::VectorXd>& start) {
  const ScalarProblem problem(stop.problem);
  if (std::abs(problem.rule(rule.grid()).measure() - rule.measure()) > 1e-9 * rule.measure())
    throw ComputationError(stop.name + ": continuation needs the same domain at all values");
  try {
    return solve_newton(problem.structures(rule.grid()), functions,
                        problem_forms(problem, rule.grid()), rule, linear, options, start)
        .linear.coefficients;
  } catch (const ComputationError& error) {
    throw ComputationError("at " + stop.name + ": " + error.what());
  }
}

PolynomialFamily polynomial_family(const Discretization& discretization) {
  using Kind = PolynomialFamily::Kind;
  PolynomialFamily family{Kind::legendre, discretization.degree, discretization.total_degree};
  if (discretization.basis == Discretization::Basis::chebyshev) family.kind = Kind::chebyshev;
  if (discretization.basis == Discretization::Basis::power) family.kind = Kind::power;
  if (discretization.basis == Discretization::Basis::trigonometric)
    family.kind = Kind::trigonometric;
  return family;
}

}  // namespace

int coefficient_count(std::span<const TensorProductSpace> spaces) {
  int count = 0;
  for (const TensorProductSpace& space : spaces) count += space.size();
  return count;
}

std::vector<Contribution> ScalarProblem::contributions(const Grid& grid) const {
  const int dimension = problem_.dimension;
  std::vector<Contribution> list{volume_energy(coefficients_, dimension)};
  for (const PieceCondition& condition : conditions_)
    for (Contribution& natural : natural_energy(condition, coefficients_))
      list.push_back(std::move(natural));
  // The penalty of Nitsche's method scales as p²/h; 20 keeps the boundary residual small against
  // the error inside.
  const int degree = problem_.discretization.degree;
  double spacing = INFINITY;
  for (int axis = 0; axis < dimension; ++axis)
    spacing =
        std::min(spacing, has_global_functions() ? grid.box().length(axis) : grid.spacing(axis));
  const double penalty = 20.0 * degree * degree / spacing;
  for (const DirichletPlan& plan : plans_)
    for (const PieceCondition& condition : plan.weakly)
      list.push_back(nitsche_energy(condition, coefficients_, dimension, penalty));
  return list;
}

bool ScalarProblem::fixed_up_to_constant() const {
  if (problem_.physics.custom || depend_on_solution(coefficients_) ||
      !coefficients_.advection.empty())
    return false;
  if (!coefficients_.reaction.is_constant(0) || !inner_.values.empty()) return false;
  return std::ranges::all_of(conditions_, [](const PieceCondition& condition) {
    if (condition.kind == Condition::Kind::flux) return true;
    if (condition.kind == Condition::Kind::value) return false;
    return condition.data[0].is_constant(0);  // no transfer, or a = 0
  });
}

void ScalarProblem::check_compatible(const DomainRule& rule) const {
  // ∫ f + ∫ q must vanish: the sum of all loads against the constant 1.
  double resultant = integrate(coefficients_.source, rule);
  double size = integrate(abs(coefficients_.source), rule);
  for (const PieceCondition& condition : conditions_)
    for (const Contribution& natural : natural_energy(condition, coefficients_))
      for (const auto& load : natural.energy.load()) {
        const IntegrationPlace place{Contribution::Place::boundary, natural.numbers};
        const Coefficient part =
            natural.where ? load.coefficient * Coefficient(step(*natural.where)) : load.coefficient;
        const double amount = integrate(part, rule, place);
        resultant += amount;
        size += std::fabs(amount);
      }
  if (std::fabs(resultant) > 1e-8 * size)
    throw ComputationError(fmt::format(
        "no steady solution exists: nothing fixes the level of u, and sources and fluxes do not "
        "balance (their resultant is {:.6g})",
        resultant));
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

ScalarSolution ScalarProblem::solve(const Grid& grid) const {
  Stopwatch quadrature;
  ScalarSolution solution{.rule = rule(grid), .results = {}, .linear = {}, .seconds = {}};
  solution.seconds.quadrature = quadrature.seconds();
  if (misses_divergence_theorem(solution.rule))
    throw ComputationError(fmt::format(
        "the grid is too coarse for the domain: its measure {:.6g} and its boundary disagree by "
        "{:.2g} in the divergence theorem; use more cells",
        solution.rule.measure(), solution.rule.report().divergence_defect));

  if (problem_.study.type == Study::Type::eigen || has_global_functions()) {
    solve_equations(solution);
    return solution;
  }
  const std::vector<TensorProductSpace> functions = spaces(solution.rule);
  solution.unknowns = coefficient_count(functions);
  const bool free_constant = fixed_up_to_constant();
  if (free_constant) check_compatible(solution.rule);
  std::vector<Form> equations;
  std::vector<Contribution> parts;
  LinearSystem system;
  if (uses_forms(*this)) {
    equations = problem_forms(*this, grid);
    if (std::ranges::all_of(equations, &Form::is_linear))
      for (const Form& form : equations) parts.push_back(form.linear());
  } else {
    parts = contributions(grid);
  }
  if (problem_.discretization.method == Discretization::Method::collocation || parts.empty()) {
    if (wants_extension(problem_))
      throw ComputationError(
          "extended splines serve linear problems by Ritz's and Galerkin's method");
    solve_forms(equations, functions, solution);
  } else
    system = solve_linear(parts, functions, free_constant, solution);
  if (!(solution.linear.relative_residual < 1e-6))
    throw ComputationError(
        fmt::format("the system of equations could not be solved (relative residual {:.1e})",
                    solution.linear.relative_residual));

  Stopwatch results;
  const std::vector<Structure> structures = this->structures(grid);
  std::vector<Field> fields = solution_fields(structures, functions, solution.linear.coefficients);
  const FreeFunctions candidates(structures, functions);
  if (!equations.empty() && !free_constant && candidates.coefficients().cols() > 0 &&
      problem_.discretization.method != Discretization::Method::collocation) {
    // Without what the equations, at the solution, do not see.
    const Kernel kernel(parts.empty()
                            ? tangent_at(equations, fields, structures, functions, solution.rule)
                            : std::move(system),
                        candidates.coefficients());
    solution.mean_set_to_zero = kernel.size() > 0;
    fields = candidates.without(kernel.weights(), std::move(fields), solution.rule);
  }
  solution.results.dimension = problem_.dimension;
  for (int c = 0; c < unknown_count(); ++c)
    solution.results.unknowns.push_back({problem_.physics.unknowns[c], fields[c]});
  solution.energy = uses_forms(*this) ? energy_of_forms(*this, equations, solution)
                                      : stored_energy(system, parts, solution);
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
  return solution;
}

LinearSolverOptions ScalarProblem::linear_options() const {
  LinearSolverOptions options;
  options.dimension = problem_.dimension;
  options.tolerance = problem_.discretization.tolerance;
  if (problem_.discretization.linear_solver == Discretization::LinearSolver::direct)
    options.method = LinearSolverOptions::Method::direct;
  // Several functions in one unknown may describe nearly the same.
  if (function_count() > unknown_count()) {
    options.method = LinearSolverOptions::Method::direct;
    options.regularization = 1e-13;
    options.refinement_steps = 4;
  }
  return options;
}

LinearSystem ScalarProblem::solve_linear(const std::vector<Contribution>& parts,
                                         const std::vector<TensorProductSpace>& functions,
                                         bool free_constant, ScalarSolution& solution) const {
  Stopwatch assembly;
  LinearSystem system = assemble(structures(solution.rule.grid()), functions, parts, solution.rule);
  if (free_constant) pin_one(system);
  solution.seconds.assembly = assembly.seconds();
  Stopwatch solve;
  if (wants_extension(problem_)) {
    const SplineExtension extension(functions, solution.rule);
    solution.linear = rfm::solve(extension.extended(system), linear_options());
    solution.linear.coefficients = extension.matrix * solution.linear.coefficients;
    solution.seconds.solve = solve.seconds();
    return system;
  }
  solution.linear =
      free_constant || !uses_forms(*this)
          ? rfm::solve(system, linear_options())
          : solve_beside_kernel(system, FreeFunctions(structures(solution.rule.grid()), functions),
                                problem_.physics.unknowns, linear_options());
  if (function_count() > unknown_count())
    solution.undetermined = undetermined_part(system, functions, solution);
  solution.seconds.solve = solve.seconds();
  return system;
}

// The regularised system is answered also where it is singular. What it then gives to a right-hand
// side of the size of the regularisation, chosen at random, is undetermined: nothing where two
// functions merely describe the same u, but a function of the size of u where a condition is
// missing.
double ScalarProblem::undetermined_part(const LinearSystem& system,
                                        const std::vector<TensorProductSpace>& functions,
                                        const ScalarSolution& solution) const {
  const LinearSolverOptions options = linear_options();
  const Eigen::VectorXd scale = system.matrix.diagonal().cwiseAbs().cwiseSqrt();
  const Eigen::VectorXd scaled = scale.cwiseProduct(solution.linear.coefficients);
  std::mt19937 engine(1);
  LinearSystem disturbed = system;
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    disturbed.right_hand_side[i] = scale[i] * (static_cast<double>(engine()) / 0x80000000u - 1);
  disturbed.right_hand_side *=
      options.regularization * std::sqrt(scaled.squaredNorm() / static_cast<double>(scale.size()));
  const LinearSolution answer = rfm::solve(disturbed, options);
  const std::vector<Structure> structures = this->structures(solution.rule.grid());
  std::vector<Structure> homogeneous;
  for (const Structure& structure : structures) homogeneous.push_back(homogeneous_part(structure));
  const std::vector<Field> open = solution_fields(homogeneous, functions, answer.coefficients),
                           u = solution_fields(structures, functions, solution.linear.coefficients);
  double part = 0, whole = 0;
  for (std::size_t c = 0; c < u.size(); ++c) {
    part = std::hypot(part, norms(open[c], solution.rule).l2);
    whole = std::hypot(whole, norms(u[c], solution.rule).l2);
  }
  return whole > 0 ? part / whole : part;
}

void ScalarProblem::solve_forms(const std::vector<Form>& equations,
                                const std::vector<TensorProductSpace>& functions,
                                ScalarSolution& solution) const {
  Stopwatch solve;
  NewtonOptions options;
  options.load_steps = problem_.discretization.load_steps;
  const bool at_points = problem_.discretization.method == Discretization::Method::collocation;
  const Grid& grid = solution.rule.grid();
  const std::vector<Structure> structures = this->structures(grid);
  std::optional<Eigen::VectorXd> start;
  for (const ContinuationStop& stop : continuation_stops(problem_)) {
    if (at_points) throw ComputationError("collocation has no continuation");
    start = solved_stop(stop, functions, solution.rule, linear_options(), options, start);
  }
  NewtonSolution newton = at_points ? solve_collocation(structures, functions, equations,
                                                        collocation_rule(grid), options)
                                    : solve_newton(structures, functions, equations, solution.rule,
                                                   linear_options(), options, start);
  solution.newton_order = newton.order();
  solution.newton = std::move(newton.iterations);
  solution.linear = std::move(newton.linear);
  solution.seconds.solve = solve.seconds();
}

Equations ScalarProblem::equations(const DomainRule& rule) const {
  const bool eigen = problem_.study.type == Study::Type::eigen;
  EquationTerms terms;
  if (problem_.physics.custom) {
    const Problem& file = problem_;
    for (const Form& form : problem_forms(*this, rule.grid()))
      terms.stiffness.push_back(quadratic(form, file));
    if (eigen)
      terms.mass = {quadratic(Form::energy(file.physics.coefficients.at("mass").entries[0]), file)};
  } else {
    terms.stiffness = contributions(rule.grid());
    if (eigen) terms.mass = {mass_energy(coefficients_)};
  }
  std::vector<Structure> structures;
  for (const Structure& structure : this->structures(rule.grid()))
    structures.push_back(eigen ? homogeneous_part(structure) : structure);
  if (!has_global_functions())
    return Equations(std::move(structures), spaces(rule), std::move(terms), rule);
  const auto functions = std::make_shared<TensorPolynomials>(
      rule.grid().box(), polynomial_family(problem_.discretization));
  return Equations(std::move(structures), GlobalSpaces{functions}, std::move(terms), rule);
}

// Problems with an energy, of one unknown.
void ScalarProblem::solve_equations(ScalarSolution& solution) const {
  const Equations equations = this->equations(solution.rule);
  solution.unknowns = equations.size();
  solution.results.dimension = problem_.dimension;
  if (problem_.study.type == Study::Type::eigen) return solve_eigen(equations, solution);
  const bool free_constant = fixed_up_to_constant();
  if (free_constant) check_compatible(solution.rule);
  Stopwatch assembly;
  LinearSystem system = equations.steady();
  if (free_constant) pin_one(system);
  solution.seconds.assembly = assembly.seconds();

  Stopwatch solve;
  solution.linear = rfm::solve(system, linear_options());
  Field u = equations.fields(solution.linear.coefficients)[0];
  solution.results.unknowns = {{problem_.physics.unknowns[0], u}};
  solution.energy = stored_energy(system, equations.terms().stiffness, solution);
  if (free_constant) {
    u = u - integrate(u, solution.rule) / solution.rule.measure();
    solution.results.unknowns[0].field = u;
    solution.mean_set_to_zero = true;
  }
  solution.results.flux = conductive_flux(coefficients_, u, problem_.dimension);
  solution.boundary_residual = boundary_residual(solution);
  solution.seconds.solve = solve.seconds();
}

void ScalarProblem::solve_eigen(const Equations& equations, ScalarSolution& solution) const {
  Stopwatch assembly;
  equations.stiffness();
  equations.mass();
  solution.seconds.assembly = assembly.seconds();

  Stopwatch solve;
  const EigenResult& eigen = solution.eigen.emplace(find_modes(equations, problem_.study, bounds_));
  solution.results.unknowns = {{problem_.physics.unknowns[0], eigen.modes[0]}};
  solution.results.modes = eigen.modes;
  if (!problem_.physics.custom)
    solution.results.flux = conductive_flux(coefficients_, eigen.modes[0], problem_.dimension);
  solution.energy = 0.5 * eigen.values[0];  // of a mode of unit mass
  solution.linear.relative_residual = std::ranges::max(eigen.residuals);
  for (const Field& mode : eigen.modes)
    solution.boundary_residual =
        std::max(solution.boundary_residual, boundary_residual({mode}, solution.rule));
  solution.seconds.solve = solve.seconds();
}

double ScalarProblem::boundary_residual(const ScalarSolution& solution) const {
  std::vector<Field> fields;
  for (const ScalarResults::Unknown& unknown : solution.results.unknowns)
    fields.push_back(unknown.field);
  return boundary_residual(fields, solution.rule);
}

double ScalarProblem::boundary_residual(const std::vector<Field>& fields,
                                        const DomainRule& rule) const {
  // Pieces that one formula holds on are looked at together: a polygon has hundreds.
  struct Group {
    const PieceCondition* first;
    std::vector<int> primitives;
  };
  std::vector<Group> groups;
  for (const PieceCondition& condition : conditions_) {
    if (condition.kind != Condition::Kind::value) continue;
    const auto known = std::ranges::find_if(groups, [&](const Group& group) {
      return !condition.where && !group.first->where &&
             group.first->component == condition.component &&
             same_expression(group.first->data[0], condition.data[0]);
    });
    if (known != groups.end())
      known->primitives.push_back(condition.primitive);
    else
      groups.push_back({&condition, {condition.primitive}});
  }
  const bool eigen = problem_.study.type == Study::Type::eigen;
  double largest = 0;
  for (const auto& [first, primitives] : groups) {
    Field residual = fields[first->component];
    if (!eigen) residual = residual - first->data[0];
    if (first->where) residual = select(step(*first->where), residual, 0.0);
    largest =
        std::max(largest, maximum(residual, rule, {Contribution::Place::boundary, primitives}));
  }
  return largest;
}

}  // namespace rfm
