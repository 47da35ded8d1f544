// Situations in which quadrature on implicit domains is known to fail or to lose its order.

#include <gmock/gmock.h>

#include "core/polygon.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

struct Errors {
  double area;
  double perimeter;
  QuadratureReport report;
};

Errors errors(const Region& region, double area, double perimeter, int cells, int points = 8) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  const DomainRule rule = make_domain_rule(RegionEvaluator(region), grid(1.7, cells), options);
  return {std::fabs(rule.measure() - area), std::fabs(rule.boundary_measure() - perimeter),
          rule.report()};
}

// Lines through the origin at angle 0.3 and their parallels.
Field along() { return std::cos(0.3) * x() + std::sin(0.3) * y(); }
Field across() { return std::cos(0.3) * y() - std::sin(0.3) * x(); }

TEST(FailureModes, InternallyTangentDisks) {
  const Region region = disk(0, 0, 1) - disk(0.5 * std::cos(0.4), 0.5 * std::sin(0.4), 0.5);
  const Errors coarse = errors(region, 0.75 * pi, 3 * pi, 16);
  EXPECT_LT(coarse.area, 1e-10);
  EXPECT_LT(coarse.perimeter, 1e-8);
  const Errors fine = errors(region, 0.75 * pi, 3 * pi, 64);
  EXPECT_LT(fine.area, 1e-14);
  EXPECT_LT(fine.perimeter, 1e-13);
  EXPECT_EQ(fine.report.uncertified.boxes, 0);
}

TEST(FailureModes, TangentFilletsOfAStadium) {
  const auto line = [](const Field& f) { return region_of(f, 2); };
  const Region body =
      line(0.8 - along()) & line(0.8 + along()) & line(0.5 - across()) & line(0.5 + across());
  const Region ends = disk(0.8 * std::cos(0.3), 0.8 * std::sin(0.3), 0.5) |
                      disk(-0.8 * std::cos(0.3), -0.8 * std::sin(0.3), 0.5);
  const double area = 1.6 + pi / 4, perimeter = 3.2 + pi;
  const Errors coarse = errors(body | ends, area, perimeter, 16);
  EXPECT_LT(coarse.area, 1e-11);
  EXPECT_LT(coarse.perimeter, 1e-9);
  const Errors fine = errors(body | ends, area, perimeter, 64);
  EXPECT_LT(fine.area, 1e-14);
  EXPECT_LT(fine.perimeter, 1e-13);
  EXPECT_EQ(fine.report.uncertified.boxes, 0);
}

// A wing's section (NACA 0012) of 1,000 edges: at its thin end the lines of twenty edges lie in a
// box however small.
TEST(FailureModes, ManyShortEdgesAlongANearlyStraightCurve) {
  Contour contour;
  constexpr int half = 500;
  for (int i = -half; i < half; ++i) {
    const double s = 0.5 * (1 - std::cos(pi * (half - std::abs(i)) / half));
    const double thickness = 0.6 * (0.2969 * std::sqrt(s) - 0.126 * s - 0.3516 * s * s +
                                    0.2843 * s * s * s - 0.1015 * s * s * s * s);
    contour.points.push_back({s, i < 0 ? -thickness : thickness});
  }
  double area = 0, perimeter = 0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const Point &p = contour.points[i], &q = contour.points[(i + 1) % contour.points.size()];
    area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    perimeter += std::hypot(q[0] - p[0], q[1] - p[1]);
  }
  const Errors found = errors(polygon({contour}).region, std::fabs(area), perimeter, 32, 2);
  EXPECT_LT(found.area, 1e-14);
  EXPECT_LT(found.perimeter, 1e-13);
  EXPECT_EQ(found.report.uncertified.boxes, 0);
}

