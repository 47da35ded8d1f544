#include "quadrature/surface_candidates.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include "core/boolean_implications.hpp"
#include "core/boolean_simplification.hpp"
#include "core/quadric_pencil.hpp"

namespace rfm {
namespace {

// With fewer branches a tape is not specialised.
constexpr int few_branches = 16;
// Expressions with fewer nodes are not shortened.
constexpr std::size_t few_nodes = 32;

bool is_crowded(const std::vector<int>& primitives) {
  return primitives.size() > static_cast<std::size_t>(TruthTable::max_variables) &&
         primitives.size() <= static_cast<std::size_t>(Implications::most_variables);
}

// What is nowhere positive is zero at most on a set of no measure, which no rule sees.
Truth sign_of(const LevelFunction& level, const Interval& value) {
  if (value.low >= 0) return Truth::yes;
  return value.high < 0 || level.range().high <= 0 ? Truth::no : Truth::unknown;
}

}  // namespace

SurfaceCandidates::SurfaceCandidates(const RegionEvaluator& region,
                                     const Interfaces& all_interfaces)
    : signs(region.primitive_count(), Truth::unknown),
      primitives(region.primitive_count()),
      interfaces(all_interfaces.count()) {
  std::iota(primitives.begin(), primitives.end(), 0);
  std::iota(interfaces.begin(), interfaces.end(), 0);
  for (const int k : primitives) {
    const Tape* const tape = region.level(k).tape();
    if (tape && tape->branch_count() >= few_branches) shortened.push_back({k, nullptr});
  }
}

Truth SurfaceCandidates::narrow(const Box& box, bool tight, const RegionEvaluator& region,
                                const Interfaces& all_interfaces) {
  const auto sign_by = [&](const LevelFunction& level, const auto& bounds) {
    const Interval value = tight ? bounds.bounds(box).value : bounds.value_bounds(box);
    return sign_of(level, intersection(value, level.range()));
  };
  for (const int k : primitives) {
    const LevelFunction& level = region.level(k);
    const auto special = std::ranges::find(shortened, k, &Shortened::primitive);
    const bool known = special != shortened.end() && special->tape;
    signs[k] = known ? sign_by(level, *special->tape) : sign_by(level, level);
  }
  const BooleanExpression& expression = open ? *open : region.region().expression();
  Truth inside = expression.evaluate(std::span<const Truth>(signs));
  if (inside == Truth::unknown) {
    // Not std::vector<bool>: the marks are a span of bool.
    const auto relevant = std::make_unique<bool[]>(signs.size());
    expression.mark_relevant(signs, std::span(relevant.get(), signs.size()));
    std::erase_if(primitives, [&](int k) { return signs[k] != Truth::unknown || !relevant[k]; });
    // A tree of n leaves has 2n − 1 nodes, negations and repetitions more.
    if (expression.nodes().size() > few_nodes + 6 * primitives.size())
      open = std::make_shared<BooleanExpression>(with_known_signs(expression, known_signs()));
    if (tight && is_crowded(primitives)) inside = drop_implied(box, region);
  }
  if (inside != Truth::unknown) primitives.clear();
  all_interfaces.narrow(box, inside, tight, interfaces);
  if (!tight) shorten(box, region);
  return inside;
}

void SurfaceCandidates::shorten(const Box& box, const RegionEvaluator& region) {
  constexpr int boxes_to_wait = 3;
  std::erase_if(shortened, [&](const Shortened& special) {
    return std::ranges::find(primitives, special.primitive) == primitives.end();
  });
  for (auto& [primitive, tape, wait] : shortened) {
    const Tape& known = tape ? *tape : *region.level(primitive).tape();
    if (known.branch_count() < few_branches || wait-- > 0) continue;
    auto special = std::make_shared<const Tape>(known.specialised(box));
    const bool pays = special->branch_count() <= 0.75 * known.branch_count();
    wait = pays ? 0 : boxes_to_wait;
    if (pays) tape = std::move(special);
  }
}

// Edges along a flat curve: the lines of many lie within a box however small, and each is beyond
// others wherever it matters. To bisect would not tell them apart.
Truth SurfaceCandidates::drop_implied(const Box& box, const RegionEvaluator& region) {
  const int count = static_cast<int>(primitives.size());
  Implications implications(primitives);
  bool any = false;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j) {
      const auto known = implied_signs(region.level(primitives[i]).quadric(),
                                       region.level(primitives[j]).quadric(), box);
      if (!known) continue;
      implications.add(i, known->of_f, j, known->of_g);
      any = true;
    }
  if (!any) return Truth::unknown;
  const BooleanExpression shorter = with_implications(
      with_known_signs(open ? *open : region.region().expression(), known_signs()), implications);
  if (shorter.is_constant(true)) return Truth::yes;
  if (shorter.is_constant(false)) return Truth::no;
  std::vector<bool> occurs(signs.size(), false);
  for (const BooleanExpression::Node& node : shorter.nodes())
    if (node.kind == BooleanExpression::Kind::variable) occurs[node.first] = true;
  std::erase_if(primitives, [&](int k) { return !occurs[k]; });
  open = std::make_shared<BooleanExpression>(shorter);
  return Truth::unknown;
}

std::vector<Truth> SurfaceCandidates::known_signs() const {
  std::vector<Truth> known = signs;
  for (Truth& sign : known)
    if (sign == Truth::unknown) sign = Truth::no;
  for (const int k : primitives) known[k] = Truth::unknown;
  return known;
}

TruthTable SurfaceCandidates::make_table(const BooleanExpression& expression) {
  // Of many primitives few are left: the table is that of the short expression which they are in.
  const std::vector<Truth> known = known_signs();
  constexpr std::size_t few = 16;
  TruthTable table(
      known.size() > few ? with_known_signs(open ? *open : expression, known) : expression,
      primitives, known);
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
