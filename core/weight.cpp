#include "core/weight.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "core/boolean_simplification.hpp"
#include "core/contact.hpp"
#include "core/error.hpp"
#include "core/expression_text.hpp"
#include "core/function_shaping.hpp"
#include "core/r_equivalence.hpp"
#include "core/r_functions.hpp"
#include "core/weight_literals.hpp"

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;

BooleanExpression subexpression(const BooleanExpression& expression, int node) {
  const auto& nodes = expression.nodes();
  switch (nodes[node].kind) {
    case Kind::constant:
      return BooleanExpression::constant(nodes[node].first != 0);
    case Kind::variable:
      return BooleanExpression::variable(nodes[node].first);
    case Kind::negation:
      return !subexpression(expression, nodes[node].first);
    case Kind::conjunction:
      return subexpression(expression, nodes[node].first) &
             subexpression(expression, nodes[node].second);
    default:
      return subexpression(expression, nodes[node].first) |
             subexpression(expression, nodes[node].second);
  }
}

// A chain of operations of one kind as a list of what it joins.
void collect(const BooleanExpression& expression, int node, Kind kind, std::vector<int>& operands) {
  const auto& nodes = expression.nodes();
  if (nodes[node].kind != kind) {
    operands.push_back(node);
    return;
  }
  collect(expression, nodes[node].first, kind, operands);
  collect(expression, nodes[node].second, kind, operands);
}

Factor as_factor(const BooleanExpression& expression) {
  Factor factor{expression, {}};
  const auto& nodes = expression.nodes();
  std::vector<bool> negated(nodes.size(), false);
  for (const auto& node : nodes)
    if (node.kind == Kind::negation) negated[node.first] = true;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].kind == Kind::variable) factor.literals.push_back({nodes[i].first, negated[i]});
  return factor;
}

// The primitive of an expression that is nothing but a literal; -1 for any other.
Factor::Literal literal_of(const BooleanExpression& expression) {
  const auto& nodes = expression.nodes();
  const auto& last = nodes.back();
  if (last.kind == Kind::variable) return {last.first, false};
  if (last.kind == Kind::negation && nodes[last.first].kind == Kind::variable)
    return {nodes[last.first].first, true};
  return {-1, false};
}

// Whether a conjunct only chooses a part of the others: the weight need not vanish on it.
bool selects_only(const BooleanExpression& conjunct, const Region& region) {
  const auto& last = conjunct.nodes().back();
  return last.kind == Kind::variable && region.primitives()[last.first]->selects_only;
}

// Two primitives with a scale for the corner where they meet.
struct ScaledCorner {
  int first = 0, second = 0;
  double scale = 1;
};

bool contains(const Factor& factor, int primitive) {
  return std::ranges::any_of(factor.literals, [&](const Factor::Literal& literal) {
    return literal.primitive == primitive;
  });
}

// Groups of conjuncts connected by pairs that must not multiply: those that meet at obtuse angles,
// and those with a scale for the corner of theirs.
std::vector<int> groups(const std::vector<Factor>& factors, SignTree& tree, bool always_multiply,
                        const std::vector<ScaledCorner>& corners) {
  std::vector<int> group(factors.size());
  std::iota(group.begin(), group.end(), 0);
  const auto must_join = [&](const Factor& a, const Factor& b) {
    const bool is_scaled = std::ranges::any_of(corners, [&](const auto& corner) {
      return (contains(a, corner.first) && contains(b, corner.second)) ||
             (contains(a, corner.second) && contains(b, corner.first));
    });
    return is_scaled || (!always_multiply && contact(a, b, tree) == Contact::obtuse);
  };
  for (std::size_t i = 0; i < factors.size(); ++i)
    for (std::size_t j = i + 1; j < factors.size(); ++j) {
      if (group[i] == group[j] || !must_join(factors[i], factors[j])) continue;
      const int from = std::max(group[i], group[j]), to = std::min(group[i], group[j]);
      std::ranges::replace(group, from, to);
    }
  return group;
}

// More factors are not all multiplied. Disks with 3, 6, 9, 12 and 24 round holes, u = 0 on all,
// cubic splines on 64 cells: the energy errs by 2e-9, 1e-8, 2e-7, 2e-6 and 4e-4 with the product,
// by 1e-9, 3e-9, 5e-8, 7e-7 and 8e-5 with R₀; at higher degrees a product of few is better.
constexpr std::size_t most_factors = 6;

// A factor of the product, and why its conjuncts are joined.
struct JoinedConjuncts {
  BooleanExpression expression;
  const char* rule = "R0-functions, a union within the shape";
};

