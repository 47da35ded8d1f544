#include "core/boolean.hpp"

#include <gmock/gmock.h>

#include <array>
#include <functional>
#include <random>

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;
constexpr int variables = 5;
constexpr int rows = 1 << variables;

// A random expression beside its truth table, computed directly: bit r of `table` is the value when
// variable v is bit v of r.
struct Pair {
  BooleanExpression expression;
  std::uint32_t table;
};

Pair leaf(int v) {
  std::uint32_t table = 0;
  for (int row = 0; row < rows; ++row) table |= static_cast<std::uint32_t>(row >> v & 1) << row;
  return {BooleanExpression::variable(v), table};
}

Pair random_pair(std::mt19937& generator, int depth) {
  if (depth == 0) {
    if (generator() % 8 == 0) {
      const bool value = generator() % 2;
      return {BooleanExpression::constant(value), value ? ~0u : 0u};
    }
    return leaf(static_cast<int>(generator() % variables));
  }
  const Pair a = random_pair(generator, depth - 1), b = random_pair(generator, depth - 1);
  switch (generator() % 4) {
    case 0:
      return {a.expression & b.expression, a.table & b.table};
    case 1:
      return {a.expression | b.expression, a.table | b.table};
    case 2:
      return {a.expression ^ b.expression, a.table ^ b.table};
    default:
      return {!a.expression, ~a.table};
  }
}

std::array<bool, variables> assignment(int row) {
  std::array<bool, variables> values;
  for (int v = 0; v < variables; ++v) values[v] = row >> v & 1;
  return values;
}

std::uint32_t table_of(const BooleanExpression& expression) {
  std::uint32_t table = 0;
  for (int row = 0; row < rows; ++row)
    table |= static_cast<std::uint32_t>(expression.evaluate(assignment(row))) << row;
  return table;
}

template <class Check>
void for_random_expressions(const Check& check) {
  std::mt19937 generator(1);
  for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i)
    check(random_pair(generator, i % 5), generator);
}

TEST(BooleanExpression, HasTheTruthTableOfItsOperators) {
  for_random_expressions(
      [](const Pair& pair, auto&) { EXPECT_EQ(table_of(pair.expression), pair.table); });
}

// All rows of the table that agree with three-valued signs.
std::vector<int> rows_of(const std::array<Truth, variables>& signs) {
  std::vector<int> list;
  for (int row = 0; row < rows; ++row) {
    bool agrees = true;
    for (int v = 0; v < variables; ++v)
      agrees = agrees && (signs[v] == Truth::unknown || (signs[v] == Truth::yes) == (row >> v & 1));
    if (agrees) list.push_back(row);
  }
  return list;
}

std::array<Truth, variables> random_signs(std::mt19937& generator) {
  std::array<Truth, variables> signs;
  for (Truth& sign : signs) sign = static_cast<Truth>(static_cast<int>(generator() % 3) - 1);
  return signs;
}

TEST(BooleanExpression, ThreeValuedLogicIsSound) {
  for_random_expressions([](const Pair& pair, std::mt19937& generator) {
    const auto signs = random_signs(generator);
    const Truth truth = pair.expression.evaluate(signs);
    for (const int row : rows_of(signs)) {
      EXPECT_TRUE(truth == Truth::unknown || (pair.table >> row & 1) == (truth == Truth::yes));
    }
  });
}

TEST(BooleanExpression, ThreeValuedLogicDecidesWhenAllSignsAreKnown) {
  for_random_expressions([](const Pair& pair, auto&) {
    for (int row = 0; row < rows; ++row) {
      std::array<Truth, variables> signs;
      for (int v = 0; v < variables; ++v) signs[v] = row >> v & 1 ? Truth::yes : Truth::no;
      EXPECT_EQ(pair.expression.evaluate(signs), pair.table >> row & 1 ? Truth::yes : Truth::no);
    }
  });
}

TEST(BooleanExpression, EveryVariableThatMattersIsMarkedRelevant) {
  for_random_expressions([](const Pair& pair, std::mt19937& generator) {
    const auto signs = random_signs(generator);
    std::array<bool, variables> relevant{};
    pair.expression.mark_relevant(signs, relevant);
    for (int v = 0; v < variables; ++v) {
      if (signs[v] != Truth::unknown) {
        EXPECT_FALSE(relevant[v]);  // its sign is known: nothing is left to find out
        continue;
      }
      for (const int row : rows_of(signs))
        EXPECT_TRUE(relevant[v] || (pair.table >> row & 1) == (pair.table >> (row ^ 1 << v) & 1));
    }
  });
}

