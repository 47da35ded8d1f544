#include "tests/core/conformance_evaluators.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <random>

#include "tests/core/conformance_points.hpp"

// One suite for every row of the table of operations and every evaluator, at nasty arguments:
// values and derivatives against power series of hundreds of digits, which know the definition of
// the operation but none of the rules.
//
// The tolerance is 8 ulp of the condition: |found − F| ≤ 8 u C, u = 2⁻⁵³, with the coefficients F
// and the conditions C of `Expected` (operation_truth.hpp): what changes of u of what is given, the
// values and coefficients of the arguments, and of the coefficients of the operation explain. From
// degree 4 on a few operations are allowed 2 ulp more for each degree, since their series are made
// of powers of rounded numbers, and two that are composed of several others another digit in base
// two (`allowance`). The node by node derivatives of slots are differences of those of the parts of
// a definition: accurate to 32 ulp with respect to the largest coefficient of their degree.
//
// Where the operation is not defined no result is a finite number, of any degree. Where it is not
// smooth derivatives are a convention (core/jet.hpp), and finite. `Expected` says when overflow
// excuses a result.
namespace rfm {
namespace {

class Conformance : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(OperationTable, Conformance, testing::ValuesIn(conformance_rows()),
                         [](const auto& info) { return info.param.identifier; });

constexpr long double unit = 0x1p-53L;

std::string text_of(const Arguments& at) {
  char text[100];
  std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", at[0], at[1], at[2]);
  return text;
}

// In ulp of the condition, beyond the degrees that most structures need.
long double allowance(Operation operation, int degree) {
  const int beyond = std::max(degree - 3, 0);
  switch (operation) {
    case Operation::power:
    case Operation::rp_equivalence:
      return 8 * (1 << beyond);
    case Operation::atan:
    case Operation::tanh:
    case Operation::asinh:
    case Operation::rp_conjunction:
    case Operation::rp_disjunction:
      return 8 + 2 * beyond;
    default:
      return 8;
  }
}

long double tolerance(Operation operation, const Expected& expected, int degree) {
  return allowance(operation, degree) * unit * expected.condition +
         (degree + 1) * 64 * expected.least;
}

// For coefficients that are accurate to 32 ulp with respect to the largest of their degree.
void share_conditions(std::vector<Expected>& coefficients, int variables) {
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const int degree = jet_degree(variables, static_cast<int>(i));
    const int end = jet_size(variables, degree);
    for (int k = static_cast<int>(i) + 1; k < end; ++k)
      coefficients[i].condition = std::max(coefficients[i].condition, coefficients[k].condition);
    if (i > 0 && jet_degree(variables, static_cast<int>(i) - 1) == degree)
      coefficients[i].condition =
          std::max(coefficients[i].condition, coefficients[i - 1].condition);
  }
  for (Expected& coefficient : coefficients) coefficient.condition *= 4;
}

// What is wrong with a coefficient, or nothing.
std::string objection(Operation operation, const OperationTruth& truth, const Expected& expected,
                      int degree, double found) {
  if (!truth.is_defined) return std::isfinite(found) ? "the operation is not defined" : "";
  if (!std::isfinite(found) && expected.overflows) return "";
  if (degree > 0 && !truth.is_smooth)
    return std::isfinite(found) ? "" : "conventional derivatives are finite";
  if (truth.is_cut || !expected.is_known) return "";
  const long double error = std::fabs(found - expected.value);
  if (error <= tolerance(operation, expected, degree)) return "";
  char text[200];
  std::snprintf(text, sizeof text, "not %.17Lg, an error of %.3Lg ulp of the condition %.3Lg",
                expected.value, error / (unit * expected.condition), expected.condition);
  return text;
}

// The jets of one evaluator at all points; returns how many coefficients were compared.
void expect_conformance(const Row& row, const Evaluator& evaluator, const ArgumentShape& shape,
                        const std::vector<Arguments>& points,
                        const std::vector<OperationTruth>& truths) {
  if (!evaluator.serves(row, shape)) return;
  const Composition composition(shape, find_operation(row.operation)->arity);
  const auto jets = evaluator.jets(row, shape, points);
  int wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<Expected> expected = composition(truths[i], points[i]);
    if (evaluator.shares_rounding) share_conditions(expected, shape.variables);
    for (std::size_t k = 0; k < jets[i].size(); ++k) {
      const int degree = jet_degree(shape.variables, static_cast<int>(k));
      // Zeros among the derivatives of slots are constants, whatever they are the zero of
      // (GraphDerivative::where_defined): who takes them looks at the value too.
      if (evaluator.shares_rounding && degree == 2 && jets[i][k] == 0 && !truths[i].is_defined)
        continue;
      const std::string wrong_here =
          objection(row.operation, truths[i], expected[k], degree, jets[i][k]);
      if (wrong_here.empty() || ++wrong > 3) continue;
      ADD_FAILURE() << row.identifier << ", number " << row.number << ", by " << evaluator.name
                    << " in " << shape.variables << " variables to order " << shape.order
                    << (shape.kind == ArgumentShape::Kind::own     ? ""
                        : shape.kind == ArgumentShape::Kind::mixed ? ", of polynomials"
                                                                   : ", of proportional jets")
                    << ": coefficient " << k << " at " << text_of(points[i]) << " is "
                    << testing::PrintToString(jets[i][k]) << ": " << wrong_here;
    }
  }
}

