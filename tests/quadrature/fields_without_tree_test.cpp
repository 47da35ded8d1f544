// Fields that are no Boolean combination (blends, offsets, sampled distances) as one primitive
// each, alone and mixed with others.

#include <gmock/gmock.h>

#include "core/contour_distance.hpp"
#include "core/evaluate.hpp"
#include "core/exact_distances.hpp"
#include "core/expression_text.hpp"
#include "core/spline_field.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

TEST(FieldsWithoutTree, AStadiumHasASmoothLevelToFirstOrderOnly) {
  // Points within 0.2 of the segment |x| ≤ 0.6: a stadium from one field, of length 1.2 and ends of
  // radius 0.2. Its level √((|x| − 0.6)₊² + y²) is smooth across x = ±0.6 to first order only.
  const Field beyond = max(abs(x()) - 0.6, Field(0.0));
  const Region stadium = region_of(0.04 - square(beyond) - square(y()), 2);
  const DomainRule rule = rule_for(stadium, grid(1.1, 16), 8);
  EXPECT_NEAR(rule.measure(), 0.48 + 0.04 * pi, 1e-9 + rule.report().uncertified.measure);
  EXPECT_NEAR(rule.boundary_measure(), 2.4 + 0.4 * pi, 1e-6 + rule.report().uncertified.measure);
}

// J. Steiner's formulas: an offset of d adds L d + π d² to the area and 2 π d to the perimeter.
TEST(FieldsWithoutTree, OffsetOfAnEllipseByItsParallelCurve) {
  const double perimeter = 7.26633616541076, area = 1.5 * 0.75 * pi, offset = 0.2;
  const Region region = region_of(ellipsoid_distance({1.5, 0.75}, 2) + offset, 2);
  const auto order = [&](int points) { return rule_for(region, grid(2, 16), points); };
  const DomainRule rule = order(10);
  EXPECT_EQ(rule.report().uncertified.boxes, 0);
  EXPECT_NEAR(rule.measure(), area + perimeter * offset + pi * offset * offset, 1e-12);
  EXPECT_NEAR(rule.boundary_measure(), perimeter + 2 * pi * offset, 1e-11);
  // Inwards, as far as the radius of curvature 0.375 at the tips allows.
  const Region inner = region_of(ellipsoid_distance({1.5, 0.75}, 2) - offset, 2);
  const DomainRule less = rule_for(inner, grid(2, 32), 10);
  EXPECT_EQ(less.report().uncertified.boxes, 0);
  EXPECT_NEAR(less.measure(), area - perimeter * offset + pi * offset * offset, 1e-9);
  EXPECT_NEAR(less.boundary_measure(), perimeter - 2 * pi * offset, 1e-7);
}

// Of a polygon whose distance bounds tell no slopes: a best effort, and said so, but no side is
// lost.
TEST(FieldsWithoutTree, TheOffsetOfATriangleHasAllOfItsSides) {
  CurvedContour contour;
  contour.points = {{0, 0}, {2, 0}, {1, 1.5}};
  const double perimeter = 2 + 2 * std::sqrt(3.25), offset = 0.2;
  const Region region = region_of(contour_distance({contour}) + offset, 2);
  QuadratureOptions options;
  options.subdivision.max_work = 200'000;
  const DomainRule rule = make_domain_rule(RegionEvaluator(region), grid(2.5, 8), options);
  EXPECT_GT(rule.report().uncertified.boxes, 0);
  EXPECT_NEAR(rule.measure(), 1.5 + perimeter * offset + pi * offset * offset, 1e-4);
  EXPECT_NEAR(rule.boundary_measure(), perimeter + 2 * pi * offset, 1e-3);
}

// In space the volume is a cubic of the offset, its slope the surface.
TEST(FieldsWithoutTree, OffsetsOfAnEllipsoidHaveTheVolumesOfSteiner) {
  const auto shell = [](double offset) {
    return rule_for(region_of(ellipsoid_distance({1, 0.8, 0.6}, 3) + offset, 3), grid(1.6, 8, 3),
                    6);
  };
  const double ball = 4 * pi / 3, h = 0.1;
  const DomainRule one = shell(h), two = shell(2 * h), three = shell(3 * h), four = shell(4 * h);
  EXPECT_EQ(one.report().uncertified.boxes, 0);
  EXPECT_NEAR(four.measure() - 3 * three.measure() + 3 * two.measure() - one.measure(),
              6 * ball * h * h * h, 1e-5);
  EXPECT_NEAR(three.boundary_measure() - 2 * two.boundary_measure() + one.boundary_measure(),
              6 * ball * h * h, 1e-3);
}

// Where a function is no number there is no inside, though what is known of its other values, or of
// a function of it, would make it one.
TEST(FieldsWithoutTree, PointsAreOutsideWhereTheFunctionIsNoNumber) {
  struct Case {
    Field field;
    double measure;
  };
  for (const auto& [field, measure] :
       {Case{-1.0 * log(x()), 0.5}, Case{1 - log(x()) - y() * y(), 0.5},
        Case{asin(4 * x()) + 2, 0.5}, Case{acos(4 * x()), 0.5},
        Case{sqrt(x()) + 1 - y() * y(), 0.5}, Case{pow(x(), Field(0.5)) + 0.1, 0.5},
        Case{exp(-1.0 * sqrt(x())), 0.5}, Case{abs(log(x())) + 1, 0.5},
        Case{square(sqrt(x())) + 1, 0.5}, Case{log(x()) + 1, 0.5 - std::exp(-1)}}) {
    const DomainRule rule = rule_for(region_of(field, 2), grid(0.5, 2), 4);
    EXPECT_NEAR(rule.measure(), measure, 1e-3) << to_text(field);
    // It is told how much of the grid that concerns.
    EXPECT_GT(rule.report().uncertified.measure, 0.49) << to_text(field);
    EXPECT_LT(rule.report().uncertified.measure, 0.53) << to_text(field);
  }
}

