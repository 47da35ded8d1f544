#include "quadrature/truth_table.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "core/error.hpp"

using namespace rfm;

namespace {

BooleanExpression variable(int number) { return BooleanExpression::variable(number); }

std::vector<int> first(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

// v0 ^ v1 ^ … depends on every variable.
BooleanExpression parity(int count) {
  BooleanExpression result = variable(0);
  for (int v = 1; v < count; ++v) result = result ^ variable(v);
  return result;
}

class EverySize : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(TruthTable, EverySize, testing::Range(1, TruthTable::max_variables + 1));

TEST_P(EverySize, ListsTheValuesOfItsExpression) {
  const int n = GetParam();
  const TruthTable table(parity(n), first(n), std::vector<Truth>(n, Truth::unknown));
  for (unsigned a = 0; a < 1u << n; ++a)
    EXPECT_EQ(table.value(a), std::popcount(a) % 2 == 1) << "assignment " << a;
  EXPECT_FALSE(table.constant());
  for (int v = 0; v < n; ++v) EXPECT_TRUE(table.depends_on(v));
}

TEST_P(EverySize, FixingAVariableShiftsTheLaterOnes) {
  const int n = GetParam();
  const std::vector<Truth> unknown(n, Truth::unknown);
  for (int fixed = 0; fixed < n; ++fixed)
    for (const bool value : {false, true}) {
      TruthTable table(parity(n), first(n), unknown);
      table.fix(fixed, value);
      ASSERT_EQ(table.variable_count(), n - 1);
      for (unsigned a = 0; a < 1u << (n - 1); ++a)
        EXPECT_EQ(table.value(a), (std::popcount(a) + value) % 2 == 1);
    }
}

TEST(TruthTable, SeesThatAVariableDoesNotMatter) {
  // Absorption: a | (a & b) = a, which pruning of the tree does not see.
  const TruthTable table(variable(0) | (variable(0) & variable(1)), first(2),
                         std::vector<Truth>(2, Truth::unknown));
  EXPECT_TRUE(table.depends_on(0));
  EXPECT_FALSE(table.depends_on(1));
}

TEST(TruthTable, OfAlwaysTrueIsConstant) {
  const TruthTable table(variable(0) | !variable(0), first(1), std::vector{Truth::unknown});
  EXPECT_EQ(table.constant(), true);
}

TEST(TruthTable, TakesTheOtherVariablesFromTheirSigns) {
  const BooleanExpression both = variable(0) & variable(1);
  const std::vector<int> only_first{0};
  EXPECT_FALSE(TruthTable(both, only_first, std::vector{Truth::unknown, Truth::yes}).constant());
  EXPECT_EQ(TruthTable(both, only_first, std::vector{Truth::unknown, Truth::no}).constant(), false);
}

TEST(TruthTable, WithConditionsIsTrueOnlyWhereAllOfThemAre) {
  TruthTable table(variable(0), first(1), std::vector{Truth::unknown});
  table = table.with_conditions(2);
  for (unsigned a = 0; a < 8; ++a) EXPECT_EQ(table.value(a), a == 7) << a;
}

TEST(TruthTable, SurvivesBeingStoredAsWords) {
  const TruthTable table(parity(8), first(8), std::vector<Truth>(8, Truth::unknown));
  EXPECT_EQ(table.words().size(), 4u);
  const TruthTable copy(8, table.words());
  for (unsigned a = 0; a < 256; ++a) EXPECT_EQ(copy.value(a), table.value(a));
}

TEST(TruthTable, TooManyVariablesAreRefused) {
  EXPECT_THROW(TruthTable(parity(11), first(11), std::vector<Truth>(11, Truth::unknown)),
               InvalidArgument);
}

}  // namespace
