#include "core/boolean_minimization.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/boolean_text.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_functions.hpp"

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;

int literals(const BooleanExpression& expression) {
  int count = 0;
  for (const auto& node : expression.nodes()) count += node.kind == Kind::variable ? 1 : 0;
  return count;
}

std::vector<Truth> table(int variables, const std::function<Truth(int row)>& value) {
  std::vector<Truth> rows;
  for (int row = 0; row < 1 << variables; ++row) rows.push_back(value(row));
  return rows;
}

Truth truth(bool value) { return value ? Truth::yes : Truth::no; }

std::vector<Truth> signs_of(int row, int variables) {
  std::vector<Truth> signs;
  for (int v = 0; v < variables; ++v) signs.push_back(truth((row >> v & 1) != 0));
  return signs;
}

TEST(MinimalExpression, OfKnownFunctionsIsAsShortAsItCanBe) {
  const auto bits = [](int row) { return std::popcount(static_cast<unsigned>(row)); };
  const auto size = [&](int variables, const std::function<bool(int)>& f) {
    return literals(minimal_expression(table(variables, [&](int r) { return truth(f(r)); })));
  };
  EXPECT_EQ(size(3, [&](int r) { return bits(r) >= 2; }), 6);       // ab + ac + bc
  EXPECT_EQ(size(3, [&](int r) { return bits(r) % 2 == 1; }), 12);  // parity: four of three
  EXPECT_EQ(size(4, [&](int r) { return bits(r) % 2 == 1; }), 32);  // eight of four
  EXPECT_EQ(size(4, [&](int r) { return (r & 3) == 3 || (r & 12) == 12; }), 4);
  EXPECT_EQ(size(3, [&](int r) { return r == 5; }), 3);
  // A product of sums: (a + b)(c + d) has 4 literals, its sum of products 8.
  EXPECT_EQ(size(4, [&](int r) { return (r & 3) != 0 && (r & 12) != 0; }), 4);
  // The cyclic core a'b' + ac + bc'… of McCluskey: three products of two.
  EXPECT_EQ(size(3, [&](int r) { return r != 0 && r != 7; }), 6);
  EXPECT_TRUE(minimal_expression(table(2, [](int) { return Truth::yes; })).is_constant(true));
  EXPECT_TRUE(minimal_expression(table(2, [](int) { return Truth::no; })).is_constant(false));
  // With don't-cares a decimal digit is at least 8 in one literal.
  EXPECT_EQ(literals(minimal_expression(
                table(4, [](int r) { return r > 9 ? Truth::unknown : truth(r >= 8); }))),
            1);
}

TEST(MinimalExpression, HasTheTableItWasMadeOf) {
  std::mt19937 generator(11);
  for (int trial = 0; trial < 60; ++trial) {
    const int variables = 1 + trial % 6;
    const auto rows =
        table(variables, [&](int) { return static_cast<Truth>(int(generator() % 3) - 1); });
    const BooleanExpression minimal = minimal_expression(rows);
    for (int row = 0; row < 1 << variables; ++row) {
      const Truth found = minimal.evaluate(signs_of(row, std::max(variables, 6)));
      if (rows[row] != Truth::unknown) {
        EXPECT_EQ(found, rows[row]);
      }
    }
    EXPECT_LE(literals(minimal_expression(minimal)), literals(minimal));
  }
  EXPECT_THROW(minimal_expression(std::vector<Truth>(3)), InvalidArgument);
  EXPECT_THROW(minimal_expression(std::vector<Truth>(2048)), InvalidArgument);
}

TEST(MinimalCover, IsPrimeAndIrredundantAlsoWithManyVariables) {
  // 40 points of 20 variables, half of them in.
  std::mt19937 generator(2);
  std::vector<Cube> on, off;
  for (int i = 0; i < 40; ++i) {
    Cube cube(20);
    for (Truth& sign : cube) sign = truth(generator() % 2 == 1);
    (i % 2 == 0 ? on : off).push_back(cube);
  }
  const auto any = [](const std::vector<Cube>& products, const Cube& point) {
    return std::ranges::any_of(products, [&](const Cube& p) { return covers(p, point); });
  };
  const std::vector<Cube> cover = minimal_cover(on, off).value();
  for (const Cube& point : on) EXPECT_TRUE(any(cover, point));
  for (const Cube& point : off) EXPECT_FALSE(any(cover, point));
  EXPECT_LT(cover.size(), 8u);
  for (std::size_t i = 0; i < cover.size(); ++i) {
    std::vector<Cube> others = cover;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(std::ranges::all_of(on, [&](const Cube& p) { return any(others, p); }));
    for (Truth& literal : others.emplace_back(cover[i])) {
      const Truth was = std::exchange(literal, Truth::unknown);
      if (was != Truth::unknown) {
        EXPECT_TRUE(std::ranges::any_of(off, [&](auto& p) { return covers(others.back(), p); }));
      }
      literal = was;
    }
  }
}

TEST(MinimalCover, SignsThatAreZeroCountAsBoth) {
  // A product covers a point on its boundary: here that point forbids the shorter ones.
  const std::vector<Cube> on{{Truth::yes, Truth::yes}};
  EXPECT_EQ(minimal_cover(on, std::vector<Cube>{{Truth::no, Truth::unknown}}).value()[0],
            (Cube{Truth::yes, Truth::unknown}));
  EXPECT_FALSE(minimal_cover(on, std::vector<Cube>{{Truth::unknown, Truth::unknown}}).has_value());
}

TEST(BooleanText, BecomesTheRFunctionOfAnyFields) {
  const BooleanExpression expression = BooleanText("a & !(b | c) ^ c").expression({"a", "b", "c"});
  const Field fields[] = {x_coordinate(), y_coordinate(), z_coordinate()};
  const Field f = r_function(expression, fields);
  const Field shorter = r_function(minimal_expression(expression), fields);
  for (int row = 0; row < 8; ++row) {
    const Point at{(row & 1) != 0 ? 2.0 : -1.0, (row & 2) != 0 ? 0.3 : -3.0,
                   (row & 4) != 0 ? 1.0 : -0.2};
    const bool p = at[0] > 0, q = at[1] > 0, r = at[2] > 0;
    EXPECT_EQ(value_at(f, at) > 0, (p && !(q || r)) != r) << row;
    EXPECT_EQ(value_at(shorter, at) > 0, (p && !(q || r)) != r) << row;
  }
  EXPECT_THROW(BooleanText("a & d").expression({"a", "b"}), InputError);
}

}  // namespace
}  // namespace rfm
