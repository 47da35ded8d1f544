#include "core/nearest_name.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace rfm;

namespace {
const std::vector<std::string> keys = {"center", "radius", "radii", "angle",
                                       "min",    "max",    "x",     "y"};
}

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("radius", "radius"), 0);
  EXPECT_EQ(edit_distance("radus", "radius"), 1);
  EXPECT_EQ(edit_distance("radiuss", "radius"), 1);
  EXPECT_EQ(edit_distance("rodius", "radius"), 1);
  EXPECT_EQ(edit_distance("raduis", "radius"), 1);
  EXPECT_EQ(edit_distance("", "radius"), 6);
  EXPECT_EQ(edit_distance("radius", ""), 6);
}
TEST(EditDistance, IsSymmetric) {
  for (const std::string& a : keys)
    for (const std::string& b : keys) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
}
TEST(EditDistance, IgnoresCase) { EXPECT_EQ(edit_distance("RADIUS", "radius"), 0); }

TEST(NearestName, FindsWhatAMisspeltNameMeans) {
  EXPECT_EQ(nearest_name("raduis", keys), "radius");
  EXPECT_EQ(nearest_name("centre", keys), "center");
  EXPECT_EQ(nearest_name("Center", keys), "center");
  EXPECT_EQ(nearest_name("mni", keys), "min");
}
TEST(NearestName, IsSilentBeyondTwoChanges) {
  EXPECT_EQ(nearest_name("diameter", keys), "");
  EXPECT_EQ(nearest_name("radiation", keys), "");
}
TEST(NearestName, DoesNotGuessShortNames) {
  EXPECT_EQ(nearest_name("z", keys), "");  // x and y are one change away, but mean nothing
  EXPECT_EQ(nearest_name("men", keys), "min");
  EXPECT_EQ(nearest_name("mon", {}), "");
  EXPECT_EQ(nearest_name("mu", keys), "");
}
TEST(NearestName, PrefersTheNearest) { EXPECT_EQ(nearest_name("radi", keys), "radii"); }
TEST(NearestName, IsTheEndOfAMessage) {
  EXPECT_EQ(did_you_mean("raduis", keys), " (did you mean 'radius'?)");
  EXPECT_EQ(did_you_mean("colour", keys), "");
}
