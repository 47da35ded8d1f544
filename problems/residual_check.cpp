#include "problems/residual_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "solvers/form_symbols.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

double size_of(const Field& residual, std::span<const Field> components, const DomainRule& rule) {
  return std::sqrt(integrate(pow(with_solution(residual, components), 2), rule));
}

}  // namespace

void warn_of_residuals(const ScalarProblem& problem, std::span<const Field> start,
                       ScalarSolution& solution) {
  constexpr double much = 0.1;
  const auto& custom = problem.problem().physics.custom;
  if (!custom || custom->kind != CustomPhysics::Kind::residuals) return;
  std::vector<Field> components;
  for (const auto& [name, field] : solution.results.unknowns) components.push_back(field);
  for (std::size_t k = 0; k < custom->formulas.size(); ++k) try {
      const double load = size_of(custom->formulas[k], start, solution.rule),
                   left = size_of(custom->formulas[k], components, solution.rule);
      if (!(left > much * load) || !(load > 0)) continue;
      solution.notes.push_back(fmt::format(
          "warning: residual {} is left at {:.2g} of its loads: the grid is too coarse, or the "
          "equations and conditions contradict each other",
          k + 1, left / load));
    } catch (const ComputationError&) {  // not defined at the start, as a logarithm
    }
}

}  // namespace rfm
