#include "quadrature/surface_candidates.hpp"

#include <gtest/gtest.h>

#include "core/polygon.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {
namespace {

// Boxes within boxes about a point on an edge, the expression shortened on the way.
TEST(SurfaceCandidates, OfManyPrimitivesLeaveTheRegionAsItIsInSmallBoxes) {
  RandomPolygons random(4);
  int tables = 0;
  for (int i = 0; i < 40; ++i) {
    Contour contour{random.next(RandomPolygons::Kind::star)};
    const RegionEvaluator region(polygon({contour}).region);
    const Interfaces none;
    for (int k = 0; k < 10; ++k) {
      const std::size_t edge = random.integer(0, static_cast<int>(contour.points.size()) - 1);
      const Point &p = contour.points[edge],
                  &q = contour.points[(edge + 1) % contour.points.size()];
      const double t = random.real(0, 1);
      const Point center{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
      SurfaceCandidates candidates(region, none);
      for (double half = 1; half > 1e-4; half /= 2) {
        const Box box{
            2, {center[0] - half, center[1] - half}, {center[0] + half, center[1] + half}};
        const Truth inside = candidates.narrow(box, true, region, none);
        ASSERT_NE(inside, Truth::no);
        if (candidates.primitives.size() > 6) continue;
        SurfaceCandidates left = candidates;
        const TruthTable table = left.make_table(region.region().expression());
        ++tables;
        for (int j = 0; j < 10; ++j) {
          const Point at{random.real(box.low[0], box.high[0]),
                         random.real(box.low[1], box.high[1])};
          unsigned signs = 0;
          for (std::size_t v = 0; v < left.primitives.size(); ++v)
            if (region.level(left.primitives[v]).value(at) >= 0) signs |= 1U << v;
          ASSERT_EQ(table.value(signs), region.contains(at));
        }
      }
      // Of many edges few are left to look at.
      if (contour.points.size() > 40) {
        ASSERT_TRUE(candidates.open);
        ASSERT_LT(candidates.open->nodes().size(), 80u);
      }
    }
  }
  EXPECT_GT(tables, 1000);
}

}  // namespace
}  // namespace rfm
