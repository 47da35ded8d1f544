#include "core/profile_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/mapped_region.hpp"
#include "core/polygon.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

// Profiles with sides of every kind: parallel, across and oblique to the axis, beyond it; circles
// and ellipses on the axis, across it and beside it; an ellipse whose odd part changes sign.
std::vector<Region> profiles() {
  return {box({0, -1}, {1.5, 0.5}),
          half_plane({0.5, 0}, {1, 0.3}),
          half_plane({0.5, 0}, {-1, 0.3}),
          half_plane({-0.5, 0}, {1, 2}),
          half_plane({0.4, 0.2}, {0, -2}),
          half_plane({0.7, 0}, {1, 0}),
          circle({0, 0.3}, 1),
          circle({1.2, 0.1}, 0.7),
          circle({0.4, 0.1}, 1),
          circle({-0.4, 0.1}, 1),
          ellipse({0.9, -0.2}, {1.1, 0.5}, 0.7),
          ellipse({-0.1, 0.2}, {1.1, 0.5}, 2),
          level_set(1.0 + 0.3 * sin(3.0 * y) - x),
          level_set(pow(x - 1.0, 4.0) - y),
          level_set(1.0 - pow(x - 0.2, 3.0) - x * y * y),
          level_set(exp(-(x * x)) - pow(y, 2.0)),
          (circle({0.9, 0}, 0.8) & half_plane({0, 0}, {1, 1})) - box({0.5, -0.2}, {1, 0.2})};
}

const Point center{0.3, -0.2, 0.5}, axis{1, 2, -2};  // of length 3

struct Meridian {
  double radius, height;
};
Meridian meridian(const Point& p) {
  const Point d{p[0] - center[0], p[1] - center[1], p[2] - center[2]};
  const double h = (d[0] + 2 * d[1] - 2 * d[2]) / 3;
  return {std::sqrt(std::max(0.0, d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - h * h)), h};
}

TEST(Revolution, HoldsThePointsWhoseDistanceAndHeightLieInTheProfile) {
  std::mt19937 generator(1);
  const auto uniform = [&] { return -2.5 + 5 * 0x1p-32 * generator(); };
  for (const Region& profile : profiles()) {
    const RegionEvaluator plane(profile), body(revolution(profile, center, axis));
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point at{uniform(), uniform(), uniform()};
      const auto [radius, height] = meridian(at);
      const bool expected = plane.contains(Point{radius, height});
      EXPECT_EQ(body.contains(at), expected) << radius << ", " << height;
      inside += expected;
    }
    EXPECT_GT(inside, 10);
    EXPECT_LT(inside, 1990);
  }
}

TEST(Revolution, SidesAreNormalisedAndHaveTheSlopesOfTheirProfile) {
  // Points on the circle of radius 0.7 about (1.2, 0.1), and on the oblique line.
  const Region ring = revolution(circle({1.2, 0.1}, 0.7));
  const Region funnel = revolution(half_plane({0.5, 0}, {1, 0.3}));
  for (double a = 0; a < 6; a += 0.5)
    for (double turn = 0.1; turn < 6; turn += 0.9) {
      const double radius = 1.2 + 0.7 * std::cos(a), height = 0.1 + 0.7 * std::sin(a);
      const Point on{radius * std::cos(turn), radius * std::sin(turn), height};
      const PointJet jet = evaluate(ring.primitives()[0]->function, on, 1);
      EXPECT_NEAR(jet.value(), 0, 1e-14);
      EXPECT_NEAR(jet.derivative(1, 0, 0), -std::cos(a) * std::cos(turn), 1e-12);
      EXPECT_NEAR(jet.derivative(0, 1, 0), -std::cos(a) * std::sin(turn), 1e-12);
      EXPECT_NEAR(jet.derivative(0, 0, 1), -std::sin(a), 1e-12);
      const double far = 0.5 - 0.3 * (height - 1.0);
      const PointJet slope =
          evaluate(funnel.primitives()[0]->function,
                   {far * std::cos(turn), far * std::sin(turn), height - 1.0}, 1);
      EXPECT_NEAR(slope.value(), 0, 1e-14);
      EXPECT_NEAR(slope.derivative(0, 0, 1), 0.3 / std::hypot(1, 0.3), 1e-12);
    }
}

