#include "core/even_and_odd.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate.hpp"
#include "core/expression_text.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

TEST(EvenAndOdd, PartsAddUpToTheFunction) {
  // In terms of the coordinates x for the square and y for the height.
  for (const Field& f :
       {x, x * x * x - 3.0 * x * y + 1.0, pow(x - 1.0, 4.0) - y, pow(x, 7.0) / (1.0 + x * x),
        exp(-(x * x)) * x + y, hypot(x, y) - 0.5, abs(x * y) + pow(2.0 * x, 3.0),
        sqrt(1.0 + pow(x, 4.0)) - x, pow(x, 3.0) * normalize(1.0 - pow(x, 4.0), 2)}) {
    const auto parts = even_and_odd(f, x, y);
    ASSERT_TRUE(parts.has_value()) << to_text(f);
    for (const double at : {0.2, 0.9, 1.7})
      for (const double height : {-0.6, 0.3, 2.0}) {
        const Point image{at * at, height};
        EXPECT_NEAR(value_at(parts->even, image) + at * value_at(parts->odd, image),
                    value_at(f, {at, height}), 1e-13);
      }
  }
}

TEST(EvenAndOdd, EvenFunctionsHaveNoOddPart) {
  for (const Field& f : {x * x - y, pow(x, 4.0) + pow(x * y, 2.0), cos(x * x), hypot(x, y),
                         (x - 1.0) * (x + 1.0) + y, normalize(1.0 - pow(x, 4.0) - y * y, 2)})
    EXPECT_TRUE(even_and_odd(f, x, y)->is_even()) << to_text(f);
  EXPECT_FALSE(even_and_odd(x * y, x, y)->is_even());
}

TEST(EvenAndOdd, WhatDoesNotShowItsPartsHasNone) {
  for (const Field& f : {sin(x), exp(x), sqrt(1.0 + x), 1.0 / (1.0 + x), min(x, y)})
    EXPECT_FALSE(even_and_odd(f, x, y).has_value());
}

}  // namespace
}  // namespace rfm
