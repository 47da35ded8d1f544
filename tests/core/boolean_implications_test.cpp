#include "core/boolean_implications.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

#include "core/error.hpp"

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;

BooleanExpression v(int number) { return BooleanExpression::variable(number); }

std::vector<int> first_numbers(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

int leaves(const BooleanExpression& expression) {
  int count = 0;
  for (const BooleanExpression::Node& node : expression.nodes())
    count += node.kind == Kind::variable;
  return count;
}

TEST(Implications, OfHalfPlanesAlongAConvexCurveLeaveOne) {
  // The middle one holds all others in the box: v5 => v0, …
  BooleanExpression all = v(0);
  for (int i = 1; i < 12; ++i) all = all & v(i);
  Implications known(first_numbers(12));
  for (int i = 0; i < 12; ++i)
    if (i != 5) known.add(5, true, i, true);
  EXPECT_EQ(leaves(with_implications(all, known)), 1);
  EXPECT_EQ(with_implications(all, known).variable_count(), 6);
}

TEST(Implications, ReachWhatStandsBelow) {
  // v0 implies v1: in v0 & (v2 | (v1 & v3)) the second is true wherever it matters.
  Implications known(first_numbers(4));
  known.add(0, true, 1, true);
  const BooleanExpression shorter = with_implications(v(0) & (v(2) | (v(1) & v(3))), known);
  EXPECT_EQ(leaves(shorter), 3);
  // And in v1 | (v2 & (v0 | v3)), where v1 is false, so is v0.
  EXPECT_EQ(leaves(with_implications(v(1) | (v(2) & (v(0) | v(3))), known)), 3);
  EXPECT_EQ(leaves(with_implications(v(1) & v(0), known)), 1);
}

TEST(Implications, OfEqualOnesKeepOne) {
  Implications known(first_numbers(2));
  known.add(0, true, 1, true);
  known.add(1, true, 0, true);
  EXPECT_EQ(leaves(with_implications(v(0) & v(1), known)), 1);
  EXPECT_EQ(leaves(with_implications(v(0) | v(1), known)), 1);
}

TEST(Implications, ThatExcludeOrCoverMakeConstants) {
  Implications apart(first_numbers(2)), covering(first_numbers(2));
  apart.add(0, true, 1, false);
  EXPECT_TRUE(with_implications(v(0) & v(1), apart).is_constant(false));
  covering.add(0, false, 1, true);
  EXPECT_TRUE(with_implications(v(0) | v(1), covering).is_constant(true));
}

// Points are signs of variables; those are possible for which everything said of them is true.
TEST(Implications, LeaveTheValueWherePointsArePossible) {
  std::mt19937 random(3);
  const auto number = [&](int count) { return static_cast<int>(random() % count); };
  constexpr int variables = 6;
  int shorter_ones = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<BooleanExpression> parts;
    for (int i = 0; i < 14; ++i) {
      const BooleanExpression leaf = v(number(variables));
      parts.push_back(number(3) == 0 ? !leaf : leaf);
    }
    while (parts.size() > 1) {
      const BooleanExpression last = parts.back();
      parts.pop_back();
      const std::size_t k = static_cast<std::size_t>(number(static_cast<int>(parts.size())));
      parts[k] = number(2) ? parts[k] & last : parts[k] | last;
      if (number(4) == 0) parts[k] = !parts[k];
    }
    struct Rule {
      int first, second;
      bool of_first, of_second;
    };
    std::vector<Rule> rules;
    Implications known(first_numbers(variables));
    for (int i = 0; i < 4; ++i) {
      const Rule rule{number(variables), number(variables), number(2) == 1, number(2) == 1};
      if (rule.first == rule.second) continue;
      rules.push_back(rule);
      known.add(rule.first, rule.of_first, rule.second, rule.of_second);
    }
    const BooleanExpression result = with_implications(parts[0], known);
    shorter_ones += leaves(result) < leaves(parts[0]);
    for (unsigned point = 0; point < 1u << variables; ++point) {
      std::array<bool, variables> signs{};
      for (int i = 0; i < variables; ++i) signs[i] = point >> i & 1;
      const bool possible = std::ranges::all_of(rules, [&](const Rule& rule) {
        return signs[rule.first] != rule.of_first || signs[rule.second] == rule.of_second;
      });
      if (possible) {
        ASSERT_EQ(result.evaluate(std::span<const bool>(signs)),
                  parts[0].evaluate(std::span<const bool>(signs)))
            << trial;
      }
    }
  }
  EXPECT_GT(shorter_ones, 1000);
}

TEST(Implications, KeepTheNumbersOfVariablesAndThoseOfWhichNothingIsKnown) {
  const std::vector<int> numbers{7, 3};
  Implications known(numbers);
  known.add(0, true, 1, true);
  const BooleanExpression result = with_implications(v(3) & v(7) & v(5), known);
  EXPECT_EQ(leaves(result), 2);
  EXPECT_EQ(result.variable_count(), 8);
}

TEST(Implications, AreAmongSixtyFourVariables) {
  EXPECT_NO_THROW(Implications(first_numbers(64)));
  EXPECT_THROW(Implications(first_numbers(65)), InvalidArgument);
}

}  // namespace
}  // namespace rfm
