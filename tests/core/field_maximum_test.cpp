#include "core/field_maximum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/contour_distance.hpp"
#include "core/exact_distances.hpp"
#include "core/field_node.hpp"
#include "core/primitives.hpp"
#include "core/spline_field.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

FieldMaximum maximum_of(const Field& f, const Region& region, const Box& bounds, const Point& start,
                        const FieldMaximumOptions& options = {}) {
  return field_maximum(LevelFunction(f, bounds.dimension), RegionEvaluator(region), bounds, start,
                       options);
}

void expect_maximum(const FieldMaximum& found, double exact, double tolerance, int most_boxes) {
  EXPECT_NEAR(found.value, exact, tolerance);
  EXPECT_LE(found.value, exact + 1e-12);
  EXPECT_GE(found.at_most, exact - 1e-12);
  EXPECT_LE(found.at_most, exact + tolerance);
  EXPECT_LE(found.boxes, most_boxes);
}

TEST(FieldMaximum, OfTheDistanceWithinAnAngleIsTheLargestInscribedDisk) {
  // Its circle touches two sides and the corner (1, 1): radius r with √2 (1 − r) = r.
  CurvedContour angle;
  angle.points = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  angle.edges.resize(angle.points.size());
  const Field distance = contour_distance({angle});
  const Region sheet = box({-1, -1}, {3, 3});
  const FieldMaximum found = maximum_of(distance, sheet, {2, {-1, -1}, {3, 3}}, {0.3, 0.3});
  expect_maximum(found, 2 - std::sqrt(2.0), 1e-8, 5000);
  EXPECT_NEAR(found.at[0], 2 - std::sqrt(2.0), 1e-7);
  EXPECT_NEAR(found.at[1], 2 - std::sqrt(2.0), 1e-7);
}

TEST(FieldMaximum, OnAConeIsItsTip) {
  const Region ball = sphere({0.1, 0.2, 0.3}, 2);
  const FieldMaximum found = maximum_of(ball_distance({0.1, 0.2, 0.3}, 2, 3), ball,
                                        {3, {-1.9, -1.8, -1.7}, {2.1, 2.2, 2.3}}, {1, 1, 1});
  expect_maximum(found, 2, 1e-8, 20000);
}

TEST(FieldMaximum, IsThatOfTheRegionAloneAndNotOfItsBox) {
  // |x| + y is largest at the corners of the box, which the disk leaves out: on it √2.
  const FieldMaximum found =
      maximum_of(abs(x) + y, circle({0, 0}, 1), {2, {-1, -1}, {1, 1}}, {0, 0}, {.tolerance = 1e-3});
  EXPECT_NEAR(found.value, std::sqrt(2.0), 4e-3);
  EXPECT_LE(found.value, std::sqrt(2.0));
  EXPECT_GE(found.at_most, std::sqrt(2.0));
}

TEST(FieldMaximum, KeepsItsBudgetAndWhatItKnowsAlreadyWhereItIsLargestAlongALine) {
  const FieldMaximum found = maximum_of(-abs(x - 0.3 * y), circle({0, 0}, 1), {2, {-1, -1}, {1, 1}},
                                        {0.5, 0.2}, {.most_boxes = 500});
  EXPECT_LE(found.boxes, 502);
  EXPECT_LE(found.value, 0);
  EXPECT_GE(found.value, -0.01);
  EXPECT_GE(found.at_most, 0);
}

TEST(FieldMaximum, GeometricFieldsHaveNoSolutionInThem) {
  EXPECT_TRUE(is_geometric(1 + abs(x) * sin(y)));
  EXPECT_TRUE(is_geometric(2 * ellipsoid_distance({2, 1}, 2)));
  const Grid grid({2, {0, 0}, {1, 1}}, {1, 1, 1});
  const auto spline = std::make_shared<SplineField>(grid, 1, std::vector<double>(4, 1.0));
  EXPECT_FALSE(is_geometric(x + field_at(spline, {x, y})));
}

}  // namespace
}  // namespace rfm
