#include "quadrature/domain_rule.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "core/field_source.hpp"
#include "core/level_function.hpp"
#include "core/multi_index.hpp"
#include "quadrature/integrate.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

double moment(const DomainRule& rule, int i, int j) {
  return integrate(rule, [&](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k)
      values[k] = std::pow(block.coordinates[0][k], i) * std::pow(block.coordinates[1][k], j);
  });
}

struct Body {
  const char* name;
  Region region;
  double area;
  double perimeter;
};
std::ostream& operator<<(std::ostream& out, const Body& body) { return out << body.name; }

// The lens of two circles of radius 1 and r at distance d, cut from the first.
Body disk_without_disk() {
  const double d = std::hypot(0.6, 0.3), r = 0.7;
  const double alpha = std::acos((d * d + 1 - r * r) / (2 * d));
  const double beta = std::acos((d * d + r * r - 1) / (2 * d * r));
  const double lens = alpha - std::sin(2 * alpha) / 2 + r * r * (beta - std::sin(2 * beta) / 2);
  return {"disk without disk", disk(0, 0, 1) - disk(0.6, 0.3, r), pi - lens,
          2 * (pi - alpha) + 2 * r * beta};
}

class CurvedBody : public testing::TestWithParam<Body> {};
INSTANTIATE_TEST_SUITE_P(
    DomainRule, CurvedBody,
    testing::Values(Body{"disk", disk(0.1, -0.07, 1), pi, 2 * pi},
                    Body{"ellipse", region_of(1 - square(x() - 0.03) - 4 * square(y() + 0.05), 2),
                         pi / 2, 4.844224110273838099},
                    Body{"disk as a square root",
                         region_of(1 - sqrt(square(x() - 0.1) + square(y())), 2), pi, 2 * pi},
                    disk_without_disk()));

TEST_P(CurvedBody, MeasuresAreExactToRoundingWithTenPoints) {
  const DomainRule rule = rule_for(GetParam().region, grid(1.7, 32), 10);
  EXPECT_NEAR(rule.measure(), GetParam().area, 1e-14 * GetParam().area);
  EXPECT_NEAR(rule.boundary_measure(), GetParam().perimeter, 1e-14 * GetParam().perimeter);
  EXPECT_LT(rule.report().divergence_defect, 1e-14);
  EXPECT_GT(rule.report().smallest_cut_fraction, 0);
  EXPECT_LE(rule.report().smallest_cut_fraction, 1);
}

class Polygon : public testing::TestWithParam<Body> {};
INSTANTIATE_TEST_SUITE_P(
    DomainRule, Polygon,
    testing::Values(Body{"turned square", turned_square(0.9, 0.3), 3.24, 7.2},
                    Body{"star", star(0.45, 0.21), star_area(0.45), star_perimeter(0.45)},
                    // Three sides of the smaller square and their corners stand outside.
                    Body{"square with notch",
                         turned_square(0.9, 0.3) -
                             turned_square(0.3, 0.3, 0.9 * std::cos(0.3), 0.9 * std::sin(0.3)),
                         3.24 - 0.18, 7.2 + 0.6}));

TEST_P(Polygon, MeasuresAreExactForEveryGridAndOrder) {
  for (const int cells : {1, 3, 4, 7, 16, 37})
    for (const int points : {1, 2, 5}) {
      const DomainRule rule = rule_for(GetParam().region, grid(1.7, cells), points);
      const double tolerance = points == 1 ? 1e-13 : 1e-14;
      EXPECT_NEAR(rule.measure(), GetParam().area, tolerance * GetParam().area) << cells;
      EXPECT_NEAR(rule.boundary_measure(), GetParam().perimeter, 1e-14 * GetParam().perimeter)
          << cells;
      EXPECT_EQ(rule.report().uncertified.boxes, 0);
    }
}

TEST(DomainRule, IntegratesPolynomialsOverAPolygonExactlyUpToItsDegreeAndNotBeyond) {
  // On a turned square inner integrals of x^i y^j have degree i + j + 1 along the base: exact for
  // i + j + 1 ≤ 2q − 1. ∫ x² = ∫ y² = a⁴ · 4/3 over a square of half side a in any position.
  const Region body = turned_square(0.9, 0.3);
  const double second = 4.0 / 3 * std::pow(0.9, 4);
  EXPECT_NEAR(moment(rule_for(body, grid(1.7, 5), 2), 2, 0), second, 1e-14);
  EXPECT_NEAR(moment(rule_for(body, grid(1.7, 5), 2), 1, 1), 0, 1e-15);
  EXPECT_GT(std::fabs(moment(rule_for(body, grid(1.7, 5), 2), 4, 0) -
                      moment(rule_for(body, grid(1.7, 5), 3), 4, 0)),
            1e-6);
  EXPECT_NEAR(moment(rule_for(body, grid(1.7, 5), 3), 4, 0),
              moment(rule_for(body, grid(1.7, 9), 8), 4, 0), 1e-14);
}

