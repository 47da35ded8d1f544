#include "core/regular_form.hpp"

#include <algorithm>
#include <cmath>

#include "core/boolean_simplification.hpp"
#include "core/regularity.hpp"
#include "core/set_description.hpp"

namespace rfm {
namespace {

constexpr int most_primitives = 16;

bool has_interior_zeros(const RegionEvaluator& region, const Box& bounds) {
  return std::ranges::any_of(irregularities(region, bounds), [](const Irregularity& found) {
    return found.kind == Irregularity::Kind::interior_zero;
  });
}

// Whether two primitives are multiples of each other, seen at a few points.
bool coincide(const LevelFunction& f, const LevelFunction& g, const Box& bounds) {
  const auto ratio = [&](double s) {
    Point at = bounds.low;
    for (int axis = 0; axis < bounds.dimension; ++axis)
      at[axis] += bounds.length(axis) * std::fmod(s * (axis + 1.37), 1.0);
    return f.value(at) / g.value(at);
  };
  const double first = ratio(0.217);
  if (!std::isfinite(first) || first == 0) return false;
  return std::ranges::all_of(std::array{0.381, 0.533, 0.741, 0.917}, [&](double s) {
    return std::fabs(ratio(s) - first) <= 1e-11 * std::fabs(first);
  });
}

bool any_coincide(const RegionEvaluator& region, const Box& bounds) {
  for (int i = 0; i < region.primitive_count(); ++i)
    for (int j = 0; j < i; ++j)
      if (coincide(region.level(i), region.level(j), bounds)) return true;
  return false;
}

bool has_disjunction(const BooleanExpression& expression) {
  const BooleanExpression normal = expression.negations_at_leaves();
  return std::ranges::any_of(normal.nodes(), [](const auto& node) {
    return node.kind == BooleanExpression::Kind::disjunction;
  });
}

}  // namespace

bool same_solid(const BooleanExpression& a, const BooleanExpression& b,
                const RegionEvaluator& region, const Box& bounds) {
  Box start = bounds;
  for (int axis = 0; axis < bounds.dimension; ++axis) {
    start.low[axis] -= 1.3e-3 * bounds.longest_side();
    start.high[axis] += 1.7e-3 * bounds.longest_side();
  }
  const double smallest = (bounds.dimension == 3 ? 0x1p-5 : 0x1p-8) * bounds.longest_side();
  std::vector<Truth> signs(region.primitive_count());
  std::vector<Box> pending{start};
  while (!pending.empty()) {
    const Box box = pending.back();
    pending.pop_back();
    for (int k = 0; k < region.primitive_count(); ++k) {
      const Interval range = region.level(k).value_bounds(box);
      signs[k] = range.low > 0 ? Truth::yes : range.high < 0 ? Truth::no : Truth::unknown;
    }
    const Truth first = a.evaluate(signs), second = b.evaluate(signs);
    if (first != Truth::unknown && second != Truth::unknown) {
      if (first != second) return false;
      continue;
    }
    if (box.longest_side() > smallest)
      for (const Box& half : bisect(box, box.longest_axis())) pending.push_back(half);
  }
  return true;
}

std::optional<BooleanExpression> regular_form(const RegionEvaluator& region, const Box& bounds) {
  const Region& whole = region.region();
  if (region.primitive_count() > most_primitives || !has_disjunction(whole.expression())) return {};
  if (!any_coincide(region, bounds) && !has_interior_zeros(region, bounds)) return {};
  std::vector<Field> levels;
  for (const auto& primitive : whole.primitives()) levels.push_back(primitive->level);
  const SetDescription description(levels, solid_membership(region), bounds);
  // Of the complement a sum of products, hence of the region a product of sums: zeros of the former
  // inside the complement do no harm, and products make smooth weights.
  const SetDescription outside = description.complement();
  if (outside.conflict()) return {};
  const BooleanExpression form = formal_complement(outside.minimal_form());
  if (!same_solid(form, whole.expression(), region, bounds)) return {};
  if (has_interior_zeros(RegionEvaluator(whole.with_expression(form)), bounds)) return {};
  return form;
}

}  // namespace rfm
