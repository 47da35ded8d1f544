#include "core/exact_distances.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/ellipsoid_distance.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/level_function.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

const Point axis{1, 2, -2};

struct Shape {
  Region region;
  Field distance;
};
std::vector<Shape> solids() {
  return {{sphere({0.1, 0.2, 0}, 1), ball_distance({0.1, 0.2, 0}, 1, 3)},
          {cylinder({0.1, 0, 0}, axis, 0.8), cylinder_distance({0.1, 0, 0}, axis, 0.8)},
          {cone({0, 0.5, 0}, axis, 0.6), cone_distance({0, 0.5, 0}, axis, 0.6)},
          {torus({0, 0, 0.1}, axis, 1, 0.3), torus_distance({0, 0, 0.1}, axis, 1, 0.3)},
          {capsule({-0.5, 0, 0}, {0.5, 0.3, 0.1}, 0.6),
           capsule_distance({-0.5, 0, 0}, {0.5, 0.3, 0.1}, 0.6)},
          {ellipsoid({0.1, 0, 0.2}, {0.7, 1.1, 0.9}, axis, 0.8),
           ellipsoid_distance({0.1, 0, 0.2}, {0.7, 1.1, 0.9}, axis, 0.8, 3)}};
}

// |∇d| = 1, so ∇d·H = 0, and once more differentiated: derivatives up to the third.
void expect_eikonal(const Field& distance, const Point& at, double tolerance) {
  const PointJet jet = evaluate(distance, at, 3);
  const auto d = [&](std::initializer_list<int> axes) {
    int count[3] = {0, 0, 0};
    for (const int a : axes) ++count[a];
    return jet.derivative(count[0], count[1], count[2]);
  };
  double square = 0;
  for (int i = 0; i < 3; ++i) square += d({i}) * d({i});
  EXPECT_NEAR(square, 1, 1e-12);
  for (int j = 0; j < 3; ++j) {
    double along = 0;
    for (int i = 0; i < 3; ++i) along += d({i}) * d({i, j});
    EXPECT_NEAR(along, 0, tolerance);
    for (int k = 0; k < 3; ++k) {
      double second = 0;
      for (int i = 0; i < 3; ++i) second += d({i, k}) * d({i, j}) + d({i}) * d({i, j, k});
      EXPECT_NEAR(second, 0, tolerance);
    }
  }
}

TEST(ExactDistances, HaveUnitSlopeAndTheSignOfTheirShape) {
  std::mt19937 generator(4);
  const auto uniform = [&] { return -1.6 + 3.2 * 0x1p-32 * generator(); };
  for (const Shape& shape : solids()) {
    const LevelFunction level(shape.region.primitives()[0]->level, 3);
    const RegionEvaluator region(shape.region);
    int checked = 0;
    for (int i = 0; i < 200; ++i) {
      const Point at{uniform(), uniform(), uniform()};
      const double value = value_at(shape.distance, at);
      // The other nappe of a cone's quadric is none of its own.
      if (shape.region.primitives().size() == 1)
        EXPECT_EQ(value >= 0, level.value(at) >= 0);
      else
        EXPECT_EQ(value >= 0, region.contains(at));
      if (std::fabs(value) > 0.25) continue;  // away from skeletons
      expect_eikonal(shape.distance, at, 2e-9);
      ++checked;
    }
    EXPECT_GT(checked, 10);
  }
}

TEST(ExactDistances, OfAnEllipseIsThatOfItsNearestPoint) {
  const Point radii{2, 0.7};
  const Field distance = ellipsoid_distance(radii, 2);
  std::mt19937 generator(5);
  const auto uniform = [&] { return -3 + 6 * 0x1p-32 * generator(); };
  for (int i = 0; i < 100; ++i) {
    const Point at{uniform(), 0.7 * uniform()};
    // A minimum over a fine parametrisation, refined about the best.
    double best = 0, nearest = 1e9;
    for (double width = 3.2, middle = 3.15; width > 1e-9; width *= 0.01) {
      for (int k = -150; k <= 150; ++k) {
        const double t = middle + width * k / 150;
        const double d = std::hypot(2 * std::cos(t) - at[0], 0.7 * std::sin(t) - at[1]);
        if (d < nearest) nearest = d, best = t;
      }
      middle = best;
    }
    const double inside = std::pow(at[0] / 2, 2) + std::pow(at[1] / 0.7, 2) <= 1 ? 1 : -1;
    EXPECT_NEAR(value_at(distance, at), inside * nearest, 1e-12);
  }
}

TEST(ExactDistances, OfAnEllipseAreFiniteOnItsAxesAndFocalSet) {
  const Field distance = ellipsoid_distance({2, 1}, 2);
  EXPECT_NEAR(value_at(distance, {0, 0}), 1, 1e-15);
  EXPECT_NEAR(value_at(distance, {3, 0}), -1, 1e-15);
  EXPECT_NEAR(value_at(distance, {1.8, 0}), 0.2, 1e-15);
  EXPECT_NEAR(value_at(distance, {0, 0.25}), 0.75, 1e-15);
  // Within the focal segment |x| < 3/2: y² = 1 − x²/3 is the squared distance.
  EXPECT_NEAR(value_at(distance, {0.9, 0}), std::sqrt(1 - 0.27), 1e-15);
  EXPECT_NEAR(evaluate(distance, {0, 0.25}, 2, 2).derivative(0, 1), -1, 1e-14);
  EXPECT_NEAR(evaluate(distance, {2, 0}, 2, 2).derivative(1, 0), -1, 1e-14);
  // The curvature at the end of the long axis is a/b² = 2, of the distance to the tangent −2.
  EXPECT_NEAR(evaluate(distance, {2, 0}, 2, 2).derivative(0, 2), -2, 1e-13);
  for (const Point& at : {Point{0, 0}, Point{1, 0}, Point{1.5, 0}})
    EXPECT_TRUE(std::isfinite(evaluate(distance, at, 2, 2).derivative(1, 0)));
}

TEST(ExactDistances, BoundsOfAnEllipsoidHold) {
  const EllipsoidDistance source({1, 0.5, 0.8}, 3);
  const Field distance = ellipsoid_distance({1, 0.5, 0.8}, 3);
  std::mt19937 generator(6);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * 0x1p-32 * generator();
  };
  for (int i = 0; i < 100; ++i) {
    Box box{3, {}, {}};
    for (int k = 0; k < 3; ++k) {
      box.low[k] = uniform(-1.5, 1.5);
      box.high[k] = box.low[k] + uniform(0, 0.5);
    }
    const Interval bounds = source.bounds(box).value;
    for (int j = 0; j < 20; ++j) {
      const Point at{uniform(box.low[0], box.high[0]), uniform(box.low[1], box.high[1]),
                     uniform(box.low[2], box.high[2])};
      EXPECT_TRUE(bounds.contains(value_at(distance, at)));
    }
  }
}

TEST(ExactDistances, RefuseSizesThatAreNone) {
  EXPECT_THROW(ellipsoid_distance({1, 0}, 2), InvalidArgument);
  EXPECT_THROW(ellipsoid_distance({1, 1}, 1), InvalidArgument);
  EXPECT_THROW(cylinder_distance({0, 0, 0}, {0, 0, 0}, 1), InvalidArgument);
}

}  // namespace
}  // namespace rfm
