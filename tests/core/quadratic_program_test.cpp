#include "core/quadratic_program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rfm {
namespace {

using Vector = QuadraticModel::Vector<double>;
using Matrix = QuadraticModel::Matrix<double>;

const ShiftedCholesky unit({{{1}, {0, 1}, {0, 0, 1}}}, 3);

TEST(QuadraticProgram, WithoutConditionsIsNewtonsStep) {
  const QuadraticMinimum minimum =
      constrained_minimum(ShiftedCholesky({{{4}, {1, 2}}}, 2), {3, 2}, 2, {});
  EXPECT_NEAR(minimum.step[0], -4.0 / 7, 1e-15);
  EXPECT_NEAR(minimum.step[1], -5.0 / 7, 1e-15);
}

TEST(QuadraticProgram, GoesToTheNearestPointOfACorner) {
  // The point of {x ≥ 1, y ≥ 2, z ≥ −1} nearest to 0: two conditions bind, by their depth.
  const std::vector<LinearCondition> corner{{{1}, -1}, {{0, 1}, -2}, {{0, 0, 1}, 1}};
  const QuadraticMinimum minimum = constrained_minimum(unit, {}, 3, corner);
  EXPECT_NEAR(minimum.step[0], 1, 1e-15);
  EXPECT_NEAR(minimum.step[1], 2, 1e-15);
  EXPECT_NEAR(minimum.step[2], 0, 1e-15);
  EXPECT_NEAR(minimum.multipliers[0], 1, 1e-15);
  EXPECT_NEAR(minimum.multipliers[1], 2, 1e-15);
  EXPECT_EQ(minimum.multipliers[2], 0);
}

TEST(QuadraticProgram, LeavesAConditionThatAnotherMakesNeedless) {
  // x ≥ 1 binds at first; where x + y ≥ 4 holds with x ≥ 1 it does not.
  const std::vector<LinearCondition> two{{{1}, -1}, {{1, 1}, -4}};
  const QuadraticMinimum minimum = constrained_minimum(unit, {}, 3, two);
  EXPECT_NEAR(minimum.step[0], 2, 1e-15);
  EXPECT_NEAR(minimum.step[1], 2, 1e-15);
  EXPECT_EQ(minimum.multipliers[0], 0);
  EXPECT_NEAR(minimum.multipliers[1], 2, 1e-15);
}

// What characterises the minimum: no force is left, multipliers push only, and only where they
// bind.
TEST(QuadraticProgram, HasTheMultipliersOfItsMinimum) {
  std::mt19937 generator(3);
  const auto uniform = [&] { return -1 + 2 * 0x1p-32 * generator(); };
  int binding = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 2 + trial % 5, count = trial % 7;
    Matrix root{}, matrix{};
    Vector gradient{};
    for (int i = 0; i < n; ++i) {
      gradient[i] = uniform();
      for (int j = 0; j < n; ++j) root[i][j] = uniform();
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        matrix[i][j] = i == j ? 0.1 : 0;
        for (int k = 0; k < n; ++k) matrix[i][j] += root[i][k] * root[j][k];
      }
    Vector feasible{};
    for (int i = 0; i < n; ++i) feasible[i] = 3 * uniform();
    std::vector<LinearCondition> conditions(count);
    for (LinearCondition& condition : conditions) {
      condition.value = std::fabs(uniform());
      for (int i = 0; i < n; ++i) {
        condition.slope[i] = uniform();
        condition.value -= condition.slope[i] * feasible[i];
      }
    }
    const QuadraticMinimum minimum =
        constrained_minimum(ShiftedCholesky(matrix, n), gradient, n, conditions);
    double size = 1;
    for (const double multiplier : minimum.multipliers) size = std::max(size, multiplier);
    for (int i = 0; i < n; ++i) {
      double force = gradient[i];
      for (int j = 0; j < n; ++j) force += matrix[i][j] * minimum.step[j];
      for (int k = 0; k < count; ++k) force -= minimum.multipliers[k] * conditions[k].slope[i];
      EXPECT_NEAR(force, 0, 1e-10 * size);
    }
    for (int k = 0; k < count; ++k) {
      double value = conditions[k].value;
      for (int i = 0; i < n; ++i) value += conditions[k].slope[i] * minimum.step[i];
      EXPECT_GE(minimum.multipliers[k], 0);
      EXPECT_GE(value, -1e-9 * size) << trial;
      if (minimum.multipliers[k] > 0) {
        EXPECT_NEAR(value, 0, 1e-9 * size) << trial;
        ++binding;
      }
    }
  }
  EXPECT_GT(binding, 100);
}

}  // namespace
}  // namespace rfm
