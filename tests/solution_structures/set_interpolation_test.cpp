#include "solution_structures/set_interpolation.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/derivative_fields.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/thin_set.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Field x = x_coordinate(), y = y_coordinate();

// An ellipse, a circle inside it, a segment, a point and a disk: sets of every kind that do not
// meet, with data that no single smooth function would give.
const Field ellipse = 1 - x * x / 9 - y * y / 4;
const ThinSet circle = arc_set({-1, 0.2}, 0.5, 0, 2 * M_PI), wire = segment_set({0.5, -1}, {1, 1}),
              nail = point_set({-2, 0.3});
const Field disk = (0.09 - pow(x - 1.8, 2) - y * y) / 0.6;
const Field region = select(step(disk), 0.0, -disk);

std::vector<SetData> every_kind() {
  return {{normalize(ellipse, 2), sin(x) * y, {cos(2 * y), exp(x / 2)}, normalize(ellipse, 2)},
          {circle.function, 3 + x, {x * y - 1}, circle.surface},
          {wire.function, {}, {2 + y}, wire.surface},
          {nail.function, 7.0},
          {region, exp(y) - x}};
}

const Field u = interpolated(every_kind(), 6, 2).inhomogeneous();

TEST(SetInterpolation, TakesTheValuesOnPointsCurvesAndRegions) {
  for (double t = 0.1; t < 6.2; t += 0.3) {
    const Point on_ellipse{3 * std::cos(t), 2 * std::sin(t)};
    EXPECT_NEAR(value_at(u, on_ellipse), value_at(sin(x) * y, on_ellipse), 1e-10);
    const Point on_circle{-1 + 0.5 * std::cos(t), 0.2 + 0.5 * std::sin(t)};
    EXPECT_NEAR(value_at(u, on_circle), 3 + on_circle[0], 1e-10);
    const Point in_disk{1.8 + 0.25 * std::cos(t), 0.25 * std::sin(t)};
    EXPECT_NEAR(value_at(u, in_disk), std::exp(in_disk[1]) - in_disk[0], 1e-12);
  }
  EXPECT_NEAR(value_at(u, {-2, 0.3}), 7, 1e-10);
}

TEST(SetInterpolation, TakesNormalDerivativesAlongTheStraightNormal) {
  for (double t = 0.1; t < 6.2; t += 0.3) {
    const Point at{3 * std::cos(t), 2 * std::sin(t)};
    const double length = std::hypot(std::cos(t) / 3, std::sin(t) / 2);
    const std::vector<Field> outward{std::cos(t) / 3 / length, std::sin(t) / 2 / length};
    EXPECT_NEAR(value_at(directional_derivative(u, outward, 1), at), std::cos(2 * at[1]), 1e-10);
    EXPECT_NEAR(value_at(directional_derivative(u, outward, 2), at), std::exp(at[0] / 2), 1e-9);
  }
}

TEST(SetInterpolation, NormalsOfCurvesInsidePointToWhereTheirFunctionFalls) {
  // Seen from both sides, since the function of the curve has either sign.
  for (const double shift : {1e-7, -1e-7})
    for (double t = 0.1; t < 6.2; t += 0.3) {
      const double r = 0.5 + shift;
      const Point at{-1 + r * std::cos(t), 0.2 + r * std::sin(t)};
      const std::vector<Field> outward{std::cos(t), std::sin(t)};
      EXPECT_NEAR(value_at(directional_derivative(u, outward, 1), at), at[0] * at[1] - 1, 1e-4);
    }
}

