#include "core/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rfm {
namespace {

__extension__ using Wide = __int128;

TEST(Orientation, IsLeftRightOrOnTheLine) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, -1}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {7, 0}), 0);
  EXPECT_EQ(orientation({0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}), 0);
}

// Points (i ulp, j ulp) around (0.5, 0.5) against the line through (12, 12) and (24, 24): the
// classical pattern on which floating point fails (Kettner et al. 2008). The truth is i against j.
TEST(Orientation, IsExactWithinRoundingOfALine) {
  const double ulp = 0x1p-53;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const Point p{0.5 + i * ulp, 0.5 + j * ulp};
      const double x = p[0], y = p[1];  // as rounded
      const int expected = y > x ? 1 : y < x ? -1 : 0;
      ASSERT_EQ(orientation({12, 12}, {24, 24}, p), expected) << i << " " << j;
      ASSERT_EQ(orientation(p, {12, 12}, {24, 24}), expected);
      ASSERT_EQ(orientation({24, 24}, {12, 12}, p), -expected);
    }
}

// Integer coordinates up to 2^30: the determinant fits in 128 bits.
TEST(Orientation, AgreesWithIntegers) {
  std::mt19937_64 generator(3);
  std::uniform_int_distribution<long long> any(-(1LL << 30), 1LL << 30), few(-3, 3);
  for (int i = 0; i < 20000; ++i) {
    const long long ax = any(generator), ay = any(generator), dx = any(generator),
                    dy = any(generator), k = few(generator);
    const long long bx = ax + dx, by = ay + dy;
    const long long cx = ax + k * dx + few(generator) / 2, cy = ay + k * dy + few(generator) / 2;
    const Wide determinant =
        static_cast<Wide>(bx - ax) * (cy - ay) - static_cast<Wide>(by - ay) * (cx - ax);
    const int expected = determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
    const auto point = [](long long x, long long y) {
      return Point{static_cast<double>(x), static_cast<double>(y)};
    };
    ASSERT_EQ(orientation(point(ax, ay), point(bx, by), point(cx, cy)), expected);
  }
}

}  // namespace
}  // namespace rfm
