#include "quadrature/zero_isolation.hpp"

#include <gmock/gmock.h>

#include <random>

#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

constexpr std::array<int, 3> axes{0, 1, 2};

ZeroSet zeros_of(const std::vector<Field>& fields, const Box& box,
                 const ZeroSearchOptions& options = {}) {
  std::vector<LevelFunction> levels;
  for (const Field& field : fields) levels.emplace_back(field, box.dimension);
  std::vector<const LevelFunction*> functions;
  for (const LevelFunction& level : levels) functions.push_back(&level);
  return isolate_zeros(functions, box, std::span(axes).first(fields.size()), options);
}

TEST(ZeroIsolation, FindsEveryCrossingOfTwoWaves) {
  // sin(πx) = 0 and sin(πy) = 0 at the points with integer coordinates.
  const ZeroSet set =
      zeros_of({sin(pi * x()) + 0.1 * sin(pi * y()), sin(pi * y())}, {2, {-3.3, -2.2}, {4.4, 3.9}});
  EXPECT_TRUE(set.unresolved.empty());
  ASSERT_EQ(set.zeros.size(), 8u * 6u);
  for (const Point& zero : set.zeros)
    for (int axis = 0; axis < 2; ++axis)
      EXPECT_NEAR(zero[axis], std::round(zero[axis]), 1e-15 * (1 + std::fabs(zero[axis])));
}

TEST(ZeroIsolation, ZerosOnSidesAndCornersOfTheBoxAreFoundOnce) {
  // Also where boxes are halved.
  const ZeroSet set = zeros_of({x() * x() - 1, y() * y() - y()}, {2, {-1, -1}, {1, 1}});
  EXPECT_TRUE(set.unresolved.empty());
  EXPECT_EQ(set.zeros.size(), 4u);
}

TEST(ZeroIsolation, ThreeSpheresMeetInTwoPoints) {
  const auto ball = [](double a, double b, double c) {
    return 1 - square(x() - a) - square(y() - b) - square(z() - c);
  };
  const ZeroSet set =
      zeros_of({ball(0.5, 0, 0), ball(-0.5, 0, 0), ball(0, 0.5, 0)}, cube_box(2, 3));
  EXPECT_TRUE(set.unresolved.empty());
  ASSERT_EQ(set.zeros.size(), 2u);
  // x = 0; the second and third differ by x = −y: y = 0, z² = 3/4.
  for (const Point& zero : set.zeros) {
    EXPECT_NEAR(zero[0], 0, 1e-15);
    EXPECT_NEAR(zero[1], 0, 1e-15);
    EXPECT_NEAR(std::fabs(zero[2]), std::sqrt(0.75), 1e-15);
  }
}

TEST(ZeroIsolation, ATangencyIsLeftUnresolvedAndNothingElseIs) {
  const ZeroSet set = zeros_of({1 - x() * x() - y() * y(), y() - 1}, {2, {-2, -2}, {2, 2}});
  EXPECT_TRUE(set.zeros.empty());
  ASSERT_FALSE(set.unresolved.empty());
  EXPECT_LT(set.unresolved.size(), 1000u);
  for (const Box& box : set.unresolved) {
    EXPECT_NEAR(box.center()[0], 0, 0.05);
    EXPECT_NEAR(box.center()[1], 1, 1e-3);
  }
}

TEST(ZeroIsolation, TwoNearlyTangentCrossingsAreTwoZeros) {
  const double d = 1e-5;
  const ZeroSet set = zeros_of({1 - x() * x() - y() * y(), y() - (1 - d)}, {2, {-2, -2}, {2, 2}},
                               {.smallest = 1e-6});
  EXPECT_TRUE(set.unresolved.empty());
  ASSERT_EQ(set.zeros.size(), 2u);
  for (const Point& zero : set.zeros)
    EXPECT_NEAR(std::fabs(zero[0]), std::sqrt(2 * d - d * d), 1e-13);
}

TEST(ZeroIsolation, GivesUpWhereFunctionsVanishTogetherOnACurve) {
  const ZeroSearchOptions options{.smallest = 1e-6, .max_unresolved = 100};
  const ZeroSet set =
      zeros_of({x() - y(), (x() - y()) * (2 + x())}, {2, {-1, -1}, {1, 1}}, options);
  EXPECT_GE(set.unresolved.size(), 100u);
  EXPECT_LT(set.unresolved.size(), 200u);
}

TEST(ZeroIsolation, RandomLinesCrossWhereCramersRuleSays) {
  std::mt19937 generator(5);
  const auto number = [&] { return 2 * (0x1p-32 * generator()) - 1; };
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const double a = number(), b = number(), c = number(), d = number(), e = number(), f = number();
    const double determinant = a * d - b * c;
    const Point exact{(e * d - b * f) / determinant, (a * f - e * c) / determinant, 0};
    const bool is_inside = std::max(std::fabs(exact[0]), std::fabs(exact[1])) <= 1;
    const ZeroSet set =
        zeros_of({a * x() + b * y() - e, c * x() + d * y() - f}, {2, {-1, -1}, {1, 1}});
    ASSERT_TRUE(set.unresolved.empty());
    ASSERT_EQ(set.zeros.size(), is_inside ? 1u : 0u);
    if (!is_inside) continue;
    ++found;
    const double tolerance = 1e-15 / std::fabs(determinant) + 1e-15;
    EXPECT_NEAR(set.zeros[0][0], exact[0], 4 * tolerance);
    EXPECT_NEAR(set.zeros[0][1], exact[1], 4 * tolerance);
  }
  EXPECT_GT(found, 100);
}

TEST(ZeroIsolation, AZeroBesideTheBoxDoesNotStandForTheOneInIt) {
  // f = x − x² + a bump left of the box: a slope between 0 and twice that at the centre proves that
  // the box holds one zero at most, and it holds x = 0. Newton's method leaves the box for a zero
  // of the bump at x = −0.086: no proof that the box holds none, since f is not monotone up to
  // there.
  const Field f = x() - x() * x() + 0.19341 * exp(-square((x() + 0.1) / 0.016));
  const Box box{2, {-0.03, -1}, {0.47, 1}};
  std::vector<LevelFunction> levels;
  levels.emplace_back(f, 2);
  levels.emplace_back(y(), 2);
  const std::vector<const LevelFunction*> functions{&levels[0], &levels[1]};
  Point elsewhere = box.center();
  ASSERT_TRUE(newton_zero(functions, std::span(axes).first(2), 8, elsewhere));
  ASSERT_LT(elsewhere[0], -0.05);
  const ZeroSet set = zeros_of({f, y()}, box);
  EXPECT_TRUE(set.unresolved.empty());
  ASSERT_EQ(set.zeros.size(), 1u);
  EXPECT_NEAR(set.zeros[0][0], 0, 1e-14);
}

TEST(ZeroIsolation, NoZeroIsLostWhereNewtonsMethodLeavesTheBox) {
  // sin has a slope of one sign on (−π/2, π/2) only. Newton's method leads from the centre of most
  // boxes out of them; every zero must be found all the same, wherever it lies in the box.
  for (int k = 0; k < 200; ++k) {
    const double low = -20 + 0.0917 * k, high = low + 7.3 + 0.031 * k;
    const ZeroSet set = zeros_of({sin(x()), y() - 0.1 * x()}, {2, {low, -4}, {high, 4}});
    EXPECT_TRUE(set.unresolved.empty()) << k;
    const int expected = static_cast<int>(std::floor(high / pi) - std::ceil(low / pi)) + 1;
    EXPECT_EQ(static_cast<int>(set.zeros.size()), expected) << k;
  }
}

}  // namespace
