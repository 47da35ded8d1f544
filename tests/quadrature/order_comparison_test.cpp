// The rule of another order, which looks for its roots where those of the first rule lead it.
#include "quadrature/order_comparison.hpp"

#include <gmock/gmock.h>

#include <random>

#include "core/mapped_region.hpp"
#include "core/primitives.hpp"
#include "quadrature/cell_surfaces.hpp"
#include "quadrature/cut_cell.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

// Calls `visit(box, active)` for the parts of cut cells.
template <class Visit>
void visit_cut_cells(const RegionEvaluator& region, const Grid& cells, Visit&& visit,
                     const Interfaces& interfaces = {}) {
  const CellClassification classification = classify_cells(region, cells, interfaces);
  const CellSurfaces surfaces(region, interfaces);
  const Breakpoints breakpoints = surfaces.breakpoints({});
  for (std::size_t c = 0; c < classification.cut_cells.size(); ++c)
    surfaces.visit_cut_cell(classification, static_cast<int>(c),
                            quadrature_cell(cells, cells.position(classification.cut_cells[c])),
                            breakpoints, visit);
}

// Bodies whose roots have no closed form: only these are followed.
std::vector<StandardRegion> bodies() {
  const auto power = [](double x0, double y0) {
    return square(square(x() - x0) + square(y() - y0));
  };
  std::vector<StandardRegion> all = {
      {"crescent of degree four",
       region_of(1 - power(0.1, -0.07), 2) & region_of(power(0.6, 0.3) - 0.3, 2), cube_box(1.7, 2)},
      {"lens of waves",
       region_of(0.3 - y() + 0.2 * sin(3 * x() + y()), 2) &
           region_of(0.2 + y() - 0.3 * cos(2 * x() - y()), 2),
       cube_box(1.7, 2)}};
  for (const StandardRegion& body : standard_regions_3d())
    for (const std::string name : {"torus", "quartic torus", "pawn"})
      if (body.name == name) all.push_back(body);
  return all;
}

// How much a cell of side 1 would be wrong where the rule of `points` − 1 points is made from the
// lines of the other instead of on its own.
CellMeasure disagreement(const StandardRegion& body, int cells, int points,
                         const Interfaces& interfaces = {}) {
  const RegionEvaluator region(body.region);
  const int dimension = region.dimension();
  Subdivision subdivision{SubdivisionOptions{}};
  CellRule both, alone;
  CellMeasure largest;
  visit_cut_cells(
      region, Grid(body.box, {cells, cells, dimension == 3 ? cells : 1}),
      [&](const Box& box, const ActiveSet& active) {
        add_cell_rule(box, active, {points, true}, subdivision, both);
        add_cell_rule(box, active, {points - 1, false}, subdivision, alone);
        const CellMeasure a = both.other_moments.measure, b = alone.moments.measure;
        const double side = box.length(0);
        largest.volume =
            std::max(largest.volume, std::fabs(a.volume - b.volume) / std::pow(side, dimension));
        largest.boundary = std::max(
            largest.boundary, std::fabs(a.boundary - b.boundary) / std::pow(side, dimension - 1));
      },
      interfaces);
  return largest;
}

TEST(OrderComparison, IsTheRuleOfOnePointFewer) {
  for (const StandardRegion& body : bodies())
    for (const int points : {3, 6}) {
      const CellMeasure wrong = disagreement(body, body.box.dimension == 3 ? 4 : 12, points);
      EXPECT_LE(wrong.volume, 1e-14) << body.name << " " << points;
      EXPECT_LE(wrong.boundary, 1e-13) << body.name << " " << points;
    }
}