TEST(Revolution, HasNoKinkOnTheAxis) {
  // ρ² alone: along x through the axis functions are even, with second derivatives.
  for (const Region& profile : {circle({0, 0}, 1), ellipse({0, 0.2}, {2, 1}), circle({0.4, 0}, 1),
                                half_plane({1, 0}, {-1, -1}), ellipse({0.3, 0}, {1, 0.5}, 0.5),
                                level_set(1.0 - pow(x, 4.0) - y * y),            // an oval
                                level_set(1.0 - pow(x - 0.2, 3.0) - x * y * y),  // odd parts
                                level_set(exp(-(x * x)) - y), level_set(0.8 - hypot(x, y))}) {
    const Region body = revolution(profile);
    for (const auto& primitive : body.primitives()) {
      const PointJet jet = evaluate(primitive->function, {0, 0, 0.1}, 3);
      EXPECT_EQ(jet.derivative(1, 0, 0), 0);
      EXPECT_EQ(jet.derivative(3, 0, 0), 0);
      EXPECT_TRUE(std::isfinite(jet.derivative(2, 0, 0)));
      const double ahead = evaluate(primitive->function, {1e-5, 0, 0.1}, 2).derivative(2, 0, 0);
      EXPECT_NEAR(ahead, jet.derivative(2, 0, 0), 1e-6 * (1 + std::fabs(ahead)));
    }
  }
}

TEST(Revolution, OfAnOvalIsThePolynomialInSpace) {
  // 1 − ρ⁴ − z²: derivatives of the polynomial to the fourth order, on the axis and off it.
  const Region body = revolution(level_set(1.0 - pow(x, 4.0) - y * y));
  const Field expected = 1.0 - pow(x * x + y * y, 2.0) - z_coordinate() * z_coordinate();
  for (const Point& at : {Point{0, 0, 0.4}, Point{0, 0, 0}, Point{0.3, -0.5, 0.2}}) {
    const PointJet jet = evaluate(body.primitives()[0]->level, at, 4);
    const PointJet exact = evaluate(expected, at, 4);
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; i + j <= 4; ++j)
        for (int k = 0; i + j + k <= 4; ++k)
          EXPECT_NEAR(jet.derivative(i, j, k), exact.derivative(i, j, k), 1e-13);
  }
}

TEST(Revolution, OfFamiliarProfilesIsTheFamiliarPrimitive) {
  const auto same = [](const Field& f, const Field& g) {
    for (const Point& at : {Point{0.3, 0.4, 0.2}, Point{-1, 2, 0.7}, Point{0, 0, -1}})
      EXPECT_NEAR(value_at(f, at), value_at(g, at), 1e-13);
  };
  same(revolution(circle({0, 0}, 2)).primitives()[0]->function,
       sphere({0, 0, 0}, 2).primitives()[0]->function);
  same(revolution(half_plane({1.5, 0}, {-1, 0})).primitives()[0]->function,
       cylinder({0, 0, 0}, {0, 0, 1}, 1.5).primitives()[0]->function);
  // x ≥ 0 holds everywhere, and is left out.
  EXPECT_EQ(revolution(box({0, -1}, {1, 1})).primitives().size(), 3u);
}

TEST(Extrusion, HoldsThePointsAboveItsProfile) {
  const Region plate =
      extrusion(circle({0, 0}, 1).named("disk") - box({-0.2, -0.2}, {0.2, 0.2}), 1, 3);
  const RegionEvaluator body(plate);
  EXPECT_TRUE(body.contains(Point{0.5, 0.5, 2}));
  EXPECT_FALSE(body.contains(Point{0.1, 0.1, 2}));
  EXPECT_FALSE(body.contains(Point{0.5, 0.5, 3.01}));
  EXPECT_FALSE(body.contains(Point{0.5, 0.5, 0.99}));
  EXPECT_EQ(plate.primitives().back()->name, "end");
  EXPECT_EQ(plate.primitives().front()->name, "disk");
}