TEST(DomainRule, WeightsArePositiveAndPointsInside) {
  const Region region = disk(0, 0, 1) - disk(0.6, 0.3, 0.7);
  const RegionEvaluator evaluator(region);
  const DomainRule rule = make_domain_rule(evaluator, grid(1.7, 16));
  const VolumePoints& points = rule.cut_points();
  ASSERT_GT(points.size(), 0);
  for (int i = 0; i < points.size(); ++i) {
    EXPECT_GT(points.weights[i], 0);
    EXPECT_TRUE(evaluator.contains(points.point(i), 1e-15));
  }
}

TEST(DomainRule, SortsPointsByTheCellsThatContainThem) {
  const DomainRule rule = rule_for(star(0.45, 0.21), grid(1.7, 11), 3);
  const auto contains = [&](int cell, const Point& point) {
    return rule.grid().cell(rule.grid().position(cell)).contains(point);
  };
  for (std::size_t i = 0; i < rule.cut_cells().size(); ++i) {
    const int cell = rule.cut_cells()[i];
    EXPECT_EQ(rule.state(cell), CellState::cut);
    const PointRange range = rule.cut_range(static_cast<int>(i));
    EXPECT_GT(range.size(), 0);
    for (int k = range.begin; k < range.end; ++k)
      EXPECT_TRUE(contains(cell, rule.cut_points().point(k)));
  }
  const SurfaceRule& boundary = rule.boundary();
  for (std::size_t i = 0; i < boundary.cells.size(); ++i) {
    EXPECT_NE(rule.state(boundary.cells[i]), CellState::outside);
    const PointRange range = boundary.range(static_cast<int>(i));
    for (int k = range.begin; k < range.end; ++k)
      EXPECT_TRUE(contains(boundary.cells[i], boundary.points.point(k)));
  }
  EXPECT_EQ(boundary.begin.back(), boundary.points.size());
  int inside = 0;
  for (int cell = 0; cell < rule.grid().cell_count(); ++cell)
    inside += rule.state(cell) == CellState::inside;
  EXPECT_EQ(inside, rule.report().inside_cells);
}

TEST(DomainRule, NormalsAreOutwardAndUnitOnEveryPiece) {
  const Region outer = disk(0, 0, 1), inner = disk(0.1, 0.2, 0.4);
  const DomainRule rule = rule_for(outer - inner, grid(1.1, 9), 4);
  const SurfacePoints& points = rule.boundary().points;
  ASSERT_GT(points.size(), 0);
  for (int i = 0; i < points.size(); ++i) {
    const Point p = points.point(i), n = points.normal(i);
    if (points.numbers[i] == 0) {
      EXPECT_NEAR(n[0], p[0], 1e-14);
      EXPECT_NEAR(n[1], p[1], 1e-14);
    } else {
      EXPECT_EQ(points.numbers[i], 1);
      EXPECT_NEAR(n[0], -(p[0] - 0.1) / 0.4, 1e-14);
      EXPECT_NEAR(n[1], -(p[1] - 0.2) / 0.4, 1e-14);
    }
  }
}

TEST(DomainRule, EachPieceOfTheBoundaryHasItsOwnMeasure) {
  // A half disk: arc π, diameter 2.
  const DomainRule rule = rule_for(disk(0, 0.1, 1) & half_plane(0, 1, -0.1), grid(1.3, 8), 10);
  EXPECT_NEAR(rule.boundary_measure(0), pi, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(1), 2, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), pi + 2, 1e-13);
  EXPECT_NEAR(rule.measure(), pi / 2, 1e-13);
}

