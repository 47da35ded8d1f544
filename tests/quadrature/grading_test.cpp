// Integrals of powers of the distance r from points and segments.

#include "quadrature/grading.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "core/error.hpp"
#include "core/point_algebra.hpp"
#include "core/primitives.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

const std::array exponents{-0.5, 1.0 / 3, 0.6};

double integral(const Region& region, const Grid& grid, int points,
                const std::vector<Grading>& gradings,
                const std::function<double(const Point&)>& f) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  options.gradings = gradings;
  const DomainRule rule = make_domain_rule(RegionEvaluator(region), grid, options);
  VolumePoints all = rule.cut_points();
  for (const int cell : rule.inside_cells()) rule.add_inside_points(cell, all);
  double sum = 0;
  for (int i = 0; i < all.size(); ++i) {
    EXPECT_GT(all.weights[i], 0);
    sum += all.weights[i] * f(all.point(i));
  }
  return sum;
}

std::function<double(const Point&)> power_of_distance(const Point& from, double exponent) {
  return [=](const Point& point) { return std::pow(norm(along(point, -1, from)), exponent); };
}

Grading towards(const Point& point, int levels, double ratio = 0.5) {
  return {point, point, levels, ratio, 0};
}

// ∫ r^α over [0, 1]²: in polar coordinates ∫ sec^(α+2) over two half quadrants.
double over_unit_square(double exponent) {
  const GaussRule& gauss = gauss_legendre(40);
  double sum = 0;
  for (int i = 0; i < gauss.size(); ++i)
    sum += gauss.weights[i] * std::pow(std::cos(pi / 4 * gauss.nodes[i]), -exponent - 2);
  return 2 * pi / 4 * sum / (exponent + 2);
}
// Over [0, 1]³: three pyramids.
double over_unit_cube(double exponent) {
  const GaussRule& gauss = gauss_legendre(40);
  double sum = 0;
  for (int i = 0; i < gauss.size(); ++i)
    for (int j = 0; j < gauss.size(); ++j)
      sum += gauss.weights[i] * gauss.weights[j] *
             std::pow(1 + std::pow(gauss.nodes[i], 2) + std::pow(gauss.nodes[j], 2), exponent / 2);
  return 3 * sum / (exponent + 3);
}

// Three more levels of ratio 1/2 divide the error by 2^(3 (α + c)), neither more nor less.
void expect_rate(const std::function<double(int)>& error, double rate, const std::string& what,
                 int first = 3) {
  const double measured = std::log2(error(first) / error(first + 3)) / 3;
  EXPECT_NEAR(measured, rate, 0.06) << what;
}

TEST(Grading, ErrorsFallWithTheLevelsAsThePowerSaysInBoxes) {
  // The point is at a corner of cells, in a cell, on a side, and at a corner of the box.
  const Region square = box({-1, -1, 0}, {1, 1, 0}), cube = box({-1, -1, -1}, {1, 1, 1}, 3);
  for (const double a : exponents) {
    const auto plane = [&](int levels) {
      return std::fabs(integral(square, grid(1, 3), 12, {towards({0, 0, 0}, levels)},
                                power_of_distance({0, 0, 0}, a)) -
                       4 * over_unit_square(a));
    };
    expect_rate(plane, a + 2, "square " + std::to_string(a));
    EXPECT_LE(plane(20), 1e-9);
    const auto corner = [&](int levels) {
      return std::fabs(integral(square, grid(1, 4), 12, {towards({-1, 1, 0}, levels)},
                                power_of_distance({-1, 1, 0}, a)) -
                       std::pow(2, a + 2) * over_unit_square(a));
    };
    expect_rate(corner, a + 2, "corner " + std::to_string(a));
    const auto space = [&](int levels) {
      return std::fabs(integral(cube, grid(1, 2, 3), 9, {towards({0, 0, 0}, levels)},
                                power_of_distance({0, 0, 0}, a)) -
                       8 * over_unit_cube(a));
    };
    expect_rate(space, a + 3, "cube " + std::to_string(a), 1);
  }
}

