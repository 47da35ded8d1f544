#include "core/weight.hpp"

#include <algorithm>
#include <numeric>

#include "core/contact.hpp"
#include "core/r_functions.hpp"

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

std::string formula_of(const BooleanExpression& expression, const Region& region,
                       CombineRule rule) {
  const bool r1 = rule == CombineRule::r1;
  std::vector<std::string> built;
  for (const auto& node : expression.nodes()) {
    switch (node.kind) {
      case Kind::constant:
        built.push_back(node.first ? "1" : "-1");
        break;
      case Kind::variable:
        built.push_back("omega(" + region.primitives()[node.first]->name + ")");
        break;
      case Kind::negation:
        built.push_back("-" + built[node.first]);
        break;
      default: {
        const bool both = node.kind == Kind::conjunction;
        built.push_back((r1 ? (both ? "min(" : "max(") : (both ? "r0_and(" : "r0_or(")) +
                        built[node.first] + ", " + built[node.second] + ")");
      }
    }
  }
  return built.back();
}

// A conjunct that multiplies: a literal as its level, anything else as an R-function.
Field multiplier(const BooleanExpression& expression, const Region& region) {
  const auto& nodes = expression.nodes();
  if (nodes.back().kind == Kind::variable) return region.primitives()[nodes.back().first]->level;
  if (nodes.back().kind == Kind::negation && nodes[nodes.back().first].kind == Kind::variable)
    return -region.primitives()[nodes[nodes.back().first].first]->level;
  return implicit(expression, region);
}

// Whether a conjunct only chooses a part of the others: the weight need not vanish on it.
bool selects_only(const BooleanExpression& conjunct, const Region& region) {
  const auto& last = conjunct.nodes().back();
  return last.kind == Kind::variable && region.primitives()[last.first]->selects_only;
}

// Groups of conjuncts connected by pairs that must not multiply.
std::vector<int> groups(const std::vector<Factor>& factors, const RegionEvaluator& region,
                        const Box& bounds, CombineRule rule) {
  std::vector<int> group(factors.size());
  std::iota(group.begin(), group.end(), 0);
  if (rule == CombineRule::product) return group;
  for (std::size_t i = 0; i < factors.size(); ++i)
    for (std::size_t j = i + 1; j < factors.size(); ++j) {
      if (group[i] == group[j]) continue;
      if (contact(factors[i], factors[j], region, bounds) != Contact::obtuse) continue;
      const int from = std::max(group[i], group[j]), to = std::min(group[i], group[j]);
      std::ranges::replace(group, from, to);
    }
  return group;
}

}  // namespace

BooleanExpression simplified(const BooleanExpression& expression, const RegionEvaluator& region,
                             const Box& bounds) {
  BooleanExpression result = expression;
  for (int k = 0; k < region.primitive_count(); ++k) {
    const Interval range = region.level(k).value_bounds(bounds);
    // A primitive that is zero on a side of the bounding box may bound the region there.
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
              CombineRule rule) {
  const BooleanExpression normal = simplified(expression, region, bounds).negations_at_leaves();
  if (rule == CombineRule::r0 || rule == CombineRule::r1) {
    const RSystem system = RAlpha{rule == CombineRule::r1 ? 1.0 : 0.0};
    return {implicit(normal, region.region(), system), formula_of(normal, region.region(), rule)};
  }
  std::vector<Factor> factors;
  for (const BooleanExpression& conjunct : conjuncts(normal)) {
    if (selects_only(conjunct, region.region())) continue;
    const Factor factor = as_factor(conjunct);
    if (meets_region(factor, region, bounds)) factors.push_back(factor);
  }
  const std::vector<int> group = groups(factors, region, bounds, rule);
  Weight product{1.0, ""};
  for (std::size_t first = 0; first < factors.size(); ++first) {
    if (group[first] != static_cast<int>(first)) continue;
    BooleanExpression joined = factors[first].expression;
    bool alone = true;
    for (std::size_t other = first + 1; other < factors.size(); ++other)
      if (group[other] == static_cast<int>(first)) {
        joined = joined & factors[other].expression;
        alone = false;
      }
    product.function = product.function * (alone ? multiplier(joined, region.region())
                                                 : implicit(joined, region.region()));
    product.formula +=
        (product.formula.empty() ? "" : " * ") + formula_of(joined, region.region(), rule);
  }
  return product;
}

Weight weight(const RegionEvaluator& region, const Box& bounds, CombineRule rule) {
  return weight(region.region().expression(), region, bounds, rule);
}

}  // namespace rfm