TEST(BooleanExpression, VariablesThatCannotMatterAreNotMarked) {
  const auto a = BooleanExpression::variable(0), b = BooleanExpression::variable(1),
             c = BooleanExpression::variable(2);
  std::array<bool, 3> relevant{};
  // Where a is false, a & b is false whatever b is.
  ((a & b) | c).mark_relevant(std::array{Truth::no, Truth::unknown, Truth::unknown}, relevant);
  EXPECT_THAT(relevant, testing::ElementsAre(false, false, true));
}

TEST(BooleanExpression, RestrictionReplacesAVariableByAConstant) {
  for_random_expressions([](const Pair& pair, std::mt19937& generator) {
    const int v = static_cast<int>(generator() % variables);
    for (const bool value : {false, true}) {
      const BooleanExpression restricted = pair.expression.restricted(v, value);
      for (int row = 0; row < rows; ++row)
        EXPECT_EQ(restricted.evaluate(assignment(row)),
                  pair.table >> (value ? row | 1 << v : row & ~(1 << v)) & 1);
      for (const auto& node : restricted.nodes())
        EXPECT_FALSE(node.kind == Kind::variable && node.first == v);
    }
  });
}

TEST(BooleanExpression, RestrictionPropagatesConstants) {
  const auto a = BooleanExpression::variable(0), b = BooleanExpression::variable(1);
  EXPECT_TRUE((a & !b).restricted(1, true).is_constant(false));
  EXPECT_TRUE((a | !b).restricted(1, false).is_constant(true));
  EXPECT_EQ((a & !b).restricted(1, false).nodes().size(), 1u);
  EXPECT_FALSE((a & b).is_constant(true));
  EXPECT_FALSE((a & b).is_constant(false));
}

TEST(BooleanExpression, RenamingPermutesVariables) {
  const std::array<int, variables> cycle{1, 2, 3, 4, 0};
  for_random_expressions([&](const Pair& pair, auto&) {
    const BooleanExpression renamed = pair.expression.renamed(cycle);
    for (int row = 0; row < rows; ++row) {
      std::array<bool, variables> values;
      for (int v = 0; v < variables; ++v) values[cycle[v]] = row >> v & 1;
      EXPECT_EQ(renamed.evaluate(values), pair.table >> row & 1);
    }
  });
}

TEST(BooleanExpression, NegationsArePushedToTheLeaves) {
  for_random_expressions([](const Pair& pair, auto&) {
    const BooleanExpression normal = pair.expression.negations_at_leaves();
    EXPECT_EQ(table_of(normal), pair.table);
    for (const auto& node : normal.nodes())
      EXPECT_TRUE(node.kind != Kind::negation || normal.nodes()[node.first].kind == Kind::variable);
  });
}

TEST(BooleanExpression, CountsVariablesByTheLargest) {
  EXPECT_EQ((BooleanExpression::variable(1) & BooleanExpression::variable(4)).variable_count(), 5);
  EXPECT_EQ(BooleanExpression::constant(true).variable_count(), 0);
}

TEST(BooleanExpression, DoubleNegationVanishes) {
  const auto a = BooleanExpression::variable(0);
  EXPECT_EQ((!!a).nodes().size(), 1u);
  EXPECT_TRUE((!BooleanExpression::constant(true)).is_constant(false));
}

TEST(BooleanExpression, LargeExpressionsAreEvaluatedToo) {
  // More nodes than fit on the stack.
  BooleanExpression any = BooleanExpression::variable(0);
  for (int v = 1; v < 300; ++v) any = any | BooleanExpression::variable(v);
  std::vector<Truth> signs(300, Truth::no);
  EXPECT_EQ(any.evaluate(signs), Truth::no);
  signs[287] = Truth::unknown;
  EXPECT_EQ(any.evaluate(signs), Truth::unknown);
  std::unique_ptr<bool[]> relevant(new bool[300]());
  any.mark_relevant(signs, {relevant.get(), 300});
  EXPECT_TRUE(relevant[287]);
  EXPECT_FALSE(relevant[286]);
}

}  // namespace
}  // namespace rfm