TEST(Grading, IsExponentialInThePointsIfLevelsKeepPace) {
  // log error against q: each of the steps q = 3, 6, 9, 12 gains more than a factor of 20, all
  // together more than 1e5 (levels 3 q, so that the corner is negligible).
  const Region square = box({-1, -1, 0}, {1, 1, 0});
  for (const double a : exponents) {
    double previous = INFINITY, first = 0;
    for (const int q : {3, 6, 9, 12}) {
      const double error = std::fabs(integral(square, grid(1, 3), q, {towards({0, 0, 0}, 3 * q)},
                                              power_of_distance({0, 0, 0}, a)) -
                                     4 * over_unit_square(a));
      if (q == 3) first = error;
      EXPECT_LE(error, std::max(previous / 20, 2e-14)) << a << " " << q;
      previous = error;
    }
    EXPECT_LE(previous, 1e-5 * first) << a;
  }
}

TEST(Grading, WithoutItConvergenceIsAlgebraic) {
  // The test above would see the difference: 12 points without levels leave more than 1e-6.
  const Region square = box({-1, -1, 0}, {1, 1, 0});
  const double error =
      std::fabs(integral(square, grid(1, 4), 12, {}, power_of_distance({0, 0, 0}, -0.5)) -
                4 * over_unit_square(-0.5));
  EXPECT_GT(error, 1e-6);
}

TEST(Grading, WorksInCutCellsAtTheApexOfASector) {
  // The apex lies anywhere in a cell; opening 0.9 rad, radius 1: ∫ r^α = 0.9 / (α + 2).
  const Point apex{0.137, -0.071, 0};
  const double opening = 0.9, turn = 0.35;
  const Region sector = circle(apex, 1) & half_plane(apex, {-std::sin(turn), std::cos(turn), 0}) &
                        half_plane(apex, {std::sin(turn + opening), -std::cos(turn + opening), 0});
  for (const double a : exponents) {
    const auto error = [&](int levels) {
      return std::fabs(
          integral(sector, grid(1.31, 7), 14, {towards(apex, levels)}, power_of_distance(apex, a)) -
          opening / (a + 2));
    };
    // Of milder powers little more is left than the other cells leave.
    if (a < 0.5) expect_rate(error, a + 2, std::to_string(a));
    EXPECT_LE(error(24), 1e-11);
  }
}

TEST(Grading, ReentrantSectorsAndOtherRatiosToo) {
  const Region pacman =
      circle({0, 0}, 1) - (half_plane({0, 0}, {1, 0.1}) & half_plane({0, 0}, {0.2, -1}));
  const double removed = pi - std::acos((0.2 - 0.1) / std::sqrt(1.01 * 1.04));
  for (const double ratio : {0.2, 0.35}) {
    const int levels = static_cast<int>(26 / std::log2(1 / ratio));
    const double value = integral(pacman, grid(1.17, 6), 16, {towards({0, 0, 0}, levels, ratio)},
                                  power_of_distance({0, 0, 0}, -0.5));
    EXPECT_NEAR(value, (2 * pi - removed) / 1.5, 1e-9) << ratio;
  }
}

TEST(Grading, PointsInBallsAndSeveralAtOnce) {
  const Point inside{0.21, 0.13, -0.3};
  for (const double a : exponents)
    EXPECT_NEAR(integral(sphere(inside, 0.6), grid(1, 4, 3), 10, {towards(inside, 14)},
                         power_of_distance(inside, a)),
                4 * pi * std::pow(0.6, a + 3) / (a + 3), 2e-9);
  // Two singularities in one disk: each is smooth where the other is.
  const Point a{-0.3, 0, 0}, b{0.3, 0.02, 0};
  const auto both = [&](const Point& p) {
    return power_of_distance(a, -0.5)(p) + power_of_distance(b, -0.5)(p);
  };
  const Region halves = circle(a, 0.25) | circle(b, 0.25);
  // Over the disk around itself exactly; over the other by a rule for smooth functions.
  double expected = 2 * 2 * pi * std::pow(0.25, 1.5) / 1.5;
  expected += integral(circle(a, 0.25), grid(1, 40), 8, {}, power_of_distance(b, -0.5));
  expected += integral(circle(b, 0.25), grid(1, 40), 8, {}, power_of_distance(a, -0.5));
  EXPECT_NEAR(integral(halves, grid(1, 10), 14, {towards(a, 24), towards(b, 24)}, both), expected,
              1e-10);
}

