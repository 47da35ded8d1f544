#include "core/neighbourhood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;
using Distance = std::function<double(const Point&)>;

class Random {
 public:
  double uniform(double low, double high) { return low + (high - low) * 0x1p-32 * generator_(); }
  Point point(int dimension, double size) {
    Point p{};
    for (int axis = 0; axis < dimension; ++axis) p[axis] = uniform(-size, size);
    return p;
  }

 private:
  std::mt19937 generator_{7};
};

Box around(const Point& point, int dimension, double radius) {
  Box box{dimension, point, point};
  for (int axis = 0; axis < dimension; ++axis) box.low[axis] -= radius, box.high[axis] += radius;
  return box;
}

// The sign of `where` is that of D − d, and every place where it changes is a zero of an end that
// its locator keeps in boxes around it.
void expect_neighbourhood(const Neighbourhood& near, double D, const Distance& distance,
                          int dimension, double size = 1.7) {
  Random random;
  const auto where = [&](const Point& p) { return value_at(near.where, p); };
  int inside = 0, crossings = 0;
  for (int i = 0; i < 400; ++i) {
    Point a = random.point(dimension, size), b = random.point(dimension, size);
    inside += where(a) >= 0;
    if (std::fabs(distance(a) - D) > 1e-12) {
      EXPECT_EQ(where(a) >= 0, distance(a) <= D);
    }
    if ((distance(a) < D) == (distance(b) < D)) continue;
    ++crossings;
    const bool side = distance(a) < D;
    Point middle{};
    for (int step = 0; step < 60; ++step) {
      for (int axis = 0; axis < 3; ++axis) middle[axis] = 0.5 * (a[axis] + b[axis]);
      ((distance(middle) < D) == side ? a : b) = middle;
    }
    for (const double radius : {1e-6, 0.01, 0.3}) {
      std::vector<int> ends(near.ends.functions.size());
      for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = static_cast<int>(k);
      Box box = around(middle, dimension, radius);
      box.high[0] += radius;
      if (near.ends.locator) near.ends.locator->narrow(box, ends);
      double least = 1;
      for (const int k : ends)
        least = std::min(least, std::fabs(value_at(near.ends.functions[k], middle)));
      EXPECT_LT(least, 1e-10) << "at " << middle[0] << ", " << middle[1] << ", " << middle[2];
    }
  }
  EXPECT_GT(inside, 5);
  EXPECT_GT(crossings, 10);
}

double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double from_triangles(const std::vector<Triangle>& triangles, const Point& point) {
  double least = 1e9;
  for (const Triangle& triangle : triangles)
    least = std::min(least, length(minus(nearest_point(triangle, point).nearest, point)));
  return least;
}

TEST(Neighbourhood, OfPointsAndSegments) {
  for (const int dimension : {2, 3}) {
    const Point p{0.3, -0.4, dimension == 3 ? 0.2 : 0.0}, q{-1, 0.7, dimension == 3 ? -0.5 : 0.0};
    expect_neighbourhood(
        neighbourhood(point_set(p, dimension), 0.8), 0.8,
        [&](const Point& x) { return length(minus(x, p)); }, dimension);
    expect_neighbourhood(
        neighbourhood(segment_set(p, q, dimension), 0.5), 0.5,
        [&](const Point& x) {
          return from_triangles({{p, q, q}}, x);
        },
        dimension);
  }
}

TEST(Neighbourhood, OfArcsAndCircles) {
  const Point c{0.2, -0.1};
  for (const double to : {1.0, pi - 0.3, pi + 0.5, 5.0, 2 * pi - 0.3})
    for (const double D : {0.2, 0.6, 1.5}) {
      const Distance exact = [&](const Point& x) {
        const double angle = std::fmod(std::atan2(x[1] - c[1], x[0] - c[0]) - 0.3 + 4 * pi, 2 * pi);
        if (angle <= to) return std::fabs(std::hypot(x[0] - c[0], x[1] - c[1]) - 1.2);
        const auto end = [&](double t) {
          return std::hypot(x[0] - c[0] - 1.2 * std::cos(t), x[1] - c[1] - 1.2 * std::sin(t));
        };
        return std::min(end(0.3), end(0.3 + to));
      };
      expect_neighbourhood(neighbourhood(arc_set(c, 1.2, 0.3, 0.3 + to), D), D, exact, 2, 1.7 + D);
    }
  expect_neighbourhood(
      neighbourhood(arc_set(c, 1.2, 0, 2 * pi), 0.4), 0.4,
      [&](const Point& x) { return std::fabs(std::hypot(x[0] - c[0], x[1] - c[1]) - 1.2); }, 2);
}

