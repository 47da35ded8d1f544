#include "core/sector_sides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/evaluate.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180;

TEST(SectorSides, OfAHalfDiskAreHalvesOfOneLine) {
  for (const double from : {-90.0, 0.0, 30.0, 77.7, 180.0, 315.3}) {
    const Point center{0.3, -0.7};
    const double begin = from * degree, end = (from + 180) * degree;
    const Region half = sector(center, 2, begin, end);
    ASSERT_EQ(half.primitives().size(), 2u) << from;
    EXPECT_EQ(half.primitives()[1]->name, "from_line");
    const auto sides = sector_sides(center, begin, end);
    ASSERT_EQ(sides.size(), 2u);
    EXPECT_EQ(sides[0].name, "from");
    EXPECT_EQ(sides[1].name, "to");
    for (const double r : {1e-3, 1.0, 1.999}) {
      const Point first{center[0] + r * std::cos(begin), center[1] + r * std::sin(begin)};
      const Point second{center[0] + r * std::cos(end), center[1] + r * std::sin(end)};
      for (const Point& point : {first, second}) {
        EXPECT_NEAR(value_at(half.primitives()[1]->function, point), 0, 1e-15);
        for (const OutlineSide& side : sides)
          EXPECT_EQ(value_at(*side.where, point) > 0, (side.name == "from") == (point == first));
      }
    }
    // Normalised where the product of two equal half-planes is not.
    const Point inside{center[0] - 1e-3 * std::sin(begin), center[1] + 1e-3 * std::cos(begin)};
    EXPECT_NEAR(value_at(half.primitives()[1]->function, inside), 1e-3, 1e-15);
  }
}

TEST(SectorSides, OfOtherSectorsArePrimitives) {
  for (const double angle : {1.0, 90.0, 179.999, 180.001, 270.0, 359.0}) {
    EXPECT_TRUE(sector_sides({0, 0}, 0.2, 0.2 + angle * degree).empty()) << angle;
    EXPECT_EQ(sector({0, 0}, 1, 0.2, 0.2 + angle * degree).primitives().size(), 3u) << angle;
  }
}

}  // namespace
}  // namespace rfm
