#include "core/second_derivatives.hpp"

#include <gtest/gtest.h>

#include "core/primitives.hpp"

namespace rfm {
namespace {

Region of(const Field& f, int dimension) { return Region(Primitive{"f", f, f}, dimension); }

TEST(SecondDerivatives, OfQuadricsAreConstants) {
  const Field x = x_coordinate(), y = y_coordinate();
  const RegionEvaluator region(of(3 * x * x + 5 * x * y - y * y + x - 2, 2));
  SecondDerivatives second(region);
  const Hessian<double> at = second.at(0, {7, -3});
  const auto bounds = second.bounds(0, Box{2, {-1, -1}, {4, 9}});
  ASSERT_TRUE(bounds);
  const double exact[2][2] = {{6, 5}, {5, -2}};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      EXPECT_DOUBLE_EQ(at[i][j], exact[i][j]);
      EXPECT_TRUE((*bounds)[i][j].contains(exact[i][j]));
      EXPECT_LE((*bounds)[i][j].width(), 1e-14);
    }
}

TEST(SecondDerivatives, OfExpressionsAreEnclosed) {
  const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
  const RegionEvaluator region(of(x * x * y * z + sin(x) * y, 3));
  SecondDerivatives second(region);
  const Box box{3, {0.1, 0.2, 0.3}, {0.4, 0.6, 0.5}};
  const auto bounds = second.bounds(0, box);
  ASSERT_TRUE(bounds);
  for (const double s : {0.0, 0.3, 1.0})
    for (const double t : {0.0, 0.6, 1.0}) {
      const Point p{box.low[0] + s * box.length(0), box.low[1] + t * box.length(1), 0.41};
      const Hessian<double> at = second.at(0, p);
      const double exact[3][3] = {{2 * p[1] * p[2] - std::sin(p[0]) * p[1],
                                   2 * p[0] * p[2] + std::cos(p[0]), 2 * p[0] * p[1]},
                                  {2 * p[0] * p[2] + std::cos(p[0]), 0, p[0] * p[0]},
                                  {2 * p[0] * p[1], p[0] * p[0], 0}};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          EXPECT_NEAR(at[i][j], exact[i][j], 1e-14);
          EXPECT_LE((*bounds)[i][j].low, exact[i][j] + 1e-14);
          EXPECT_GE((*bounds)[i][j].high, exact[i][j] - 1e-14);
        }
    }
}

TEST(SecondDerivatives, AreUnknownAcrossKinks) {
  const Field x = x_coordinate(), y = y_coordinate();
  // Once differentiable at x = 0: the second derivative jumps from −2 to 2.
  const RegionEvaluator region(of(x * abs(x) + y * y * y, 2));
  SecondDerivatives second(region);
  EXPECT_FALSE(second.bounds(0, Box{2, {-1, 0}, {1, 1}}));
  const auto beside = second.bounds(0, Box{2, {0.5, 0}, {1, 1}});
  ASSERT_TRUE(beside);
  EXPECT_TRUE((*beside)[0][0].contains(2));
}

}  // namespace
}  // namespace rfm
