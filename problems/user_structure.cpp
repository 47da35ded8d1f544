#include "problems/user_structure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "problems/structure_language.hpp"

namespace rfm {
namespace {

constexpr int most_functions = 64;  // as of `Structure::undetermined`

const DocumentNode* structure_node(const Problem& problem) {
  const DocumentNode* discretization = problem.document.find("discretization");
  return discretization ? discretization->find("structure") : nullptr;
}

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

UserStructure read_structure(const DocumentNode& node, const Problem& problem,
                             const CellSides& cell) {
  try {
    const Expression text(node.text);
    const bool is_alone = problem.physics.unknowns.size() == 1 && text.uses("psi");
    const ExpressionScope scope = structure_scope(problem, is_alone ? 1 : most_functions, cell);
    return UserStructure{node.text, to_structure(text, scope), node.place};
  } catch (const InputError& mistake) {
    refuse(mistake.what(), node.place_within(mistake.offset, mistake.length));
  }
}

// The same; without an undetermined function u would be what the file says, whatever its equation.
std::vector<UserStructure> with_functions(std::vector<UserStructure> structures) {
  if (std::ranges::all_of(structures,
                          [](const UserStructure& own) { return own.structure.terms().empty(); }))
    refuse("the structure contains no undetermined function: nothing is left to be solved",
           structures[0].place);
  return structures;
}

}  // namespace

std::vector<UserStructure> user_structures(const Problem& problem, const CellSides& cell) {
  const DocumentNode* node = structure_node(problem);
  if (!node) return {};
  const std::vector<std::string>& unknowns = problem.physics.unknowns;
  if (!node->is_map()) {
    if (unknowns.size() == 1) return with_functions({read_structure(*node, problem, cell)});
    refuse(fmt::format("there are several unknowns: expected {{{}: .., {}: ..}}", unknowns[0],
                       unknowns[1]),
           node->place);
  }
  for (const DocumentNode::Entry& entry : node->entries)
    if (std::ranges::find(unknowns, entry.key) == unknowns.end())
      refuse(fmt::format("unknown result '{}' in structure{}; expected: {}", entry.key,
                         did_you_mean(entry.key, unknowns), fmt::join(unknowns, ", ")),
             entry.key_place);
  std::vector<UserStructure> structures;
  for (const std::string& unknown : unknowns) {
    const DocumentNode* text = node->find(unknown);
    if (!text) refuse(fmt::format("the structure of '{}' is missing", unknown), node->place);
    structures.push_back(read_structure(*text, problem, cell));
  }
  return with_functions(std::move(structures));
}

}  // namespace rfm
