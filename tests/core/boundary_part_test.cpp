#include "core/boundary_part.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/quadric.hpp"

namespace rfm {
namespace {

constexpr double degree = std::numbers::pi / 180;
using Extent = BoundaryPart::Extent;

BoundaryPart facing(const Region& region, int primitive, const Point& direction, double degrees) {
  return part_with_normal(primitive, RegionEvaluator(region), direction, degrees * degree);
}

TEST(BoundaryPart, FacesHaveTheirNormalAllOverOrNowhere) {
  const Region cube = box({0, 0, 0}, {1, 2, 3}, 3);
  for (int side = 0; side < 6; ++side) {
    Point outward{};
    outward[side / 2] = side % 2 ? 2.5 : -2.5;  // its length does not matter
    for (int other = 0; other < 6; ++other)
      EXPECT_EQ(facing(cube, other, outward, 89).extent,
                other == side ? Extent::all : Extent::none);
    EXPECT_EQ(facing(cube, side, outward, 1e-3).extent, Extent::all);
  }
  // A face at 30° to the direction.
  const Region slope = half_plane({0, 0}, {-std::sin(30 * degree), -std::cos(30 * degree)});
  EXPECT_EQ(facing(slope, 0, {0, 1}, 30.0001).extent, Extent::all);
  EXPECT_EQ(facing(slope, 0, {0, 1}, 29.9999).extent, Extent::none);
}

// The part of a circle or of a hole whose normal lies within an angle is an arc of twice the angle.
TEST(BoundaryPart, NormalsOfCirclesChooseArcsByAnAffineFunction) {
  const Region ring = circle({0.3, -0.2}, 2) - circle({0.3, -0.2}, 0.5);
  for (int k = 0; k < 2; ++k) {
    const BoundaryPart part = facing(ring, k, {0, 3}, 40);
    EXPECT_EQ(part.extent, Extent::some);
    EXPECT_TRUE(as_quadric(part.where, 2)->is_affine());
    const double radius = k == 0 ? 2 : 0.5, sign = k == 0 ? 1 : -1;
    for (int turn = 0; turn < 360; turn += 3) {
      const double c = std::cos(turn * degree), s = std::sin(turn * degree);
      const Point at{0.3 + radius * c, -0.2 + radius * s};
      EXPECT_NEAR(value_at(part.where, at), sign * s - std::cos(40 * degree), 1e-15);
    }
  }
}

TEST(BoundaryPart, NormalsOfCurvedSurfacesAreThoseOfTheSurface) {
  const Region egg = ellipsoid({1, 0, 0}, {1, 2, 3});
  const BoundaryPart part = facing(egg, 0, {0, 0, 1}, 50);
  for (double u = 0.1; u < 3; u += 0.3)
    for (double v = 0; v < 6; v += 0.5) {
      const Point at{1 + std::sin(u) * std::cos(v), 2 * std::sin(u) * std::sin(v), 3 * std::cos(u)};
      const Point n{at[0] - 1, at[1] / 4, at[2] / 9};
      const double expected = n[2] / std::hypot(n[0], n[1], n[2]) - std::cos(50 * degree);
      EXPECT_NEAR(value_at(part.where, at), expected, 1e-14);
    }
}

// Points of a cone and its outward normals in closed form, in metres and in millimetres, on a
// slanted axis, far from the origin.
TEST(BoundaryPart, NormalsOfConesChooseByTwoPlanes) {
  for (const double unit : {1.0, 1000.0})
    for (const double angle : {10.0, 30.0, 70.0}) {
      const Point apex{3 * unit, -5 * unit, 7 * unit}, axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
      const Point e{1 / std::sqrt(5.0), 2 / std::sqrt(5.0), 0};
      const Point f{axis[1] * e[2] - axis[2] * e[1], axis[2] * e[0] - axis[0] * e[2],
                    axis[0] * e[1] - axis[1] * e[0]};
      const Region cap = cone(apex, axis, angle * degree, 4 * unit);
      const Point direction{1, 2, -0.5};
      const BoundaryPart part = facing(cap, 0, direction, 50);
      ASSERT_EQ(part.extent, Extent::some);
      ASSERT_EQ(part.ends.size(), 2u);
      for (const Field& end : part.ends) EXPECT_TRUE(as_quadric(end, 3)->is_affine());
      const double s = std::sin(angle * degree), c = std::cos(angle * degree);
      for (int turn = 0; turn < 360; turn += 7) {
        const double x = std::cos(turn * degree), y = std::sin(turn * degree), h = 1.7 * unit;
        Point at = apex;
        double along = 0;
        for (int i = 0; i < 3; ++i) {
          at[i] += h * (axis[i] + s / c * (x * e[i] + y * f[i]));
          along += direction[i] / std::sqrt(5.25) * (c * (x * e[i] + y * f[i]) - s * axis[i]);
        }
        EXPECT_NEAR(value_at(part.where, at) / h, along - std::cos(50 * degree), 1e-13);
      }
    }
}

TEST(BoundaryPart, AlongItsAxisAConeHasOneAngleOfTheNormal) {
  const Region cap = cone({0.1, 0.2, 0.3}, {0, 0, -1}, 30 * degree, 4);
  for (const double within : {59.9, 60.0, 60.1, 119.9, 130.0}) {
    const BoundaryPart part = facing(cap, 0, {0, 0, 1}, within);  // n·d = sin 30° = cos 60°
    ASSERT_EQ(part.extent == Extent::none, within < 60) << within;
    if (part.extent != Extent::some) continue;
    EXPECT_GT(value_at(part.where, {0.1, 0.2, -1}), 0) << within;
  }
  EXPECT_EQ(facing(cap, 0, {0, 0, 1}, 125).extent, Extent::all);  // the other nappe as well
  EXPECT_EQ(facing(cap, 0, {0, 0, -1}, 90).extent, Extent::some);
  EXPECT_LT(value_at(facing(cap, 0, {0, 0, -1}, 90).where, {0.1, 0.2, -1}), 0);
}

TEST(BoundaryPart, SlopeIsConstantOnPlanesSpheresAndCircularCylindersOnly) {
  const auto slope = [](const Region& region) {
    return constant_slope(region.primitives()[0]->level, 3);
  };
  EXPECT_NEAR(*slope(level_set(3.0 * x_coordinate() + 4.0 * y_coordinate() - 7.0, 3)), 5, 1e-15);
  EXPECT_NEAR(*slope(sphere({1, 2, 3}, 4)), 1, 1e-15);
  EXPECT_NEAR(*slope(cylinder({1, 2, 3}, {1, -2, 2}, 0.25)), 1, 1e-13);
  EXPECT_FALSE(slope(ellipsoid({0, 0, 0}, {1, 1, 1.001})));
  EXPECT_FALSE(slope(cone({0, 0, 0}, {0, 0, 1}, 0.5)));
  EXPECT_FALSE(slope(torus({0, 0, 0}, {0, 0, 1}, 2, 1)));
}

TEST(BoundaryPart, TouchingFacesTouchDespiteRounding) {
  // Two blocks side by side at 0.1 + 0.2, which is not 0.3.
  const Region left = box({0, 0}, {0.3, 1}), right = box({0.1 + 0.2, 0.25}, {1, 0.75});
  const RegionEvaluator evaluator(left);
  const BoundaryPart face = part_touching(1, evaluator, right);
  ASSERT_EQ(face.extent, Extent::some);
  EXPECT_GT(value_at(face.where, {0.3, 0.5}), 0.2);
  EXPECT_NEAR(value_at(face.where, {0.3, 0.25}), 0, 1e-15);
  EXPECT_LT(value_at(face.where, {0.3, 0.2}), 0);
  const BoundaryPart top = part_touching(3, evaluator, right);
  for (const double x : {0.0, 0.1, 0.29}) EXPECT_LT(value_at(top.where, {x, 1}), 0);
}

TEST(BoundaryPart, ASurfaceTouchesItselfWhicheverSideTheShapeIsOn) {
  const Region disk = circle({0, 0}, 1), same = level_set(3.0 - 3.0 * pow(x_coordinate(), 2.0) -
                                                          3.0 * pow(y_coordinate(), 2.0));
  EXPECT_EQ(part_touching(0, RegionEvaluator(disk), disk).extent, Extent::all);
  EXPECT_EQ(part_touching(0, RegionEvaluator(disk), same).extent, Extent::all);
  EXPECT_EQ(part_touching(0, RegionEvaluator(disk), !same).extent, Extent::all);
  EXPECT_EQ(part_touching(0, RegionEvaluator(disk), circle({0, 0}, 1 + 1e-6)).extent, Extent::some);
}

TEST(BoundaryPart, DirectionsHaveALength) {
  EXPECT_THROW(facing(circle({0, 0}, 1), 0, {0, 0}, 5), InvalidArgument);
}

}  // namespace
}  // namespace rfm
