#include "core/r_systems.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/r_functions.hpp"
#include "core/r_system_functions.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

std::vector<RSystem> systems() {
  return {RAlpha{0},
          RAlpha{0.3},
          RAlpha{1},
          R1{},
          Rp{2},
          Rp{6},
          RCm{1},
          RCm{3},
          RAlphaM{0, 2},
          RAlphaM{-0.5, 3},
          RAlphaField{0.5 / (1 + x * x * y * y)}};
}

std::string name_of(const RSystem& system) {
  std::ostringstream text;
  text << system;
  return text.str();
}

ExpressionScope scope() {
  ExpressionScope scope = coordinate_scope(2);
  define_r_functions(scope);
  return scope;
}

TEST(RSystems, FormulasOfEverySystemAreReadBackAsTheSameFunction) {
  for (const RSystem& system : systems()) {
    const auto read = [&](bool is_conjunction) {
      return to_field(Expression(operation_text(system, is_conjunction, "x + 1", "x*y")), scope());
    };
    EXPECT_TRUE(same_expression(read(true), conjunction(x + 1, x * y, system))) << name_of(system);
    // Disjunctions by De Morgan's law or by an operation of their own are the same function.
    const Tape tape({read(false), disjunction(x + 1, x * y, system)}, {0}, 2);
    for (const Point& point : {Point{0.3, -2}, Point{-1.5, 0.7}, Point{-0.4, 2}})
      EXPECT_NEAR(tape.value(point, 0), tape.value(point, 1),
                  1e-15 * (1 + std::fabs(tape.value(point, 1))))
          << name_of(system);
  }
}

// The largest k for which ∂/∂x (x ∧ y) = 1 and the derivatives of order 2 … k vanish on x = 0, y
// = 1.
int measured_normalization(const RSystem& system, int highest) {
  const std::vector<double> jet = Tape({conjunction(x, y, system)}, {highest}, 2).jet({0, 2});
  if (std::fabs(jet[jet_index(2, {1, 0})] - 1) > 1e-12) return 0;
  for (std::uint8_t k = 2; k <= highest; ++k)
    if (std::fabs(jet[jet_index(2, {k, 0})]) > 1e-12) return k - 1;
  return highest;
}

TEST(RSystems, PromiseTheNormalizationThatTheyKeepAndNoMore) {
  constexpr int highest = 7;
  for (const RSystem& system : systems())
    EXPECT_EQ(std::min(normalization_order(system), highest),
              measured_normalization(system, highest))
        << name_of(system);
}

TEST(RSystems, AreCalledByTheirParameters) {
  EXPECT_EQ(name_of(RAlpha{0.5}), "R-alpha, alpha = 0.5");
  EXPECT_EQ(name_of(RAlphaM{0, 2}), "R-alpha-m, alpha = 0, m = 2");
  EXPECT_EQ(name_of(UserSystem{"quartic", {}}), "system quartic");
  EXPECT_EQ(smoothness_text(R1{}), smoothness_text(RAlpha{1}));
  EXPECT_EQ(smoothness_text(RCm{3}), "2 times differentiable");
  EXPECT_EQ(operation_text(UserSystem{"quartic", {}}, false, "a", "b"), "quartic_or(a, b)");
}

std::string mistake(const std::string& text) {
  try {
    to_field(Expression(text), scope());
  } catch (const InputError& error) {
    return std::to_string(error.offset) + ": " + error.what();
  }
  return "none";
}

TEST(RSystemFunctions, RefuseParametersOutOfRangeAtTheirPlace) {
  EXPECT_EQ(mistake("r0m_and(x, y, 0)"), "14: the order m must be a whole number from 1 to 16");
  EXPECT_EQ(mistake("rcm_or(x, y, x)"), "13: the order m must be a whole number from 1 to 16");
  EXPECT_THAT(mistake("ralpham_and(x, y, -1, 2)"), testing::StartsWith("18: alpha must be "));
  EXPECT_THAT(mistake("ralpha_field_and(x, y, 2)"), testing::StartsWith("23: alpha must be "));
  EXPECT_EQ(mistake("rcm_and(x, y)"), "0: rcm_and takes 3 arguments, got 2");
}

}  // namespace
}  // namespace rfm
