#include "core/primitives.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

constexpr double pi = 3.14159265358979323846;

double slope_at(const Field& f, const Point& point, int dimension = 2) {
  const PointJet jet = evaluate(f, point, 1, dimension);
  return std::hypot(jet.derivative(1), dimension > 1 ? jet.derivative(0, 1) : 0.0,
                    dimension > 2 ? jet.derivative(0, 0, 1) : 0.0);
}

// Zero with unit slope on the boundary, positive at `inside`, and of one sign with `level`.
void expect_normalized(const Region& region, const std::vector<Point>& boundary,
                       const Point& inside) {
  ASSERT_EQ(region.primitives().size(), 1u);
  const Primitive& primitive = *region.primitives()[0];
  for (const Point& point : boundary) {
    EXPECT_NEAR(value_at(primitive.function, point), 0, 4e-15);
    EXPECT_NEAR(value_at(primitive.level, point), 0, 4e-15);
    EXPECT_NEAR(slope_at(primitive.function, point), 1, 1e-13);
    for (const double t : {0.3, 0.9, 1.1, 2.5}) {
      const Point at{std::lerp(inside[0], point[0], t), std::lerp(inside[1], point[1], t)};
      EXPECT_EQ(value_at(primitive.function, at) > 0, t < 1);
      EXPECT_EQ(value_at(primitive.level, at) > 0, t < 1);
    }
  }
}

TEST(Primitives, HalfPlaneIsASignedDistance) {
  const Region region = half_plane({1, 2}, {3, -4});
  const Field& distance = region.primitives()[0]->function;
  EXPECT_NEAR(value_at(distance, {1, 2}), 0, 1e-15);
  EXPECT_NEAR(value_at(distance, {1 + 3, 2 - 4}), 5, 1e-15);
  EXPECT_NEAR(value_at(distance, {1 - 3 + 4, 2 + 4 + 3}), -5, 1e-15);
  EXPECT_NEAR(slope_at(distance, {7, -3}), 1, 1e-15);
}

TEST(Primitives, CircleIsNormalized) {
  std::vector<Point> boundary;
  for (double t = 0; t < 2 * pi; t += 0.4)
    boundary.push_back({0.3 + 0.7 * std::cos(t), -0.2 + 0.7 * std::sin(t)});
  expect_normalized(circle({0.3, -0.2}, 0.7), boundary, {0.3, -0.2});
}

TEST(Primitives, EllipseIsNormalizedAndTurnsCounterClockwise) {
  const double angle = 0.6;
  std::vector<Point> boundary;
  for (double t = 0; t < 2 * pi; t += 0.4) {
    const double a = 1.5 * std::cos(t), b = 0.4 * std::sin(t);
    boundary.push_back({0.3 + a * std::cos(angle) - b * std::sin(angle),
                        -0.2 + a * std::sin(angle) + b * std::cos(angle)});
  }
  expect_normalized(ellipse({0.3, -0.2}, {1.5, 0.4}, angle), boundary, {0.3, -0.2});
}

TEST(Primitives, SidesOfABoxAreSignedDistances) {
  const Region region = box({-1, 2, 3}, {4, 3, 7}, 3);
  const char* names[] = {"left", "right", "bottom", "top", "back", "front"};
  const double distances[] = {1, 4, 0.5, 0.5, 1, 3};  // from (0, 2.5, 4)
  ASSERT_EQ(region.primitives().size(), 6u);
  for (int i = 0; i < 6; ++i) {
    const Primitive& side = *region.primitives()[i];
    EXPECT_EQ(side.name, names[i]);
    EXPECT_EQ(value_at(side.function, {0, 2.5, 4}), distances[i]) << side.name;
    EXPECT_EQ(slope_at(side.function, {0, 2.5, 4}, 3), 1);
  }
  EXPECT_EQ(box({0}, {1}, 1).primitives().size(), 2u);
}

TEST(Primitives, CapsuleIsNormalizedAndReachesAsFarAsItsRadius) {
  const Point from{0.1, -0.2, 0.3}, to{1.1, 0.4, -0.6};
  const double radius = 0.35;
  const Field function = capsule(from, to, radius).primitives()[0]->function;
  // Directions that point away from the segment: across it anywhere, and off its ends.
  const Point along{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  for (double t = 0.1; t < 6; t += 0.7)
    for (double height = -0.95; height < 1; height += 0.3) {
      const double ring = std::sqrt(1 - height * height);
      const Point n{ring * std::cos(t), ring * std::sin(t), height};
      const double forward = n[0] * along[0] + n[1] * along[1] + n[2] * along[2];
      const Point& end = forward > 0 ? to : from;
      for (const double s : {0.5, 1.0, 2.0}) {
        const double distance = s * radius;
        const Point point{end[0] + distance * n[0], end[1] + distance * n[1],
                          end[2] + distance * n[2]};
        EXPECT_NEAR(value_at(function, point), (1 - s * s) * radius / 2, 1e-15);
        EXPECT_NEAR(slope_at(function, point, 3), s, 1e-14);
      }
    }
  // Beside the segment: its middle, moved along a vector across it.
  const Point across{along[1] / 2, -along[0] / 2, 0};
  const double scale = radius / std::hypot(across[0], across[1]);
  const Point point{(from[0] + to[0]) / 2 + scale * across[0],
                    (from[1] + to[1]) / 2 + scale * across[1], (from[2] + to[2]) / 2};
  EXPECT_NEAR(value_at(function, point), 0, 1e-15);
  EXPECT_NEAR(slope_at(function, point, 3), 1, 1e-14);
}

TEST(Primitives, LevelSetsAreTakenAsTheyAre) {
  const Field f = x_coordinate() * y_coordinate();
  const Region region = level_set(f);
  EXPECT_TRUE(region.primitives()[0]->function.same_as(f));
  EXPECT_TRUE(region.primitives()[0]->level.same_as(f));
}

TEST(Primitives, SizesThatAreNotPositiveAreRefused) {
  EXPECT_THROW(half_plane({0, 0}, {0, 0}), InvalidArgument);
  EXPECT_THROW(circle({0, 0}, 0), InvalidArgument);
  EXPECT_THROW(circle({0, 0}, -1), InvalidArgument);
  EXPECT_THROW(circle({0, 0}, std::nan("")), InvalidArgument);
  EXPECT_THROW(ellipse({0, 0}, {1, 0}), InvalidArgument);
  EXPECT_THROW(ellipse({0, 0}, {-1, 1}), InvalidArgument);
  EXPECT_THROW(capsule({0, 0, 0}, {1, 0, 0}, 0), InvalidArgument);
  EXPECT_THROW(capsule({0, 0, 0}, {0, 0, 0}, 1), InvalidArgument);
  EXPECT_THROW(box({0, 0}, {1, 0}), InvalidArgument);
  EXPECT_THROW(box({0, 0}, {-1, 1}), InvalidArgument);
  EXPECT_THROW(box({0, 0, 0}, {1, 1, 1}, 4), InvalidArgument);
}

}  // namespace
}  // namespace rfm
