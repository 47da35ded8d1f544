#include "core/regular_form.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/boolean_simplification.hpp"
#include "core/regularity.hpp"
#include "core/same_solid.hpp"
#include "core/set_description.hpp"

namespace rfm {
namespace {

constexpr int most_primitives = 16;

bool has_interior_zeros(const RegionEvaluator& region, const Box& bounds) {
  return std::ranges::any_of(irregularities(region, bounds), [](const Irregularity& found) {
    return found.kind == Irregularity::Kind::interior_zero;
  });
}

// The region with one level for sides that coincide, up to rounding: a point beside such a side is
// beside all of them, where two levels would leave a sliver between, of points that no expression
// describes. Nothing if no sides coincide.
std::optional<Region> with_common_levels(const RegionEvaluator& region, const Box& bounds) {
  auto primitives = region.region().primitives();
  bool any = false;
  for (int i = 0; i < region.primitive_count(); ++i)
    for (int j = 0; j < i; ++j) {
      const double ratio = ratio_of_multiples(region.level(i), region.level(j), bounds);
      if (ratio == 0) continue;
      Primitive common = *primitives[i];
      common.level = ratio > 0 ? primitives[j]->level : -primitives[j]->level;
      primitives[i] = std::make_shared<const Primitive>(std::move(common));
      any = true;
      break;
    }
  if (!any) return {};
  return Region(region.dimension(), std::move(primitives), region.region().expression());
}

bool has_disjunction(const BooleanExpression& expression) {
  const BooleanExpression normal = expression.negations_at_leaves();
  return std::ranges::any_of(normal.nodes(), [](const auto& node) {
    return node.kind == BooleanExpression::Kind::disjunction;
  });
}

}  // namespace

std::optional<BooleanExpression> regular_form(const RegionEvaluator& region, const Box& bounds) {
  const Region& whole = region.region();
  if (region.primitive_count() > most_primitives || !has_disjunction(whole.expression())) return {};
  const std::optional<Region> common = with_common_levels(region, bounds);
  if (!common && !has_interior_zeros(region, bounds)) return {};
  const Region& solid = common ? *common : whole;
  std::vector<Field> levels;
  for (const auto& primitive : solid.primitives()) levels.push_back(primitive->level);
  const RegionEvaluator known(solid.within(bounds));  // which size it has
  const SetDescription description(levels, solid_membership(known), bounds);
  // Of the complement a sum of products, hence of the region a product of sums: zeros of the former
  // inside the complement do no harm, and products make smooth weights.
  const SetDescription outside = description.complement();
  if (outside.conflict()) return {};
  const BooleanExpression form = formal_complement(outside.minimal_form());
  if (!same_solid(form, whole.expression(), region, bounds)) return {};
  if (has_interior_zeros(RegionEvaluator(solid.with_expression(form)), bounds)) return {};
  return form;
}

}  // namespace rfm
