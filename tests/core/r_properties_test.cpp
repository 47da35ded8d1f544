#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/evaluate.hpp"
#include "core/r_functions.hpp"

// The general properties of R-functions: V. Shapiro, Semi-analytic geometry with R-functions, Acta
// Numerica 16 (2007), §3.2, properties 1 to 6, and the examples before them.
namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

using Signs = std::array<bool, 3>;
using Companion = std::function<bool(const Signs&)>;

// f has the sign of its companion whatever the size of its arguments.
void expect_companion(const Field& f, const Companion& companion) {
  constexpr double sizes[] = {1e-6, 0.3, 1, 7};
  for (int corner = 0; corner < 8; ++corner) {
    const Signs signs{(corner & 4) != 0, (corner & 2) != 0, (corner & 1) != 0};
    for (const double a : sizes)
      for (const double b : sizes)
        for (const double c : sizes) {
          const Point point{signs[0] ? a : -a, signs[1] ? b : -b, signs[2] ? c : -c};
          const double value = value_at(f, point);
          EXPECT_TRUE(companion(signs) ? value > 0 : value < 0)
              << value << " at " << point[0] << ", " << point[1] << ", " << point[2];
        }
  }
}

// The sign table of a function of three arguments, for −−−, −−+, −+−, −++, +−−, +−+, ++−, +++.
Companion table(const std::string& signs) {
  return [signs](const Signs& s) { return signs[4 * s[0] + 2 * s[1] + s[2]] == '+'; };
}

TEST(Shapiro2007, ExamplesW1ToW5HaveTheirSignTables) {  // table 3.1
  const auto root = [](const Field& a, const Field& b) { return sqrt(a * a + b * b); };
  expect_companion(x * y * z, table("-++-+--+"));
  expect_companion(x + y + sqrt(x * y + x * x + y * y), table("--++++++"));
  expect_companion(2 + x * x + y * y + z * z, table("++++++++"));
  expect_companion(x + y + z - root(x, y) - root(x, z) - root(y, z) + sqrt(x * x + y * y + z * z),
                   [](const Signs& s) { return s[0] && s[1] && s[2]; });
  // |z − xy| + xy + z = 2 max(xy, z): at most zero where both are negative.
  expect_companion(2 * max(x * y, z), table("++-+-+++"));
  for (const Point& point : {Point{1, -2, 3}, Point{-1, 2, -3}, Point{0.5, 0.25, -1}})
    EXPECT_NEAR(value_at(x * y + z + abs(z - y * x), point), value_at(2 * max(x * y, z), point),
                1e-15);
}

TEST(Shapiro2007, Property1RFunctionsAreClosedUnderComposition) {
  std::mt19937 generator(4);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::pair<Field, Companion>> made = {{x, [](const Signs& s) { return s[0]; }},
                                                     {y, [](const Signs& s) { return s[1]; }},
                                                     {z, [](const Signs& s) { return s[2]; }}};
    const RSystem systems[] = {RAlpha{}, RAlpha{0.4}, Rp{4}, R1{}};
    for (int step = 0; step < 5; ++step) {
      const auto [f, left] = made[generator() % made.size()];
      const auto [g, right] = made[generator() % made.size()];
      const RSystem& system = systems[generator() % 4];
      const auto add = [&made](Field field, Companion companion) {
        made.emplace_back(std::move(field), std::move(companion));
      };
      switch (generator() % 4) {
        case 0:
          add(conjunction(f, g, system), [left, right](auto& s) { return left(s) && right(s); });
          break;
        case 1:
          add(disjunction(f, g, system), [left, right](auto& s) { return left(s) || right(s); });
          break;
        case 2:
          add(negation(f), [left](auto& s) { return !left(s); });
          break;
        default:
          add(implication(f, g, system), [left, right](auto& s) { return !left(s) || right(s); });
      }
    }
    // x ∧ ¬x is zero for R₁ and x = ±x: only its "not positive" is a theorem.
    const auto& [f, companion] = made.back();
    for (int corner = 0; corner < 8; ++corner) {
      const Signs signs{(corner & 4) != 0, (corner & 2) != 0, (corner & 1) != 0};
      const double value =
          value_at(f, {signs[0] ? 0.7 : -1.3, signs[1] ? 2.0 : -0.4, signs[2] ? 0.11 : -5.0});
      EXPECT_TRUE(companion(signs) ? value >= 0 : value <= 0) << trial << ", " << corner;
    }
  }
}

TEST(Shapiro2007, Property2ContinuousFunctionsWithZerosOnCoordinatePlanesOnlyAreRFunctions) {
  // After eq. (3.2): companions of all are x ⇔ y.
  const Companion equal = [](const Signs& s) { return s[0] == s[1]; };
  expect_companion(x * y, equal);
  expect_companion(x * y * (1 + x * x + y * y), equal);
  expect_companion((1 - pow(2, -x)) * (pow(3, y) - 1), equal);
  expect_companion(sinh(x) * atan(y), equal);
}

TEST(Shapiro2007, Property3ProductsHaveTheEquivalenceAsCompanion) {
  const Field f = conjunction(x, y), g = disjunction(y, z, Rp{4});
  expect_companion(f * g, [](const Signs& s) { return (s[0] && s[1]) == (s[1] || s[2]); });
  expect_companion(f * (1 + x * x * z * z), [](const Signs& s) { return s[0] && s[1]; });
  expect_companion(f * exp(-abs(y * z)), [](const Signs& s) { return s[0] && s[1]; });
}

TEST(Shapiro2007, Property4SumsStayInTheBranch) {
  expect_companion(conjunction(x, y) + conjunction(x, y, R1{}) + conjunction(x, y, Rp{6}),
                   [](const Signs& s) { return s[0] && s[1]; });
  expect_companion(disjunction(x, z) + max(x, z), [](const Signs& s) { return s[0] || s[2]; });
}

TEST(Shapiro2007, Property5ConstantsKeepOrNegateTheBranch) {
  const Field f = conjunction(x, disjunction(y, z));
  expect_companion(3.5 * f, [](const Signs& s) { return s[0] && (s[1] || s[2]); });
  expect_companion(-0.01 * f, [](const Signs& s) { return !(s[0] && (s[1] || s[2])); });
}

TEST(Shapiro2007, Property6IntegralsHaveTheEquivalenceWithTheirVariable) {
  // ∫₀ˣ (s ∧₀ y) ds = x²/2 + xy − (x √(x² + y²) + y² arsinh(x/|y|)) / 2, and its companion is
  // x ⇔ (x ∧ y).
  const Field f = conjunction(x, y);
  const Field integral = 0.5 * x * x + x * y - 0.5 * (x * hypot(x, y) + y * y * asinh(x / abs(y)));
  for (const Point& point : {Point{1, 2}, Point{-0.3, 0.7}, Point{2, -1}, Point{-2, -3}})
    EXPECT_NEAR(value_at(partial(integral, 0), point), value_at(f, point), 4e-15);
  for (const double a : {-3.0, -0.2, 0.2, 3.0})
    for (const double b : {-3.0, -0.2, 0.2, 3.0}) {
      const bool companion = (a > 0) == (a > 0 && b > 0);
      EXPECT_EQ(value_at(integral, {a, b}) > 0, companion) << a << ", " << b;
    }
}

}  // namespace
}  // namespace rfm
