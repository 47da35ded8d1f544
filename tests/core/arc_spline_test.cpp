#include "core/arc_spline.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

std::vector<Point> ellipse_points(double a, double b, int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * pi * i / count + 0.1;
    points.push_back({a * std::cos(t), b * std::sin(t)});
  }
  return points;
}

double turn(const Point& a, const Point& b) {
  return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}

TEST(ArcSplines, GoThroughTheirPointsWithOneTangent) {
  const std::vector<Point> points = {{0, 0},     {1, 0.2},   {1.5, 1},
                                     {0.6, 0.7}, {0.1, 1.4}, {-0.5, 0.3}};
  for (const bool closed : {false, true}) {
    const ArcSpline spline = arc_spline(points, closed);
    const std::size_t count = spline.edges.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || spline.spans[i] != spline.spans[i - 1]) {
        EXPECT_EQ(spline.edges[i].from, points[spline.spans[i]]);
      }
      if (!closed && i + 1 == count) break;
      const CircularEdge& next = spline.edges[(i + 1) % count];
      EXPECT_EQ(spline.edges[i].to, next.from);
      EXPECT_NEAR(turn(spline.edges[i].end_direction(), next.start_direction()), 0, 1e-14);
    }
    EXPECT_EQ(spline.edges.back().to, closed ? points.front() : points.back());
  }
}

// A stadium whose sides have nine points each, turned, with a number of digits.
TEST(ArcSplines, ThroughRoundedPointsOfALineAreALine) {
  for (int digits = 4; digits <= 12; ++digits) {
    const double unit = std::pow(10, -digits), c = std::cos(0.3), s = std::sin(0.3);
    const auto rounded = [&](double x, double y) {
      return Point{std::round((c * x - s * y) / unit) * unit,
                   std::round((s * x + c * y) / unit) * unit};
    };
    std::vector<Point> points;
    for (int k = 0; k <= 8; ++k) points.push_back(rounded(0.25 * k, 0));
    for (int k = 1; k < 8; ++k)
      points.push_back(rounded(2 + 0.5 * std::sin(pi * k / 8), 0.5 - 0.5 * std::cos(pi * k / 8)));
    for (int k = 8; k >= 0; --k) points.push_back(rounded(0.25 * k, 1));
    const ArcSpline spline = arc_spline(points, false);
    int straight = 0;
    for (std::size_t i = 0; i < spline.edges.size(); ++i) {
      const CircularEdge& edge = spline.edges[i];
      const int span = spline.spans[i];
      EXPECT_LE(std::hypot(edge.from[0] - points[span][0], edge.from[1] - points[span][1]),
                i > 0 && spline.spans[i - 1] == span ? 1 : 1.5 * unit);
      if (edge.bulge != 0) continue;
      ++straight;
      if (i == 0 || spline.edges[i - 1].bulge != 0) continue;
      EXPECT_NEAR(turn(spline.edges[i - 1].start_direction(), edge.start_direction()), 0, 1e-14);
    }
    EXPECT_EQ(straight, 14) << digits;  // the spans at the ends of the semicircle are not
  }
  // Numbers with all digits are taken as they are.
  std::vector<Point> bent;
  for (int k = 0; k <= 8; ++k) bent.push_back({k / 7.0, 1e-6 * (k % 2) / 7});
  for (const CircularEdge& edge : arc_spline(bent, false).edges) EXPECT_NE(edge.bulge, 0);
}

TEST(ArcSplines, ThroughPointsOfACircleAreTheCircle) {
  // Unevenly spaced, about (0.3, -0.2).
  std::vector<Point> points;
  for (const double t : {0.0, 0.7, 1.1, 2.9, 4.0, 5.5})
    points.push_back({0.3 + 2 * std::cos(t), -0.2 + 2 * std::sin(t)});
  const ArcSpline spline = arc_spline(points, true);
  EXPECT_EQ(spline.edges.size(), 6);  // one for each span
  for (const CircularEdge& edge : spline.edges) EXPECT_NEAR(edge.curvature(), 0.5, 1e-14);
  // Open as well: its ends have the tangents of the circle.
  points.resize(4);
  for (const CircularEdge& edge : arc_spline(points, false).edges)
    EXPECT_NEAR(edge.curvature(), 0.5, 1e-14);
}

TEST(ArcSplines, ThroughPointsOfALineAreTheLine) {
  const ArcSpline spline = arc_spline({{0, 0}, {1, 2}, {1, 2}, {1.5, 3}, {4, 8}}, false);
  ASSERT_EQ(spline.edges.size(), 3);
  EXPECT_THAT(spline.spans, testing::ElementsAre(0, 2, 3));
  for (const CircularEdge& edge : spline.edges) EXPECT_NEAR(edge.bulge, 0, 1e-16);
}

// Greatest distance of the spline's points from the ellipse, by the polynomial and its gradient.
double error_of_ellipse(int count) {
  const double a = 2, b = 1;
  double worst = 0;
  for (const CircularEdge& edge : arc_spline(ellipse_points(a, b, count), true).edges)
    for (const CircularEdge& half : edge.divided_at(edge.middle()))
      for (const Point& p : {half.from, half.middle()}) {
        const double f = p[0] * p[0] / (a * a) + p[1] * p[1] / (b * b) - 1;
        worst = std::max(worst, std::fabs(f) / std::hypot(2 * p[0] / (a * a), 2 * p[1] / (b * b)));
      }
  return worst;
}

TEST(ArcSplines, ApproximateToThirdOrder) {
  const double coarse = error_of_ellipse(80), fine = error_of_ellipse(160);
  EXPECT_GT(std::log2(coarse / fine), 2.9);
  EXPECT_LT(std::log2(coarse / fine), 3.1);
  EXPECT_LT(fine, 1e-5);
}

TEST(ArcSplines, WithoutASenseAreRefused) {
  const auto refused = [](const std::vector<Point>& points, bool closed, const char* reason) {
    try {
      arc_spline(points, closed);
      FAIL() << "accepted";
    } catch (const InvalidArgument& error) {
      EXPECT_THAT(error.what(), HasSubstr(reason));
    }
  };
  refused({{0, 0}, {0, 0}}, false, "two different points");
  refused({{0, 0}, {1, 1}, {0, 0}}, true, "three different points");
  refused({{0, 0}, {1, 0}, {0, 0}}, false, "turn back at point 2");
  refused({{0, 0}, {1, std::nan("")}, {0, 0}}, false, "point 2 are not finite");
}

}  // namespace
}  // namespace rfm
