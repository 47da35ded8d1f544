#include "core/spline_interpolation.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

class EveryDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(SplineInterpolation, EveryDegree, testing::Values(1, 2, 3, 4, 5));

Field as_field(const SplineField& spline) { return field(std::make_shared<SplineField>(spline)); }

TEST_P(EveryDegree, PointsAscendFromEndToEnd) {
  const Grid grid({1, {-0.3}, {0.9}}, {7, 1, 1});
  const std::vector<double> points = interpolation_points(grid, 0, GetParam());
  ASSERT_EQ(static_cast<int>(points.size()), 7 + GetParam());
  EXPECT_EQ(points.front(), -0.3);
  EXPECT_EQ(points.back(), 0.9);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LT(points[i - 1], points[i]);
}

TEST_P(EveryDegree, PolynomialsOfTheDegreeAreReproducedInThreeDimensions) {
  const int p = GetParam();
  const Grid grid({3, {-0.3, 0.1, 0}, {0.9, 0.7, 2}}, {4, 3, 2});
  const Field exact = pow(x, p) * (1 - pow(y, p)) + 0.5 * pow(z, p) * x - y * pow(z, p - 1);
  const Field found = as_field(sample(exact, grid, p));
  for (const Point& point : {Point{-0.3, 0.1, 0}, Point{0.2, 0.33, 1.2}, Point{0.9, 0.7, 2}}) {
    const PointJet left = evaluate(found, point, 1), right = evaluate(exact, point, 1);
    const double size = std::pow(2, p);
    EXPECT_NEAR(left.value(), right.value(), 1e-13 * size);
    EXPECT_NEAR(left.derivative(1), right.derivative(1), 1e-12 * size);
    EXPECT_NEAR(left.derivative(0, 0, 1), right.derivative(0, 0, 1), 1e-12 * size);
  }
}

TEST_P(EveryDegree, OrderIsTheDegreePlusOne) {
  // And one less for each derivative.
  const int p = GetParam();
  const Field exact = sin(2 * x + y) * exp(0.5 * y);
  const auto errors = [&](int cells) {
    const Grid grid({2, {0, -0.4}, {1.3, 1}}, {cells, cells, 1});
    const Field difference = as_field(sample(exact, grid, p)) - exact;
    std::array<double, 2> largest{};
    for (double a = 0; a <= 1.3; a += 0.0371)
      for (double b = -0.4; b <= 1; b += 0.0413) {
        const PointJet jet = evaluate(difference, {a, b}, 1, 2);
        largest[0] = std::max(largest[0], std::fabs(jet.value()));
        largest[1] = std::max(largest[1], std::fabs(jet.derivative(1)));
      }
    return largest;
  };
  const auto coarse = errors(8), fine = errors(16);
  for (const int k : {0, 1}) {
    const double order = std::log2(coarse[k] / fine[k]);
    EXPECT_GT(order, p + 1 - k - 0.45) << "derivative " << k;
    EXPECT_LT(order, p + 1 - k + 0.6) << "derivative " << k;
  }
  EXPECT_LT(fine[0], 0.3 * std::pow(0.17, p + 1));
}

TEST(SplineInterpolation, ADistanceSampledOnAGridIsAPrimitiveWithDerivatives) {
  const Field distance = 1 - hypot(x, y);
  const Grid grid({2, {0.2, 0.2}, {1.2, 1.2}}, {40, 40, 1});
  const PointJet jet = evaluate(as_field(sample(distance, grid, 3)), {0.6, 0.8}, 2, 2);
  EXPECT_NEAR(jet.value(), 0, 1e-7);
  EXPECT_NEAR(jet.derivative(1), -0.6, 1e-5);
  EXPECT_NEAR(jet.derivative(2), -0.64, 1e-3);
}

TEST(SplineInterpolation, WrongValuesAreRefused) {
  const Grid grid({1, {0}, {1}}, {4, 1, 1});
  EXPECT_THROW(interpolate(grid, 3, std::vector<double>(6)), InvalidArgument);
  EXPECT_THROW(interpolate(grid, 9, std::vector<double>(13)), InvalidArgument);
  EXPECT_THROW(interpolate(grid, 1, {0, 1, NAN, 3, 4}), InvalidArgument);
  try {
    sample(log(x - 0.5), grid, 1);
    FAIL() << "no error";
  } catch (const ComputationError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("log(-0.5) in log(x - 0.5)"));
  }
}

}  // namespace
}  // namespace rfm
