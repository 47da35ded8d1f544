// Collision queries of random Boolean combinations of shapes never contradict dense sampling.

#include <gtest/gtest.h>

#include "core/relations.hpp"
#include "tests/quadrature/random_pairs.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

void check(int dimension, unsigned first, int count, int samples) {
  int meeting = 0, apart = 0, open = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const RandomPair pair = random_pair(seed, dimension);
    const RegionEvaluator a(pair.first), b(pair.second);
    RelationOptions options;
    options.resolution = 1e-4;
    options.most_boxes = 50000;
    const Relation relation = intersects(pair.first, pair.second, pair.bounds, options);
    if (relation.answer == Truth::yes) {
      ++meeting;
      EXPECT_TRUE(a.contains(*relation.witness) && b.contains(*relation.witness)) << seed;
      continue;
    }
    relation.answer == Truth::no ? ++apart : ++open;
    if (relation.answer != Truth::no) continue;
    const int layers = dimension == 3 ? samples : 1;
    for (int i = 0; i < samples; ++i)
      for (int j = 0; j < samples; ++j)
        for (int k = 0; k < layers; ++k) {
          const auto at = [&](int axis, int n) {
            return pair.bounds.low[axis] + (n + 0.5) / samples * pair.bounds.length(axis);
          };
          const Point point{at(0, i), at(1, j), dimension == 3 ? at(2, k) : 0};
          ASSERT_FALSE(a.contains(point) && b.contains(point)) << seed;
        }
  }
  std::printf("%d pairs meet, %d are apart, %d are left open\n", meeting, apart, open);
  EXPECT_LE(open, count / 20);
  EXPECT_GT(meeting, count / 6);
  EXPECT_GT(apart, count / 10);
}

TEST(RandomRelations, AgreeWithSamplesInThePlane) { check(2, 1, 60, 60); }
TEST(RandomRelations, AgreeWithSamplesInSpace) { check(3, 1, 20, 20); }
TEST(LongRandomRelations, AgreeWithSamplesInThePlane) { check(2, 1000, 1000, 200); }
TEST(LongRandomRelations, AgreeWithSamplesInSpace) { check(3, 1000, 1000, 40); }

}  // namespace
