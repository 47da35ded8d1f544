#include "problems/pictures/missing_values.hpp"

#include <gtest/gtest.h>

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

TEST(MissingValues, AreExplainedAtTheFirstOfThePoints) {
  MissingValues missing;
  missing.add({-0.25, 0.5, 0});
  missing.add({-0.75, 0.5, 0});
  EXPECT_EQ(missing.count, 2);
  const ShownField shown{"a title", "root", {sqrt(x) * y}};
  EXPECT_EQ(missing_values_text("the picture is grey at 2 pixels", missing, shown, 2),
            "the picture is grey at 2 pixels, where root is not a finite number, as at the point "
            "(-0.25, 0.5): sqrt(-0.25) in sqrt(x)");
}

TEST(MissingValues, OfAVectorAreExplainedByTheComponentThatFails) {
  MissingValues missing;
  missing.add({0, 2, 0});
  const ShownField shown{"", "|v|", {y, 1 / x}};
  EXPECT_EQ(missing_values_text("gaps", missing, shown, 2),
            "gaps, where |v| is not a finite number, as at the point (0, 2): 1 / 0 in 1/x");
}

}  // namespace
}  // namespace rfm
