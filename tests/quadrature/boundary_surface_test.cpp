#include "quadrature/boundary_surface.hpp"

#include <gmock/gmock.h>

#include <map>

#include "core/primitives.hpp"
#include "quadrature/facet_stitching.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Measured {
  BoundarySurface surface;
  double measure = 0;   ///< length or area
  double enclosed = 0;  ///< area or volume by the divergence theorem
};

Measured measured(const Region& region, const Grid& grid, int subdivisions = 1) {
  const RegionEvaluator evaluator(region);
  TessellationOptions options;
  options.subdivisions = subdivisions;
  Measured result{boundary_surface(evaluator, tessellate(evaluator, grid, options))};
  const BoundarySurface& surface = result.surface;
  for (int f = 0; f < surface.facets.size(); ++f) {
    const auto v = surface.facets.vertices(f);
    const Point &a = surface.points[v[0]], &b = surface.points[v[1]];
    if (v.size() == 2) {
      result.measure += std::hypot(b[0] - a[0], b[1] - a[1]);
      result.enclosed += 0.5 * (a[0] * b[1] - b[0] * a[1]);
    } else {
      const Point& c = surface.points[v[2]];
      const Point twice_area = cross(minus(b, a), minus(c, a));
      result.measure += 0.5 * std::hypot(twice_area[0], twice_area[1], twice_area[2]);
      result.enclosed += dot(twice_area, a) / 6;
    }
  }
  return result;
}

/// Sides of triangles, by the places of their ends, that do not occur once in each direction.
int sides_without_partner(const BoundarySurface& surface) {
  std::map<Point, int> number;
  std::map<std::pair<int, int>, int> sides;
  const auto at = [&](int vertex) {
    return number.try_emplace(surface.points[vertex], static_cast<int>(number.size()))
        .first->second;
  };
  for (int f = 0; f < surface.facets.size(); ++f) {
    const auto v = surface.facets.vertices(f);
    for (std::size_t i = 0; i < v.size(); ++i) ++sides[{at(v[i]), at(v[(i + 1) % v.size()])}];
  }
  int wrong = 0;
  for (const auto& [side, count] : sides) {
    const auto opposite = sides.find({side.second, side.first});
    if (count != 1 || opposite == sides.end() || opposite->second != 1) ++wrong;
  }
  return wrong;
}

Region off_center_ball() { return sphere({0.1, 0, 0.03}, 1); }
Region bored_ball() { return off_center_ball() - cylinder({0, 0.1, 0}, {1, 0.3, 0.2}, 0.4); }
Region turned_box() {
  Region box = half_space({0.5, 0.4, 0.3}, {-1, -0.4, -0.3});
  for (const Point& normal : {Point{1, 0.4, 0.3}, Point{-0.4, 1, 0}, Point{0.4, -1, 0},
                              Point{-0.3, -0.12, 1.16}, Point{0.3, 0.12, -1.16}})
    box = box & half_space({-0.6 * normal[0], -0.6 * normal[1], -0.6 * normal[2]}, normal);
  return box;
}

class BoundarySurfaceOf : public testing::TestWithParam<std::pair<const char*, Region>> {};
INSTANTIATE_TEST_SUITE_P(
    Bodies, BoundarySurfaceOf,
    testing::Values(std::pair{"ball", off_center_ball()}, std::pair{"bored_ball", bored_ball()},
                    std::pair{"turned_box", turned_box()},
                    std::pair{"rod", cylinder({0, 0, 0}, {0.2, 0.1, 1}, 0.6, 1.3)},
                    std::pair{"cone_on_rod", cone({0, 0, 1}, {0, 0, -1}, 0.5, 1) |
                                                 cylinder({0, 0, -0.4}, {0, 0, 1}, 0.3, 1)},
                    std::pair{"torus", torus({0, 0, 0}, {0, 0, 1}, 0.8, 0.3)},
                    std::pair{"box", box({-1, -1, -1}, {1, 0.7, 0.5}, 3)},
                    std::pair{"shell", off_center_ball() - sphere({0.3, 0.1, 0}, 0.4)}),
    [](const auto& body) { return body.param.first; });

TEST_P(BoundarySurfaceOf, IsClosedEachSideOccursOnceInEachDirection) {
  for (const int cells : {5, 6, 9})
    for (const int subdivisions : {1, 2}) {
      const Measured result = measured(GetParam().second, grid(1.37, cells, 3), subdivisions);
      EXPECT_EQ(sides_without_partner(result.surface), 0) << cells << " cells " << subdivisions;
      EXPECT_EQ(result.surface.open_edges, 0) << cells << " cells " << subdivisions;
    }
}