// Shapes of arguments with values at so many points: to the order of compiled kernels and beyond.
struct Extent {
  int points;
  int highest;
  std::vector<int> variables;  ///< 0 for as many as the operation has arguments
  ArgumentShape (*shape)(int variables, int order);
};

void expect_conformance(const Row& row, const Extent& extent, unsigned seed) {
  const int arity = find_operation(row.operation)->arity;
  std::mt19937_64 generator(seed);
  const auto sample =
      extent.shape == ArgumentShape::proportional ? arguments_of_every_size : nasty_arguments;
  const std::vector<Arguments> points = sample(arity, extent.points, generator);
  std::vector<OperationTruth> truths;
  for (const Arguments& arguments : points)
    truths.push_back(truth_of(row, arguments, extent.highest));
  for (const int variables : extent.variables)
    for (int order = 0; order <= extent.highest; ++order) {
      const ArgumentShape shape = extent.shape(variables > 0 ? variables : arity, order);
      for (const Evaluator& evaluator : all_evaluators())
        expect_conformance(row, evaluator, shape, points, truths);
    }
}

TEST_P(Conformance, IsMetAtNastyArguments) {
  expect_conformance(GetParam(), {64, 2, {0}, ArgumentShape::own}, 1);
}
TEST_P(Conformance, IsMetByPolynomialsInOneToFourVariables) {
  expect_conformance(GetParam(), {12, 3, {1, 2, 3, 4}, ArgumentShape::mixed}, 2);
}
TEST_P(Conformance, IsMetByArgumentsOfEverySizeProportionalToIt) {
  expect_conformance(GetParam(), {32, 3, {1, 2, 3}, ArgumentShape::proportional}, 9);
  expect_conformance(GetParam(), {6, 8, {1}, ArgumentShape::proportional}, 10);
}
TEST_P(Conformance, IsMetToOrderEight) {
  expect_conformance(GetParam(), {24, 8, {0}, ArgumentShape::own}, 3);
  expect_conformance(GetParam(), {2, 6, {2}, ArgumentShape::mixed}, 4);
}

TEST(LongConformance, OfEveryOperation) {
  for (const Row& row : conformance_rows()) {
    expect_conformance(row, {1000, 2, {0, 3}, ArgumentShape::own}, 5);
    expect_conformance(row, {200, 4, {1, 2, 3, 4}, ArgumentShape::mixed}, 6);
    expect_conformance(row, {100, 8, {0}, ArgumentShape::own}, 7);
    expect_conformance(row, {10, 8, {1, 2, 3, 4}, ArgumentShape::mixed}, 8);
    expect_conformance(row, {300, 4, {1, 2, 3, 4}, ArgumentShape::proportional}, 11);
    expect_conformance(row, {30, 8, {1, 2, 3, 4}, ArgumentShape::proportional}, 12);
  }
}

// Arguments that are no finite numbers: values as the definition has them in long double.
long double definition(const Row& row, long double a, long double b, long double c) {
  using std::pow, std::fabs, std::sqrt, std::cbrt, std::exp, std::log, std::sin, std::cos, std::tan,
      std::asin, std::acos, std::atan, std::atan2, std::sinh, std::cosh, std::tanh, std::asinh,
      std::erf, std::hypot, std::floor;
  const long double number = row.number;
  switch (row.operation) {
#define RFM_REFERENCE(id, name, arity, numbers, rule, reference, ...) \
  case Operation::id:                                                 \
    return static_cast<long double>(reference);
    RFM_OPERATIONS(RFM_REFERENCE)
#undef RFM_REFERENCE
    default:
      return std::nan("");
  }
}

// Arguments of which the first or the second is not a number.
std::vector<Arguments> points_with_nan(int arity) {
  std::vector<Arguments> points;
  for (const double other : {0.0, -1.0, 2.5}) {
    points.push_back({std::nan(""), other, 0.5});
    if (arity > 1) points.push_back({other, std::nan(""), 0.5});
  }
  return points;
}