TEST(FieldsWithoutTree, ABlendOfTwoDisksMixesWithALine) {
  // Cassini's oval |p − a| |p + a| = b²: two disks melted into one. Its half x ≥ 0 has half the
  // area, and the line adds the chord of length 2 √(b² − a²).
  const double a = 0.6, b = 0.7;
  const Field oval =
      std::pow(b, 4) - (square(x() - a) + square(y())) * (square(x() + a) + square(y()));
  const auto order = [&](int points) {
    return rule_for(region_of(oval, 2), grid(1.1, 12), points);
  };
  const DomainRule whole = order(12);
  // Two orders agree, and the divergence theorem holds.
  EXPECT_NEAR(whole.measure(), order(14).measure(), 1e-12);
  EXPECT_LT(whole.report().divergence_defect, 1e-12);
  EXPECT_EQ(whole.report().uncertified.boxes, 0);
  const DomainRule half = rule_for(region_of(oval, 2) & half_plane(1, 0, 0), grid(1.1, 12), 12);
  EXPECT_NEAR(half.measure(), 0.5 * whole.measure(), 1e-12);
  EXPECT_NEAR(half.boundary_measure(0), 0.5 * whole.boundary_measure(), 1e-11);
  EXPECT_NEAR(half.boundary_measure(1), 2 * std::sqrt(b * b - a * a), 1e-12);
}

TEST(FieldsWithoutTree, TheRConjunctionAsOneFieldEndsInSmallReportedBoxes) {
  // The corner of an R-function is singular: unlike the tree of the same square it is not exact.
  const Field u = 0.8 - square(x()), v = 0.8 - square(y());
  const DomainRule rule =
      rule_for(region_of(u + v - sqrt(square(u) + square(v)), 2), grid(1.7, 9), 8);
  EXPECT_GT(rule.report().uncertified.boxes, 0);
  EXPECT_LT(rule.report().uncertified.measure, 1e-5);
  EXPECT_NEAR(rule.measure(), 3.2, 1e-8);
  EXPECT_NEAR(rule.boundary_measure(), 8 * std::sqrt(0.8), 1e-3);
}

// A field at the control points of a spline of degree 2 on a grid: its knots are at the lines.
std::shared_ptr<const SplineField> sampled(const Grid& knots, const Field& f) {
  const int degree = 2;
  std::vector<double> coefficients;
  std::array<int, 3> count{1, 1, 1};
  for (int axis = 0; axis < knots.dimension(); ++axis) count[axis] = knots.cells(axis) + degree;
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i) {
        Point p{};
        const std::array<int, 3> index{i, j, k};
        for (int axis = 0; axis < knots.dimension(); ++axis)
          p[axis] = knots.box().low[axis] + (index[axis] - 0.5) * knots.spacing(axis);
        coefficients.push_back(evaluate(f, p, 0, knots.dimension()).value());
      }
  return std::make_shared<const SplineField>(knots, degree, coefficients);
}

TEST(FieldsWithoutTree, ASampledFieldIsSplitAtItsKnotsAndKeepsTheOrder) {
  // The grid of the rule and that of the spline do not match. A quadratic spline reproduces
  // 1 − x² − y² up to a constant of h²/2 (control points are not values): the disk has radius
  // √(1 − h²/2).
  const Grid knots = grid(1.3, 13);
  const double h = knots.spacing(0);
  const Region disk = region_of(field(sampled(knots, 1 - square(x()) - square(y()))), 2);
  const double area = pi * (1 - 0.5 * h * h);
  const auto error = [&](int cells) {
    return std::fabs(rule_for(disk, grid(1.3, cells), 2).measure() - area);
  };
  EXPECT_LT(error(7), 1e-3);
  const DomainRule fine = rule_for(disk, grid(1.3, 7), 12);
  EXPECT_NEAR(fine.measure(), area, 1e-13);
  EXPECT_NEAR(fine.boundary_measure(), 2 * std::sqrt(pi * area), 1e-12);
  EXPECT_EQ(fine.report().uncertified.boxes, 0);
}

TEST(FieldsWithoutTree, ASampledFieldMixesWithPrimitivesInSpace) {
  const Grid knots = grid(1.3, 9, 3);
  const double h = knots.spacing(0), radius = std::sqrt(1 - 0.75 * h * h);
  const Field ball = field(sampled(knots, 1 - square(x()) - square(y()) - square(z())));
  const Region region = solid(ball) & solid(z() - 0.1 - 0.2 * x());
  const DomainRule rule = rule_for(region, grid(1.3, 7, 3), 10);
  const double d = 0.1 / std::sqrt(1.04), cap = radius - d;
  EXPECT_NEAR(rule.measure(), pi * cap * cap * (2 * radius + d) / 3, 1e-11);
  EXPECT_NEAR(rule.boundary_measure(0), 2 * pi * radius * cap, 1e-9);
  EXPECT_NEAR(rule.boundary_measure(1), pi * (radius * radius - d * d), 1e-9);
  EXPECT_EQ(rule.report().uncertified.boxes, 0);
}

}  // namespace