TEST(DomainRule, InterfacesSplitTheRuleWhereIntegrandsJump) {
  // f = 3 above the line y = 0.1 + 0.5 x and 1 below it, over the unit disk; the line is at
  // distance d = 0.1 / √1.25 from the centre, so that the segment above has area acos d − d √(1 −
  // d²).
  std::vector<LevelFunction> interfaces;
  interfaces.emplace_back(y() - 0.1 - 0.5 * x(), 2);
  QuadratureOptions options;
  options.inside_points = options.cut_points = 8;
  const RegionEvaluator region(disk(0, 0, 1));
  const DomainRule rule = make_domain_rule(region, grid(1, 12), options, interfaces);
  const double d = 0.1 / std::sqrt(1.25), above = std::acos(d) - d * std::sqrt(1 - d * d);
  const double jump = integrate(rule, [](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k)
      values[k] = block.coordinates[1][k] > 0.1 + 0.5 * block.coordinates[0][k] ? 3 : 1;
  });
  EXPECT_NEAR(jump, pi + 2 * above, 1e-13);
  EXPECT_NEAR(rule.measure(), pi, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), 2 * pi, 1e-13);
  EXPECT_NEAR(rule.interfaces().measure(0), 2 * std::sqrt(1 - d * d), 1e-13);
  const SurfacePoints& points = rule.interfaces().points;
  ASSERT_GT(points.size(), 0);
  for (int i = 0; i < points.size(); ++i)
    EXPECT_NEAR(points.normal(i)[1], -1 / std::sqrt(1.25), 1e-14);
}

TEST(DomainRule, InterfacesSplitTheBoundaryToo) {
  // The length of the unit circle where y > 0.1 + 0.5 x.
  std::vector<LevelFunction> interfaces;
  interfaces.emplace_back(y() - 0.1 - 0.5 * x(), 2);
  QuadratureOptions options;
  options.inside_points = options.cut_points = 10;
  const DomainRule rule =
      make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1, 12), options, interfaces);
  const double length =
      integrate(rule.boundary(), [](const QuadratureBlock& block, double* values) {
        for (int k = 0; k < block.count; ++k)
          values[k] = block.coordinates[1][k] > 0.1 + 0.5 * block.coordinates[0][k];
      });
  EXPECT_NEAR(length, 2 * std::acos(0.1 / std::sqrt(1.25)), 1e-12);
}

TEST(DomainRule, BreakpointsSplitCellsInsideAndCut) {
  // ∫ |x − 0.137| over the square |x|, |y| ≤ 1: (1 + 0.137²) · 2.
  QuadratureOptions options;
  options.inside_points = options.cut_points = 2;
  options.breakpoints[0] = {0.137};
  const Region region = region_of(1 - square(x()), 2) & region_of(1 - square(y()), 2);
  const auto integral = [&](const DomainRule& rule) {
    return integrate(rule, [](const QuadratureBlock& block, double* values) {
      for (int k = 0; k < block.count; ++k) values[k] = std::fabs(block.coordinates[0][k] - 0.137);
    });
  };
  const RegionEvaluator evaluator(region);
  const double exact = 2 * (1 + 0.137 * 0.137);
  EXPECT_NEAR(integral(make_domain_rule(evaluator, grid(1.2, 7), options)), exact, 1e-14);
  options.breakpoints[0].clear();
  EXPECT_GT(std::fabs(integral(make_domain_rule(evaluator, grid(1.2, 7), options)) - exact), 1e-4);
}

// y below 0.3 + max(x − 0.123, 0)²: the curvature of its boundary jumps at the knot.
class SplineGraph : public FieldSource {
 public:
  explicit SplineGraph(bool tells_knots) : tells_knots_(tells_knots) {}
  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override {
    std::fill(jets, jets + jet_size(variables, order) * stride, 0.0);
    for (int i = 0; i < count; ++i) {
      const double t = std::max(coordinates[0][i] - knot, 0.0);
      jets[i] = 0.3 + t * t - coordinates[1][i];
      if (order < 1) continue;
      jets[jet_index(variables, unit_index(0)) * stride + i] = 2 * t;
      jets[jet_index(variables, unit_index(1)) * stride + i] = -1;
    }
  }
  FunctionBounds bounds(const Box& box) const override {
    FunctionBounds result;
    const Interval t{std::max(box.low[0] - knot, 0.0), std::max(box.high[0] - knot, 0.0)};
    result.value = Interval(0.3) + rfm::square(t) - box.interval(1);
    result.gradient[0] = Interval(2.0) * t;
    result.gradient[1] = -1.0;
    return result;
  }
  std::vector<double> breakpoints(int axis) const override {
    return axis == 0 && tells_knots_ ? std::vector{knot} : std::vector<double>{};
  }
  Box valid() const override { return grid(2, 1).box(); }

 private:
  static constexpr double knot = 0.123;
  bool tells_knots_;
};