TEST_P(Conformance, WhatIsNotANumberStaysSo) {
  const Row& row = GetParam();
  const int arity = find_operation(row.operation)->arity;
  const std::vector<Arguments> points = points_with_nan(arity);
  for (const Evaluator& evaluator : all_evaluators())
    for (int order = 0; order <= 2; ++order) {
      const ArgumentShape shape = ArgumentShape::own(arity, order);
      if (!evaluator.serves(row, shape)) continue;
      const auto jets = evaluator.jets(row, shape, points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [a, b, c] = points[i];
        // Only the branch of an `if` that is not taken may hide it.
        const bool hidden = row.operation == Operation::select && !std::isnan(a) &&
                            !std::isnan(definition(row, a, b, c));
        EXPECT_EQ(std::isnan(jets[i][0]), !hidden)
            << row.identifier << " by " << evaluator.name << " at " << text_of(points[i]);
      }
    }
}

// Derivatives of what is not a number follow conventions (those of a sum are not touched), but the
// same ones everywhere: an order must not decide whether a point outside the domain is seen.
TEST_P(Conformance, DerivativesOfWhatIsNotANumberAreAlikeInEveryEvaluator) {
  const Row& row = GetParam();
  const std::vector<Arguments> points = points_with_nan(find_operation(row.operation)->arity);
  // Whether the slope along the first variable is a number, by the first evaluator at first order.
  std::vector<bool> is_number;
  for (const Evaluator& evaluator : all_evaluators())
    for (const int variables : {1, 2, 3, 4})
      for (const int order : {1, 2, 3, 5}) {
        const ArgumentShape shape = ArgumentShape::mixed(variables, order);
        if (!evaluator.serves(row, shape)) continue;
        const auto jets = evaluator.jets(row, shape, points);
        if (is_number.empty())
          for (const auto& jet : jets) is_number.push_back(!std::isnan(jet[1]));
        for (std::size_t i = 0; i < points.size(); ++i)
          for (std::size_t k = 1; k < jets[i].size() && k < 5; ++k)
            EXPECT_EQ(!std::isnan(jets[i][k]), is_number[i])
                << row.identifier << " by " << evaluator.name << " in " << variables
                << " variables to order " << order << ", coefficient " << k << ", at "
                << text_of(points[i]);
      }
}

TEST_P(Conformance, InfinityHasItsLimitInEveryEvaluator) {
  const Row& row = GetParam();
  const int arity = find_operation(row.operation)->arity;
  std::vector<Arguments> points;
  for (const double other : {1.0, -2.5, 0.0})
    for (const double infinite : {INFINITY, -INFINITY}) {
      points.push_back({infinite, other, 0.5});
      if (arity > 1) points.push_back({other, infinite, 0.5});
      if (arity > 1) points.push_back({infinite, std::copysign(INFINITY, other), 0.5});
    }
  for (const Evaluator& evaluator : all_evaluators())
    for (int order = 0; order <= 2; ++order) {
      const ArgumentShape shape = ArgumentShape::own(arity, order);
      if (!evaluator.serves(row, shape)) continue;
      const auto jets = evaluator.jets(row, shape, points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [a, b, c] = points[i];
        const auto exact = static_cast<double>(definition(row, a, b, c));
        // No number is safe, it is reported. R-functions have a limit where the difference that
        // defines them has none, ∞ − ∞.
        const bool is_difference = row.identifier.find("junction") != std::string::npos;
        if (std::isnan(jets[i][0]) || (is_difference && std::isnan(exact))) continue;
        EXPECT_TRUE(jets[i][0] == exact ||
                    std::fabs(jets[i][0] - exact) <= 1e-15 * std::fabs(exact))
            << row.identifier << " by " << evaluator.name << " at " << text_of(points[i]) << ": "
            << jets[i][0] << ", not " << exact;
      }
    }
}

// Zeros of both signs and ∞ of both signs: the sign decides at cuts and poles, and in all
// evaluators as in the definition.
TEST_P(Conformance, ZeroHasItsSignInEveryEvaluator) {
  const Row& row = GetParam();
  const int arity = find_operation(row.operation)->arity;
  std::vector<Arguments> points;
  for (const double zero : {0.0, -0.0})
    for (const double other : {0.0, -0.0, 1.0, -2.5}) {
      points.push_back({zero, other, 0.5});
      if (arity > 1) points.push_back({other, zero, 0.5});
    }
  for (const Evaluator& evaluator : all_evaluators())
    for (int order = 0; order <= 2; ++order) {
      const ArgumentShape shape = ArgumentShape::own(arity, order);
      if (!evaluator.serves(row, shape)) continue;
      const auto jets = evaluator.jets(row, shape, points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [a, b, c] = points[i];
        const auto exact = static_cast<double>(definition(row, a, b, c));
        const bool as_defined = std::isnan(exact)   ? !std::isfinite(jets[i][0])
                                : std::isinf(exact) ? jets[i][0] == exact
                                                    : std::fabs(jets[i][0] - exact) <= 1e-14;
        EXPECT_TRUE(as_defined) << row.identifier << " by " << evaluator.name << " to order "
                                << order << " at " << text_of(points[i]) << ": " << jets[i][0]
                                << ", not " << exact;
      }
    }
}

}  // namespace
}  // namespace rfm
