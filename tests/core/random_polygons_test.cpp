#include "tests/core/random_contours.hpp"

#include <gmock/gmock.h>

#include "core/orientation.hpp"
#include "core/polygon.hpp"
#include "core/polygon_chains.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

double distance_from_boundary(const std::vector<Point>& polygon, const Point& x) {
  double least = INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (polygon[i] != polygon[(i + 1) % polygon.size()])
      least = std::min(least, distance_from(polygon[i], polygon[(i + 1) % polygon.size()], x));
  return least;
}

std::vector<double> values_at(const Field& field, const std::vector<Point>& points) {
  const Tape tape({field}, {0}, 2);
  Tape::Workspace workspace(tape);
  std::vector<double> values;
  for (std::size_t begin = 0; begin < points.size(); begin += 64) {
    const int count = static_cast<int>(std::min<std::size_t>(64, points.size() - begin));
    std::array<double, 64> x{}, y{};
    for (int i = 0; i < count; ++i) {
      x[i] = points[begin + i][0];
      y[i] = points[begin + i][1];
    }
    tape.evaluate({{x.data(), y.data(), nullptr}, count}, workspace);
    const double* const block = workspace.coefficient(0);
    values.insert(values.end(), block, block + count);
  }
  return values;
}

struct Disagreements {
  int polygons = 0, signs = 0, zeros = 0;
};

// The sign of the R0-function at random points of the bounding box, a third of them next to edges;
// its value on edges is zero and away from them is not.
void compare(const std::vector<Point>& polygon, RandomPolygons& random, int points,
             Disagreements& found) {
  const Field function = implicit(rfm::polygon(polygon));
  Point low = polygon[0], high = polygon[0];
  for (const Point& p : polygon)
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  std::vector<Point> at, on;
  const auto on_edge = [&] {
    const int i = random.integer(0, static_cast<int>(polygon.size()) - 1);
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double t = random.real(0, 1);
    return Point{std::lerp(p[0], q[0], t), std::lerp(p[1], q[1], t)};
  };
  for (int i = 0; i < points; ++i)
    if (i % 3 == 0) {
      const Point edge = on_edge();
      const double step = size * std::pow(10, random.real(-10, -1));
      at.push_back({edge[0] + random.real(-step, step), edge[1] + random.real(-step, step)});
    } else {
      at.push_back({random.real(low[0], high[0]), random.real(low[1], high[1])});
    }
  for (int i = 0; i < 30; ++i) on.push_back(on_edge());
  ++found.polygons;
  std::vector<Point> all = at;
  all.insert(all.end(), on.begin(), on.end());
  const std::vector<double> values = values_at(function, all);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double distance = distance_from_boundary(polygon, at[i]);
    if (distance < 1e-12 * size) continue;
    if ((values[i] > 0) != is_inside(polygon, at[i]) || values[i] == 0) ++found.signs;
  }
  for (std::size_t i = at.size(); i < all.size(); ++i)
    if (!(std::fabs(values[i]) < 1e-13 * size)) ++found.zeros;
}

void agree(int count) {
  RandomPolygons random(11);
  Disagreements found;
  for (int i = 0; i < count; ++i) {
    const auto kind =
        static_cast<RandomPolygons::Kind>(i % static_cast<int>(RandomPolygons::Kind::count));
    const std::vector<Point> polygon = random.next(kind);
    ASSERT_NO_THROW(compare(polygon, random, 1000, found)) << "polygon " << i;
    ASSERT_EQ(found.signs, 0) << "polygon " << i << " of kind " << static_cast<int>(kind);
    ASSERT_EQ(found.zeros, 0) << "polygon " << i << " of kind " << static_cast<int>(kind);
  }
  EXPECT_EQ(found.polygons, count);
}

TEST(RandomPolygons, SignsOfTheRFunctionAreThoseOfTheWindingNumber) { agree(400); }
TEST(LongRandomPolygons, SignsOfTheRFunctionAreThoseOfTheWindingNumber) { agree(10000); }

// A counter-example of the kind of Peterson (1986): hulls of chains that are not extended divide
// this polygon at other vertices, and what they give is not the polygon.
TEST(PolygonChains, AreRightWhereHullsOfTrimmedChainsAreNot) {
  const std::vector<Point> points = {{0, 9},   {10, 3},  {17, 3},  {24, 1},  {39, 0},  {36, 9},
                                     {35, 35}, {30, 40}, {29, 34}, {17, 25}, {8, 14},  {22, 32},
                                     {6, 12},  {7, 10},  {22, 14}, {29, 16}, {16, 15}, {29, 27},
                                     {31, 23}, {32, 17}, {29, 8},  {30, 5},  {12, 4},  {1, 10}};
  std::vector<BooleanExpression> edges;
  for (int i = 0; i < 24; ++i) edges.push_back(BooleanExpression::variable(i));
  const auto& e = edges;
  const BooleanExpression trimmed = e[0] & (e[1] | e[2]) & e[3] & (e[4] | e[5]) & e[6] &
                                    (e[7] | (e[8] & e[9]) | e[10]) &
                                    ((e[11] & e[12] & e[13] & e[14] & (e[15] | e[16])) | e[17] |
                                     e[18] | (e[19] & e[20]) | e[21] | (e[22] & e[23]));
  const BooleanExpression extended = chain_expression(points, edges);
  int wrong = 0, wrong_trimmed = 0;
  for (double x = -1.3; x < 42; x += 0.377)
    for (double y = -1.1; y < 42; y += 0.377) {
      std::array<bool, 24> signs{};
      for (int i = 0; i < 24; ++i)
        signs[i] = orientation(points[i], points[(i + 1) % 24], {x, y}) > 0;
      const bool inside = is_inside(points, {x, y});
      if (extended.evaluate(signs) != inside) ++wrong;
      if (trimmed.evaluate(signs) != inside) ++wrong_trimmed;
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(wrong_trimmed, 10);
}

}  // namespace
}  // namespace rfm
