// Rules of every number of Gauss points, 1 to 14, in one, two and three dimensions: positive
// weights, exact where nothing is curved, and closer with every two points where something is.

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "quadrature/integrate.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

constexpr int most_points = 14;

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

void expect_positive_weights(const DomainRule& rule) {
  EXPECT_GT(*std::ranges::min_element(rule.cut_points().weights), 0);
  EXPECT_GT(*std::ranges::min_element(rule.boundary().points.weights), 0);
}

template <class Points>
double sum_of(const Points& points, const std::function<double(const Point&)>& f) {
  double sum = 0;
  for (int i = 0; i < points.size(); ++i) sum += points.weights[i] * f(points.point(i));
  return sum;
}

VolumePoints all_points(const DomainRule& rule) {
  VolumePoints points;
  for (const int cell : rule.inside_cells()) rule.add_inside_points(cell, points);
  points.append(rule.cut_points());
  return points;
}

double rising(double a, double b, int power) {
  return (std::pow(b, power + 1) - std::pow(a, power + 1)) / (power + 1);
}

// Powers up to 2q − 1 along each axis, of coordinates that reach from −0.85 to 0.95.
double power(const Point& p, const std::array<int, 3>& powers) {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis) product *= std::pow(p[axis], powers[axis]);
  return product;
}

Region box_region(int dimension) {
  const std::array<Field, 3> coordinates{x(), y(), z()};
  Region box = region_of(0.95 - x(), dimension) & region_of(0.85 + x(), dimension);
  for (int axis = 1; axis < dimension; ++axis)
    box = box & region_of(0.95 - coordinates[axis], dimension) &
          region_of(0.85 + coordinates[axis], dimension);
  return box;
}

class NumbersOfPoints : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimension, NumbersOfPoints, testing::Values(1, 2, 3));

TEST_P(NumbersOfPoints, IntegratePowersToTwiceTheirNumberMinusOneInBoxes) {
  // Along each axis, in cells that the faces cut, and over the faces.
  const int dimension = GetParam();
  const Region region = box_region(dimension);
  for (int q = 1; q <= most_points; ++q) {
    const DomainRule rule = rule_for(region, grid(1.1, dimension == 3 ? 3 : 5, dimension), q);
    expect_positive_weights(rule);
    EXPECT_EQ(rule.report().uncertified.boxes, 0);
    const VolumePoints points = all_points(rule);
    const int top = 2 * q - 1;
    for (const std::array<int, 3>& powers :
         {std::array{top, 0, 0}, std::array{top - 1, top, 0}, std::array{0, top - 1, top},
          std::array{top, top, top - 1}}) {
      double exact = 1, on_face = 1;
      std::array<int, 3> used{};
      for (int axis = 0; axis < dimension; ++axis) {
        used[axis] = powers[axis];
        exact *= rising(-0.85, 0.95, used[axis]);
        if (axis > 0) on_face *= rising(-0.85, 0.95, used[axis]);
      }
      const auto f = [&](const Point& p) { return power(p, used); };
      EXPECT_NEAR(sum_of(points, f), exact, 2e-14) << q;
      // The two faces across x are pieces 0 and 1.
      on_face *= std::pow(0.95, used[0]) + std::pow(-0.85, used[0]);
      double sum = 0;
      const SurfacePoints& surface = rule.boundary().points;
      for (int i = 0; i < surface.size(); ++i)
        if (surface.numbers[i] < 2) sum += surface.weights[i] * f(surface.point(i));
      EXPECT_NEAR(sum, on_face, 2e-14) << q;
    }
  }
}

TEST(NumbersOfPoints, IntegrateOneDegreeLessPerAxisOnTurnedPolytopes) {
  // Slanted faces raise the degree by one with each axis that has been integrated over: a
  // polynomial of total degree 2q − d is exact, one of 2q − d + 1 need not be.
  const auto rows = standard_rotation();
  const double c = std::cos(0.3), s = std::sin(0.3);
  const auto polynomial = [](double t, int degree) { return std::pow(t, degree); };
  for (int q = 2; q <= most_points; ++q) {
    const DomainRule plane = rule_for(turned_square(0.9, 0.3), grid(1.7, 4), q);
    expect_positive_weights(plane);
    // t = c x + s y is a coordinate of the square itself.
    const int flat = 2 * q - 2;
    const double square_moment = sum_of(
        all_points(plane), [&](const Point& p) { return polynomial(c * p[0] + s * p[1], flat); });
    EXPECT_NEAR(square_moment, 1.8 * rising(-0.9, 0.9, flat), 1e-14) << q;
    const int deep = 2 * q - 3;
    const DomainRule space = rule_for(rotated_cube(0.85), grid(1.7, 4, 3), q);
    expect_positive_weights(space);
    const auto along = [&](const Point& p) {
      return rows[1][0] * p[0] + rows[1][1] * p[1] + rows[1][2] * p[2] + 0.1;
    };
    const double cube_moment =
        sum_of(all_points(space), [&](const Point& p) { return polynomial(along(p), deep); });
    EXPECT_NEAR(cube_moment, 1.7 * 1.7 * rising(-0.75, 0.95, deep), 1e-14) << q;
  }
}

TEST(NumbersOfPoints, ComeCloserToCurvedBodiesWithEveryTwoMore) {
  const auto study = [](const StandardRegion& body, int cells, double factor) {
    const Grid grid(body.box, {cells, cells, cells});
    double volume = INFINITY, boundary = INFINITY;
    for (const int start : {1, 2})
      for (int q = start; q <= most_points; q += 2) {
        const DomainRule rule = rule_for(body.region, grid, q);
        expect_positive_weights(rule);
        if (q == start) volume = boundary = INFINITY;
        const double error = std::fabs(rule.measure() / body.measure - 1);
        const double other = std::fabs(rule.boundary_measure() / body.boundary - 1);
        EXPECT_LE(error, std::max(factor * volume, 2e-15)) << body.name << " " << q;
        EXPECT_LE(other, std::max(factor * boundary, 1e-14)) << body.name << " " << q;
        volume = error;
        boundary = other;
        if (q < 13) continue;
        EXPECT_LT(error, 2e-15) << body.name << " " << q;
        EXPECT_LT(other, 1e-14) << body.name << " " << q;
      }
  };
  const auto plane = standard_regions_2d();
  const auto space = standard_regions_3d();
  study(plane[0], 12, 0.1);
  study(plane[1], 24, 0.2);
  study(space[0], 10, 0.1);
}

TEST(NumbersOfPoints, OnALineTheEndsAreExactHoweverTheyAreGiven) {
  // The roots of cubics and of waves: ±√0.5, and π/8, 3π/8.
  const Region cubic = region_of(0.5 * x() - x() * x() * x(), 1);
  const Region wave = region_of(cos(4 * x()), 1);
  for (int q = 1; q <= most_points; ++q) {
    const DomainRule rule = rule_for(cubic & wave, grid(1, 7, 1), q);
    // 0 < x < √0.5 or x < −√0.5, without −3π/8 < … < −π/8 and π/8 < … < 3π/8: 0 to π/8.
    EXPECT_NEAR(rule.measure(), pi / 8, 1e-15) << q;
    EXPECT_EQ(rule.boundary().points.size(), 2) << q;
  }
}

TEST(NumbersOfPoints, BeyondFourteenAreServedOrRefused) {
  EXPECT_THROW(rule_for(disk(0, 0, 1), grid(1, 4), 0), InvalidArgument);
  EXPECT_NEAR(rule_for(disk(0, 0, 1), grid(1.1, 8), 20).measure(), pi, 1e-14);
}

}  // namespace