TEST(FailureModes, CuspBetweenTwoParabolas) {
  // |y| < x², 0 < x < 1. Arc length of y = x² on [0, 1]: (2√5 + asinh 2) / 4.
  const Region region = region_of(square(x()) - y(), 2) & region_of(square(x()) + y(), 2) &
                        half_plane(1, 0, 0) & half_plane(-1, 0, 1);
  const double perimeter = 2 * (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4 + 2;
  for (const int cells : {4, 16}) {
    const Errors error = errors(region, 2.0 / 3, perimeter, cells, 12);
    EXPECT_LT(error.area, 1e-14);
    EXPECT_LT(error.perimeter, 1e-11);
    EXPECT_EQ(error.report.uncertified.boxes, 0);
  }
}

TEST(FailureModes, CuspOfOnePrimitiveEndsInSmallReportedBoxes) {
  const Region region = region_of(x() * x() * x() - square(y()), 2) & half_plane(-1, 0, 1);
  const double perimeter = 2 + 2 * (std::pow(13.0, 1.5) / 27 - 8.0 / 27);
  const Errors coarse = errors(region, 0.8, perimeter, 4);
  EXPECT_LT(coarse.area, 1e-11);
  EXPECT_LT(coarse.perimeter, 1e-9);
  EXPECT_GT(coarse.report.uncertified.boxes, 0);
  EXPECT_LT(coarse.report.uncertified.measure, 1e-6);
  const Errors fine = errors(region, 0.8, perimeter, 64);
  EXPECT_LT(fine.area, 1e-14);
  EXPECT_LT(fine.perimeter, 1e-13);
}

TEST(FailureModes, NodeOfALemniscate) {
  const Region region = region_of(square(x()) - square(y()) - square(square(x()) + square(y())), 2);
  const double perimeter = 5.244115108584239621;  // the lemniscate constant times two
  const Errors coarse = errors(region, 1, perimeter, 4);
  EXPECT_LT(coarse.area, 1e-11);
  EXPECT_LT(coarse.perimeter, 1e-9);
  EXPECT_GT(coarse.report.uncertified.boxes, 0);
  EXPECT_LT(coarse.report.uncertified.measure, 1e-6);
  const Errors fine = errors(region, 1, perimeter, 64);
  EXPECT_LT(fine.area, 1e-14);
  EXPECT_LT(fine.perimeter, 1e-11);
}

TEST(FailureModes, ApexOfASquareRootOnTheBoundary) {
  // y > |x − 0.03| + 0.05, written with √(x²): the primitive is not smooth on the boundary.
  const Region region =
      region_of(y() - 0.05 - sqrt(square(x() - 0.03)), 2) & half_plane(0, -1, 1.05);
  const Errors coarse = errors(region, 1, 2 + 2 * std::sqrt(2.0), 4);
  EXPECT_LT(coarse.area, 1e-9);
  EXPECT_LT(coarse.perimeter, 1e-9);
  const Errors fine = errors(region, 1, 2 + 2 * std::sqrt(2.0), 64);
  EXPECT_LT(fine.area, 1e-11);
}

TEST(FailureModes, ApexAwayFromTheBoundaryCostsNothing) {
  const Errors error = errors(region_of(1 - sqrt(square(x()) + square(y())), 2), pi, 2 * pi, 16);
  EXPECT_LT(error.area, 1e-14);
  EXPECT_LT(error.perimeter, 1e-13);
  EXPECT_EQ(error.report.uncertified.boxes, 0);
}

TEST(FailureModes, CornerOfAHorizontalAndAVerticalTangent) {
  // y > x² and x > y², moved off the grid: no axis serves for both curves at the corner, a rotated
  // frame does.
  const Region region =
      region_of(y() - 0.05 - square(x() - 0.05), 2) & region_of(x() - 0.05 - square(y() - 0.05), 2);
  const double perimeter = 2 * (2 * std::sqrt(5.0) + std::asinh(2.0)) / 4;
  const Errors coarse = errors(region, 1.0 / 3, perimeter, 4);
  EXPECT_LT(coarse.area, 1e-9);
  EXPECT_LT(coarse.perimeter, 1e-8);
  const Errors fine = errors(region, 1.0 / 3, perimeter, 16);
  EXPECT_LT(fine.area, 1e-14);
  EXPECT_LT(fine.perimeter, 1e-13);
  EXPECT_EQ(fine.report.uncertified.boxes, 0);
}

TEST(FailureModes, SidesThatAreStraightWithoutShowingItMeetCirclesAtRightAngles) {
  // On lines of the grid and between them.
  for (const Field& factor : {3 + square(x()), exp(x()), -exp(-x())})
    for (const double height : {0.0, 0.1})
      for (const int cells : {4, 5, 16, 17}) {
        const Errors error = errors(disk(0.02, height, 1) & region_of((y() - height) * factor, 2),
                                    pi / 2, pi + 2, cells, 12);
        EXPECT_LT(error.area, cells < 10 ? 1e-10 : 1e-13) << cells;
        EXPECT_LT(error.perimeter, cells < 10 ? 1e-8 : 1e-12) << cells;
        EXPECT_EQ(error.report.uncertified.boxes, 0) << cells;
      }
}

TEST(FailureModes, InterfacesTakeNothingFromTheBoundary) {
  const RegionEvaluator region(disk(0, 0, 1));
  // Lines through the circle along axes, and a curve that meets it at right angles in all of its
  // points with a horizontal or vertical tangent.
  for (const Field& inside : {(x() - 0.3) * y(), x() * y() * exp(x()), sin(3 * x()) * y()})
    for (const int cells : {16, 17, 24}) {
      std::vector<LevelFunction> interfaces;
      interfaces.emplace_back(inside, 2);
      const DomainRule rule = make_domain_rule(region, grid(1, cells), {}, interfaces);
      EXPECT_NEAR(rule.boundary_measure(), 2 * pi, rule.report().order_difference.boundary + 1e-12)
          << cells;
    }
}

TEST(FailureModes, WhereStructureIsNotProvenTheBoundaryMayBeMissingAndThatIsSaid) {
  // Bounds of a quotient that cancels say nothing near x = 0, and points there are no numbers.
  const Field r2 = square(x()) + square(y());
  for (const Field& level : {cbrt(1 - r2), (1 - r2) / x() * x(), (1 - r2) * (1 - r2) * (1 - r2)}) {
    const DomainRule rule = make_domain_rule(RegionEvaluator(region_of(level, 2)), grid(2.1, 4));
    const QuadratureReport& report = rule.report();
    EXPECT_GT(report.uncertified.boxes, 0);
    EXPECT_TRUE(std::isfinite(report.divergence_defect));
    EXPECT_TRUE(std::isfinite(report.order_difference.boundary));
    EXPECT_NEAR(rule.boundary_measure(), 2 * pi, report.uncertified.boundary);
    EXPECT_NEAR(rule.measure(), pi, report.uncertified.measure);
  }
}

TEST(FailureModes, CubeRootsKeepTheDirectionOfTheirSurface) {
  const Errors error = errors(region_of(cbrt(1 - square(x()) - square(y())), 2), pi, 2 * pi, 5, 6);
  EXPECT_LT(error.area, 1e-4);
  EXPECT_LT(error.perimeter, 0.1);
}

TEST(FailureModes, TheSizeOfAFunctionDoesNotMatter) {
  // Neither squares of gradients nor of values are numbers.
  for (const double size : {1e-200, 1e200})
    for (const Field& shape :
         {1 - square(x()) - square(y()), exp(1 - square(x()) - square(y())) - 1}) {
      const Errors error = errors(region_of(size * shape, 2), pi, 2 * pi, 16, 10);
      EXPECT_LT(error.area, 1e-13) << size;
      EXPECT_LT(error.perimeter, 1e-12) << size;
      EXPECT_EQ(error.report.uncertified.boxes, 0) << size;
    }
}

TEST(FailureModes, CoincidentPrimitivesAndScaledCopiesCountOnce) {
  const Field f = 1 - square(x()) - square(y());
  const Region region = region_of(f, 2) & region_of(f * (2 + x()), 2) & region_of(3 * f, 2);
  for (const int cells : {4, 16}) {
    const Errors error = errors(region, pi, 2 * pi, cells, 16);
    EXPECT_LT(error.area, 1e-13);
    EXPECT_LT(error.perimeter, 1e-12);
  }
}

TEST(FailureModes, ALineAndItsComplementLeaveNoCrack) {
  const Field line = y() - 0.1 - 0.3 * x();
  const Region circle = disk(0, 0, 1);
  const Region region = (circle & region_of(line, 2)) | (circle & region_of(-2 * line, 2));
  for (const int cells : {4, 16, 64}) {
    const Errors error = errors(region, pi, 2 * pi, cells, 16);
    EXPECT_LT(error.area, 1e-13);
    EXPECT_LT(error.perimeter, 1e-12);
    EXPECT_EQ(error.report.uncertified.boxes, 0);
  }
}

TEST(FailureModes, APrimitiveThatOnlyTouchesZeroIsPositive) {
  // exp(line)… has no zero; (line)⁴ is never negative, and bounds say so: low ≥ 0 counts as inside.
  const Field line = y() - 0.1 - 0.2 * x();
  const Region region = disk(0, 0, 1) & region_of(pow(line, 4), 2);
  for (const int cells : {4, 16}) {
    const Errors error = errors(region, pi, 2 * pi, cells, 16);
    EXPECT_LT(error.area, 1e-13);
    EXPECT_LT(error.perimeter, 1e-12);
    EXPECT_EQ(error.report.uncertified.boxes, 0);
  }
}

TEST(FailureModes, TheSquareOfALineCostsNothing) {
  // Never negative, as the structure of the expression says; its zeros bound nothing.
  const Field line = y() - 0.1 - 0.2 * x();
  for (const int cells : {4, 16}) {
    const Errors error = errors(disk(0, 0, 1) & region_of(line * line, 2), pi, 2 * pi, cells, 16);
    EXPECT_LT(error.area, 1e-13);
    EXPECT_LT(error.perimeter, 1e-12);
    EXPECT_EQ(error.report.uncertified.boxes, 0);
    const Errors alone = errors(disk(0, 0, 1), pi, 2 * pi, cells, 16);
    EXPECT_EQ(error.report.cut_cells, alone.report.cut_cells);
  }
}

TEST(FailureModes, WhatIsNowherePositiveIsOutside) {
  const Field line = y() - 0.1 - 0.2 * x();
  const Region without = disk(0, 0, 1) - region_of(-square(line), 2);
  const Errors error = errors(without, pi, 2 * pi, 8, 16);
  EXPECT_LT(error.area, 1e-13);
  EXPECT_LT(error.perimeter, 1e-12);
  EXPECT_EQ(error.report.uncertified.boxes, 0);
  const DomainRule empty =
      make_domain_rule(RegionEvaluator(region_of(-pow(line, 4), 2)), grid(1.7, 8));
  EXPECT_EQ(empty.measure(), 0);
  EXPECT_EQ(empty.boundary_measure(), 0);
}

TEST(FailureModes, StripsAsThinAsOneTenBillionth) {
  for (const double width : {2e-3, 2e-6, 2e-10, 1e-10}) {
    const double w = width / 2;
    const Region strip = disk(0, 0, 1) & region_of(w - across(), 2) & region_of(w + across(), 2);
    const double area = 2 * (w * std::sqrt(1 - w * w) + std::asin(w));
    const Errors error = errors(strip, area, 4 * std::sqrt(1 - w * w) + 4 * std::asin(w), 16);
    EXPECT_LT(error.area, 1e-15);
    EXPECT_LT(error.perimeter, 1e-12);
    EXPECT_EQ(error.report.uncertified.boxes, 0);
  }
}

TEST(FailureModes, AnnuliAsThinAsOneTenBillionth) {
  for (const double width : {1e-3, 1e-6, 1e-10}) {
    const Region annulus = disk(0.1, 0.2, 1) - disk(0.1, 0.2, 1 - width);
    const Errors error = errors(annulus, pi * width * (2 - width), 2 * pi * (2 - width), 16);
    EXPECT_LT(error.area, 1e-14);
    EXPECT_LT(error.perimeter, 1e-12);
    EXPECT_EQ(error.report.uncertified.boxes, 0);
  }
}

TEST(FailureModes, BisectionThatHelpsNothingEndsAtTheBudget) {
  // x² + y² < 0.01 written so that bounds are hopeless: a sum of terms that cancel.
  Field hopeless = square(x()) + square(y()) - 0.01;
  for (int k = 1; k < 12; ++k) hopeless = hopeless + sin(k * 100 * x()) - sin(k * 100 * x());
  QuadratureOptions options;
  options.subdivision.max_work = 20000;
  options.cut_points = 3;
  const DomainRule rule = make_domain_rule(
      RegionEvaluator(region_of(-hopeless * (1 + exp(x())), 2)), grid(0.2, 2), options);
  EXPECT_LE(rule.report().uncertified.boxes, 4 * 51);
  EXPECT_NEAR(rule.measure(), pi * 0.01, rule.report().uncertified.measure + 1e-6);
}

TEST(FailureModes, MeasuresHoldForEveryPositionOfTheGrid) {
  // Divergence identity and area under rotation and translation of a region with corners, curved
  // sides, a hole and a re-entrant corner.
  for (int k = 0; k < 40; ++k) {
    const double t = 0.157 * k, c = std::cos(t), s = std::sin(t);
    const Field u = c * (x() - 0.01 * k) + s * (y() + 0.007 * k);
    const Field v = c * (y() + 0.007 * k) - s * (x() - 0.01 * k);
    const Region body = (region_of(0.8 - u, 2) & region_of(0.8 + u, 2) & region_of(0.6 - v, 2) &
                         region_of(0.6 + v, 2)) -
                        region_of(0.09 - u * u - v * v, 2) -
                        region_of(0.25 - square(u - 0.8) - square(v - 0.6), 2);
    const double area = 1.92 - 0.09 * pi - 0.0625 * pi;
    const double perimeter = 5.6 - 1 + 0.25 * pi + 0.6 * pi;
    const Errors coarse = errors(body, area, perimeter, 12, 10);
    EXPECT_LT(coarse.area, 1e-10) << k;
    EXPECT_LT(coarse.perimeter, 1e-8) << k;
    EXPECT_LT(coarse.report.divergence_defect, 1e-8) << k;
    const Errors fine = errors(body, area, perimeter, 48, 10);
    EXPECT_LT(fine.area, 1e-14) << k;
    EXPECT_LT(fine.perimeter, 1e-13) << k;
    EXPECT_LT(fine.report.divergence_defect, 1e-14) << k;
  }
}

}  // namespace
