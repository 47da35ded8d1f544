#include "core/box_tree.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace rfm {
namespace {

std::vector<Box> random_boxes(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    Box box{3, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = uniform(random);
      box.high[axis] = box.low[axis] + 0.1 * (1 + uniform(random));
    }
    boxes.push_back(box);
  }
  return boxes;
}

TEST(BoxTree, DistanceFromABoxIsThatOfItsNearestPoint) {
  const Box box{3, {0, 0, 0}, {1, 2, 3}};
  EXPECT_EQ(BoxTree::square_distance(box, {0.5, 1, 2}), 0);
  EXPECT_EQ(BoxTree::square_distance(box, {-2, 1, 2}), 4);
  EXPECT_EQ(BoxTree::square_distance(box, {3, 5, 2}), 4 + 9);
  EXPECT_EQ(BoxTree::square_distance(box, {2, -1, 5}), 1 + 1 + 4);
}

// The nearest box by all of them, whatever the number of items.
TEST(BoxTree, FindsTheNearestBoxAndVisitsFewOfTheOthers) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (const int count : {1, 2, 9, 1000}) {
    const std::vector<Box> boxes = random_boxes(count, random);
    const BoxTree tree(boxes);
    int visits = 0;
    for (int trial = 0; trial < 100; ++trial) {
      const Point point{uniform(random), uniform(random), uniform(random)};
      double found = INFINITY, exact = INFINITY;
      tree.walk(
          point,
          [&](int item) {
            ++visits;
            found = std::min(found, BoxTree::square_distance(boxes[item], point));
          },
          [&] { return found; });
      for (const Box& box : boxes) exact = std::min(exact, BoxTree::square_distance(box, point));
      EXPECT_EQ(found, exact);
    }
    EXPECT_LE(visits, 100 * (count / 10 + 10));
  }
}

TEST(BoxTree, WithinALimitVisitsEveryItemOnce) {
  std::mt19937 random(4);
  const std::vector<Box> boxes = random_boxes(300, random);
  std::multiset<int> visited;
  BoxTree(boxes).walk(
      {}, [&](int item) { visited.insert(item); }, [] { return 1e9; });
  EXPECT_EQ(visited.size(), boxes.size());
  EXPECT_EQ(std::set<int>(visited.begin(), visited.end()).size(), boxes.size());
}

}  // namespace
}  // namespace rfm
