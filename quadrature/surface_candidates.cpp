#include "quadrature/surface_candidates.hpp"

#include <memory>
#include <numeric>

namespace rfm {
namespace {

// What is nowhere positive is zero at most on a set of no measure, which no rule sees.
Truth sign_of(const LevelFunction& level, const Interval& value) {
  if (value.low >= 0) return Truth::yes;
  return value.high < 0 || level.range().high <= 0 ? Truth::no : Truth::unknown;
}

}  // namespace

SurfaceCandidates::SurfaceCandidates(const RegionEvaluator& region,
                                     std::span<const LevelFunction> interface_levels)
    : signs(region.primitive_count(), Truth::unknown),
      primitives(region.primitive_count()),
      interfaces(interface_levels.size()) {
  std::iota(primitives.begin(), primitives.end(), 0);
  std::iota(interfaces.begin(), interfaces.end(), 0);
}

Truth SurfaceCandidates::narrow(const Box& box, bool tight, const RegionEvaluator& region,
                                std::span<const LevelFunction> interface_levels) {
  const auto sign_in_box = [&](const LevelFunction& level) {
    return sign_of(level, tight ? level.bounds(box).value : level.value_bounds(box));
  };
  for (const int k : primitives) signs[k] = sign_in_box(region.level(k));
  const BooleanExpression& expression = region.region().expression();
  const Truth inside = expression.evaluate(std::span<const Truth>(signs));
  if (inside == Truth::unknown) {
    // Not std::vector<bool>: the marks are a span of bool.
    const auto relevant = std::make_unique<bool[]>(signs.size());
    expression.mark_relevant(signs, std::span(relevant.get(), signs.size()));
    std::erase_if(primitives, [&](int k) { return signs[k] != Truth::unknown || !relevant[k]; });
  } else {
    primitives.clear();
  }
  std::erase_if(interfaces, [&](int k) {
    return inside == Truth::no || sign_in_box(interface_levels[k]) != Truth::unknown;
  });
  return inside;
}

TruthTable SurfaceCandidates::make_table(const BooleanExpression& expression) {
  TruthTable table(expression, primitives, signs);
  for (int v = 0; v < table.variable_count();) {
    if (table.depends_on(v)) {
      ++v;
      continue;
    }
    table.fix(v, false);
    primitives.erase(primitives.begin() + v);
  }
  return table;
}

}  // namespace rfm