// A slot with round ends in few cells, where errors fall by half with each point: what is announced
// is more than the error, and not a hundred times as much.
TEST(OrderComparison, IsABoundOfTheErrorOnCoarseCells) {
  std::mt19937 generator(77);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(generator);
  };
  for (int slot = 0; slot < 60; ++slot) {
    const double r = uniform(3, 10), x0 = uniform(-1, 1), y0 = uniform(-1, 1);
    Similarity turn;
    turn.angle = uniform(0, pi);
    turn.about = {x0, y0};
    const Region region =
        transformed(rfm::box({x0 - 0.6 * r, y0 - 0.4 * r}, {x0 + 0.6 * r, y0 + 0.4 * r}) |
                        circle({x0 - 0.6 * r, y0}, 0.4 * r) | circle({x0 + 0.6 * r, y0}, 0.4 * r),
                    turn);
    for (const int cells : {1, 2, 3})
      for (const int points : {4, 6, 8, 12}) {
        QuadratureOptions options;
        options.inside_points = options.cut_points = points;
        const DomainRule rule = make_domain_rule(RegionEvaluator(region), grid(12, cells), options);
        const QuadratureReport& report = rule.report();
        const double error = std::fabs(rule.boundary_measure() - r * (2.4 + 0.8 * pi));
        EXPECT_EQ(report.uncertified.boxes, 0);
        EXPECT_LE(error, report.order_difference.boundary + 1e-10) << slot << " " << cells;
        EXPECT_LE(report.order_difference.boundary, 1000 * error + 1e-6) << slot << " " << cells;
      }
  }
}

TEST(OrderComparison, SplitsPartsAtInterfacesToo) {
  // A wave through the middle of the body, with inside on both of its sides.
  std::vector<LevelFunction> wave;
  wave.emplace_back(y() - 0.05 - 0.1 * sin(4 * x()), 2);
  const Interfaces interfaces{wave};
  for (const StandardRegion& body : {bodies()[0], bodies()[1]}) {
    const CellMeasure wrong = disagreement(body, 12, 4, interfaces);
    EXPECT_LE(wrong.volume, 1e-14) << body.name;
    EXPECT_LE(wrong.boundary, 1e-13) << body.name;
  }
}

// The unit disk as a source, which counts how often it is evaluated at a point.
class CountingDisk : public FieldSource {
 public:
  void evaluate(const std::array<const double*, 3>& coordinates, int count, int, int order,
                double* jets, int stride) const override {
    for (int i = 0; i < count; ++i) {
      const double x = coordinates[0][i], y = coordinates[1][i];
      jets[i] = 1 - x * x - y * y;
      if (order < 1) continue;
      jets[stride + i] = -2 * x;
      jets[2 * stride + i] = -2 * y;
    }
    evaluations_ += count;
  }
  FunctionBounds bounds(const Box& box) const override {
    FunctionBounds result;
    result.value = Interval(1.0) - square(box.interval(0)) - square(box.interval(1));
    for (int axis = 0; axis < 2; ++axis)
      result.gradient[axis] = Interval(-2.0) * box.interval(axis);
    return result;
  }
  std::vector<double> breakpoints(int) const override { return {}; }
  Box valid() const override { return cube_box(2, 2); }
  int evaluations() const { return evaluations_; }

 private:
  mutable int evaluations_ = 0;
};

TEST(OrderComparison, TakesAFractionOfTheEvaluationsOfTheRule) {
  const auto source = std::make_shared<CountingDisk>();
  const RegionEvaluator region(region_of(field(source), 2));
  Subdivision subdivision{SubdivisionOptions{}};
  CellRule rule;
  const auto evaluations = [&](bool compare) {
    const int before = source->evaluations();
    visit_cut_cells(region, grid(1.3, 16), [&](const Box& box, const ActiveSet& active) {
      add_cell_rule(box, active, {6, compare}, subdivision, rule);
    });
    return source->evaluations() - before;
  };
  const int alone = evaluations(false), both = evaluations(true);
  // Five lines beside six, with two evaluations instead of five for each.
  EXPECT_LT(both - alone, 0.4 * alone);
  EXPECT_GT(both - alone, 0.1 * alone);
}

}  // namespace
