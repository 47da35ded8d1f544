#include "problems/user_structure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/tape.hpp"
#include "solution_structures/structure_text.hpp"
#include "solution_structures/verification.hpp"

namespace rfm {
namespace {

constexpr int most_functions = 9;  // psi1 to psi9

const DocumentNode* structure_node(const Problem& problem) {
  const DocumentNode* discretization = problem.document.find("discretization");
  return discretization ? discretization->find("structure") : nullptr;
}

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

// The points of a rule that a condition is about.
std::vector<Point> points_of(const PieceCondition& condition, const DomainRule& rule) {
  const Tape where({condition.where.value_or(1.0)}, {0}, rule.dimension());
  const SurfacePoints& all = rule.boundary().points;
  std::vector<Point> points;
  for (int i = 0; i < all.size(); ++i)
    if (all.numbers[i] == condition.primitive && where.value(all.point(i)) >= 0)
      points.push_back(all.point(i));
  return points;
}

}  // namespace

std::optional<UserStructure> user_structure(const Problem& problem) {
  const DocumentNode* node = structure_node(problem);
  if (!node) return std::nullopt;
  if (problem.physics.unknowns.size() > 1)
    refuse("a structure of one's own is for problems of one unknown", node->place);
  try {
    const Expression text(node->text);
    ExpressionScope scope = problem.scope;
    define_structures(scope, problem.dimension, text.uses("psi") ? 1 : most_functions);
    return UserStructure{node->text, to_structure(text, scope)};
  } catch (const InputError& mistake) {
    refuse(mistake.what(), node->place_within(mistake.offset, mistake.length));
  }
}

void require_values(const UserStructure& user, const std::vector<PieceCondition>& conditions,
                    const Problem& problem, const DomainRule& rule) {
  const BoundaryOperator value = [](const std::vector<Field>& u) { return u[0]; };
  const StructureTrials trials{.dimension = problem.dimension, .count = 2};
  for (const PieceCondition& condition : conditions) {
    if (condition.kind != Condition::Kind::value ||
        condition.enforcement == Condition::Enforcement::weak)
      continue;
    const std::vector<Point> points = points_of(condition, rule);
    if (points.empty()) continue;
    const StructureDeviation deviation =
        largest_deviation({user.structure}, value, condition.data[0], points, trials);
    // The functions are of the order of 10.
    if (deviation.largest < 1e-6) continue;
    refuse(
        fmt::format("this structure does not take the value on '{}': it is {:.3g} off at ({:.4g}, "
                    "{:.4g}{}) for an arbitrary psi",
                    condition.name, deviation.largest, deviation.place[0], deviation.place[1],
                    problem.dimension > 2 ? fmt::format(", {:.4g}", deviation.place[2]) : ""),
        structure_node(problem)->place);
  }
}

}  // namespace rfm
