#include "quadrature/root_contact.hpp"

#include <gmock/gmock.h>

using namespace rfm;

namespace {

constexpr double zero = 1e-13, rounding = 1e-15;

// Of t ↦ a tᵏ on [−1, 1] about its zero, the contact being where it is at most `zero`.
Contact contact_of_power(int k, double a = 1) {
  const double reach = std::pow(zero / std::fabs(a), 1.0 / k);
  const auto function = [&](double t, double& slope) {
    slope = a * k * std::pow(t, k - 1);
    return a * std::pow(t, k);
  };
  return classify_contact(function, -1, 1, -0.9 * reach, 0.8 * reach, zero, rounding);
}

TEST(RootContact, EvenPowersTouchAndOddPowersCross) {
  for (const double a : {1.0, -3.0}) {
    EXPECT_EQ(contact_of_power(2, a), Contact::touches);
    EXPECT_EQ(contact_of_power(3, a), Contact::crosses);
    EXPECT_EQ(contact_of_power(4, a), Contact::touches);  // 1e-3 long
    EXPECT_EQ(contact_of_power(5, a), Contact::crosses);
  }
}

TEST(RootContact, WhatIsZeroOnAPartVanishesThere) {
  const auto function = [](double t, double& slope) {
    slope = t < 0 ? 0 : 2 * t;
    return t < 0 ? 0 : t * t;
  };
  EXPECT_EQ(classify_contact(function, -1, 1, -1, 3e-7, zero, rounding), Contact::vanishes);
}

TEST(RootContact, AtAnEndOfTheIntervalNothingIsCrossed) {
  const auto function = [](double t, double& slope) {
    slope = 3 * t * t;
    return t * t * t;
  };
  EXPECT_EQ(classify_contact(function, 0, 1, 0, 4e-5, zero, rounding), Contact::touches);
}

}  // namespace
