#include "core/contour_check.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/curved_polygon.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

struct Divided {
  std::vector<CurvedEdge> edges;
  std::vector<std::vector<ContourLink>> links;
  explicit Divided(const std::vector<CurvedContour>& contours) {
    std::vector<std::vector<CurvePiece>> pieces;
    for (const CurvedContour& contour : contours) pieces.push_back(cleaned(contour, edges));
    std::vector<std::string> names(edges.size(), "edge");
    links = divided(pieces, names);
  }
};

CurvedContour circle_of(const Point& center, double radius) {
  return {{{center[0] - radius, center[1]}, {center[0] + radius, center[1]}}, {{1.0}, {1.0}}};
}

TEST(ContourParity, OfARingOfArcsIsThatOfTwoCircles) {
  const Divided ring({circle_of({0, 0}, 2), circle_of({0.3, 0.1}, 1)});
  const ContourParity parity(ring.links, ring.edges);
  for (double x = -2.53; x < 2.6; x += 0.1)
    for (double y = -2.53; y < 2.6; y += 0.1)
      EXPECT_EQ(parity.is_inside({x, y}), std::hypot(x, y) < 2 && std::hypot(x - 0.3, y - 0.1) > 1)
          << x << ", " << y;
}

TEST(ContourParity, OfAParabolaIsThatOfItsFormula) {
  // y = x (2 − x) over its chord.
  CurvedContour contour{{{0, 0}, {2, 0}}, {{}, {}}};
  contour.edges[1].conic = EdgeCurve::Conic{{1, 2}, 1};
  const Divided parabola({contour});
  const ContourParity parity(parabola.links, parabola.edges);
  for (double x = -0.53; x < 2.6; x += 0.1)
    for (double y = -0.53; y < 2; y += 0.1)
      EXPECT_EQ(parity.is_inside({x, y}), y > 0 && y < x * (2 - x)) << x << ", " << y;
}

TEST(WrongLinks, AreThoseBesideWhichTheRegionIsAnother) {
  const CurvedContour disk = circle_of({0, 0}, 1);
  const Divided divided_disk({disk});
  const auto wrong = [&](const Region& region) {
    return wrong_links(RegionEvaluator(region), divided_disk.links, divided_disk.edges).size();
  };
  EXPECT_EQ(wrong(curved_polygon({disk}).region), 0u);
  EXPECT_EQ(wrong(circle({0, 0}, 1)), 0u);
  EXPECT_EQ(wrong(circle({0, 0}, 1.01)), divided_disk.links[0].size());
  // The upper half lacks.
  const std::size_t lower = wrong(circle({0, 0}, 1) & half_plane({0, 0}, {0, -1}));
  EXPECT_GT(lower, 0u);
  EXPECT_LT(lower, divided_disk.links[0].size());
}

}  // namespace
}  // namespace rfm
