#include "core/jet_shape.hpp"

#include <gmock/gmock.h>

#include <set>

#include "core/error.hpp"

namespace rfm {
namespace {

class Shapes : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  const JetShape& shape = JetShape::get(std::get<0>(GetParam()), std::get<1>(GetParam()));
};
INSTANTIATE_TEST_SUITE_P(JetShape, Shapes,
                         testing::Combine(testing::Values(1, 2, 3, 4),
                                          testing::Values(0, 1, 3, 6)));

TEST_P(Shapes, HaveEveryExponentOnceInAscendingDegree) {
  std::set<MultiIndex> seen;
  for (int i = 0; i < shape.size(); ++i) {
    EXPECT_TRUE(seen.insert(shape.exponent(i)).second);
    EXPECT_EQ(jet_index(shape.variables(), shape.exponent(i)), i);
    if (i > 0) {
      EXPECT_GE(degree(shape.exponent(i)), degree(shape.exponent(i - 1)));
    }
  }
  EXPECT_EQ(shape.size(), jet_size(shape.variables(), shape.order()));
  for (int k = 0; k <= shape.order(); ++k) EXPECT_EQ(shape.size(k), jet_size(shape.variables(), k));
}

TEST_P(Shapes, ListEveryProductOfTwoMonomialsUnderTheirProduct) {
  std::size_t listed = 0, pairs = 0;
  for (int i = 0; i < shape.size(); ++i)
    for (const JetShape::Term& term : shape.product_terms(i)) {
      ++listed;
      EXPECT_EQ(shape.exponent(term.left) + shape.exponent(term.right), shape.exponent(i));
    }
  for (int i = 0; i < shape.size(); ++i)
    for (int j = 0; j < shape.size(); ++j)
      pairs += degree(shape.exponent(i)) + degree(shape.exponent(j)) <= shape.order();
  EXPECT_EQ(listed, pairs);
}

TEST_P(Shapes, RaiseExponentsIntoTheNextOrder) {
  if (shape.order() == maximum_order) return;
  const JetShape& next = JetShape::get(shape.variables(), shape.order() + 1);
  for (int axis = 0; axis < shape.variables(); ++axis)
    for (int i = 0; i < shape.size(); ++i)
      EXPECT_EQ(next.exponent(shape.raised(axis, i)), shape.exponent(i) + unit_index(axis));
}

TEST(JetShape, ThereIsOneOfEachAndNoneBeyondTheLimits) {
  EXPECT_EQ(&JetShape::get(3, 5), &JetShape::get(3, 5));
  EXPECT_NE(&JetShape::get(3, 5), &JetShape::get(3, 4));
  EXPECT_THROW(JetShape::get(0, 2), InvalidArgument);
  EXPECT_THROW(JetShape::get(5, 2), InvalidArgument);
  EXPECT_THROW(JetShape::get(2, maximum_order + 1), InvalidArgument);
  EXPECT_THROW(JetShape::get(2, -1), InvalidArgument);
}

}  // namespace
}  // namespace rfm
