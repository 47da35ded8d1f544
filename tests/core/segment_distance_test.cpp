#include "core/segment_distance.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Point from{0.3, -0.2, 0.1}, to{1.5, 0.7, -0.4};

// The same function written with `select`.
Field by_cases(int dimension) {
  Field square = 0.0, beyond = 0.0, along = 0.0;
  double length = 0;
  for (int axis = 0; axis < dimension; ++axis) length += std::pow(to[axis] - from[axis], 2);
  length = std::sqrt(length);
  for (int axis = 0; axis < dimension; ++axis) {
    square = square + pow(coordinate(axis) - from[axis], 2);
    beyond = beyond + pow(coordinate(axis) - to[axis], 2);
    along = along + (coordinate(axis) - from[axis]) * ((to[axis] - from[axis]) / length);
  }
  return select(step(-along), square, select(step(along - length), beyond, square - along * along));
}

class SegmentDistanceIn : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(EveryDimension, SegmentDistanceIn, testing::Values(2, 3));

TEST_P(SegmentDistanceIn, JetsAreThoseOfThePolynomialBesideAndBeyondTheSegment) {
  const int dimension = GetParam();
  const Field found = field(std::make_shared<const SegmentDistance>(from, to, dimension));
  const Field expected = by_cases(dimension);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 2.5);
  for (int i = 0; i < 100; ++i) {
    const Point point{place(random), place(random), dimension > 2 ? place(random) : 0};
    const PointJet a = evaluate(found, point, 3, dimension),
                   b = evaluate(expected, point, 3, dimension);
    for (int x = 0; x <= 3; ++x)
      for (int y = 0; x + y <= 3; ++y)
        for (int z = 0; x + y + z <= (dimension > 2 ? 3 : x + y); ++z)
          EXPECT_NEAR(a.derivative(x, y, z), b.derivative(x, y, z), 2e-14) << x << y << z;
  }
}

TEST_P(SegmentDistanceIn, BoundsHoldAndAreOfSecondOrder) {
  const int dimension = GetParam();
  const SegmentDistance distance(from, to, dimension);
  const Field found = field(std::make_shared<const SegmentDistance>(distance));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1, 2.5), part(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double side = std::pow(10.0, -3 * part(random));
    Box box{dimension, {}, {}};
    for (int axis = 0; axis < dimension; ++axis) {
      box.low[axis] = place(random);
      box.high[axis] = box.low[axis] + side;
    }
    const FunctionBounds bounds = distance.bounds(box);
    EXPECT_TRUE(bounds.smooth);
    Interval range(INFINITY, -INFINITY);
    for (int sample = 0; sample < 60; ++sample) {
      Point point{};
      for (int axis = 0; axis < dimension; ++axis)
        point[axis] = sample < 1 << dimension
                          ? (sample >> axis & 1 ? box.high : box.low)[axis]
                          : std::lerp(box.low[axis], box.high[axis], part(random));
      const PointJet jet = evaluate(found, point, 1, dimension);
      EXPECT_TRUE(bounds.value.contains(jet.value()));
      range = hull(range, Interval(jet.value()));
      for (int axis = 0; axis < dimension; ++axis)
        EXPECT_TRUE(
            bounds.gradient[axis].contains(jet.derivative(axis == 0, axis == 1, axis == 2)));
    }
    // The tangent at the centre misses a function with curvature ≤ 2 by |x − c|² at most, and the
    // samples miss the minimum, which may lie inside, by as much.
    EXPECT_LE(bounds.value.width(), range.width() + 2 * dimension * side * side + 1e-12);
    for (int axis = 0; axis < dimension; ++axis)
      EXPECT_LE(bounds.gradient[axis].width(), 2 * dimension * side + 1e-12);
  }
}

TEST(SegmentDistance, IsContinuouslyDifferentiableWhereTheEndsBegin) {
  const SegmentDistance distance({0, 0, 0}, {2, 0, 0});
  const Field square = field(std::make_shared<const SegmentDistance>(distance));
  for (const double end : {0.0, 2.0})
    for (const double step : {-1e-9, 1e-9}) {
      const PointJet jet = evaluate(square, {end + step, 0.3, 0.4}, 1);
      EXPECT_NEAR(jet.value(), 0.25, 1e-15);
      EXPECT_NEAR(jet.derivative(1), 0, 3e-9);
      EXPECT_NEAR(jet.derivative(0, 1), 0.6, 1e-15);
    }
  EXPECT_THAT(distance.breakpoints(0), testing::ElementsAre(0, 2));
  EXPECT_THAT(distance.breakpoints(1), testing::IsEmpty());
  EXPECT_THAT(SegmentDistance({0, 0, 0}, {2, 1, 0}).breakpoints(0), testing::IsEmpty());
}

TEST(SegmentDistance, EndsThatCoincideAreRefused) {
  EXPECT_THROW(SegmentDistance({1, 2, 3}, {1, 2, 3}), InvalidArgument);
  EXPECT_THROW(SegmentDistance({1, 2, 3}, {1, 2, 4}, 2), InvalidArgument);
  EXPECT_THROW(SegmentDistance({0, 0, 0}, {1, 2, 4}, 1), InvalidArgument);
}

}  // namespace
}  // namespace rfm