TEST(Neighbourhood, OfLevelCurvesThatAreCirclesOrLines) {
  const Field x = x_coordinate(), y = y_coordinate();
  expect_neighbourhood(
      neighbourhood(level_curve_set(2 * x * x + 2 * y * y - 2, {}), 0.3), 0.3,
      [](const Point& p) { return std::fabs(std::hypot(p[0], p[1]) - 1); }, 2);
  expect_neighbourhood(
      neighbourhood(level_curve_set(3 * x - 4 * y + 1, {}), 0.3), 0.3,
      [](const Point& p) { return std::fabs(3 * p[0] - 4 * p[1] + 1) / 5; }, 2);
  EXPECT_THROW(neighbourhood(level_curve_set(y - x * x, {}), 0.3), InvalidArgument);
  EXPECT_THROW(neighbourhood(level_curve_set(y - x, x), 0.3), InvalidArgument);
}

TEST(Neighbourhood, OfChains) {
  const std::vector<Point> points{{-1, -0.5}, {0, 0.2}, {0.6, 0.62}, {1, -1}, {-0.5, -1}};
  std::vector<ThinSet> segments;
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    segments.push_back(segment_set(points[i], points[i + 1]));
    triangles.push_back({points[i], points[i + 1], points[i + 1]});
  }
  const Neighbourhood near = neighbourhood(composite_set(segments), 0.3);
  // The first two lie on a line: three lines, and circles but for where they meet.
  EXPECT_EQ(near.ends.functions.size(), 3u + 4u);
  expect_neighbourhood(
      near, 0.3, [&](const Point& x) { return from_triangles(triangles, x); }, 2);
}

TEST(Neighbourhood, OfSurfacesOfTriangles) {
  const Point a{0, 0, 1}, b{1, 0.1, -0.5}, c{-0.5, 0.9, -0.4}, d{-0.6, -0.8, -0.5};
  const std::vector<Triangle> tetrahedron{{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}};
  const std::vector<Triangle> open{{a, b, c}, {a, c, d}};
  for (const auto& triangles : {tetrahedron, open})
    expect_neighbourhood(
        neighbourhood(triangles, 0.4), 0.4,
        [&](const Point& x) { return from_triangles(triangles, x); }, 3);
}

TEST(Neighbourhood, OfAFlatSurfaceHasTheEndsOfItsOutline) {
  // Two planes, four cylinders and four balls, however fine the square is divided.
  for (const int n : {1, 4}) {
    std::vector<Triangle> square;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto at = [n](int p, int q) { return Point{double(p) / n, double(q) / n, 0.25}; };
        square.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        square.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    const Neighbourhood near = neighbourhood(square, 0.35);
    EXPECT_EQ(near.ends.functions.size(), 10u);
    expect_neighbourhood(
        near, 0.35, [&](const Point& x) { return from_triangles(square, x); }, 3);
    // Nothing ends within, beyond, and beside the rest of the set where a plane does.
    const auto left = [&](const Point& point, double radius) {
      std::vector<int> ends(10);
      for (int k = 0; k < 10; ++k) ends[k] = k;
      near.ends.locator->narrow(around(point, 3, radius), ends);
      return ends.size();
    };
    EXPECT_EQ(left({0.3, 0.4, 0.25}, 0.1), 0u);
    EXPECT_EQ(left({0.3, 0.4, 0.9}, 0.1), 0u);
    EXPECT_EQ(left({0.5, 0.5, 0.6}, 0.05), 1u);
    EXPECT_EQ(left({1.35, 0.5, 0.25}, 0.05), 1u);
  }
}

TEST(Neighbourhood, NeedsADistance) {
  EXPECT_THROW(neighbourhood(point_set({0, 0}), 0), InvalidArgument);
  EXPECT_THROW(neighbourhood(std::vector<Triangle>{}, 1), InvalidArgument);
}

}  // namespace
}  // namespace rfm