// What is known of a profile is known of its bodies: the star is too many-sided to be enclosed from
// afar.
TEST(ProfileBodies, AreEnclosedAsTheirProfilesAre) {
  constexpr int edges = 300;
  std::vector<Point> points;
  for (int k = 0; k < edges; ++k) {
    const double radius = k % 2 == 0 ? 1 : 0.6, angle = 2 * std::numbers::pi * (k + 0.3) / edges;
    points.push_back({3 + radius * std::cos(angle), radius * std::sin(angle)});
  }
  const auto extent = [&](auto&& measure) {
    std::vector<double> values;
    for (const Point& point : points) values.push_back(measure(point));
    const auto [low, high] = std::ranges::minmax(values);
    return Interval{low, high};
  };
  const Interval across = extent([](const Point& p) { return p[0]; });
  const Interval along = extent([](const Point& p) { return p[1]; });
  const auto expect = [](const Region& region, std::vector<Interval> sides) {
    ASSERT_TRUE(region.enclosure());
    const Box& box = *region.enclosure();
    ASSERT_EQ(box.dimension, region.dimension());
    for (int axis = 0; axis < box.dimension; ++axis) {
      EXPECT_NEAR(box.low[axis], sides[axis].low, 1e-14) << axis;
      EXPECT_NEAR(box.high[axis], sides[axis].high, 1e-14) << axis;
    }
  };
  const Region star = polygon(points);
  expect(extrusion(star, -1, 2), {across, along, {-1, 2}});
  const double outer = across.high;
  expect(revolution(star, {1, 2, 3}, {0, 0, 2}),
         {{1 - outer, 1 + outer}, {2 - outer, 2 + outer}, {3 + along.low, 3 + along.high}});
  expect(revolution(star, {1, 2, 3}, {-1, 0, 0}),
         {{1 - along.high, 1 - along.low}, {2 - outer, 2 + outer}, {3 - outer, 3 + outer}});
  Similarity quarter;
  quarter.scale = 2, quarter.angle = std::numbers::pi / 2, quarter.about = {1, 1, 0};
  quarter.translation = {0.5, 0, 0};
  expect(transformed(star, quarter), {{1.5 - 2 * (along.high - 1), 1.5 - 2 * (along.low - 1)},
                                      {1 + 2 * (across.low - 1), 1 + 2 * (across.high - 1)}});
  // Turned otherwise, the box is too large, and the search goes on from it.
  Similarity turn;
  turn.angle = 0.4;
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Box found = bounding_box(RegionEvaluator(transformed(star, turn)));
  const Interval x = extent([&](const Point& p) { return c * p[0] - s * p[1]; });
  const Interval y = extent([&](const Point& p) { return s * p[0] + c * p[1]; });
  EXPECT_NEAR(found.low[0], x.low, 1e-12);
  EXPECT_NEAR(found.high[0], x.high, 1e-12);
  EXPECT_NEAR(found.low[1], y.low, 1e-12);
  EXPECT_NEAR(found.high[1], y.high, 1e-12);
}

TEST(Transform, MovesPointsAsItSays) {
  const Region brick = box({0, 0, 0}, {1, 2, 3}, 3) - sphere({1, 2, 3}, 0.5);
  // Scaled by 2, turned by 90° about z, moved: (x, y, z) → (−2y + 5, 2x + 6, 2z + 7).
  const Region moved = transformed(brick, {2, std::acos(-1.0) / 2, {0, 0, 3}, {5, 6, 7}, {}});
  const RegionEvaluator before(brick), after(moved);
  std::mt19937 generator(2);
  const auto uniform = [&] { return -1 + 5 * 0x1p-32 * generator(); };
  for (int i = 0; i < 500; ++i) {
    const Point p{uniform(), uniform(), uniform()};
    const Point image{5 - 2 * p[1], 6 + 2 * p[0], 7 + 2 * p[2]};
    EXPECT_EQ(after.contains(image), before.contains(p));
  }
  for (const auto& primitive : moved.primitives()) {  // normalised still
    if (!primitive->level.same_as(primitive->function)) continue;
    const PointJet jet = evaluate(primitive->function, {5 - 2, 6 + 1, 7 + 3}, 1);
    if (std::fabs(jet.value()) < 1e-12) {
      EXPECT_NEAR(
          std::hypot(jet.derivative(1, 0, 0), jet.derivative(0, 1, 0), jet.derivative(0, 0, 1)), 1,
          1e-12);
    }
  }
}

TEST(Transform, KeepsFunctionsNormalised) {
  const Region egg =
      transformed(ellipse({1, 0}, {2, 1}, 0.3), {3, 1.1, {0, 0, 1}, {4, -2}, {1, 0}});
  for (double t = 0; t < 6; t += 0.4) {
    const double a = 2 * std::cos(t), b = std::sin(t), turn = 0.3 + 1.1;
    const Point on{1 + 4 + 3 * (a * std::cos(turn) - b * std::sin(turn)),
                   -2 + 3 * (a * std::sin(turn) + b * std::cos(turn))};
    const PointJet jet = evaluate(egg.primitives()[0]->function, on, 1, 2);
    EXPECT_NEAR(jet.value(), 0, 1e-14);
    EXPECT_NEAR(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 1, 1e-12);
  }
}

TEST(ProfileBodies, RefuseWhatHasNoMeaning) {
  EXPECT_THROW(extrusion(sphere({0, 0, 0}, 1), 0, 1), InvalidArgument);
  EXPECT_THROW(extrusion(circle({0, 0}, 1), 1, 1), InvalidArgument);
  EXPECT_THROW(revolution(circle({0, 0}, 1), {0, 0, 0}, {0, 0, 0}), InvalidArgument);
  EXPECT_THROW(revolution(half_plane({-1, 0}, {-1, 0})), InvalidArgument);  // nothing at x > 0
  EXPECT_THROW(transformed(circle({0, 0}, 1), {0, 0, {0, 0, 1}, {}, {}}), InvalidArgument);
  EXPECT_THROW(transformed(circle({0, 0}, 1), {1, 1, {1, 0, 0}, {}, {}}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
