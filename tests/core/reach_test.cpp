#include "core/reach.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/primitives.hpp"

namespace rfm {
namespace {

struct Body {
  const char* name;
  Region region;
};
std::ostream& operator<<(std::ostream& out, const Body& body) { return out << body.name; }

// A rod around (1, 2, 2)/3 with flat ends.
Region rod() { return cylinder({0, 0, 0}, {1, 2, 2}, 0.5, 1.2); }
// The farthest point of the rod along x lies on the edge of its end.
Point end_of_rod() {
  const double along = 0.6, root = std::sqrt(8.0);  // across: e_x − a/3 = (8, −2, −2)/9
  return {along / 3 + 0.5 * 8 / (3 * root), 2 * along / 3 - 0.5 * 2 / (3 * root),
          2 * along / 3 - 0.5 * 2 / (3 * root)};
}

Box cube_around(const Point& point, double half, int dimension) {
  Box box;
  box.dimension = dimension;
  for (int axis = 0; axis < dimension; ++axis) {
    box.low[axis] = point[axis] - half;
    box.high[axis] = point[axis] + half;
  }
  return box;
}

class EveryBody : public testing::TestWithParam<Body> {};
INSTANTIATE_TEST_SUITE_P(
    Reach, EveryBody,
    testing::Values(Body{"disk", circle({0, 0}, 0.8)},
                    Body{"disk without disk", circle({0, 0}, 0.9) - circle({0.5, 0.2}, 0.4)},
                    Body{"one of two disks", circle({-0.3, 0}, 0.6) ^ circle({0.3, 0.1}, 0.7)},
                    Body{"lens or disk",
                         (circle({-0.5, 0}, 0.8) & circle({0.5, 0}, 0.8)) | circle({0, -0.7}, 0.2)},
                    Body{"apex of a root",
                         level_set(0.5 - sqrt(pow(x_coordinate(), 2) + pow(y_coordinate(), 2)))},
                    Body{"rod", rod()}, Body{"torus", torus({0, 0, 0}, {0, 0.3, 1}, 0.6, 0.25)}));

TEST_P(EveryBody, NoPointOfABoxReachesFarther) {
  const RegionEvaluator region(GetParam().region);
  const int dimension = region.dimension();
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int boxes_with_points = 0, boxes_cut = 0;
  for (int round = 0; round < 1500; ++round) {
    const Point center{uniform(generator), uniform(generator), uniform(generator)};
    const Box box = cube_around(center, std::pow(10, -1 + 0.9 * uniform(generator)), dimension);
    for (int axis = 0; axis < dimension; ++axis)
      for (const bool upper : {false, true}) {
        const auto bound = reach(region, box, axis, upper);
        bool found = false;
        for (int i = 0; i < 60; ++i) {
          Point point{};
          for (int k = 0; k < dimension; ++k)
            point[k] = box.interval(k).middle() + box.interval(k).radius() * uniform(generator);
          if (!region.contains(point)) continue;
          found = true;
          ASSERT_TRUE(bound.has_value()) << GetParam();
          ASSERT_TRUE(upper ? point[axis] <= *bound : point[axis] >= *bound)
              << GetParam() << " at " << point[0] << ", " << point[1] << ", " << point[2];
        }
        boxes_with_points += found;
        boxes_cut += bound && found && (upper ? *bound < box.high[axis] : *bound > box.low[axis]);
      }
  }
  EXPECT_GT(boxes_with_points, 100);
  EXPECT_GT(boxes_cut, 10);  // or else nothing has been tested
}

// How much farther than its extreme point, which lies at the centre, a small box is said to reach.
double excess(const Region& region, const Point& extreme, double half) {
  const Box box = cube_around(extreme, half, region.dimension());
  return reach(RegionEvaluator(region), box, 0, true).value() - extreme[0];
}

class SecondOrder : public testing::TestWithParam<std::pair<Body, Point>> {};
INSTANTIATE_TEST_SUITE_P(
    Reach, SecondOrder,
    testing::Values(std::pair{Body{"disk", circle({0.1, 0.2}, 0.8)}, Point{0.9, 0.2}},
                    std::pair{Body{"ball", sphere({0.1, 0.2, -0.3}, 0.8)}, Point{0.9, 0.2, -0.3}},
                    std::pair{
                        Body{"corner of a lens", circle({0, 0.5}, 0.8) & circle({0, -0.5}, 0.8)},
                        Point{std::sqrt(0.39), 0}},
                    std::pair{Body{"edge of a rod", rod()}, end_of_rod()}));

TEST_P(SecondOrder, InTheSizeOfABoxAtAnExtreme) {
  const auto& [body, extreme] = GetParam();
  const double coarse = excess(body.region, extreme, 1e-2);
  const double fine = excess(body.region, extreme, 1e-3);
  EXPECT_GE(fine, -1e-15) << body;
  EXPECT_LE(fine, 1e-5) << body;
  EXPECT_LE(coarse, 1e-3) << body;
}

TEST(Reach, IsEmptyWhereABoxIsOutside) {
  const RegionEvaluator region(rod());
  EXPECT_FALSE(reach(region, cube_around({0.8, 0, 0}, 0.1, 3), 0, true).has_value());
  EXPECT_FALSE(reach(region, cube_around({0.8, 0, 0}, 0.1, 3), 2, false).has_value());
}

TEST(Reach, IsThatOfTheBoxWhereTheBoxIsInside) {
  const RegionEvaluator region(rod());
  EXPECT_EQ(reach(region, cube_around({0, 0, 0}, 0.1, 3), 0, true), 0.1);
  EXPECT_EQ(reach(region, cube_around({0, 0, 0}, 0.1, 3), 0, false), -0.1);
}

}  // namespace
}  // namespace rfm
