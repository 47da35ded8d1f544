#include "problems/output/coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace rfm {
namespace {

double total(const Coverage& coverage) {
  return std::accumulate(coverage.amount.begin(), coverage.amount.end(), 0.0);
}

double area(const std::vector<PixelPosition>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PixelPosition &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return std::abs(twice) / 2;
}

TEST(PolygonCoverage, SumsToTheAreaOfAnyStarShapedPolygon) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(5, 45);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<PixelPosition> corners;
    const int count = 3 + trial % 12;
    for (int i = 0; i < count; ++i) {
      const double r = radius(random), angle = 2 * std::numbers::pi * i / count;
      corners.push_back({50.3 + r * std::cos(angle), 49.6 + r * std::sin(angle)});
    }
    EXPECT_NEAR(total(polygon_coverage(corners, 100, 100)), area(corners), 1e-3);
    std::ranges::reverse(corners);
    EXPECT_NEAR(total(polygon_coverage(corners, 100, 100)), area(corners), 1e-3);
  }
}

TEST(PolygonCoverage, IsTheExactShareOfEachPixel) {
  const std::vector<PixelPosition> rectangle = {{1.25, 1.5}, {3.5, 1.5}, {3.5, 2.75}, {1.25, 2.75}};
  const Coverage coverage = polygon_coverage(rectangle, 10, 10);
  EXPECT_NEAR(coverage.at(1, 1), 0.75 * 0.5, 1e-6);
  EXPECT_NEAR(coverage.at(2, 1), 0.5, 1e-6);
  EXPECT_NEAR(coverage.at(3, 1), 0.25, 1e-6);
  EXPECT_NEAR(coverage.at(1, 2), 0.75 * 0.75, 1e-6);
  EXPECT_NEAR(coverage.at(2, 2), 0.75, 1e-6);
  EXPECT_NEAR(coverage.at(3, 2), 0.375, 1e-6);
  // A diagonal halves the pixels it crosses from corner to corner.
  const Coverage triangle =
      polygon_coverage(std::vector<PixelPosition>{{0, 0}, {8, 0}, {0, 8}}, 10, 10);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(triangle.at(i, 7 - i), 0.5, 1e-6);
  EXPECT_NEAR(triangle.at(0, 0), 1, 1e-6);
  EXPECT_NEAR(triangle.at(7, 7), 0, 1e-6);
}

TEST(PolygonCoverage, IsCutToTheImage) {
  // The square [−20, 30]² seen on 10 × 12 pixels fills them; a triangle keeps its part.
  const Coverage all = polygon_coverage(
      std::vector<PixelPosition>{{-20, -20}, {30, -20}, {30, 30}, {-20, 30}}, 10, 12);
  EXPECT_NEAR(total(all), 120, 1e-4);
  // {x + y ≤ 8} within the image, from a triangle that reaches far beyond it at the left and above.
  const Coverage triangle =
      polygon_coverage(std::vector<PixelPosition>{{-100, -100}, {108, -100}, {-100, 108}}, 10, 10);
  EXPECT_NEAR(total(triangle), 32, 1e-3);
  EXPECT_EQ(
      total(polygon_coverage(std::vector<PixelPosition>{{20, 20}, {30, 20}, {30, 30}}, 10, 10)), 0);
}

TEST(LineCoverage, SumsToLengthTimesWidthWhateverTheDirection) {
  // Of a long line, whose round ends (a half disk each, and the filter around it) are left out by
  // taking the difference of two lengths.
  for (const double width : {0.4, 1.0, 2.0, 3.7})
    for (double angle = 0; angle < 3.2; angle += 0.17) {
      const auto covered = [&](double length) {
        const double c = std::cos(angle), s = std::sin(angle);
        const PixelPosition ends[] = {{150.2 - length * c, 150.7 - length * s},
                                      {150.2 + length * c, 150.7 + length * s}};
        return total(line_coverage(ends, width, 300, 300));
      };
      EXPECT_NEAR(covered(120) - covered(40), 160 * width, 0.005 * 160 * width + 0.6)
          << width << " at " << angle;
    }
}

TEST(LineCoverage, IsTheBoxFilteredProfileAcross) {
  const PixelPosition ends[] = {{-5, 10.25}, {50, 10.25}};
  const Coverage coverage = line_coverage(ends, 2, 30, 30);  // covers y from 9.25 to 11.25
  EXPECT_NEAR(coverage.at(15, 9), 0.75, 1e-6);
  EXPECT_NEAR(coverage.at(15, 10), 1, 1e-6);
  EXPECT_NEAR(coverage.at(15, 11), 0.25, 1e-6);
}

TEST(LineCoverage, DoesNotDarkenJoints) {
  // A polyline with many points on one line is that line.
  std::vector<PixelPosition> many;
  for (int i = 0; i <= 100; ++i) many.push_back({10 + 0.8 * i, 20 + 0.3 * i});
  const PixelPosition ends[] = {many.front(), many.back()};
  const Coverage one = line_coverage(ends, 1.5, 100, 100),
                 joined = line_coverage(many, 1.5, 100, 100);
  EXPECT_NEAR(total(one), total(joined), 1e-2);
}

TEST(LineCoverage, OfASinglePointIsADot) {
  const PixelPosition point[] = {{10, 10}};
  EXPECT_NEAR(total(line_coverage(point, 6, 20, 20)), std::numbers::pi * 9, 0.5);
  EXPECT_EQ(total(line_coverage({}, 6, 20, 20)), 0);
}

}  // namespace
}  // namespace rfm