std::function<double(const Point&)> power_of_radius(const Point& axis, double exponent) {
  return [=](const Point& p) { return std::pow(norm(cross(p, axis)), exponent); };
}

TEST(Grading, SegmentsAlongAnAxisAreNotSplitAlongIt) {
  // ρ^α around the axis of a cylinder of radius 0.7 and length 2: 2π · 2 · R^(α+2) / (α+2).
  const Region rod = cylinder({0, 0, 0}, {0, 0, 1}, 0.7, 2);
  for (const double a : exponents) {
    const auto error = [&](int levels) {
      return std::fabs(integral(rod, grid(1, 3, 3), 10, {{{0, 0, -1}, {0, 0, 1}, levels, 0.5, 0}},
                                power_of_radius({0, 0, 1}, a)) -
                       4 * pi * std::pow(0.7, a + 2) / (a + 2));
    };
    expect_rate(error, a + 2, std::to_string(a));
  }
}

TEST(Grading, ObliqueSegmentsConvergeAtTheSameRate) {
  const Point axis = scaled(1 / norm({1, 0.4, 0.7}), {1, 0.4, 0.7});
  const Region rod = cylinder({0, 0, 0}, axis, 0.5, 1);
  const Point end = scaled(0.5, axis), start = scaled(-0.5, axis);
  for (const double a : {-0.5, 0.6}) {
    const auto error = [&](int levels) {
      return std::fabs(integral(rod, grid(1, 2, 3), 6, {{start, end, levels, 0.5, 0}},
                                power_of_radius(axis, a)) -
                       2 * pi * std::pow(0.5, a + 2) / (a + 2));
    };
    // Where the segment cuts the smallest boxes changes from level to level.
    EXPECT_NEAR(std::log2(error(1) / error(5)) / 4, a + 2, 0.7) << a;
  }
  // A diagonal of the cells: no point lies on it.
  const double value =
      integral(box({-1, -1, 0}, {1, 1, 0}), grid(1, 4), 5, {{{-1, -1, 0}, {1, 1, 0}, 6, 0.5, 0}},
               [](const Point& p) { return 1 / std::sqrt(std::fabs(p[0] - p[1])); });
  // ∫∫ |x − y|^(−1/2) over [−1, 1]² = 2 · 2^(3/2) / (1/2 · 3/2).
  EXPECT_NEAR(value, 2 * std::pow(2, 1.5) / 0.75, 0.4);
}

TEST(Grading, TowardsACircleOfThePlaneErrorsFallAsThePowerSays) {
  // ∫ |r − 1|^α over 1/2 < r < 3/2: 2 · 2π (1/2)^(α + 1) / (α + 1).
  const Region ring = disk(0, 0, 1.5) - disk(0, 0, 0.5);
  const Field r2 = square(x()) + square(y());
  for (const double exponent : exponents) {
    const double exact = 4 * pi * std::pow(0.5, exponent + 1) / (exponent + 1);
    const auto error = [&](int levels) {
      return std::fabs(integral(ring, grid(1.6, 9), 8, {towards_curve({r2 - 1}, 2, levels)},
                                [&](const Point& p) {
                                  return std::pow(std::fabs(std::hypot(p[0], p[1]) - 1), exponent);
                                }) /
                           exact -
                       1);
    };
    const double order = std::log2(error(2) / error(6)) / 4;
    // At least; the errors of the parts along the curve have either sign, which gives half an
    // order.
    EXPECT_GT(order, exponent + 0.9) << exponent;
    EXPECT_LT(order, exponent + 1.9) << exponent;
  }
}

