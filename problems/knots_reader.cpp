#include "problems/knots_reader.hpp"

#include <algorithm>

namespace rfm {
namespace {

std::optional<AxisKnots> read_axis(const DocumentNode& node, ValueReader& values) {
  AxisKnots knots;
  knots.place = node.place;
  if (!node.entries.empty()) {
    if (const DocumentNode* toward = values.find(node, "toward")) {
      if (toward->is_scalar()) {
        if (const auto place = values.number(*toward)) knots.grading.toward = {*place};
      } else {
        knots.grading.toward = values.numbers(*toward).value_or(std::vector<double>{});
      }
    }
    if (const DocumentNode* finer = values.find(node, "finer"))
      knots.grading.finer = values.number(*finer).value_or(knots.grading.finer);
    if (const DocumentNode* within = values.find(node, "within"))
      knots.within = values.number(*within);
    return knots;
  }
  const auto lines = values.numbers(node);
  if (!lines) return std::nullopt;
  if (lines->size() < 2 ||
      std::ranges::adjacent_find(*lines, std::greater_equal<>()) != lines->end()) {
    values.mistakes.add("expected two knots or more, each greater than the one before", node.place);
    return std::nullopt;
  }
  knots.lines = *lines;
  return knots;
}

}  // namespace

void read_knots(const DocumentNode& basis, ValueReader& values, Discretization& result) {
  const DocumentNode* map = values.find(basis, "knots");
  if (!map) return;
  constexpr const char* names[] = {"x", "y", "z"};
  for (int axis = 0; axis < values.dimension; ++axis) {
    const DocumentNode* node = values.find(*map, names[axis]);
    if (!node) continue;
    const auto knots = result.knots[axis] = read_axis(*node, values);
    if (knots && !knots->lines.empty() && result.grid &&
        (knots->lines.front() != result.grid->low[axis] ||
         knots->lines.back() != result.grid->high[axis]))
      values.mistakes.add("the first and last knots are not the sides of `grid`", node->place);
  }
}

}  // namespace rfm