TEST(SetInterpolation, ASetWithADerivativeAloneLeavesTheValueToTheOthers) {
  std::vector<SetData> others = every_kind();
  others.erase(others.begin() + 2);
  const Field values = interpolated(others, 6, 2).inhomogeneous();
  const std::vector<Field> outward = gradient(-*wire.surface, 2);
  for (const double s : {0.1, 0.3, 0.55, 0.9}) {
    const Point at{0.5 + 0.5 * s, -1 + 2 * s};
    EXPECT_NEAR(value_at(u, at), value_at(values, at), 1e-9);
    const Point beside{at[0] + 1e-7, at[1]};
    EXPECT_NEAR(value_at(outward[0] * partial(u, 0) + outward[1] * partial(u, 1), beside),
                2 + at[1], 1e-4);
  }
}

TEST(SetInterpolation, IsTheSameInEveryUnitOfLength) {
  const auto in_unit = [](double unit) {
    const Field a = x / unit, b = y / unit;
    return interpolated({{unit * (1 - a), 2 + b, {}, {}, 1}, {unit * (1 + a), 3 * b, {}, {}, 3}},
                        2 * unit, 2)
        .inhomogeneous();
  };
  EXPECT_NEAR(value_at(in_unit(1), {0.3, 0.4}), value_at(in_unit(1000), {300, 400}), 1e-13);
}

TEST(SetInterpolation, OfSeveralSetsAndSecondDerivativesIsTheSameInEveryUnitOfLength) {
  const auto in_unit = [](double unit) {
    const Field a = x / unit, b = y / unit, edge = unit * (1 - a * a - b * b / 4) / 2;
    const Field side = normalize(edge, 2, 1, unit);
    return interpolated(
               {{side, b, {3.0 / unit, a / (unit * unit)}, side},
                {unit * abs(2 - a), a + 1, {}, {}, 0, {unit * abs(2 + a), unit * abs(3 - b)}}},
               4 * unit, 2)
        .inhomogeneous();
  };
  const Field one = in_unit(1);
  for (const double unit : {1e-6, 1e-3, 1e3, 1e6}) {
    const Field other = in_unit(unit);
    EXPECT_NEAR(value_at(other, {0.3 * unit, 0.4 * unit}), value_at(one, {0.3, 0.4}), 1e-12)
        << unit;
    // On the ellipse at (1, 0), whose normal is the x axis.
    EXPECT_NEAR(value_at(directional_derivative(other, {1.0, 0.0}, 2), {unit, 0}) * unit * unit, 1,
                1e-8)
        << unit;
  }
}

TEST(SetInterpolation, ExponentsDecideHowFlatItIsNextToASet) {
  // d/dx at x = 1 is that of the datum only with an exponent of 2 at least.
  const auto slope = [](int exponent) {
    const Field f =
        interpolated({{1 - x, 2 + x, {}, {}, exponent}, {1 + x, 5.0}}, 2, 2).inhomogeneous();
    return value_at(partial(f, 0), {1, 0});
  };
  EXPECT_NEAR(slope(2), 1, 1e-12);
  EXPECT_NEAR(slope(3), 1, 1e-12);
  EXPECT_GT(std::fabs(slope(1) - 1), 0.1);
}

TEST(SetInterpolation, WhatWouldBeLostOrHasNoMeaningIsRefused) {
  const Field d = 1 - x;
  EXPECT_THROW(interpolated({}, 1, 2), InvalidArgument);
  EXPECT_THROW(interpolated({{d, {}, {1.0}, d}}, 1, 2), InvalidArgument);
  EXPECT_THROW(interpolated({{d, 1.0, {1.0}, d, 1}}, 1, 2), InvalidArgument);
  EXPECT_THROW(interpolated({{d, 1.0, {1.0}}}, 1, 2), InvalidArgument);
  EXPECT_THROW(interpolated({{d, 1.0, {}, {}, -1}}, 1, 2), InvalidArgument);
  EXPECT_THROW(interpolated({{d, 1.0}, {d, {}, {1.0, 2.0}, d}}, 1, 2), InvalidArgument);
  EXPECT_THROW(interpolated({{d, 1.0, std::vector<Field>(5, 1.0), d}}, 1, 2), InvalidArgument);
}

}  // namespace
}  // namespace rfm
