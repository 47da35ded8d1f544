#include "solution_structures/taylor_polynomial.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/derivative_fields.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Field x = x_coordinate(), y = y_coordinate();

TEST(TaylorPart, HasItsDerivativesAlongTheStraightNormal) {
  // On an ellipse, normalised to order 3.
  const Field omega = normalize(1 - x * x / 4 - y * y, 2, 3);
  const std::vector<Field> data{sin(x) * y, cos(2 * y), x * y - 1, exp(x)};
  const ConditionPart part = taylor_part(data, omega, 2);
  EXPECT_EQ(part.exponent, 4);
  for (double t = 0.1; t < 6.2; t += 0.7) {
    const Point at{2 * std::cos(t), std::sin(t)};
    const double length = std::hypot(std::cos(t) / 2, std::sin(t));
    const std::vector<Field> inward{-std::cos(t) / 2 / length, -std::sin(t) / length};
    for (int k = 0; k <= 3; ++k)
      EXPECT_NEAR(value_at(directional_derivative(part.polynomial.inhomogeneous(), inward, k), at),
                  value_at(data[static_cast<std::size_t>(k)], at), 1e-9)
          << k << " at " << t;
  }
}

// Example 7.1 of Shapiro (2007): the disk of radius 2 about (0, 2) cut by y ≥ 1, values and inward
// normal derivatives on the segment and on the arc.
TEST(TaylorPart, InterpolatesTheExampleOfTheSurvey) {
  const Field segment = y - 1, arc = (4 - x * x - pow(y - 2, 2)) / 4;
  const double pi = M_PI;
  const Field g0 = 1 + x * x, g1 = 10 * (cos(pi * x) + y);
  const Field h0 = 10 + pow(y - 2, 2), h1 = 10 * sin(pi * x) * cos(pi * y);
  const Field u = transfinite({taylor_part({g0, g1}, segment, 2), taylor_part({h0, h1}, arc, 2)})
                      .inhomogeneous();
  const double end = std::sqrt(3.0);
  for (const Point& at : on_segment({-end, 1}, {end, 1})) {
    EXPECT_NEAR(value_at(u, at), value_at(g0, at), 1e-10);
    EXPECT_NEAR(value_at(partial(u, 1), at), value_at(g1, at), 1e-10);
  }
  const double from = -std::asin(0.5);
  for (const Point& at : on_circle({0, 2}, 2, from, pi - from)) {
    if (at[1] < 1.05) continue;
    EXPECT_NEAR(value_at(u, at), value_at(h0, at), 1e-10);
    const Field inward = -0.5 * (x * partial(u, 0) + (y - 2) * partial(u, 1));
    EXPECT_NEAR(value_at(inward, at), value_at(h1, at), 1e-10);
  }
}

TEST(TaylorPart, WithoutNormalizersTheDerivativeIsAnother) {
  const Field arc = (4 - x * x - pow(y - 2, 2)) / 4, h0 = 10 + pow(y - 2, 2);
  const Point at{2 * std::cos(1.0), 2 + 2 * std::sin(1.0)};
  EXPECT_GT(std::fabs(value_at(inward_derivative(h0, arc, 2), at)), 1);
  EXPECT_NEAR(
      value_at(inward_derivative(taylor_part({h0, 0.0}, arc, 2).polynomial.inhomogeneous(), arc, 2),
               at),
      0, 1e-13);
}

TEST(TaylorPart, IsItsValueWithoutDerivatives) {
  EXPECT_TRUE(taylor_part({x}, y, 2).polynomial.inhomogeneous().same_as(x));
  EXPECT_THROW(taylor_part({}, y, 2), InvalidArgument);
}

}  // namespace
}  // namespace rfm
