#include "problems/scalar_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/regular_form.hpp"
#include "problems/partial_coverage.hpp"
#include "problems/regular_data.hpp"
#include "problems/stopwatch.hpp"
#include "solution_structures/dirichlet.hpp"
#include "solvers/assembly.hpp"
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
  const double size = discretization.cell_size.value_or(box.longest_side() / 64);
  return Grid::with_square_cells(
      box, std::max(1, static_cast<int>(std::ceil(box.longest_side() / size - 1e-9))));
}

ScalarProblem::ScalarProblem(const Problem& problem)
    : problem_(problem),
      region_(*problem.domain),
      bounds_(problem_bounds(problem, region_)),
      interfaces_(coefficient_interfaces(problem)),
      coefficients_(scalar_coefficients(problem)) {
  // Which primitives bound the domain, and whether data are defined, is seen on the problem's grid
  // with few points.
  QuadratureOptions coarse;
  coarse.inside_points = 1;
  coarse.cut_points = 2;
  const DomainRule probe = make_domain_rule(region_, grid(), coarse, interfaces_);
  if (!(probe.measure() > 0)) refuse("the domain is empty", domain_place(problem));
  for (int k = 0; k < region_.primitive_count(); ++k)
    if (!region_.region().primitives()[k]->selects_only &&
        probe.boundary_measure(k) > 1e-12 * probe.boundary_measure())
      bounding_primitives_.push_back(k);
  conditions_ = piece_conditions(problem, region_, bounding_primitives_, probe);
  check_within_grid(probe);
  check_parts(problem, region_, bounding_primitives_, probe);
  check_materials(problem, probe);
  if (!is_isotropic(coefficients_, problem.dimension)) check_no_robin();
  std::vector<bool> regular;
  for (const PieceCondition& condition : conditions_)
    regular.push_back(
        condition.kind != Condition::Kind::value || condition.data[0].is_constant() ||
        (is_regular(condition.data[0], region_, bounds_) && is_defined(condition.data[0], probe)));
  try {
    plan_ = plan_dirichlet(conditions_, region_, bounds_, problem.combine, regular,
                           regular_form(region_, bounds_));
  } catch (const InvalidArgument& error) {  // a cap that is not positive, corners that cross inside
    refuse(error.what(), geometry_place(problem, "combine"));
  }
  irregularities_ = rfm::irregularities(region_, bounds_);
  structure_ = plan_.by_structure.empty() ? Structure::undetermined()
                                          : rfm::dirichlet(plan_.data, plan_.weight.function);
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
  options.inside_points = problem_.discretization.quadrature_order.value_or(degree + 1);
  options.cut_points = problem_.discretization.quadrature_order.value_or(degree + 3);
  options.gradings = problem_.discretization.gradings;
  options.inside_points += more_points;
  options.cut_points += more_points;
  return make_domain_rule(region, grid, options, interfaces_);
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
  double spacing = grid.spacing(0);
  for (int axis = 1; axis < dimension; ++axis) spacing = std::min(spacing, grid.spacing(axis));
  const double penalty = 20.0 * degree * degree / spacing;
  for (const PieceCondition& condition : plan_.weakly)
    list.push_back(nitsche_energy(condition, coefficients_, dimension, penalty));
  return list;
}

bool ScalarProblem::fixed_up_to_constant() const {
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
  double energy = system.energy(coefficients);
  if (parts.size() == 1 && plan_.data.is_constant(0))
    energy += system.right_hand_side.dot(coefficients);  // the load of the source, and no other
  else if (!coefficients_.source.is_constant(0))
    energy += integrate(coefficients_.source * solution.u, solution.rule);
  for (const Contribution& part : parts)
    if (part.place != Contribution::Place::volume)
      energy -= rfm::energy(part, {&solution.u, 1}, solution.rule);
  return energy;
}

ScalarSolution ScalarProblem::solve(const Grid& grid) const {
  Stopwatch quadrature;
  ScalarSolution solution{.rule = rule(grid), .u = 0.0, .flux = {}, .linear = {}, .seconds = {}};
  solution.seconds.quadrature = quadrature.seconds();
  if (misses_divergence_theorem(solution.rule))
    throw ComputationError(fmt::format(
        "the grid is too coarse for the domain: its measure {:.6g} and its boundary disagree by "
        "{:.2g} in the divergence theorem; use more cells",
        solution.rule.measure(), solution.rule.report().divergence_defect));

  Stopwatch assembly;
  const bool free_constant = fixed_up_to_constant();
  if (free_constant) check_compatible(solution.rule);
  const std::vector<std::uint8_t> cells =
      cells_in_region(solution.rule, problem_.discretization.degree);
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(grid, problem_.discretization.degree, cells)};
  const std::vector<Structure> structures{structure_};
  const std::vector<Contribution> parts = contributions(grid);
  LinearSystem system = assemble(structures, spaces, parts, solution.rule);
  if (free_constant) pin_one(system);
  solution.unknowns = spaces[0].size();
  solution.seconds.assembly = assembly.seconds();

  Stopwatch solve;
  LinearSolverOptions options;
  options.dimension = problem_.dimension;
  options.tolerance = problem_.discretization.tolerance;
  if (problem_.discretization.linear_solver == Discretization::LinearSolver::direct)
    options.method = LinearSolverOptions::Method::direct;
  solution.linear = rfm::solve(system, options);
  if (!(solution.linear.relative_residual < 1e-6))
    throw ComputationError(
        fmt::format("the system of equations could not be solved (relative residual {:.1e})",
                    solution.linear.relative_residual));
  solution.u = solution_fields(structures, spaces, solution.linear.coefficients)[0];
  solution.energy = stored_energy(system, parts, solution);
  if (free_constant) {
    solution.u = solution.u - integrate(solution.u, solution.rule) / solution.rule.measure();
    solution.mean_set_to_zero = true;
  }
  solution.seconds.solve = solve.seconds();

  solution.flux = conductive_flux(coefficients_, solution.u, problem_.dimension);
  for (const PieceCondition& condition : conditions_) {
    if (condition.kind != Condition::Kind::value) continue;
    Field residual = solution.u - condition.data[0];
    if (condition.where) residual = select(step(*condition.where), residual, 0.0);
    solution.boundary_residual = std::max(
        solution.boundary_residual,
        maximum(residual, solution.rule, {Contribution::Place::boundary, {condition.primitive}}));
  }
  return solution;
}

}  // namespace rfm
