#include "core/ellipsoid_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/exact_distances.hpp"

namespace rfm {
namespace {

// A ball is an ellipsoid: r − |x| with all its derivatives.
TEST(EllipsoidDistance, OfABallIsThatOfTheBall) {
  const Field general = ellipsoid_distance({1.3, 1.3, 1.3}, 3),
              ball = ball_distance({0, 0, 0}, 1.3, 3);
  for (const Point& at : {Point{0.3, -0.2, 0.5}, Point{2, 1, -3}, Point{0, 0, 0.7}}) {
    const PointJet found = evaluate(general, at, 4), expected = evaluate(ball, at, 4);
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; i + j <= 4; ++j)
        for (int k = 0; i + j + k <= 4; ++k)
          EXPECT_NEAR(found.derivative(i, j, k), expected.derivative(i, j, k),
                      1e-12 * std::pow(4, i + j + k) + 1e-12)
              << i << j << k;
  }
}

// p + t n lies at distance −t from p, as long as t is less than the radius of curvature inwards.
TEST(EllipsoidDistance, AlongANormalIsTheWayFromTheSurface) {
  const Point radii{1.5, 0.8, 1.1};
  const Field distance = ellipsoid_distance(radii, 3);
  for (double t = 0.1; t < 6; t += 0.7)
    for (double height = -0.95; height < 1; height += 0.3) {
      const double ring = std::sqrt(1 - height * height);
      const Point direction{ring * std::cos(t), ring * std::sin(t), height};
      Point foot, normal;
      for (int axis = 0; axis < 3; ++axis) {
        foot[axis] = radii[axis] * direction[axis];
        normal[axis] = direction[axis] / radii[axis];
      }
      const double length = std::hypot(normal[0], normal[1], normal[2]);
      const double curvature_radius = 0.8 * 0.8 / 1.5;
      for (const double away : {-0.9 * curvature_radius, -0.01, 1e-9, 0.4, 5.0, 1e3}) {
        Point at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = foot[axis] + away * normal[axis] / length;
        EXPECT_NEAR(value_at(distance, at), -away, 4e-15 * (1 + std::fabs(away)));
      }
    }
}

// Slopes at random points of random boxes, which are as tight as their side is small.
TEST(EllipsoidDistance, BoundsHoldTheSlopesAndShrinkWithTheBox) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const int dimension : {2, 3}) {
    const Point radii{1.5, 0.5, 0.8};
    const EllipsoidDistance source(radii, dimension);
    const Field distance = ellipsoid_distance(radii, dimension);
    for (const double side : {1.0, 0.1, 1e-3}) {
      int smooth = 0;
      for (int repetition = 0; repetition < 300; ++repetition) {
        Box box{dimension, {}, {}};
        double far = 0;
        for (int axis = 0; axis < dimension; ++axis) {
          const double middle = 4 * uniform(generator) - 2;
          box.low[axis] = middle - side * uniform(generator);
          box.high[axis] = middle + side * uniform(generator);
          far += middle * middle / (radii[axis] * radii[axis]);
        }
        const FunctionBounds bounds = source.bounds(box);
        smooth += bounds.smooth;
        for (int sample = 0; sample < 20; ++sample) {
          Point at{};
          for (int axis = 0; axis < dimension; ++axis)
            at[axis] = box.low[axis] + uniform(generator) * (box.high[axis] - box.low[axis]);
          const PointJet jet = evaluate(distance, at, 1);
          EXPECT_TRUE(bounds.value.contains(jet.value()));
          for (int axis = 0; axis < dimension; ++axis) {
            EXPECT_TRUE(
                bounds.gradient[axis].contains(jet.derivative(axis == 0, axis == 1, axis == 2)));
          }
        }
        // Where curvatures of the level are at most 4.
        for (int axis = 0; axis < dimension && far > 1; ++axis) {
          EXPECT_LT(bounds.gradient[axis].width(), 40 * side);
        }
      }
      EXPECT_GT(smooth, side < 0.5 ? 280 : 100);
    }
  }
}

TEST(EllipsoidDistance, BoundsShrinkWithTheBoxAndKnowTheFocalSet) {
  const EllipsoidDistance source({2, 1}, 2);
  for (const double side : {1e-1, 1e-3, 1e-6}) {
    const Box box{2, {0.7, 0.6}, {0.7 + side, 0.6 + side}};
    const FunctionBounds bounds = source.bounds(box);
    EXPECT_LE(bounds.value.width(), 1.5 * side);
    EXPECT_TRUE(bounds.smooth);
    EXPECT_TRUE(bounds.value.contains(value_at(ellipsoid_distance({2, 1}, 2), box.center())));
  }
  EXPECT_FALSE(source.bounds({2, {-0.5, -0.1}, {0.5, 0.1}}).smooth);
  EXPECT_TRUE(source.breakpoints(0).empty());
  EXPECT_THROW(EllipsoidDistance({1, -1}, 2), InvalidArgument);
  EXPECT_THROW(EllipsoidDistance({1, 1}, 4), InvalidArgument);
}

}  // namespace
}  // namespace rfm
