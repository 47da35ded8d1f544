#include "basis/tensor_product_space.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"

namespace rfm {
namespace {

using testing::ElementsAre;

const Grid plane({2, {0, 0}, {4, 3}}, {4, 3, 1});
const Grid solid({3, {0, 0, 0}, {4, 3, 2}}, {4, 3, 2});

TEST(TensorProductSpace, OnAFullGridHasCellsPlusDegreeFunctionsAlongEachAxis) {
  EXPECT_EQ(TensorProductSpace(Grid({1, {0}, {1}}, {7, 1, 1}), 4).size(), 11);
  EXPECT_EQ(TensorProductSpace(plane, 2).size(), 6 * 5);
  EXPECT_EQ(TensorProductSpace(solid, 3).size(), 7 * 6 * 5);
}

TEST(TensorProductSpace, KeepsExactlyTheSplinesOfMarkedCells) {
  std::vector<std::uint8_t> cells(plane.cell_count(), 0);
  cells[plane.number({0, 0, 0})] = 1;
  cells[plane.number({3, 2, 0})] = 1;
  const TensorProductSpace space(plane, 1, cells);
  std::set<int> kept;
  for (int function = 0; function < space.size(); ++function)
    kept.insert(space.spline_of_function(function));
  EXPECT_THAT(kept, ElementsAre(0, 1, 5, 6, 13, 14, 18, 19));  // rows of 5 splines
  for (int spline = 0; spline < space.spline_count(); ++spline) {
    const int function = space.function_of_spline(spline);
    EXPECT_EQ(function >= 0, kept.count(spline) == 1);
    if (function >= 0) {
      EXPECT_EQ(space.spline_of_function(function), spline);
    }
    EXPECT_EQ(space.spline(space.place(spline)), spline);
  }
}

TEST(TensorProductSpace, NumbersTheFunctionsOfARunOfSplinesConsecutively) {
  std::vector<std::uint8_t> cells(solid.cell_count(), 0);
  cells[solid.number({1, 1, 0})] = cells[solid.number({2, 1, 1})] = 1;
  const TensorProductSpace space(solid, 2, cells);
  std::vector<int> numbers(space.functions_per_cell());
  ASSERT_EQ(numbers.size(), 27u);
  for (const int cell : {solid.number({1, 1, 0}), solid.number({2, 1, 1})}) {
    space.cell_functions(cell, numbers);
    EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
    for (int run = 0; run < 9; ++run) {
      EXPECT_GE(numbers[3 * run], 0);
      EXPECT_EQ(numbers[3 * run + 2], numbers[3 * run] + 2);
    }
  }
  // A cell out of reach has none of them.
  space.cell_functions(solid.number({0, 0, 0}), numbers);
  EXPECT_EQ(numbers[0], -1);
}

TEST(TensorProductSpace, ExpandsCoefficientsToAllSplines) {
  std::vector<std::uint8_t> cells{0, 1, 0};
  const TensorProductSpace space(Grid({1, {0}, {3}}, {3, 1, 1}), 1, cells);
  EXPECT_THAT(space.expand(std::vector<double>{5, 7}), ElementsAre(0, 5, 7, 0));
  EXPECT_THROW(space.expand(std::vector<double>{1, 2, 3}), InvalidArgument);
}

TEST(TensorProductSpace, WrongNumbersAreRefused) {
  EXPECT_THROW(TensorProductSpace(plane, 0), InvalidArgument);
  EXPECT_THROW(TensorProductSpace(plane, 9), InvalidArgument);
  EXPECT_THROW(TensorProductSpace(plane, 2, std::vector<std::uint8_t>(5, 1)), InvalidArgument);
  EXPECT_THROW(TensorProductSpace(plane, 2, std::vector<std::uint8_t>(12, 0)), InvalidArgument);
}

}  // namespace
}  // namespace rfm
