#include "problems/scalar_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "basis/tensor_polynomials.hpp"
#include "core/error.hpp"
#include "core/regular_form.hpp"
#include "problems/holes.hpp"
#include "problems/partial_coverage.hpp"
#include "problems/problem_forms.hpp"
#include "problems/regular_data.hpp"
#include "problems/stopwatch.hpp"
#include "problems/user_structure.hpp"
#include "solvers/assembly.hpp"
#include "solvers/collocation.hpp"
#include "solvers/energy.hpp"
#include "solvers/integrate.hpp"
#include "solvers/solution.hpp"

namespace rfm {
namespace {

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

Place geometry_place(const Problem& problem, std::string_view key) {
  const DocumentNode* geometry = problem.document.find("geometry");
  const DocumentNode* node = geometry ? geometry->find(key) : nullptr;
  return node ? node->place : problem.document.place;
}

Place domain_place(const Problem& problem) { return geometry_place(problem, "domain"); }

Box problem_bounds(const Problem& problem, const RegionEvaluator& region) {
  if (problem.bounds) return *problem.bounds;
  try {
    return bounding_box(region);
  } catch (const InvalidArgument& error) {
    const bool empty = std::string(error.what()).find("empty") != std::string::npos;
    refuse(empty ? "the domain is empty"
                 : fmt::format("{}; give geometry.bounds: {{min: [..], max: [..]}}", error.what()),
           domain_place(problem));
  }
}

// Whether values of a field are finite at all points of a rule.
bool is_defined(const Field& field, const DomainRule& rule) {
  try {
    maximum(field, rule);
    maximum(field, rule, {Contribution::Place::boundary});
    return true;
  } catch (const ComputationError&) {
    return false;
  }
}

// Beyond this a rule is not one for the domain: pieces of its boundary are missing or unresolved.
bool misses_divergence_theorem(const DomainRule& rule) {
  return rule.report().divergence_defect > 1e-2 * rule.measure();
}

// Whether `inner` lies in `outer`, up to the accuracy of bounding boxes.
bool contains(const Box& outer, const Box& inner) {
  const double tolerance = 1e-6 * inner.longest_side();
  for (int axis = 0; axis < inner.dimension; ++axis)
    if (inner.low[axis] < outer.low[axis] - tolerance ||
        inner.high[axis] > outer.high[axis] + tolerance)
      return false;
  return true;
}

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

PolynomialFamily polynomial_family(const Discretization& discretization) {
  using Kind = PolynomialFamily::Kind;
  PolynomialFamily family{Kind::legendre, discretization.degree, discretization.total_degree};
  if (discretization.basis == Discretization::Basis::chebyshev) family.kind = Kind::chebyshev;
  if (discretization.basis == Discretization::Basis::power) family.kind = Kind::power;
  if (discretization.basis == Discretization::Basis::trigonometric)
    family.kind = Kind::trigonometric;
  return family;
}

// Cells on which functions of the whole domain are integrated, and Gauss points in each: they turn
// about once per cell.
int global_cells(const Discretization& discretization) {
  return std::max(8, discretization.degree);
}
constexpr int global_points = 8;

}  // namespace

Grid problem_grid(const Problem& problem, const Box& bounds, std::optional<int> cells) {
  const Discretization& discretization = problem.discretization;
  const Box box = discretization.grid.value_or(bounds);
  if (cells) return Grid::with_square_cells(box, *cells);
  if (discretization.cells.size() == 1)
    return Grid::with_square_cells(box, discretization.cells[0]);
  if (discretization.cells.size() > 1) {
    std::array<int, 3> counts{1, 1, 1};
    std::copy_n(discretization.cells.begin(), problem.dimension, counts.begin());
    return Grid(box, counts);
  }
  if (discretization.basis != Discretization::Basis::bspline)
    return Grid::with_square_cells(box, global_cells(discretization));
  const double size = discretization.cell_size.value_or(box.longest_side() / 64);
  return Grid::with_square_cells(
      box, std::max(1, static_cast<int>(std::ceil(box.longest_side() / size - 1e-9))));
}

int coefficient_count(std::span<const TensorProductSpace> spaces) {
  int count = 0;
  for (const TensorProductSpace& space : spaces) count += space.size();
  return count;
}

ScalarProblem::ScalarProblem(const Problem& problem)
    : problem_(problem),
      region_(*problem.domain),
      bounds_(problem_bounds(problem, region_)),
      interfaces_(problem),
      coefficients_(problem.physics.custom ? ScalarCoefficients{} : scalar_coefficients(problem)) {
  check_method(problem);
  if (problem.study.type == Study::Type::eigen || has_global_functions()) check_equations();
  // Which primitives bound the domain, and whether data are defined, is seen on the problem's grid
  // with few points.
  QuadratureOptions coarse;
  coarse.inside_points = 1;
  coarse.cut_points = 2;
  const DomainRule probe = make_domain_rule(region_, grid(), coarse, interfaces_.all());
  if (!(probe.measure() > 0)) refuse("the domain is empty", domain_place(problem));
  for (int k = 0; k < region_.primitive_count(); ++k)
    if (!region_.region().primitives()[k]->selects_only &&
        probe.boundary_measure(k) > 1e-12 * probe.boundary_measure())
      bounding_primitives_.push_back(k);
  if (problem.physics.type == PhysicsType::torsion) check_torsion(probe);
  conditions_ = piece_conditions(problem, region_, bounding_primitives_, probe);
  check_within_grid(probe);
  check_parts(problem, region_, bounding_primitives_, probe);
  check_materials(problem, probe);
  if (!problem.physics.custom && !is_isotropic(coefficients_, problem.dimension)) check_no_robin();
  plan_values(probe);
  irregularities_ = rfm::irregularities(region_, bounds_);
}

// All values that are not to be enforced weakly hold by the user's structure.
void ScalarProblem::plan_own_structure(const UserStructure& user, const DomainRule& probe) {
  require_values(user, conditions_, problem_, probe);
  DirichletPlan plan;
  plan.data = user.structure.inhomogeneous();
  plan.own_structure = user.text;
  for (const PieceCondition& condition : conditions_)
    if (condition.kind == Condition::Kind::value)
      (condition.enforcement == Condition::Enforcement::weak ? plan.weakly : plan.by_structure)
          .push_back(condition);
  plans_.push_back(plan);
  structures_.push_back(user.structure);
}

void ScalarProblem::plan_values(const DomainRule& probe) {
  if (const std::optional<UserStructure> user = user_structure(problem_))
    return plan_own_structure(*user, probe);
  const std::optional<BooleanExpression> form = regular_form(region_, bounds_);
  for (int component = 0; component < unknown_count(); ++component) {
    std::vector<PieceCondition> own;
    std::vector<bool> regular;
    for (const PieceCondition& condition : conditions_) {
      if (condition.component != component) continue;
      own.push_back(condition);
      regular.push_back(condition.kind != Condition::Kind::value ||
                        condition.data[0].is_constant() ||
                        (is_regular(condition.data[0], region_, bounds_) &&
                         is_defined(condition.data[0], probe)));
    }
    try {
      plans_.push_back(plan_dirichlet(own, region_, bounds_, problem_.combine, regular, form));
    } catch (const InvalidArgument& error) {  // a cap that is not positive, corners inside
      refuse(error.what(), geometry_place(problem_, "combine"));
    }
    const DirichletPlan& plan = plans_.back();
    for (const PieceCondition& piece : plan.weakly)
      if (piece.clamped)
        refuse(fmt::format("'{}' can be clamped by structure only: whole pieces whose corners are "
                           "all clamped or held",
                           piece.name),
               problem_.conditions[piece.condition].place);
    const Structure psi = Structure::undetermined(component);
    structures_.push_back(plan.by_structure.empty() ? psi : plan.data + plan.weight.function * psi);
  }
}

void ScalarProblem::check_within_grid(const DomainRule& rule) const {
  // A domain that is cut off by the box has a boundary without points: the divergence theorem
  // fails. So it may for a thin body on this coarse rule, too; where the bounds are the program's
  // own, they tell the two apart.
  if (!misses_divergence_theorem(rule)) return;
  const Grid box = grid();
  if (!problem_.bounds && contains(box.box(), bounds_)) return;
  std::string text;
  for (int axis = 0; axis < problem_.dimension; ++axis)
    text += fmt::format("{}{} from {:.6g} to {:.6g}", axis > 0 ? ", " : "", "xyz"[axis],
                        box.box().low[axis], box.box().high[axis]);
  refuse(fmt::format("the domain reaches beyond the box of the grid ({})", text),
         domain_place(problem_));
}

bool ScalarProblem::has_global_functions() const {
  return problem_.discretization.basis != Discretization::Basis::bspline;
}

void ScalarProblem::check_equations() const {
  using Method = Discretization::Method;
  const Method method = problem_.discretization.method;
  if (problem_.physics.custom || depend_on_solution(coefficients_) ||
      !coefficients_.advection.empty() || method == Method::least_squares ||
      method == Method::collocation)
    refuse(fmt::format(
               "{} of equations that do not follow from a quadratic energy are not "
               "supported yet",
               has_global_functions() ? "functions of the whole domain for solutions" : "modes"),
           problem_.document.place);
}

void ScalarProblem::check_torsion(const DomainRule& rule) const {
  if (problem_.dimension != 2)
    refuse("torsion is that of a cross-section: dimension 2", domain_place(problem_));
  if (euler_characteristic(region_, bounds_, rule, bounding_primitives_) < 0.5)
    refuse(
        "torsion of a section with holes, on each of which u is a constant of its own, is not "
        "supported yet",
        domain_place(problem_));
}

void ScalarProblem::check_no_robin() const {
  for (const PieceCondition& condition : conditions_)
    if (condition.kind == Condition::Kind::robin)
      refuse(
          "robin prescribes the plain normal derivative, which does not follow from an energy "
          "where the diffusivity is a matrix; use flux or convection (n.K grad u)",
          problem_.conditions[condition.condition].place);
}

DomainRule ScalarProblem::rule(const RegionEvaluator& region, const Grid& grid,
                               int more_points) const {
  const int degree = problem_.discretization.degree;
  QuadratureOptions options;
  const bool global = has_global_functions();
  const std::optional<int> order = problem_.discretization.quadrature_order;
  options.inside_points = order.value_or(global ? global_points : degree + 1);
  options.cut_points = order.value_or(global ? global_points + 2 : degree + 3);
  options.gradings = problem_.discretization.gradings;
  options.inside_points += more_points;
  options.cut_points += more_points;
  return make_domain_rule(region, grid, options, interfaces_.all());
}

std::vector<TensorProductSpace> ScalarProblem::spaces(const DomainRule& rule) const {
  const Discretization& discretization = problem_.discretization;
  std::vector<TensorProductSpace> spaces;
  for (const std::string& unknown : problem_.physics.unknowns) {
    const auto own = discretization.degrees.find(unknown);
    const int degree = own == discretization.degrees.end() ? discretization.degree : own->second;
    // Cells are left out by the degree of all, so that unknowns live on the same ones.
    spaces.emplace_back(rule.grid(), degree, cells_in_region(rule, discretization.degree));
  }
  // The further functions of a structure of the user's own.
  while (static_cast<int>(spaces.size()) < structures_[0].unknown_count())
    spaces.push_back(spaces[0]);
  return spaces;
}

DomainRule ScalarProblem::collocation_rule(const Grid& grid) const {
  QuadratureOptions options;
  options.inside_points = std::max(2, problem_.discretization.degree - 1);
  options.cut_points = std::max(2, problem_.discretization.degree);
  options.gradings = problem_.discretization.gradings;
  return make_domain_rule(region_, grid, options, interfaces_.all());
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
  if (!coefficients_.reaction.is_constant(0)) return false;
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
  if (problem_.discretization.method == Discretization::Method::collocation || parts.empty())
    solve_forms(equations, functions, solution);
  else
    system = solve_linear(parts, functions, free_constant, solution);
  if (!(solution.linear.relative_residual < 1e-6))
    throw ComputationError(
        fmt::format("the system of equations could not be solved (relative residual {:.1e})",
                    solution.linear.relative_residual));

  Stopwatch results;
  const std::vector<Field> fields =
      solution_fields(structures_, functions, solution.linear.coefficients);
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
  return solution;
}

LinearSolverOptions ScalarProblem::linear_options() const {
  LinearSolverOptions options;
  options.dimension = problem_.dimension;
  options.tolerance = problem_.discretization.tolerance;
  if (problem_.discretization.linear_solver == Discretization::LinearSolver::direct)
    options.method = LinearSolverOptions::Method::direct;
  // Several functions in one unknown may describe nearly the same.
  if (unknown_count() == 1 && structures_[0].unknown_count() > 1) {
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
  LinearSystem system = assemble(structures_, functions, parts, solution.rule);
  if (free_constant) pin_one(system);
  solution.seconds.assembly = assembly.seconds();
  Stopwatch solve;
  solution.linear = rfm::solve(system, linear_options());
  solution.seconds.solve = solve.seconds();
  return system;
}

void ScalarProblem::solve_forms(const std::vector<Form>& equations,
                                const std::vector<TensorProductSpace>& functions,
                                ScalarSolution& solution) const {
  Stopwatch solve;
  NewtonOptions options;
  options.load_steps = problem_.discretization.load_steps;
  const bool at_points = problem_.discretization.method == Discretization::Method::collocation;
  NewtonSolution newton = at_points
                              ? solve_collocation(structures_, functions, equations,
                                                  collocation_rule(solution.rule.grid()), options)
                              : solve_newton(structures_, functions, equations, solution.rule,
                                             linear_options(), options);
  solution.newton_order = newton.order();
  solution.newton = std::move(newton.iterations);
  solution.linear = std::move(newton.linear);
  solution.seconds.solve = solve.seconds();
}

Equations ScalarProblem::equations(const DomainRule& rule) const {
  const bool eigen = problem_.study.type == Study::Type::eigen;
  EquationTerms terms;
  if (!problem_.physics.custom) terms.stiffness = contributions(rule.grid());
  if (eigen) terms.mass = {mass_energy(coefficients_)};
  std::vector<Structure> structures;
  for (const Structure& structure : structures_)
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
  const bool eigen = problem_.study.type == Study::Type::eigen;
  double largest = 0;
  for (const PieceCondition& condition : conditions_) {
    if (condition.kind != Condition::Kind::value) continue;
    Field residual = fields[condition.component];
    if (!eigen) residual = residual - condition.data[0];
    if (condition.where) residual = select(step(*condition.where), residual, 0.0);
    largest = std::max(
        largest, maximum(residual, rule, {Contribution::Place::boundary, {condition.primitive}}));
  }
  return largest;
}

}  // namespace rfm
