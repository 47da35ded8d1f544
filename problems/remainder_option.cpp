#include "problems/remainder_option.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "problems/structure_check.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

}  // namespace

std::optional<RemainderOption> remainder_option(const Problem& problem) {
  const DocumentNode* node = problem.document.find("remainder");
  if (!node) return std::nullopt;
  try {
    return RemainderOption{to_field(Expression(node->text), problem.scope), node->place};
  } catch (const InputError& mistake) {
    refuse(mistake.what(), node->place_within(mistake.offset, mistake.length));
  }
}

void check_remainder(const RemainderOption& remainder, const Problem& problem,
                     const std::vector<DirichletPlan>& plans,
                     const std::vector<Structure>& structures,
                     const ScalarCoefficients& coefficients, const DomainRule& rule,
                     const RegionEvaluator& region) {
  if (plans.size() > 1) refuse("a remainder is that of one unknown", remainder.place);
  if (plans[0].by_structure.empty())
    refuse("no value is prescribed by structure, so that nothing is multiplied by a remainder",
           remainder.place);
  if (structures[0].terms().empty())
    refuse("the remainder is 0: nothing is left to be solved", remainder.place);
  for (const PieceCondition& condition : plans[0].by_structure)
    if (const auto deviation = deviation_from(condition, structures, coefficients, rule, region);
        !is_met(deviation))
      refuse(fmt::format("the remainder does not vanish on '{}'{}: {}", condition.name,
                         condition.clamped ? ", with its slope" : "",
                         deviation_text(*deviation, problem.dimension)),
             remainder.place);
}

std::optional<std::string> remainder_note(const RemainderOption& remainder,
                                          const DomainRule& rule) {
  const Field& factor = remainder.factor;
  const double above = maximum(select(step(factor), factor, 0.0), rule),
               below = maximum(select(step(-factor), factor, 0.0), rule);
  constexpr double rounding = 1e-9;  // at points of the boundary
  if (std::min(above, below) <= rounding * std::max(above, below)) return std::nullopt;
  return "the remainder changes its sign inside the domain: where it is 0 there, u is the data, "
         "whatever the equation";
}

}  // namespace rfm
