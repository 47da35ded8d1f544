#include "core/boolean_simplification.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "core/evaluate.hpp"
#include "core/r_functions.hpp"

namespace rfm {
namespace {

constexpr int variables = 4;
const BooleanExpression a = BooleanExpression::variable(0), b = BooleanExpression::variable(1),
                        c = BooleanExpression::variable(2), d = BooleanExpression::variable(3);

using Signs = std::array<Truth, variables>;

template <class Check>
void for_all_signs(const Check& check) {
  for (int code = 0; code < 81; ++code) {
    Signs signs;
    int rest = code;
    for (Truth& sign : signs) {
      sign = static_cast<Truth>(rest % 3 - 1);
      rest /= 3;
    }
    check(signs);
  }
}

BooleanExpression random_expression(std::mt19937& generator, int depth) {
  if (depth == 0) return BooleanExpression::variable(static_cast<int>(generator() % variables));
  const BooleanExpression p = random_expression(generator, depth - 1);
  const BooleanExpression q = random_expression(generator, static_cast<int>(generator() % depth));
  switch (generator() % 5) {
    case 0:
    case 1:
      return p & q;
    case 2:
    case 3:
      return p | q;
    default:
      return !p;
  }
}

std::size_t size(const BooleanExpression& expression) { return expression.nodes().size(); }

TEST(WithKnownSigns, HasTheValuesOfTheWholeAndItsRelevantVariablesAlone) {
  std::mt19937 generator(3);
  for (int trial = 0; trial < 60; ++trial) {
    const BooleanExpression whole = random_expression(generator, 5);
    for_all_signs([&](const Signs& signs) {
      const BooleanExpression open = with_known_signs(whole, signs);
      std::array<bool, variables> relevant{}, occurs{};
      whole.mark_relevant(signs, relevant);
      for (const auto& node : open.nodes())
        if (node.kind == BooleanExpression::Kind::variable) occurs[node.first] = true;
      EXPECT_EQ(occurs, relevant);
      for_all_signs([&](const Signs& further) {  // whatever the others turn out to be
        Signs all = signs;
        for (int v = 0; v < variables; ++v)
          if (signs[v] == Truth::unknown) all[v] = further[v];
        EXPECT_EQ(open.evaluate(all), whole.evaluate(all));
      });
    });
  }
}

TEST(WithoutRedundancy, AppliesTheLawsOfLattices) {
  EXPECT_EQ(size(without_redundancy(a & a)), 1u);
  EXPECT_EQ(size(without_redundancy(a | a | a)), 1u);
  EXPECT_EQ(size(without_redundancy(a & (a | b))), 1u);
  EXPECT_EQ(size(without_redundancy((b & a) | a)), 1u);
  EXPECT_EQ(size(without_redundancy((a | b) & (c | b | a))), 3u);
  EXPECT_EQ(size(without_redundancy((a & b) | (b & a))), 3u);
  EXPECT_EQ(size(without_redundancy(!((!a) | (!(a | c))))), 1u);
  EXPECT_EQ(size(without_redundancy((a & (b | c)) | ((c | b) & a & d))), 5u);
  EXPECT_EQ(size(without_redundancy((a & (!b)) | ((!a) & b))), 9u);  // nothing to do
}

TEST(WithoutRedundancy, KeepsTheValueInThreeValuedLogicAndNeverGrows) {
  std::mt19937 generator(3);
  for (int trial = 0; trial < 500; ++trial) {
    const BooleanExpression whole = random_expression(generator, 1 + trial % 6);
    const BooleanExpression shorter = without_redundancy(whole);
    EXPECT_LE(size(shorter), size(whole.negations_at_leaves()));
    EXPECT_EQ(size(without_redundancy(shorter)), size(shorter));
    for_all_signs(
        [&](const Signs& signs) { EXPECT_EQ(shorter.evaluate(signs), whole.evaluate(signs)); });
  }
}

TEST(WithoutRedundancy, DoesNotTouchWhatFailsForClosedSets) {
  // a & !a is the boundary of a, on which it holds; a | !a is zero there.
  EXPECT_EQ(size(without_redundancy(a & (!a))), 4u);
  EXPECT_EQ(size(without_redundancy(a | (!a))), 4u);
}

TEST(WithoutRedundancy, RestoresNormalization) {
  // a ∧₀ a = (2 − √2) a, but a once.
  const Field fields[] = {x_coordinate()};
  const auto slope = [&](const BooleanExpression& e) {
    return evaluate(r_function(e, fields), {0.7}, 1, 1).derivative(1);
  };
  EXPECT_NEAR(slope(a & a), 2 - std::sqrt(2.0), 1e-15);
  EXPECT_EQ(slope(without_redundancy(a & a)), 1);
}

TEST(WithoutRedundancy, TakesLongChains) {
  BooleanExpression::Node leaf{BooleanExpression::Kind::variable, 0, 0};
  std::vector<BooleanExpression::Node> nodes{leaf};
  for (int i = 1; i < 2000; ++i) {
    leaf.first = i % 7;
    nodes.push_back(leaf);
    const int last = static_cast<int>(nodes.size()) - 1;
    nodes.push_back({BooleanExpression::Kind::conjunction, i == 1 ? 0 : last - 1, last});
  }
  const auto chain = BooleanExpression::of_nodes(nodes, static_cast<int>(nodes.size()) - 1);
  EXPECT_EQ(size(without_redundancy(chain)), 13u);
}

TEST(Dual, IsTheNegationOfTheFunctionOfNegatedArguments) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 100; ++trial) {
    const BooleanExpression whole = random_expression(generator, 4);
    for_all_signs([&](const Signs& signs) {
      Signs negated;
      for (int v = 0; v < variables; ++v) negated[v] = static_cast<Truth>(-int(signs[v]));
      EXPECT_EQ(int(dual(whole).evaluate(signs)), -int(whole.evaluate(negated)));
      EXPECT_EQ(int(formal_complement(whole).evaluate(signs)), -int(whole.evaluate(signs)));
    });
    EXPECT_EQ(size(dual(dual(whole))), size(whole));
  }
}

TEST(FormalComplement, HasTheNegatedRFunction) {
  const Field fields[] = {x_coordinate(), y_coordinate(), z_coordinate()};
  const BooleanExpression whole = (a | (!b)) & c;
  const Field f = r_function(whole, fields), g = r_function(formal_complement(whole), fields);
  for (const Point& at : {Point{1, 2, 3}, Point{-1, 2, 0.5}, Point{0.3, -0.2, -0.1}})
    EXPECT_NEAR(value_at(f, at), -value_at(g, at), 1e-15);
}

}  // namespace
}  // namespace rfm
