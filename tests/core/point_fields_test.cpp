#include "core/point_fields.hpp"

#include <gtest/gtest.h>

#include "core/evaluate.hpp"

namespace rfm {
namespace {

TEST(PointFields, AreSquaresOfDistancesAndHeights) {
  const Point p{0.5, -1, 2}, x{1.5, 1, 4};
  EXPECT_DOUBLE_EQ(evaluate(square_distance(p, 3), x, 0, 3).value(), 9);
  EXPECT_DOUBLE_EQ(evaluate(square_distance(p, 2), x, 0, 2).value(), 5);
  EXPECT_DOUBLE_EQ(evaluate(height_along({0, 2, -1}, p, 3), x, 0, 3).value(), 2);
}

}  // namespace
}  // namespace rfm
