#include "quadrature/interfaces.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/evaluate.hpp"
#include "core/neighbourhood.hpp"
#include "core/primitives.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

struct Part {
  Field where;
  std::vector<LevelFunction> levels;
  std::vector<BoundaryEnds> ends;

  Part(const Neighbourhood& near, int dimension) : where(near.where) {
    for (const Field& end : near.ends.functions) levels.emplace_back(end, dimension);
    ends.push_back({0, static_cast<int>(levels.size()), near.ends.locator});
  }
  DomainRule rule(const Region& region, const Grid& grid, int points) const {
    QuadratureOptions options;
    options.inside_points = 2;
    options.cut_points = points;
    options.compare_orders = false;
    return make_domain_rule(RegionEvaluator(region), grid, options, {levels, ends});
  }
  double measure(const DomainRule& rule) const {
    double sum = 0;
    const SurfacePoints& points = rule.boundary().points;
    for (int i = 0; i < points.size(); ++i)
      if (value_at(where, points.point(i)) >= 0) sum += points.weights[i];
    return sum;
  }
};

// The order between the coarsest and the finest of three grids, on which errors are summed over
// several places of the point.
template <class Error>
double order(int coarsest, const Error& error) {
  const auto sum = [&](int cells) {
    double total = 0;
    for (double t = 0.1; t < 1; t += 0.171) total += error(cells, t);
    return total;
  };
  return std::log2(sum(coarsest) / sum(4 * coarsest)) / 2;
}

TEST(Interfaces, TheArcOfACircleNearAPointHasTheOrderOfTheRule) {
  // Points of the unit circle within D of one of them: the chord of half of the arc is D.
  const double D = 0.7;
  for (const int points : {2, 3}) {
    const double measured = order(16, [&](int cells, double t) {
      const Part part(neighbourhood(point_set({std::cos(t), std::sin(t)}), D), 2);
      return std::fabs(part.measure(part.rule(disk(0, 0, 1), grid(1.03, cells), points)) -
                       4 * std::asin(D / 2));
    });
    EXPECT_GT(measured, 2 * points - 0.5);
    EXPECT_LT(measured, 2 * points + 0.9);
  }
}

TEST(Interfaces, TheCapOfASphereNearAPointIsAsExactAsTheSphere) {
  // Its area is that of a disk whose radius is the distance.
  const double D = 0.7;
  for (const int points : {2, 3})
    for (const int cells : {4, 8, 16}) {
      double part_error = 0, whole_error = 0;
      for (const double t : {0.1, 0.4, 0.7}) {
        const Part part(neighbourhood(point_set({0.6 * std::cos(t), 0.6 * std::sin(t), 0.8}, 3), D),
                        3);
        const DomainRule rule = part.rule(sphere({0, 0, 0}, 1), grid(1.03, cells, 3), points);
        part_error += std::fabs(part.measure(rule) - pi * D * D);
        whole_error += std::fabs(rule.boundary_measure() - 4 * pi);
      }
      EXPECT_LT(part_error, whole_error) << cells << " cells, " << points << " points";
      if (points == 3 && cells == 16) {
        EXPECT_LT(part_error, 1e-6);
      }
    }
}

TEST(Interfaces, ThePartOfAFaceNearATriangulatedSquareIsThatOfItsOutline) {
  // The square with a rounded margin. Its triangles do not show.
  const double D = 0.15;
  for (const int n : {1, 3}) {
    std::vector<Triangle> square;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto at = [n](int a, int b) {
          return Point{-0.25 + 0.5 * a / n, -0.3 + 0.5 * b / n, 1};
        };
        square.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        square.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    const Part part(neighbourhood(square, D), 3);
    const Region block = box({-0.9, -0.9, -1}, {0.9, 0.9, 1}, 3);
    const DomainRule rule = part.rule(block, grid(1.01, 18, 3), 6);
    EXPECT_NEAR(part.measure(rule), 0.25 + 2 * D + pi * D * D, 1e-8);
  }
}

TEST(Interfaces, EndsOfPartsOfTheBoundaryLeaveCellsInsideWhole) {
  const Part part(neighbourhood(point_set({0.6, 0.8}), 0.7), 2);
  const DomainRule cut = part.rule(disk(0, 0, 1), grid(1.03, 16), 4);
  const DomainRule whole = make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1.03, 16));
  const DomainRule split =
      make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1.03, 16), {}, part.levels);
  EXPECT_EQ(cut.report().inside_cells, whole.report().inside_cells);
  EXPECT_LT(split.report().inside_cells, whole.report().inside_cells);
  EXPECT_NEAR(cut.measure(), pi, 1e-9);
}

}  // namespace