std::vector<JoinedConjuncts> joined_conjuncts(const BooleanExpression& normal, SignTree& tree,
                                              bool always_multiply,
                                              const std::vector<ScaledCorner>& corners) {
  std::vector<Factor> factors;
  for (const BooleanExpression& conjunct : conjuncts(normal)) {
    if (selects_only(conjunct, tree.region().region())) continue;
    const Factor factor = as_factor(conjunct);
    if (meets_region(factor, tree)) factors.push_back(factor);
  }
  const std::vector<int> group = groups(factors, tree, always_multiply, corners);
  std::vector<JoinedConjuncts> result;
  for (std::size_t first = 0; first < factors.size(); ++first) {
    if (group[first] != static_cast<int>(first)) continue;
    JoinedConjuncts& joined = result.emplace_back(JoinedConjuncts{factors[first].expression});
    for (std::size_t other = first + 1; other < factors.size(); ++other)
      if (group[other] == static_cast<int>(first)) {
        joined.expression = joined.expression & factors[other].expression;
        joined.rule = "R0-functions, boundaries that meet at more than 90 degrees";
      }
  }
  // A product of many functions varies by a power of their number from cell to cell: of these,
  // those that do not meet are one R₀-function, which is smooth off its own corners.
  if (always_multiply || result.size() <= most_factors) return result;
  std::vector<JoinedConjuncts> classes;
  for (const JoinedConjuncts& joined : result) {
    const Factor factor = as_factor(joined.expression);
    const auto free = std::ranges::find_if(classes, [&](const JoinedConjuncts& other) {
      return contact(factor, as_factor(other.expression), tree) == Contact::none;
    });
    if (free == classes.end())
      classes.push_back(joined);
    else
      *free = {free->expression & joined.expression,
               "R0-functions, of many boundaries those that do not meet"};
  }
  return classes;
}

// Pairs of primitives with a scale for the corner where they meet, of those that `normal` holds.
std::vector<ScaledCorner> scaled_corners(const WeightOptions& options, const Factor& normal,
                                         const WeightLiterals& literals, SignTree& tree) {
  std::vector<ScaledCorner> corners;
  for (const CornerScale& corner : options.corner_scales) {
    if (!(corner.scale > 0))
      throw InvalidArgument("the scale of the corner of " + corner.first + " and " + corner.second +
                            " must be positive, got " + std::to_string(corner.scale));
    bool meet = false;
    for (const int a : literals.named(corner.first))
      for (const int b : literals.named(corner.second)) {
        if (a == b || may_cross_within(a, b, tree))
          throw InvalidArgument("the corner of " + corner.first + " and " + corner.second +
                                " cannot be scaled: they meet inside the region");
        if (!contains(normal, a) || !contains(normal, b)) continue;
        meet = meet || contact(as_factor(BooleanExpression::variable(a)),
                               as_factor(BooleanExpression::variable(b)), tree) != Contact::none;
        corners.push_back({a, b, corner.scale});
      }
    if (!meet)
      throw InvalidArgument("the corner of " + corner.first + " and " + corner.second +
                            " cannot be scaled: they meet nowhere on the boundary");
  }
  return corners;
}

// R-functions of normalised functions, joined by R-equivalence with the distances of the corners
// that they hold, lengths as they are. (Of a product in millimetres the larger of the two would be
// the product up to a hair's breadth from the boundary.)
void scale_corners(Weight& weight, const BooleanExpression& joined,
                   const std::vector<ScaledCorner>& corners, const Region& region) {
  const Factor factor = as_factor(joined);
  for (const auto& [a, b, scale] : corners) {
    if (!contains(factor, a) || !contains(factor, b)) continue;
    const auto& primitives = region.primitives();
    const Field distance = hypot(primitives[a]->function, primitives[b]->function);
    weight.function = equivalence(weight.function, distance / scale);
    const std::string text = "hypot(omega(" + primitives[a]->name + "), omega(" +
                             primitives[b]->name + "))/" + number_text(scale);
    weight.formula = "rp_equivalence(" + weight.formula + ", " + text + ", 2)";
    weight.parts.push_back({text, "R-equivalence with the distance from a corner",
                            "analytic but at the corner; there Lipschitz"});
  }
}

constexpr const char* of_a_shape = "as the function of the shape";

// Whether operations of a system are of another degree than their arguments: in another unit of
// length they are other functions, and of deep expressions soon zero or infinite.
bool depends_on_units(const RSystem& system) {
  return std::holds_alternative<RAlphaM>(system) || std::holds_alternative<RCm>(system);
}

// A weight of R-functions of one system throughout, in a region of this size.
Weight weight_of_system(const BooleanExpression& normal, const WeightLiterals& literals,
                        const RSystem& system, double size = 1) {
  const bool alone = literal_of(normal).primitive >= 0;
  const double unit = depends_on_units(system) && !alone ? size : 1.0;
  Weight result{literals.combined(normal, system, unit),
                literals.combined_text(normal, system, unit)};
  std::ostringstream rule;
  rule << "R-functions, " << system;
  if (alone)
    result.parts.push_back({result.formula, "the shape alone", of_a_shape});
  else
    result.parts.push_back({result.formula, rule.str(), smoothness_text(system)});
  return result;
}

// Conjuncts that meet at obtuse angles, or a single one, as one factor of the product.
Weight weight_of_group(const BooleanExpression& joined, const char* rule,
                       const WeightLiterals& literals) {
  const RSystem r0 = RAlpha{0};
  const Factor::Literal literal = literal_of(joined);
  if (literal.primitive >= 0) {
    const std::string text = literals.text(literal.primitive, literal.negated);
    return {literals.factor(literal.primitive, literal.negated),
            text,
            {{text, "the shape alone", of_a_shape}}};
  }
  const std::string text = literals.combined_text(joined, r0);
  return {literals.combined(joined, r0), text, {{text, rule, smoothness_text(r0)}}};
}