TEST(Grading, TowardsACircleOfSpaceErrorsFallAsThePowerSays) {
  // ∫ s^α over the tube of radius 0.4 about the circle ρ = 1, z = 0, s the distance from it: by
  // Pappus' theorem 2π · 2π 0.4^(α + 2) / (α + 2). The functions of the circle are those of a
  // sphere and a plane that meet in it.
  const Field ring = square(x()) + square(y());
  const Region tube = solid(4 * ring - square(ring + square(z()) + 0.84));
  for (const double exponent : {-0.5, 0.6}) {
    const double exact = 4 * pi * pi * std::pow(0.4, exponent + 2) / (exponent + 2);
    const auto error = [&](int levels) {
      return std::fabs(integral(tube, grid(1.5, 6, 3), 5,
                                {towards_curve({1 - ring - square(z()), z()}, 3, levels)},
                                [&](const Point& p) {
                                  return std::pow(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]),
                                                  exponent);
                                }) /
                           exact -
                       1);
    };
    const double finest = error(3);
    EXPECT_NEAR(std::log2(error(0) / finest) / 3, exponent + 2, 0.3) << exponent;
    EXPECT_LT(finest, 3e-5) << exponent;
  }
}

TEST(Grading, PartsNearACurveAreNoLargerThanTheirDistance) {
  Box unit;
  unit.dimension = 2;
  unit.low = {0, 0, 0};
  unit.high = {1, 1, 0};
  const double r = 0.7;
  const Grading grading = towards_curve({square(x()) + square(y()) - r * r}, 2, 6);
  double area = 0;
  visit_graded_parts(unit, std::span(&grading, 1), 1, [&](const Box& part) {
    area += part.measure();
    const double low = std::hypot(part.low[0], part.low[1]);
    const double high = std::hypot(part.high[0], part.high[1]);
    const double distance = std::max({low - r, r - high, 0.0});
    // √2 for the maximum norm; the smallest parts touch the curve.
    EXPECT_LE(part.longest_side(), std::max(std::sqrt(2.0) * distance, 1.0 / 64));
  });
  EXPECT_NEAR(area, 1, 1e-14);
}

TEST(Grading, PartsCoverTheBoxOnce) {
  for (const Grading& grading :
       {towards({0.3, 0.2, 0.9}, 7), towards({1, 1, 1}, 5, 0.3), towards({1.2, 0.5, 0.5}, 4),
        Grading{{0, 0.5, 0.5}, {0.6, 0.5, 0.5}, 4, 0.5, 0},
        Grading{{0, 0.1, 0.2}, {0.7, 0.9, 0.6}, 3, 0.5, 0}}) {
    const Box unit{3, {0, 0, 0}, {1, 1, 1}};
    double measure = 0;
    int parts = 0;
    visit_graded_parts(unit, std::span(&grading, 1), 1.0, [&](const Box& part) {
      measure += part.measure();
      ++parts;
      for (int axis = 0; axis < 3; ++axis) EXPECT_GT(part.length(axis), 0);
    });
    EXPECT_NEAR(measure, 1, 1e-13);
    EXPECT_GT(parts, 5);
    EXPECT_TRUE(is_graded(unit, std::span(&grading, 1), 1.0));
  }
  const Grading far = towards({9, 9, 9}, 5);
  EXPECT_FALSE(is_graded({3, {0, 0, 0}, {1, 1, 1}}, std::span(&far, 1), 1.0));
}

TEST(Grading, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(check({.levels = -1}), InvalidArgument);
  EXPECT_THROW(check({.levels = 61}), InvalidArgument);
  EXPECT_THROW(check({.ratio = 1}), InvalidArgument);
  EXPECT_THROW(check({.ratio = 0}), InvalidArgument);
  EXPECT_THROW(check({.reach = -1}), InvalidArgument);
  EXPECT_NO_THROW(check({}));
}

}  // namespace
