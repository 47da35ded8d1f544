#include "problems/problem_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/boundary_piece.hpp"
#include "core/error.hpp"
#include "core/graph_walk.hpp"
#include "problems/custom_forms.hpp"
#include "problems/scalar_forms.hpp"
#include "solvers/integrate.hpp"
#include "solvers/weak_values.hpp"

namespace rfm {
namespace {

using Method = Discretization::Method;

bool uses_residuals(const Problem& problem) {
  return problem.discretization.method == Method::least_squares ||
         problem.discretization.method == Method::collocation;
}

[[noreturn]] void refuse_at(const Place& place, const std::string& message) {
  throw ProblemFileErrors({Mistake{message, place}});
}

// Whether the graph of a field holds an operation whose value jumps.
bool jumps(const Field& field) {
  return any_node(field, [](const Field& part) {
    switch (part.node().operation) {
      case Operation::step:
      case Operation::sign:
      case Operation::floor:
      case Operation::mod:
      case Operation::select:
        return true;
      default:
        return false;
    }
  });
}

// Residuals in cells do not see that fluxes go on across a jump of the conductivity.
void require_continuous_conductivity(const ScalarProblem& problem) {
  if (std::ranges::none_of(problem.coefficients().conductivity, jumps)) return;
  const DocumentNode& root = problem.problem().document;
  const DocumentNode* discretization = root.find("discretization");
  const DocumentNode* method = discretization ? discretization->find("method") : nullptr;
  refuse_at(method ? method->place : root.place,
            "least squares and collocation need a conductivity without jumps: residuals do not "
            "see the flux across them; expected ritz or galerkin");
}

// An interface leaves the slope free to jump; how much it does, the flux across it tells.
void require_no_interfaces(const Problem& problem) {
  const StructureOptions options = structure_options(problem);
  if (options.interfaces.empty()) return;
  refuse_at(options.interfaces[0].place,
            "least squares and collocation do not go with interfaces: residuals do not see the "
            "flux across them; expected ritz or galerkin");
}

// The highest order of derivatives of an unknown in equations.
int order_in(const std::vector<Form>& forms, int component) {
  int order = 0;
  for (const Form& form : forms)
    for (const SymbolSlot& slot : form.slots())
      if (slot.slot.component == component) order = std::max(order, degree(slot.slot.derivative));
  return order;
}

// Splines of degree p have p derivatives that are integrable, and lose all orders beyond.
[[noreturn]] void refuse_degree(const Problem& problem, int component, int order,
                                const Structure::Term& term, int degree) {
  const std::string& name = problem.physics.unknowns[component];
  const DocumentNode* node = &problem.document;
  for (const char* key : {"discretization", "basis", "degrees"})
    if (const DocumentNode* inner = node->find(key)) node = inner;
  const int in_structure = rfm::degree(term.derivative);
  if (in_structure == 0)
    refuse_at(node->place,
              fmt::format("splines of degree {} have no derivatives of order {}, which the "
                          "equations contain{}; expected a degree of {} or more",
                          degree, order,
                          problem.discretization.degrees.contains(name) ? " of '" + name + "'" : "",
                          order));
  refuse_at(node->place,
            fmt::format("splines of degree {} have no derivatives of order {}: the structure of "
                        "'{}' contains those of order {}, and the equations those of '{}' of order "
                        "{}; expected a degree of {} or more",
                        degree, order + in_structure, name, in_structure, name, order,
                        order + in_structure));
}

// Whether a form depends on an unknown, and not by a part that is multiplied by zero; what is not
// linear is not looked into.
bool contains(const Form& form, int component, int dimension) {
  const auto of_role = [&](bool test) {
    std::vector<Slot> slots;
    for (const SymbolSlot& slot : form.slots())
      if ((slot.role == SymbolRole::test) == test) slots.push_back(slot.slot);
    return slots;
  };
  for (const Slot& slot : of_role(false)) {
    if (slot.component != component) continue;
    if (!form.is_linear()) return true;
    if (form.kind() != Form::Kind::weak && !form.residual(slot, dimension).is_constant(0))
      return true;
    for (const Slot& test : of_role(true))
      if (!form.tangent(test, slot, dimension).is_constant(0)) return true;
  }
  return false;
}

// What no equation contains, or no equation is for, nothing determines.
void require_every_unknown(const Problem& problem, const std::vector<Form>& forms) {
  const DocumentNode* physics = problem.document.find("physics");
  const DocumentNode* names = physics ? physics->find("unknowns") : nullptr;
  const bool is_weak = problem.physics.custom->kind == CustomPhysics::Kind::weak;
  for (std::size_t c = 0; c < problem.physics.unknowns.size(); ++c) {
    const int component = static_cast<int>(c);
    const bool is_contained = std::ranges::any_of(
        forms, [&](const Form& form) { return contains(form, component, problem.dimension); });
    const bool is_tested = std::ranges::any_of(forms, [&](const Form& form) {
      return std::ranges::any_of(form.slots(), [&](const SymbolSlot& slot) {
        return slot.slot.component == component && slot.role == SymbolRole::test;
      });
    });
    const std::string& name = problem.physics.unknowns[c];
    const Place& place =
        names && c < names->items.size() ? names->items[c].place : problem.physics.custom->place;
    if (!is_contained)
      refuse_at(place, "no equation contains '" + name + "': nothing determines it");
    if (is_weak && !is_tested)
      refuse_at(place, "no part of the weak form has test(" + name +
                           ") or its derivatives: there are fewer equations than unknowns");
  }
}

// What is differentiated may not jump: residuals in cells do not see what it does at the jump.
void require_continuous_coefficients(const Problem& problem, const std::vector<Form>& forms) {
  if (problem.physics.custom->kind != CustomPhysics::Kind::residuals) return;
  Field some = 1.0;  // no slot is zero in it
  for (int axis = 0; axis < problem.dimension; ++axis)
    some = some + exp((axis + 1) * coordinate(axis));
  const std::vector<Field> state(problem.physics.unknowns.size(), some);
  for (const Form& form : forms)
    for (const Form::ResidualRow& row : form.residual_rows(state))
      for (const auto& [slot, slope] : row.slopes)
        if (degree(slot.derivative) >= 2 && jumps(slope))
          refuse_at(problem.physics.custom->place,
                    "the coefficients of second and higher derivatives in residuals must not jump: "
                    "residuals do not see the flux across jumps (of materials, if or step); "
                    "expected energy or weak");
}

// Residuals at points are brought down at once.
void require_one_stop(const Problem& problem) {
  const Discretization& discretization = problem.discretization;
  if (discretization.method != Method::collocation &&
      !(discretization.method == Method::least_squares &&
        discretization.factorization == Discretization::Factorization::qr))
    return;
  for (const char* key : {"load_steps", "continuation"}) {
    const DocumentNode* node = &problem.document;
    for (const char* step : {"discretization", "solver", key})
      if (node) node = node->find(step);
    if (node && (std::string_view(key) == "continuation" || discretization.load_steps > 1))
      refuse_at(node->place,
                fmt::format("{} is for Newton's method by ritz, galerkin and least squares with "
                            "normal equations, not for residuals at points (collocation, qr)",
                            key));
  }
}

std::vector<Form> scalar_forms(const ScalarProblem& problem, double h) {
  const int dimension = problem.problem().dimension;
  const bool residuals = uses_residuals(problem.problem());
  if (residuals) require_continuous_conductivity(problem);
  std::vector<Form> list{volume_form(problem.coefficients(), dimension, residuals)};
  for (const PieceCondition& condition : problem.conditions()) {
    // The residual of what the structure satisfies is nothing.
    if (residuals && condition.enforcement == Condition::Enforcement::structure) continue;
    for (Form& natural :
         natural_forms(condition, problem.coefficients(),
                       outward_normal(condition.primitive, problem.region()), residuals, h))
      list.push_back(std::move(natural));
  }
  return list;
}

Form weak_value(const ScalarProblem& problem, const PieceCondition& condition, const Form& volume,
                double h) {
  const std::vector<Field> normal = outward_normal(condition.primitive, problem.region());
  if (volume.kind() == Form::Kind::least_squares && !problem.problem().physics.custom)
    return value_residual(condition, problem.coefficients(), normal, h);
  const double degree = problem.problem().discretization.degree;
  try {
    return weak_values(volume, condition.component, condition.data[0], normal,
                       20 * degree * degree / h, form_place(condition));
  } catch (const InvalidArgument& error) {
    refuse_at(problem.problem().conditions[condition.condition].place,
              fmt::format("the value at '{}' cannot be enforced weakly: {}", condition.name,
                          error.what()));
  }
}

// The size of a cell; of functions of the whole domain, Nitsche's method has the degree beside the
// size of the domain, and weights of residuals have the size by the degree.
double cell_size(const Problem& problem, const Grid& grid) {
  const Discretization& discretization = problem.discretization;
  const bool global = discretization.basis != Discretization::Basis::bspline;
  double h = INFINITY;
  for (int axis = 0; axis < grid.dimension(); ++axis)
    h = std::min(h, global ? grid.box().length(axis) : grid.smallest_width(axis));
  return global && uses_residuals(problem) ? h / std::max(1, discretization.degree) : h;
}

double integral_of_energy(const Form& form, const std::vector<Field>& fields,
                          const DomainRule& rule) {
  Field density = form.density(fields);
  if (form.place().where) density = select(step(*form.place().where), density, 0.0);
  return integrate(density, rule, {form.place().place, form.place().numbers});
}

}  // namespace

bool uses_forms(const ScalarProblem& problem) {
  const Problem& file = problem.problem();
  if (file.physics.custom || file.discretization.method != Method::ritz ||
      !problem.coefficients().advection.empty() || depend_on_solution(problem.coefficients()))
    return true;
  return std::ranges::any_of(problem.conditions(), [](const PieceCondition& condition) {
    return condition.kind == Condition::Kind::oblique ||
           std::ranges::any_of(condition.data, has_symbols);
  });
}

int function_degree(const ScalarProblem& problem, int function) {
  const Discretization& discretization = problem.problem().discretization;
  const int unknowns = problem.unknown_count();
  for (const Window& window : problem.windows())
    if (function >= window.function && function < window.function + unknowns)
      return window.option.degree.value_or(function_degree(problem, function - window.function));
  if (function >= unknowns) return discretization.degree;
  const auto own = discretization.degrees.find(problem.problem().physics.unknowns[function]);
  return own == discretization.degrees.end() ? discretization.degree : own->second;
}

void require_degrees(const ScalarProblem& problem, const Grid& grid,
                     const std::vector<int>& orders) {
  if (problem.problem().discretization.basis != Discretization::Basis::bspline) return;
  const std::vector<Structure> structures = problem.structures(grid);
  for (int c = 0; c < problem.unknown_count(); ++c)
    for (const Structure::Term& term : structures[c].terms()) {
      const int degree = function_degree(problem, term.unknown);
      if (orders[c] + rfm::degree(term.derivative) > degree)
        refuse_degree(problem.problem(), c, orders[c], term, degree);
    }
}

std::vector<Form> problem_forms(const ScalarProblem& problem, const Grid& grid) {
  const double h = cell_size(problem.problem(), grid);
  std::vector<Form> list =
      problem.problem().physics.custom
          ? custom_forms(problem.problem(), problem.region(), problem.bounding_primitives())
          : scalar_forms(problem, h);
  std::vector<int> orders;
  for (int c = 0; c < problem.unknown_count(); ++c) orders.push_back(order_in(list, c));
  require_degrees(problem, grid, orders);
  if (problem.problem().physics.custom) {
    require_every_unknown(problem.problem(), list);
    require_continuous_coefficients(problem.problem(), list);
  }
  for (const DirichletPlan& plan : problem.dirichlet())
    for (const PieceCondition& condition : plan.weakly)
      list.push_back(weak_value(problem, condition, list[0], h));
  return list;
}

std::optional<double> energy_of_forms(const ScalarProblem& problem,
                                      const ScalarSolution& solution) {
  std::vector<Field> fields;
  for (const auto& [name, field] : solution.results.unknowns) fields.push_back(field);
  if (const auto& custom = problem.problem().physics.custom) {
    if (custom->kind != CustomPhysics::Kind::energy) return std::nullopt;
    double sum = 0;
    for (const Form& form :
         custom_forms(problem.problem(), problem.region(), problem.bounding_primitives(), false))
      sum += integral_of_energy(form, fields, solution.rule);
    return sum;
  }
  const int dimension = problem.problem().dimension;
  const Field& u = fields[0];
  Field density = product_or_nothing(problem.coefficients().reaction, u * u);
  const std::vector<Field> flux = conductive_flux(problem.coefficients(), u, dimension);
  for (int axis = 0; axis < dimension; ++axis) density = density + flux[axis] * partial(u, axis);
  return 0.5 * integrate(with_solution(density, fields), solution.rule);
}

void check_method(const Problem& problem) {
  require_one_stop(problem);
  if (uses_residuals(problem)) require_no_interfaces(problem);
  if (!problem.physics.custom) return;
  const CustomPhysics& custom = *problem.physics.custom;
  const bool has_residuals = custom.kind == CustomPhysics::Kind::residuals;
  if (has_residuals && custom.formulas.size() < problem.physics.unknowns.size()) {
    const DocumentNode* physics = problem.document.find("physics");
    const DocumentNode* residuals = physics ? physics->find("residuals") : nullptr;
    refuse_at(residuals ? residuals->place : custom.place,
              fmt::format("{} unknowns need as many residuals or more: {} given",
                          problem.physics.unknowns.size(), custom.formulas.size()));
  }
  if (uses_residuals(problem) && !has_residuals)
    refuse_at(custom.place,
              "least squares and collocation need `residuals`: no energy or weak form tells them");
  if (uses_residuals(problem))
    for (const CustomPhysics::BoundaryForm& form : custom.boundary)
      if (form.kind != CustomPhysics::Kind::residuals)
        refuse_at(form.place,
                  "least squares and collocation need a `residual` on the boundary, too");
  if (problem.discretization.method == Method::galerkin && has_residuals)
    refuse_at(
        custom.place,
        "residuals are solved by least squares or collocation; Galerkin's method needs `weak`");
}

}  // namespace rfm
