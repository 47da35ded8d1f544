#include "core/r_functions.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/r_rules.hpp"

namespace rfm {

namespace {

const Field x = x_coordinate(), y = y_coordinate();

// Failures name the system.
std::string name_of(const testing::TestParamInfo<RSystem>& info) {
  std::ostringstream text;
  text << info.param;
  std::string name;
  for (const char c : text.str())
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
  return name + "_" + std::to_string(info.index);
}

// Symmetric in its arguments and in their signs, between −0.5 and 0.8.
const Field alpha_field = 0.8 - 1.3 * (x * x + y * y) / (1 + x * x + y * y);

// A system of one's own: (x + y)⁴ exceeds x⁴ + x²y² + y⁴ exactly where both are positive or both
// negative, and on x = 0 the root is |y| + O(x²).
const UserSystem quartic{"quartic",
                         [](const Field& a, const Field& b) {
                           return a + b - sqrt(sqrt(pow(a, 4) + a * a * b * b + pow(b, 4)));
                         },
                         {},
                         1};

// Systems that are normalised, and all of them.
const auto normalized_systems =
    testing::Values(RSystem(RAlpha{-0.9}), RSystem(RAlpha{0}), RSystem(RAlpha{0.5}),
                    RSystem(RAlpha{1}), RSystem(R1{}), RSystem(Rp{2}), RSystem(Rp{4}),
                    RSystem(Rp{6}), RSystem(RAlphaField{alpha_field}), RSystem(quartic));
const auto flat_systems =
    testing::Values(RSystem(RAlphaM{0, 1}), RSystem(RAlphaM{0, 2}), RSystem(RAlphaM{0.3, 3}),
                    RSystem(RCm{1}), RSystem(RCm{2}), RSystem(RCm{3}), RSystem(RCm{4}));

class EverySystem : public testing::TestWithParam<RSystem> {};
INSTANTIATE_TEST_SUITE_P(Normalized, EverySystem, normalized_systems, name_of);
INSTANTIATE_TEST_SUITE_P(Flat, EverySystem, flat_systems, name_of);
class EveryNormalizedSystem : public testing::TestWithParam<RSystem> {};
INSTANTIATE_TEST_SUITE_P(RFunctions, EveryNormalizedSystem, normalized_systems, name_of);
class EveryAlpha : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(RFunctions, EveryAlpha, testing::Values(-0.5, 0.0, 0.3, 0.9, 1.0));

constexpr double places[] = {-2.0, -1e-9, 1e-9, 0.7, 3.0};

// The companion of f, at points on both sides of each axis and close to them.
template <class Companion>
void expect_sign(const Field& f, const Companion& companion) {
  for (const double a : places)
    for (const double b : places)
      EXPECT_EQ(value_at(f, {a, b}) > 0, companion(a > 0, b > 0)) << "at " << a << ", " << b;
}

TEST_P(EverySystem, ConjunctionIsPositiveExactlyWhereBothArgumentsAre) {
  expect_sign(conjunction(x, y, GetParam()), [](bool a, bool b) { return a && b; });
}

TEST_P(EverySystem, DisjunctionIsPositiveExactlyWhereAnyArgumentIs) {
  expect_sign(disjunction(x, y, GetParam()), [](bool a, bool b) { return a || b; });
}

TEST_P(EverySystem, OtherFunctionsHaveTheSignsOfTheirCompanions) {
  expect_sign(exclusive_or(x, y, GetParam()), [](bool a, bool b) { return a != b; });
  expect_sign(implication(x, y, GetParam()), [](bool a, bool b) { return !a || b; });
  expect_sign(sheffer_stroke(x, y, GetParam()), [](bool a, bool b) { return !(a && b); });
  expect_sign(negation(x), [](bool a, bool) { return !a; });
}

TEST_P(EverySystem, ShefferStrokeIsComplete) {
  // ¬x = x | x and x ∧ y = (x | y) | (x | y) have the right signs (Shapiro 2007, after theorem 1).
  const auto stroke = [&](const Field& a, const Field& b) {
    return sheffer_stroke(a, b, GetParam());
  };
  expect_sign(stroke(x, x), [](bool a, bool) { return !a; });
  expect_sign(stroke(stroke(x, y), stroke(x, y)), [](bool a, bool b) { return a && b; });
  expect_sign(stroke(stroke(x, x), stroke(y, y)), [](bool a, bool b) { return a || b; });
}

TEST_P(EverySystem, ConjunctionsOfManyHaveTheSignOfTheSmallest) {
  std::vector<Field> fields;
  for (int i = 0; i < 7; ++i) fields.push_back(x + 0.25 * i);
  const Field all = conjunction(fields, GetParam()), any = disjunction(fields, GetParam());
  for (double a = -2.1; a < 1; a += 0.2) {
    EXPECT_EQ(value_at(all, {a, 0}) > 0, a > 0) << a;
    EXPECT_EQ(value_at(any, {a, 0}) > 0, a > -1.5) << a;
  }
  EXPECT_TRUE(conjunction(std::vector<Field>{x}, GetParam()).same_as(x));
  EXPECT_GT(conjunction(std::vector<Field>{}, GetParam()).constant(), 0);
  EXPECT_LT(disjunction(std::vector<Field>{}, GetParam()).constant(), 0);
}

TEST(RFunctions, FieldsOfAlphaAreAsAccurateAsConstantsAtEverySize) {
  const RAlphaField field{z_coordinate()};
  const RAlpha constant{0.3};
  for (const double size : {1e-290, 1e-170, 1e-160, 1.0, 1e154, 1e300})
    for (const double a : {-1.3, 1e-9, 0.7})
      for (const double b : {-1e-9, 0.4, 1.5})
        for (const bool is_conjunction : {true, false}) {
          const auto jet = [&](const RSystem& system) {
            return evaluate(is_conjunction ? conjunction(x, y, system) : disjunction(x, y, system),
                            {size * a, size * b, 0.3}, 1);
          };
          const PointJet found = jet(field), expected = jet(constant);
          const std::string at = "at " + std::to_string(a) + ", " + std::to_string(b) + " times ";
          EXPECT_NEAR(found.value() / size, expected.value() / size,
                      1e-15 * std::fabs(expected.value() / size) + 1e-300)
              << at << size;
          for (int axis = 0; axis < 2; ++axis)
            EXPECT_NEAR(found.derivative(axis == 0, axis == 1),
                        expected.derivative(axis == 0, axis == 1), 4e-15)
                << at << size;
        }
}

TEST_P(EveryNormalizedSystem, ConjunctionIsNormalizedOnItsFace) {
  // On {x = 0, y > 0}: x ∧ y = x + O(x²), so ∂/∂x = 1 and ∂/∂y = 0.
  const PointJet omega = evaluate(conjunction(x, y, GetParam()), {0.0, 2.0}, 1);
  EXPECT_NEAR(omega.derivative(1, 0), 1.0, 1e-14);
  EXPECT_NEAR(omega.derivative(0, 1), 0.0, 1e-14);
}

TEST_P(EverySystem, DeMorgansLawAndCommutativityHold) {
  const Field law = disjunction(x, y, GetParam()) + conjunction(-x, -y, GetParam());
  const Field commuted = conjunction(x, y, GetParam()) - conjunction(y, x, GetParam());
  for (const double a : places)
    for (const double b : places) {
      EXPECT_NEAR(value_at(law, {a, b}), 0, 1e-15);
      EXPECT_NEAR(value_at(commuted, {a, b}), 0, 1e-15);
    }
}

TEST_P(EverySystem, DerivativesAreFiniteAtTheCorner) {
  for (const Field& f : {conjunction(x, y, GetParam()), disjunction(x, y, GetParam())}) {
    const PointJet jet = evaluate(f, {0, 0}, 2);
    EXPECT_EQ(jet.value(), 0);
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; i + j <= 2; ++j) EXPECT_TRUE(std::isfinite(jet.derivative(i, j)));
  }
}

TEST_P(EveryAlpha, SumAndProductOfConjunctionAndDisjunctionAreRational) {
  // (x ∧ y) + (x ∨ y) = 2 (x + y) / (1 + α) and (x ∧ y)(x ∨ y) = 2 x y / (1 + α).
  const double alpha = GetParam();
  const Field both = conjunction(x, y, RAlpha{alpha}), either = disjunction(x, y, RAlpha{alpha});
  for (const double a : places)
    for (const double b : places) {
      EXPECT_NEAR(value_at(both + either, {a, b}), 2 * (a + b) / (1 + alpha), 2e-14);
      EXPECT_NEAR(value_at(both * either, {a, b}), 2 * a * b / (1 + alpha), 5e-14);
    }
}

TEST_P(EveryAlpha, ConjunctionKeepsItsDigitsNextToTheBoundary) {
  // On y = 1: x ∧ 1 = x − (1 − α) x² / 2 + O(x³) for α < 1 and x for α = 1.
  const double alpha = GetParam();
  const Field both = conjunction(x, y, RAlpha{alpha});
  for (const double a : {1e-12, 1e-40}) {
    const double expected = a - 0.5 * (1 - alpha) * a * a;
    EXPECT_NEAR(value_at(both, {a, 1}), expected, 1e-15 * a);
    EXPECT_NEAR(value_at(disjunction(x, y, RAlpha{alpha}), {-a, -1}), -expected, 1e-15 * a);
  }
}

TEST(RFunctions, RpIsNormalizedToOrderPMinusOne) {
  // x ∧ y = x + O(xᵖ): all pure derivatives along x from the second to order p − 1 vanish on x = 0,
  // and the p-th is not zero.
  const PointJet four = evaluate(conjunction(x, y, Rp{4}), {0.0, 2.0}, 4, 2);
  EXPECT_DOUBLE_EQ(four.derivative(1), 1);
  EXPECT_NEAR(four.derivative(2), 0, 1e-14);
  EXPECT_NEAR(four.derivative(3), 0, 1e-14);
  // (x⁴ + 16)^{1/4} = 2 + x⁴ / 32 + O(x⁸)
  EXPECT_NEAR(four.derivative(4), -24.0 / 32, 1e-13);
  EXPECT_NEAR(evaluate(conjunction(x, y, Rp{2}), {0.0, 2.0}, 2, 2).derivative(2), -0.5, 1e-14);
}

TEST(RFunctions, RpIsNormalizedToOrderPMinusOneForHigherP) {
  // (x⁶ + 64)^{1/6} = 2 + x⁶ / 192 + O(x¹²).
  using Number = Jet<double, 1, 7>;
  const Number both = rp_conjunction(Number::variable(0, 0.0), Number(2.0), 6);
  EXPECT_NEAR(both.c[1], 1, 1e-15);
  for (int k = 2; k <= 5; ++k) EXPECT_NEAR(both.c[k], 0, 1e-15) << k;
  EXPECT_NEAR(both.c[6], -1.0 / 192, 1e-15);
}

TEST(RFunctions, RpKeepsItsDigitsNextToTheBoundaryAndInTheCorner) {
  // On y = 1: x ∧ 1 = x − xᵖ/p + O(x²ᵖ); on x = y = s: s (2 − 2^{1/p}).
  for (const int p : {2, 4, 6, 10}) {
    const Field both = conjunction(x, y, Rp{p});
    for (const double a : {0.01, 1e-12, 1e-200})
      EXPECT_NEAR(value_at(both, {a, 1}), a - std::expm1(std::log1p(std::pow(a, p)) / p),
                  1e-15 * a);
    for (const double s : {1e-200, 1e-20, 7.0, 1e20}) {
      EXPECT_NEAR(value_at(both, {s, s}), s * (2 - std::pow(2, 1.0 / p)), 2e-15 * s) << p;
      EXPECT_NEAR(value_at(both, {-s, s}), -s * std::pow(2, 1.0 / p), 2e-15 * s) << p;
    }
  }
}

TEST(RFunctions, RpWithAnExponentOf2IsR0) {
  using Number = Jet<double, 2, 2>;
  for (const double a : places)
    for (const double b : places) {
      const Number p = rp_conjunction(Number::variable(0, a), Number::variable(1, b), 2);
      const Number r0 = r0_conjunction(Number::variable(0, a), Number::variable(1, b));
      for (int k = 0; k < Number::size; ++k)
        EXPECT_NEAR(p.c[k], r0.c[k], 1e-15 * (1 + std::fabs(r0.c[k])));
    }
}

TEST(RFunctions, ExclusiveOrOfR0IsTheCompositionAndKeepsItsDigits) {
  // (¬x ∧ y) ∨ (x ∧ ¬y), Shapiro (2007) §3.4; on y = 1: −x + O(x²), with coefficient ¼.
  const Field composed = disjunction(conjunction(-x, y), conjunction(x, -y));
  const Field direct = exclusive_or(x, y);
  for (const double a : places)
    for (const double b : places) {
      EXPECT_NEAR(value_at(direct, {a, b}), value_at(composed, {a, b}), 4e-15);
      const PointJet left = evaluate(direct, {a, b}, 2, 2),
                     right = evaluate(composed, {a, b}, 2, 2);
      EXPECT_NEAR(left.derivative(1, 0), right.derivative(1, 0), 1e-13);
      EXPECT_NEAR(left.derivative(0, 1), right.derivative(0, 1), 1e-13);
    }
  for (const double a : {1e-12, -1e-12, 1e-40, 1e-250}) {
    EXPECT_NEAR(value_at(direct, {a, 1}), -a - 0.25 * a * a, 1e-15 * std::fabs(a));
    EXPECT_NEAR(value_at(direct, {a, a}), -2 * std::fabs(a) / (1 + std::sqrt(2.0)),
                2e-15 * std::fabs(a));
  }
}

TEST(RFunctions, R0mIsMTimesDifferentiableAtTheCorner) {
  // f = R₀ rᵐ is homogeneous of degree m + 1: derivatives up to order m vanish at 0 and are
  // continuous there, those of order m + 1 depend on the direction.
  for (const int m : {1, 2}) {
    const Field f = conjunction(x, y, RAlphaM{0, m});
    const PointJet corner = evaluate(f, {0, 0}, m, 2);
    for (int i = 0; i <= m; ++i)
      for (int j = 0; i + j <= m; ++j) EXPECT_EQ(corner.derivative(i, j), 0) << i << j;
    double least = 1e300, most = -1e300;
    for (double angle = 0; angle < 6; angle += 1) {
      const double h = 1e-3;
      const PointJet near = evaluate(f, {h * std::cos(angle), h * std::sin(angle)}, m + 1, 2);
      for (int i = 0; i <= m; ++i)
        for (int j = 0; i + j <= m; ++j) EXPECT_LT(std::fabs(near.derivative(i, j)), 60 * h);
      least = std::min(least, near.derivative(m + 1, 0));
      most = std::max(most, near.derivative(m + 1, 0));
    }
    EXPECT_GT(most - least, 0.5);
  }
}

TEST(RFunctions, RCmIsItsFormulaAndSmoothAcrossTheDiagonal) {
  const auto formula = [](double a, double b, int m) {
    const double s = 0.5 * (a + b), d = 0.5 * (a - b);
    return (s > 0 ? 1 : -1) * std::pow(std::fabs(s), m) - std::pow(std::fabs(d), m);
  };
  for (const int m : {1, 2, 3, 4})
    for (const double a : places)
      for (const double b : places)
        EXPECT_NEAR(value_at(conjunction(x, y, RCm{m}), {a, b}), formula(a, b, m), 2e-14);
  // Derivatives up to order m − 1 agree from both sides of x = y.
  const Field f = conjunction(x, y, RCm{3});
  const PointJet below = evaluate(f, {1, 1 - 1e-9}, 3, 2), above = evaluate(f, {1, 1 + 1e-9}, 3, 2);
  for (int k = 0; k <= 2; ++k) EXPECT_NEAR(below.derivative(k), above.derivative(k), 1e-8) << k;
  EXPECT_NEAR(above.derivative(3) - below.derivative(3), 1.5, 1e-6);  // 2 · 3! / 2³
}

TEST(RFunctions, ParametersOutOfRangeAreRefused) {
  EXPECT_THROW(conjunction(x, y, RAlpha{-1}), InvalidArgument);  // −1 < α ≤ 1
  EXPECT_THROW(conjunction(x, y, RAlpha{1.01}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, RAlpha{std::nan("")}), InvalidArgument);
  EXPECT_THROW(disjunction(x, y, RAlpha{-1}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, Rp{3}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, Rp{0}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, RAlphaM{0, 0}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, RAlphaM{-1, 1}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, RCm{17}), InvalidArgument);
}

TEST_P(EverySystem, ImplicitFunctionOfARegionHasItsSign) {
  const Region region = (box({-1, -1}, {1, 1}) - circle({1, 1}, 0.8)) | circle({-1, 0}, 0.5);
  const RegionEvaluator evaluator(region);
  const Field omega = implicit(region, GetParam());
  for (double a = -1.63; a < 1.6; a += 0.11)
    for (double b = -1.617; b < 1.6; b += 0.11)
      EXPECT_EQ(value_at(omega, {a, b}) > 0, evaluator.contains(Point{a, b})) << a << ", " << b;
}

TEST_P(EverySystem, NormalizationIsKeptToTheOrderItClaimsAndNoFurther) {
  // On {x = 0, y > 0}: x ∧ y = x + O(x^{k+1}), and x ∨ y likewise on {x = 0, y < 0}.
  const int claimed = std::min(normalization_order(GetParam()), 6);
  const Field functions[] = {conjunction(x, y, GetParam()), disjunction(x, y, GetParam())};
  for (const int which : {0, 1}) {
    const PointJet jet = evaluate(functions[which], {0.0, which == 0 ? 0.8 : -0.8}, 7, 2);
    if (claimed == 0) {
      EXPECT_GT(std::fabs(jet.derivative(1, 0) - 1), 1e-3);
      continue;
    }
    EXPECT_NEAR(jet.derivative(1, 0), 1, 1e-13);
    for (int k = 2; k <= claimed; ++k) EXPECT_NEAR(jet.derivative(k, 0), 0, 1e-10) << k;
    if (claimed < 6) {
      EXPECT_GT(std::fabs(jet.derivative(claimed + 1, 0)), 0.1);
    }
  }
}

TEST(RFunctions, OfAnyBooleanFunctionOfThreeArgumentsHaveItsSigns) {
  // All 256 of them, as sums of their rows in a truth table.
  const Field z = z_coordinate();
  const Field fields[] = {x, y, z};
  for (int table = 0; table < 256; ++table) {
    BooleanExpression expression = BooleanExpression::constant(false);
    for (int row = 0; row < 8; ++row) {
      if ((table >> row & 1) == 0) continue;
      BooleanExpression term = BooleanExpression::constant(true);
      for (int v = 0; v < 3; ++v)
        term = term & ((row >> v & 1) != 0 ? BooleanExpression::variable(v)
                                           : !BooleanExpression::variable(v));
      expression = expression | term;
    }
    const Field f = r_function(expression, fields);
    for (int row = 0; row < 8; ++row) {
      const Point at{(row & 1) != 0 ? 0.7 : -2.0, (row & 2) != 0 ? 3.0 : -0.4,
                     (row & 4) != 0 ? 1.0 : -1.0};
      EXPECT_EQ(value_at(f, at) > 0, (table >> row & 1) != 0) << table << ", " << row;
    }
  }
  EXPECT_THROW(r_function(BooleanExpression::variable(3), fields), InvalidArgument);
}

}  // namespace
}  // namespace rfm