TEST(DomainRule, KnotsOfAPrimitiveSplitCells) {
  // ∫ over −1 ≤ x ≤ 1 of 0.3 + max(x − 0.123, 0)² = 0.6 + 0.877³ / 3.
  const auto area = [](bool tells_knots) {
    const Region below = region_of(field(std::make_shared<SplineGraph>(tells_knots)), 2);
    const Region region = below & half_plane(0, 1, 0) & half_plane(1, 0, 1) & half_plane(-1, 0, 1);
    return rule_for(region, grid(1.4, 7), 2).measure();
  };
  const double exact = 0.6 + std::pow(0.877, 3) / 3;
  EXPECT_NEAR(area(true), exact, 1e-14);
  EXPECT_GT(std::fabs(area(false) - exact), 1e-9);
}

TEST(DomainRule, InOneDimensionIsAUnionOfIntervals) {
  // [−0.8, 0.9] without (−0.1, 0.3)
  const Region region =
      (region_of(0.9 - x(), 1) & region_of(0.8 + x(), 1)) - region_of((x() + 0.1) * (0.3 - x()), 1);
  for (const int cells : {1, 2, 5, 17}) {
    const DomainRule rule = rule_for(region, grid(1.1, cells, 1), 3);
    EXPECT_NEAR(rule.measure(), 1.3, 1e-15);
    EXPECT_EQ(rule.boundary().points.size(), 4);
    EXPECT_NEAR(rule.boundary_measure(), 4, 1e-15);
    EXPECT_LT(rule.report().divergence_defect, 1e-15);
  }
}

TEST(DomainRule, CellsWithMorePrimitivesThanATruthTableHoldsAreDivided) {
  // A regular polygon of 30 sides in one cell.
  const int sides = 30;
  Region polygon = half_plane(-1, 0, 1);
  for (int k = 1; k < sides; ++k) {
    const double t = 2 * pi * k / sides;
    polygon = polygon & half_plane(-std::cos(t), -std::sin(t), 1);
  }
  const DomainRule rule = rule_for(polygon, grid(1.2, 1), 2);
  EXPECT_NEAR(rule.measure(), sides * std::tan(pi / sides), 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), 2 * sides * std::tan(pi / sides), 1e-13);
  EXPECT_EQ(rule.report().uncertified.boxes, 0);
}

TEST(DomainRule, ManyPrimitivesThroughOnePointEndInASmallReportedBox) {
  // Every second of 24 sectors of the disk: 12 lines through its centre.
  Region sectors = half_plane(std::cos(0.01), std::sin(0.01), 0);
  for (int k = 1; k < 12; ++k) {
    const double t = pi * k / 12 + 0.01;
    sectors = sectors ^ half_plane(std::cos(t), std::sin(t), 0);
  }
  const DomainRule rule = rule_for(disk(0, 0, 1) & sectors, grid(1.3, 5), 8);
  EXPECT_GT(rule.report().uncertified.boxes, 0);
  EXPECT_LT(rule.report().uncertified.measure, 1e-6);
  EXPECT_NEAR(rule.measure(), pi / 2, rule.report().uncertified.measure + 1e-10);
}

TEST(DomainRule, RegionAndGridOfDifferentDimensionAreRefused) {
  EXPECT_THROW(make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1, 4, 1)), InvalidArgument);
}

TEST(DomainRule, OptionsThatMakeNoSenseAreRefused) {
  const auto expect_refused = [](auto&& change) {
    QuadratureOptions options;
    change(options);
    EXPECT_THROW(make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1, 4), options),
                 InvalidArgument);
  };
  expect_refused([](auto& options) { options.subdivision.max_work = 0; });
  expect_refused([](auto& options) { options.subdivision.max_depth[1] = -1; });
  expect_refused([](auto& options) { options.subdivision.flatness[1] = NAN; });
  expect_refused([](auto& options) { options.subdivision.flatness_decay = 0; });
  expect_refused([](auto& options) { options.breakpoints[0] = {NAN}; });
  expect_refused([](auto& options) { options.gradings = {Grading{{NAN, 0, 0}, {0, 0, 0}}}; });
  expect_refused([](auto& options) {
    options.gradings = {Grading{}};
    options.gradings[0].reach = INFINITY;
  });
}

TEST(DomainRule, NumbersOfPointsOutOfRangeAreRefused) {
  QuadratureOptions options;
  options.cut_points = 0;
  EXPECT_THROW(make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1, 4), options),
               InvalidArgument);
}

}  // namespace