void level_off(Weight& factor, const PlateauRule& rule) {
  factor.function = plateau(factor.function, rule);
  const std::string w = number_text(rule.width), p = std::to_string(rule.power);
  factor.formula = "(1 - max(1 - " + factor.formula + "/" + w + ", 0)^" + p + ")";
  factor.parts[0].rule += ", levelled off at " + w;
  factor.parts[0].smoothness +=
      "; at the edge of the plateau " + std::to_string(rule.power - 1) + " times differentiable";
}

// What shaping does to the smoothness of every part.
void tell_of_shaping(Weight& weight, const WeightOptions& options) {
  std::string text;
  if (options.saturation && std::fmod(options.saturation->alpha, 2) != 0)
    text += "; where the function of a shape is zero " +
            number_text(std::ceil(options.saturation->alpha)) +
            " times differentiable, as it is saturated by |omega|^" +
            number_text(options.saturation->alpha);
  if (options.cap) text += "; no smoother than the cap";
  for (WeightPart& part : weight.parts) part.smoothness += text;
}

std::string reason_for_product(const CombineRule& rule) {
  return std::holds_alternative<ProductRule>(rule)
             ? "as asked"
             : "their boundaries do not meet, or at no more than 90 degrees";
}

}  // namespace

BooleanExpression simplified(const BooleanExpression& expression, const RegionEvaluator& region,
                             const Box& bounds) {
  BooleanExpression result = expression;
  // A primitive that is zero on a side of the bounding box, up to rounding, may bound the region
  // there.
  Box around = bounds;
  for (int axis = 0; axis < bounds.dimension; ++axis) {
    around.low[axis] -= 1e-12 * bounds.longest_side();
    around.high[axis] += 1e-12 * bounds.longest_side();
  }
  for (int k = 0; k < region.primitive_count(); ++k) {
    const Interval range = region.level(k).value_bounds(around);
    if (range.low > 0) result = result.restricted(k, true);
    if (range.high < 0) result = result.restricted(k, false);
  }
  return result;
}

std::vector<BooleanExpression> conjuncts(const BooleanExpression& expression) {
  std::vector<int> operands;
  collect(expression, static_cast<int>(expression.nodes().size()) - 1, Kind::conjunction, operands);
  std::vector<BooleanExpression> list;
  for (int operand : operands) list.push_back(subexpression(expression, operand));
  return list;
}

Weight weight(const BooleanExpression& expression, const RegionEvaluator& region, const Box& bounds,
              const WeightOptions& options) {
  const WeightLiterals literals(region.region(), options);
  SignTree tree(region, bounds);
  if (options.cap && may_vanish_within(LevelFunction(*options.cap, bounds.dimension), tree))
    throw InvalidArgument("the cap of a weight must be positive all over the region");
  const BooleanExpression normal = without_redundancy(simplified(expression, region, bounds));
  const auto corners = scaled_corners(options, as_factor(normal), literals, tree);
  Weight result{1.0, ""};
  if (const auto* system = std::get_if<RSystem>(&options.rule)) {
    result = weight_of_system(normal, literals, *system, bounds.longest_side());
    tell_of_shaping(result, options);
    scale_corners(result, normal, corners, region.region());
    return result;
  }
  const bool always = std::holds_alternative<ProductRule>(options.rule);
  const auto* plateau = std::get_if<PlateauRule>(&options.rule);
  const auto factors = joined_conjuncts(normal, tree, always, corners);
  for (const auto& [joined, rule] : factors) {
    Weight factor = weight_of_group(joined, rule, literals);
    tell_of_shaping(factor, options);
    scale_corners(factor, joined, corners, region.region());
    if (plateau) level_off(factor, *plateau);
    result.function = result.function * factor.function;
    result.formula += (result.formula.empty() ? "" : " * ") + factor.formula;
    result.parts.insert(result.parts.end(), factor.parts.begin(), factor.parts.end());
  }
  if (factors.size() > 1)
    result.parts.insert(result.parts.begin(), {result.formula,
                                               "product of " + std::to_string(factors.size()) +
                                                   " factors, " + reason_for_product(options.rule),
                                               "as its factors"});
  return result;
}

std::vector<Weight> normalized_factors(const BooleanExpression& expression,
                                       const RegionEvaluator& region, const Box& bounds) {
  const WeightOptions plain;
  const WeightLiterals literals(region.region(), plain);
  SignTree tree(region, bounds);
  const BooleanExpression normal = without_redundancy(simplified(expression, region, bounds));
  std::vector<Weight> factors;
  for (const JoinedConjuncts& joined : joined_conjuncts(normal, tree, false, {}))
    factors.push_back(weight_of_system(joined.expression, literals, RAlpha{0}));
  return factors;
}

Weight weight(const RegionEvaluator& region, const Box& bounds, const WeightOptions& options) {
  return weight(region.region().expression(), region, bounds, options);
}

}  // namespace rfm
