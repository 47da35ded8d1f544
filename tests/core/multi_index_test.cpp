#include "core/multi_index.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace rfm {
namespace {

std::vector<MultiIndex> all_indices(int variables, int order) {
  std::vector<MultiIndex> list;
  MultiIndex index{};
  const auto visit = [&](auto&& self, int axis, int left) -> void {
    if (axis == variables) return list.push_back(index);
    for (int power = 0; power <= left; ++power) {
      index[axis] = static_cast<std::uint8_t>(power);
      self(self, axis + 1, left - power);
    }
    index[axis] = 0;
  };
  visit(visit, 0, order);
  return list;
}

TEST(MultiIndex, JetsHaveAsManyCoefficientsAsThereAreMonomials) {
  static_assert(jet_size(1, 3) == 4 && jet_size(2, 2) == 6 && jet_size(3, 3) == 20);
  for (int variables = 1; variables <= 4; ++variables)
    for (int order = 0; order <= 6; ++order)
      EXPECT_EQ(jet_size(variables, order), all_indices(variables, order).size());
}

TEST(MultiIndex, EveryMonomialHasAPlaceOfItsOwnAndLowerOrdersComeFirst) {
  for (int variables = 1; variables <= 4; ++variables)
    for (int order = 0; order <= 6; ++order) {
      std::vector<int> taken(jet_size(variables, order), 0);
      for (const MultiIndex& index : all_indices(variables, order)) {
        const int place = jet_index(variables, index);
        ASSERT_LT(place, jet_size(variables, degree(index)));
        ASSERT_GE(place, degree(index) == 0 ? 0 : jet_size(variables, degree(index) - 1));
        ++taken[place];
      }
      EXPECT_THAT(taken, testing::Each(1));
    }
}

TEST(MultiIndex, WithinADegreeXComesBeforeYBeforeZ) {
  EXPECT_EQ(jet_index(2, {2, 0}), 3);
  EXPECT_EQ(jet_index(2, {1, 1}), 4);
  EXPECT_EQ(jet_index(2, {0, 2}), 5);
  EXPECT_EQ(jet_index(3, {0, 1, 0}), 2);
  EXPECT_EQ(jet_index(3, {1, 0, 1}), 6);
}

TEST(MultiIndex, FactorialIsTheProductOfFactorials) {
  EXPECT_EQ(factorial({0, 1, 0, 0}), 1);
  EXPECT_EQ(factorial({3, 2, 0, 4}), 6 * 2 * 24);
}

}  // namespace
}  // namespace rfm
