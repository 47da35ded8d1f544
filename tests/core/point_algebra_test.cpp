#include "core/point_algebra.hpp"

#include <gtest/gtest.h>

namespace rfm {
namespace {

TEST(PointAlgebra, CrossProductsAreNormalAndAsLongAsTheArea) {
  const Point a{1, 2, -2}, b{0.5, -1, 3}, n = cross(a, b);
  EXPECT_NEAR(dot(n, a), 0, 1e-15);
  EXPECT_NEAR(dot(n, b), 0, 1e-15);
  EXPECT_NEAR(dot(n, n), dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b), 1e-12);
  EXPECT_EQ(cross({1, 0, 0}, {0, 1, 0}), (Point{0, 0, 1}));
}

TEST(PointAlgebra, UnitsAndDifferences) {
  EXPECT_DOUBLE_EQ(norm(unit({1, 2, -2})), 1);
  EXPECT_DOUBLE_EQ(dot(unit({1, 2, -2}), {1, 2, -2}), 3);
  EXPECT_EQ(difference({3, 2, 1}, {1, 1, 1}), (Point{2, 1, 0}));
  EXPECT_EQ(along({1, 1, 1}, 2, {0, 1, 2}), (Point{1, 3, 5}));
}

}  // namespace
}  // namespace rfm
