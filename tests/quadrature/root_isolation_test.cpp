#include "quadrature/root_isolation.hpp"

#include <gmock/gmock.h>

#include <vector>

using namespace rfm;

namespace {

// Roots of the polynomial with the given ascending coefficients on [low, high].
std::vector<double> roots_of(const std::vector<double>& coefficients, double low, double high,
                             IsolationBudget* spent = nullptr) {
  const auto function = [&](double t, double& slope) {
    double value = 0;
    slope = 0;
    for (int i = static_cast<int>(coefficients.size()) - 1; i >= 0; --i) {
      slope = slope * t + value;
      value = value * t + coefficients[i];
    }
    return value;
  };
  const auto slopes = [&](double from, double to) {
    Interval sum(0);
    for (int i = static_cast<int>(coefficients.size()) - 1; i > 0; --i)
      sum = sum * Interval(from, to) + Interval(i * coefficients[i]);
    return sum;
  };
  std::vector<double> roots;
  IsolationBudget budget;
  isolate_roots(
      function, slopes, low, high, 1e-13, [&](double t) { roots.push_back(t); }, budget);
  if (spent) *spent = budget;
  return roots;
}

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(RootIsolation, FindsEveryRootOfACubic) {
  // (t + 1)(t − 0.1)(t − 2)
  EXPECT_THAT(roots_of({0.2, -1.9, -1.1, 1}, -3, 3),
              ElementsAre(DoubleNear(-1, 4e-16), DoubleNear(0.1, 4e-16), DoubleNear(2, 8e-16)));
}

TEST(RootIsolation, FindsNoRootWhereThereIsNone) {
  IsolationBudget budget;
  EXPECT_THAT(roots_of({1e-6, 0, 1}, -1, 1, &budget), IsEmpty());
  EXPECT_FALSE(budget.exhausted);
}

TEST(RootIsolation, ReportsATangentialContactOnce) {
  // (t − 0.3)²: the contact is as wide as the root of the tolerance.
  IsolationBudget budget;
  EXPECT_THAT(roots_of({0.09, -0.6, 1}, -1, 1, &budget), ElementsAre(DoubleNear(0.3, 4e-7)));
  EXPECT_FALSE(budget.exhausted);
  EXPECT_GT(budget.calls, 200);
}

TEST(RootIsolation, SeparatesRootsCloseTogether) {
  // (t − 0.3)² − 1e-10
  EXPECT_THAT(roots_of({0.09 - 1e-10, -0.6, 1}, -1, 1),
              ElementsAre(DoubleNear(0.3 - 1e-5, 1e-11), DoubleNear(0.3 + 1e-5, 1e-11)));
}

TEST(RootIsolation, ReportsNothingForAFunctionThatVanishes) {
  IsolationBudget budget;
  EXPECT_THAT(roots_of({0, 0}, -1, 1, &budget), IsEmpty());
  EXPECT_FALSE(budget.exhausted);
}

TEST(RootIsolation, AZeroAtTheLowEndBelongsToThePositiveSide) {
  // sign(0) = +: t changes sign on [0, 1] only if it is negative beyond 0.
  EXPECT_THAT(roots_of({0, 1}, 0, 1), IsEmpty());
  EXPECT_THAT(roots_of({0, -1}, 0, 1), ElementsAre(0.0));
}

TEST(RootIsolation, SaysWhenItGivesUp) {
  // Slope bounds that say nothing, and a function that oscillates about zero.
  const auto function = [](double t, double& slope) {
    slope = 1e6 * std::cos(1e6 * t);
    return std::sin(1e6 * t);
  };
  const auto slopes = [](double, double) { return Interval(-1e6, 1e6); };
  IsolationBudget budget;
  int found = 0;
  isolate_roots(
      function, slopes, 0.0, 1.0, 1e-13, [&](double) { ++found; }, budget);
  EXPECT_TRUE(budget.exhausted);
  EXPECT_LE(found, 600);
}

TEST(BracketedRoot, ConvergesFromABadStart) {
  const auto function = [](double t, double& slope) {
    slope = 1 / (1 + t * t);
    return std::atan(t);
  };
  EXPECT_NEAR(bracketed_root(function, -1.0, 1000.0, std::atan(-1.0), std::atan(1000.0)), 0, 1e-12);
}

TEST(BracketedRoot, BisectsWhereTheSlopeIsUseless) {
  const auto function = [](double t, double& slope) {
    slope = std::nan("");
    return std::cbrt(t - 0.7);
  };
  EXPECT_NEAR(bracketed_root(function, 0.0, 1.0, -1.0, 1.0), 0.7, 1e-15);
}

}  // namespace
