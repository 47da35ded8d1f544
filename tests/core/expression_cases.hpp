#pragma once

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/expression.hpp"

namespace rfm {

// What the tests of formulas share: a scope with names of every kind, formulas with the value of
// the same formula in C++, and wrong ones with what is said of them.

inline constexpr double at_x = 0.7, at_y = -1.3, value_a = 2.5;

inline ExpressionScope test_scope() {
  ExpressionScope scope = coordinate_scope(2);
  define_derivatives(scope, 2);
  scope.define("a", value_a);
  scope.define("radius", 0.25);
  scope.define("v", ExpressionValue(std::vector<Field>{3.0, x_coordinate()}));
  scope.define("plate.left", 7.0);
  scope.define("square", Expression("x^2 + y^2"));
  scope.define_function("f", {"p", "q"}, Expression("p - 2*q"));
  scope.define("wave", sin(x_coordinate() + y_coordinate()));
  scope.define_function("g", {"h"}, Expression("h(x + 1, y)"));
  scope.define_parameter("k", 4);
  scope.refuse("u", "is known after the solve only");
  return scope;
}

inline double value_of(const std::string& text) {
  return value_at(to_field(Expression(text), test_scope()), {at_x, at_y, 0}, 0.5);
}

/// The mistake in a formula, as "offset+length: message".
inline std::string mistake(const std::string& text, const ExpressionScope& scope = test_scope()) {
  try {
    to_field(Expression(text), scope);
  } catch (const InputError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.what();
  }
  return "none";
}

struct Case {
  std::string text;
  double expected;
};
inline std::ostream& operator<<(std::ostream& stream, const Case& c) { return stream << c.text; }

struct FormulaWithValue : testing::TestWithParam<Case> {
  void expect_value() {
    EXPECT_NEAR(value_of(GetParam().text), GetParam().expected,
                2e-15 * (1 + std::abs(GetParam().expected)));
  }
};

struct WrongFormula : testing::TestWithParam<std::pair<std::string, std::string>> {
  void expect_mistake() { EXPECT_EQ(mistake(GetParam().first), GetParam().second); }
};

}  // namespace rfm