TEST_P(BoundarySurfaceOf, HasItsPointsOnTheirPrimitives) {
  const RegionEvaluator evaluator(GetParam().second);
  const Measured result = measured(GetParam().second, grid(1.37, 6, 3));
  for (std::size_t i = 0; i < result.surface.points.size(); ++i)
    EXPECT_NEAR(evaluator.level(result.surface.primitives[i]).value(result.surface.points[i]), 0,
                1e-8);
}

TEST(BoundarySurface, AreaAndVolumeOfABoredBallConvergeWithOrderTwo) {
  // Two balls; their areas and the volume between them are known.
  const Region shell = off_center_ball() - sphere({0.3, 0.1, 0}, 0.4);
  const double area = 4 * pi * (1 + 0.16), volume = 4 * pi / 3 * (1 - 0.064);
  const auto errors = [&](int cells) {
    const Measured result = measured(shell, grid(1.3, cells, 3));
    return std::array{area - result.measure, volume - result.enclosed};
  };
  const auto coarse = errors(10), fine = errors(24);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(std::log(std::fabs(coarse[k] / fine[k])) / std::log(2.4), 2, 0.25);
  EXPECT_LT(std::fabs(fine[0]), 0.08);
}

TEST(BoundarySurface, OfAPolyhedronIsExact) {
  const Region cube = box({-1, -1, -1}, {1, 0.7, 0.5}, 3);
  for (const int cells : {3, 8}) {
    const Measured result = measured(cube, grid(1.37, cells, 3), 2);
    EXPECT_NEAR(result.measure, 2 * (2 * 1.7 + 2 * 1.5 + 1.7 * 1.5), 1e-12);
    EXPECT_NEAR(result.enclosed, 2 * 1.7 * 1.5, 1e-12);
  }
}

TEST(BoundarySurface, LengthInThePlaneConvergesWithOrderTwo) {
  const Region ring = circle({0.1, 0.05}, 1) - circle({0.2, 0}, 0.4);
  const auto error = [&](int cells) {
    const Measured result = measured(ring, grid(1.3, cells));
    EXPECT_EQ(result.surface.open_edges, 0);
    return 2 * pi * 1.4 - result.measure;
  };
  const double coarse = error(20), fine = error(60);
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(3.0), 2, 0.2);
}

TEST(BoundarySurface, NormalsPointOutwardsAndBelongToTheirPiece) {
  const Region region = bored_ball();
  const RegionEvaluator evaluator(region);
  const Measured result = measured(region, grid(1.3, 8, 3));
  const BoundarySurface& surface = result.surface;
  ASSERT_GT(surface.points.size(), 100u);
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Point &p = surface.points[i], &n = surface.normals[i];
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-14);
    const LevelFunction& level = evaluator.level(surface.primitives[i]);
    EXPECT_NEAR(level.value(p), 0, 1e-9);
    // The ball is inside where its function is positive, the bore where it is negative.
    Point gradient;
    level.value_and_gradient(p, gradient);
    EXPECT_NEAR(dot(gradient, n) / std::hypot(gradient[0], gradient[1], gradient[2]),
                surface.primitives[i] == 0 ? -1 : 1, 1e-12);
  }
  for (int f = 0; f < surface.facets.size(); ++f) {
    const auto v = surface.facets.vertices(f);
    for (const int vertex : v)
      EXPECT_EQ(surface.primitives[vertex], surface.primitives[v[0]]) << "pieces share no points";
  }
}

TEST(FacetStitching, DividesTheTriangleWhoseSideOthersHaveDivided) {
  // A tetrahedron on the square's diagonal 0–1, of which one side has a point more: 4 lies beside
  // the middle of that side.
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, -0.05, -0.05}};
  const std::vector<Facet> facets{
      {{0, 2, 1}, 0}, {{0, 4, 3}, 1}, {{4, 1, 3}, 1}, {{1, 2, 3}, 2}, {{2, 0, 3}, 3}};
  EXPECT_EQ(count_open_sides(facets), 3);
  const std::vector<Facet> closed = stitched(facets, points, 0);
  EXPECT_EQ(count_open_sides(closed), 0);
  EXPECT_EQ(closed.size(), 6u);
}

TEST(FacetStitching, LeavesARimAlone) {
  // Three faces of a tetrahedron; the rim is an equilateral triangle of side √2.
  const std::vector<Point> points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  const std::vector<Facet> open{{{1, 0, 3}, 0}, {{2, 1, 3}, 0}, {{0, 2, 3}, 0}};
  EXPECT_EQ(count_open_sides(stitched(open, points, 1.4)), 3);
  EXPECT_EQ(count_open_sides(stitched(open, points, 1.5)), 0);
}

}  // namespace
