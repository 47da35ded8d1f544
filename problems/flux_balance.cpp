#include "problems/flux_balance.hpp"

#include <cmath>

#include "solvers/form_symbols.hpp"
#include "solvers/integrate.hpp"

namespace rfm {

std::optional<double> flux_imbalance(const ScalarProblem& problem, const ScalarSolution& solution) {
  if (problem.problem().physics.custom || !structure_options(problem.problem()).values.empty())
    return std::nullopt;
  const DomainRule& rule = solution.rule;
  const ScalarCoefficients& coefficients = problem.coefficients();
  const Field& u = solution.results.unknowns[0].field;
  const auto at_solution = [&](const Field& f) { return with_solution(f, {&u, 1}); };
  Coefficient flux;
  for (int axis = 0; axis < rule.dimension(); ++axis)
    flux = flux + Coefficient::normal(axis) * Coefficient(solution.results.flux[axis]);
  double sum = 0, size = 0;
  for (const int primitive : problem.bounding_primitives()) {
    const IntegrationPlace piece{Contribution::Place::boundary, {primitive}};
    sum += integrate(flux, rule, piece);
    // ∫ |q| or more: of one piece parts balance, too.
    size += std::sqrt(rule.boundary_measure(primitive) * integrate(flux * flux, rule, piece));
  }
  const Field source = at_solution(coefficients.source);
  Field rest = product_or_nothing(at_solution(coefficients.reaction), u);
  for (std::size_t axis = 0; axis < coefficients.advection.size(); ++axis)
    rest = rest + product_or_nothing(at_solution(coefficients.advection[axis]),
                                     partial(u, static_cast<int>(axis)));
  sum += integrate(source - rest, rule);
  size += integrate(abs(source), rule) + integrate(abs(rest), rule);
  // What enters also leaves.
  return size > 0 ? 2 * std::fabs(sum) / size : 0;
}

}  // namespace rfm
