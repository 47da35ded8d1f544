#include "problems/scalar_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.hpp"
#include "problems/defined_regions.hpp"
#include "problems/holes.hpp"
#include "problems/partial_coverage.hpp"
#include "problems/problem_forms.hpp"
#include "solvers/integrate.hpp"

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

// Volumes, stiffness and energies are powers of lengths, which have to be numbers themselves.
void check_size(const Problem& problem, const Box& box) {
  constexpr double least = 1e-50, most = 1e50;
  const double size = box.longest_side();
  double farthest = 0;
  for (int axis = 0; axis < box.dimension; ++axis)
    farthest = std::max({farthest, std::fabs(box.low[axis]), std::fabs(box.high[axis])});
  if ((size > 0 && size < least) || farthest > most)
    refuse(fmt::format("the domain is {:.3g} long and reaches to {:.3g}: lengths are numbers from "
                       "{:.0e} to {:.0e}; take another unit",
                       size, farthest, least, most),
           domain_place(problem));
}

BoundingBox problem_bounds(const Problem& problem, const RegionEvaluator& region) {
  if (problem.bounds) {
    check_size(problem, *problem.bounds);
    return {*problem.bounds};
  }
  if (region.region().enclosure()) check_size(problem, *region.region().enclosure());
  try {
    const BoundingBox found = bounding_box_and_excess(region);
    check_size(problem, found.box);
    return found;
  } catch (const InvalidArgument& error) {
    const bool empty = std::string(error.what()).find("empty") != std::string::npos;
    refuse(empty ? "the domain is empty"
                 : fmt::format("{}; give geometry.bounds: {{min: [..], max: [..]}}", error.what()),
           domain_place(problem));
  }
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

// Whether the domain itself, whatever bounds its file gives, lies in a box.
bool lies_within(const Box& box, const RegionEvaluator& region) {
  try {
    return contains(box, bounding_box(region));
  } catch (const InvalidArgument&) {
    return false;
  }
}

// Gauss points per cell for functions of the whole domain (problems/problem_grid.cpp).
constexpr int global_points = 8;
// Beyond the degree, for structures with further functions. With three the errors of what corrects
// fluxes near the boundary stop falling at 10⁻⁷, with five they do not.
constexpr int corrected_points = 5;

}  // namespace

std::string bounds_note(const ScalarProblem& problem) {
  const double excess = problem.bounds_excess();
  if (!(excess > 1e-9 * problem.bounds().longest_side())) return "";
  return fmt::format(
      "the box around the domain is up to {:.1e} larger than it; geometry.bounds "
      "gives an exact one",
      excess);
}

ScalarProblem::ScalarProblem(const Problem& problem)
    : problem_(problem),
      region_(*problem.domain),
      interfaces_(problem),
      coefficients_(problem.physics.custom ? ScalarCoefficients{} : scalar_coefficients(problem)) {
  const BoundingBox found = problem_bounds(problem, region_);
  bounds_ = found.box;
  bounds_excess_ = found.excess;
  check_method(problem);
  if (problem.study.type == Study::Type::eigen) check_modes();
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
  check_regions_are_defined(problem, region_, probe);
  conditions_ = piece_conditions(problem, region_, bounding_primitives_, probe);
  check_within_grid(probe);
  if (interpolates()) {
    plan_interpolation();
    return;
  }
  check_parts(problem, region_, bounding_primitives_, probe);
  check_materials(problem, probe);
  if (!problem.physics.custom && !is_isotropic(coefficients_, problem.dimension)) check_no_robin();
  check_directions(probe);
  irregularities_ = rfm::irregularities(region_, bounds_);
  plan_values(probe);
  plan_periodic(probe);
  check_windows();
}

bool ScalarProblem::has_irregular_weight() const {
  return std::ranges::any_of(plans_, [](const DirichletPlan& plan) {
    return !plan.by_structure.empty() && plan.own_structure.empty() && !plan.uses_regular_form;
  });
}

// Pieces of the boundary are missing or unresolved.
bool ScalarProblem::misses_divergence_theorem(const DomainRule& rule) {
  return rule.report().divergence_defect > 1e-2 * rule.measure();
}

void ScalarProblem::check_within_grid(const DomainRule& rule) const {
  // A domain that is cut off by the box has a boundary without points: the divergence theorem
  // fails. So it may for a thin body on this coarse rule, too; the bounds that the program finds
  // tell the two apart.
  if (!misses_divergence_theorem(rule)) return;
  const Grid box = grid();
  if (problem_.bounds ? lies_within(box.box(), region_) : contains(box.box(), bounds_)) return;
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

void ScalarProblem::check_modes() const {
  using Method = Discretization::Method;
  const Method method = problem_.discretization.method;
  if (problem_.physics.custom && problem_.physics.coefficients.contains("mass") &&
      method == Method::ritz)
    return;  // whether its energy is quadratic, its forms tell
  if (problem_.physics.custom && problem_.physics.coefficients.contains("mass"))
    refuse("modes of an energy are found by Ritz's method: expected discretization.method: ritz",
           problem_.physics.custom->place);
  if (problem_.physics.custom || depend_on_solution(coefficients_) ||
      !coefficients_.advection.empty() || method == Method::least_squares ||
      method == Method::collocation)
    refuse("modes are those of a quadratic energy and a mass",
           problem_.physics.custom ? problem_.physics.custom->place : problem_.document.place);
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

void ScalarProblem::plan_periodic(const DomainRule& probe) {
  periodic_ = periodic_pairs(problem_, region_.region(), probe);
  if (periodic_.empty()) return;
  const Place& place = periodic_[0].place;
  const Discretization& discretization = problem_.discretization;
  if (has_global_functions() || discretization.extension || !grid().is_uniform() || must_use_qr() ||
      discretization.method == Discretization::Method::collocation)
    refuse(
        "splines are periodic on equal cells, by the methods of Ritz and Galerkin and by least "
        "squares with normal equations",
        place);
  check_periodic(structures(probe.grid()), periodic_, probe);
  // What is to hold there holds of every function: no residual says more.
  for (PieceCondition& condition : conditions_)
    for (const PeriodicPair& pair : periodic_)
      if (condition.primitive == pair.first || condition.primitive == pair.second)
        condition.enforcement = Condition::Enforcement::structure;
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
  // What corrects a structure near the boundary or in a window is far from a polynomial in cells.
  const bool corrected = function_count() > unknown_count();
  options.inside_points =
      order.value_or(global ? global_points : degree + (corrected ? corrected_points : 1));
  options.cut_points =
      order.value_or(global ? global_points + 2 : degree + (corrected ? corrected_points : 3));
  options.gradings = problem_.discretization.gradings;
  std::ranges::copy(natural_gradings(natural_, region_, bounds_),
                    std::back_inserter(options.gradings));
  options.inside_points += more_points;
  options.cut_points += more_points;
  return make_domain_rule(region, common_grid(grid, windows_), options, interfaces_.all());
}

DomainRule ScalarProblem::collocation_rule(const Grid& grid) const {
  QuadratureOptions options;
  const int further = function_count() > unknown_count() ? 2 : 0;
  options.inside_points = std::max(2, problem_.discretization.degree - 1) + further;
  options.cut_points = std::max(2, problem_.discretization.degree) + further;
  options.gradings = problem_.discretization.gradings;
  return make_domain_rule(region_, grid, options, interfaces_.all());
}

}  // namespace rfm
