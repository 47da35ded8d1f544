#include "core/boolean_derivative.hpp"

#include <gmock/gmock.h>

#include <array>
#include <random>

namespace rfm {
namespace {

BooleanExpression variable(int number) { return BooleanExpression::variable(number); }

int occurrences(const BooleanExpression& expression, int number) {
  int count = 0;
  for (const auto& node : expression.nodes())
    count += node.kind == BooleanExpression::Kind::variable && node.first == number;
  return count;
}

BooleanExpression random_expression(std::mt19937& generator, int depth) {
  if (depth == 0) return variable(static_cast<int>(generator() % 6));
  const BooleanExpression a = random_expression(generator, depth - 1),
                          b = random_expression(generator, depth - 1);
  switch (generator() % 4) {
    case 0:
      return a & b;
    case 1:
      return a | b;
    case 2:
      return !a;
    default:
      return a ^ b;
  }
}

TEST(BooleanDerivative, IsTrueWhereTheVariableDecides) {
  std::mt19937 generator(3);
  int decided = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const BooleanExpression expression = random_expression(generator, 4);
    for (int v = 0; v < 6; ++v) {
      const BooleanExpression derivative = boolean_derivative(expression, v);
      EXPECT_EQ(occurrences(derivative, v), 0);
      for (int bits = 0; bits < 64; ++bits) {
        std::array<bool, 6> signs{};
        for (int k = 0; k < 6; ++k) signs[k] = (bits >> k & 1) != 0;
        const std::span<const bool> all(signs);
        signs[v] = true;
        const bool with = expression.evaluate(all);
        signs[v] = false;
        EXPECT_EQ(derivative.evaluate(all), with != expression.evaluate(all));
        decided += derivative.evaluate(all);
      }
    }
  }
  EXPECT_GT(decided, 1000);
}

TEST(BooleanDerivative, IsAProductWhereTheVariableOccursOnce) {
  // (a & b) | (c & d): a decides where b is true and c & d is not.
  const BooleanExpression derivative =
      boolean_derivative((variable(0) & variable(1)) | (variable(2) & variable(3)), 0);
  EXPECT_EQ(derivative.nodes().size(), 6u);  // b, c, d, c & d, its negation, the conjunction
  for (const int v : {1, 2, 3}) EXPECT_EQ(occurrences(derivative, v), 1);
}

}  // namespace
}  // namespace rfm
