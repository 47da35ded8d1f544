#include "core/graded_lines.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

using testing::DoubleNear;
using testing::Pointwise;

TEST(GradedLines, AreEquallySpacedWhereNothingIsGraded) {
  const std::vector<double> equal{1, 1.5, 2, 2.5, 3};
  EXPECT_THAT(graded_lines(1, 3, 4, {}), Pointwise(DoubleNear(1e-15), equal));
  EXPECT_THAT(graded_lines(1, 3, 4, {{9}, 5, 1}), Pointwise(DoubleNear(1e-15), equal));
  EXPECT_THAT(graded_lines(1, 3, 4, {{2}, 1, 1}), Pointwise(DoubleNear(1e-15), equal));
}

TEST(GradedLines, HaveTheSizesThatAreAskedFor) {
  // In the limit of many cells, at, half-way to, and away from the places.
  const LineGrading grading{{-0.5, 0.4}, 10, 0.2};
  const std::vector<double> lines = graded_lines(-1, 1, 20000, grading);
  EXPECT_EQ(lines.size(), 20001u);
  EXPECT_EQ(lines.front(), -1);
  EXPECT_EQ(lines.back(), 1);
  const auto size = [&](double x) {
    const auto above = std::ranges::upper_bound(lines, x);
    return *above - *(above - 1);
  };
  const double far = size(0);
  for (const double place : grading.toward) {
    EXPECT_NEAR(size(place) / far, 0.1, 1e-3);
    EXPECT_NEAR(size(place + 0.1) / far, 0.55, 1e-3);
    EXPECT_NEAR(size(place - 0.1) / far, 0.55, 1e-3);
    EXPECT_NEAR(size(place - 0.21) / far, 1, 1e-9);
  }
}

TEST(GradedLines, OfTwiceAsManyCellsHaveTheseAmongThem) {
  const LineGrading grading{{0.1, 0.3}, 30, 0.4};
  const std::vector<double> coarse = graded_lines(0, 1, 17, grading),
                            fine = graded_lines(0, 1, 34, grading);
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_NEAR(coarse[i], fine[2 * i], 1e-14);
}

TEST(GradedLines, AscendAlsoWhenGradedByTenMillionTowardsAnEnd) {
  const std::vector<double> lines = graded_lines(0, 1, 64, {{0}, 1e7, 1});
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) EXPECT_LT(lines[i], lines[i + 1]);
  EXPECT_LT(lines[1], 1e-6);
}

TEST(GradedLines, AreDividedIntoEqualParts) {
  EXPECT_THAT(divided_lines({0, 1, 4}, 2), testing::ElementsAre(0, 0.5, 1, 2.5, 4));
  EXPECT_THAT(divided_lines({0, 1, 4}, 1), testing::ElementsAre(0, 1, 4));
}

TEST(GradedLines, WithoutAnIntervalOrASizeAreRefused) {
  EXPECT_THROW(graded_lines(1, 1, 4, {}), InvalidArgument);
  EXPECT_THROW(graded_lines(0, 1, 0, {}), InvalidArgument);
  EXPECT_THROW(graded_lines(0, 1, 4, {{0}, 0.5, 1}), InvalidArgument);
  EXPECT_THROW(graded_lines(0, 1, 4, {{0}, 2, 0}), InvalidArgument);
  EXPECT_THROW(divided_lines({1}, 2), InvalidArgument);
  EXPECT_THROW(divided_lines({0, 1}, 0), InvalidArgument);
}

}  // namespace
}  // namespace rfm
