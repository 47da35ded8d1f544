#include "problems/solution_jumps.hpp"

#include <algorithm>

#include "core/graph_walk.hpp"
#include "solvers/form_symbols.hpp"

namespace rfm {

bool jumps_with_symbols(const Field& formula) {
  return any_node(formula, [](const Field& part) {
    switch (part.node().operation) {
      case Operation::abs:
      case Operation::sign:
      case Operation::min:
      case Operation::max:
      case Operation::step:
      case Operation::floor:
      case Operation::mod:
      case Operation::less:
      case Operation::less_equal:
      case Operation::equal:
      case Operation::select:
        return std::ranges::any_of(part.node().arguments, has_symbols);
      default:
        return false;
    }
  });
}

std::string jumps_with_solution(const ScalarProblem& problem) {
  const Problem& file = problem.problem();
  std::string text;
  const auto add = [&](const std::string& name, const Place& place) {
    const std::string entry = name + " (" + place.text() + ")";
    if (text.find(entry) == std::string::npos) text += (text.empty() ? "" : ", ") + entry;
  };
  for (const auto& [name, coefficient] : file.physics.coefficients)
    if (std::ranges::any_of(coefficient.entries, jumps_with_symbols)) add(name, coefficient.place);
  for (const Material& material : file.physics.materials)
    for (const auto& [name, coefficient] : material.coefficients)
      if (std::ranges::any_of(coefficient.entries, jumps_with_symbols))
        add(name, coefficient.place);
  if (const auto& custom = file.physics.custom) {
    const DocumentNode* physics = file.document.find("physics");
    for (const char* key : {"energy", "weak", "residuals"})
      if (const DocumentNode* node = physics ? physics->find(key) : nullptr)
        if (std::ranges::any_of(custom->formulas, jumps_with_symbols)) add(key, node->place);
  }
  for (const PieceCondition& condition : problem.conditions())
    if (std::ranges::any_of(condition.data, jumps_with_symbols))
      add("condition at '" + condition.name + "'", file.conditions[condition.condition].place);
  return text;
}

}  // namespace rfm
