#include "core/table.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

template <class Function>
Field tabulated(const std::vector<double>& abscissae, const Function& f,
                const Field& argument = x) {
  std::vector<double> values;
  for (const double abscissa : abscissae) values.push_back(f(abscissa));
  return table(abscissae, values, argument);
}

const std::vector<double> uneven = {-1, -0.8, -0.1, 0.2, 0.9, 1.0, 1.7, 2};

TEST(Table, GoesThroughItsPoints) {
  const Field f = tabulated(uneven, [](double s) { return std::sin(9 * s); });
  for (const double abscissa : uneven)
    EXPECT_NEAR(value_at(f, {abscissa, 0}), std::sin(9 * abscissa), 1e-15);
}

TEST(Table, ReproducesCubicPolynomialsWithAllTheirDerivatives) {
  const Field f = tabulated(uneven, [](double s) { return 2 - s + s * s * (3 - 0.5 * s); });
  const Field exact = 2 - x + x * x * (3 - 0.5 * x);
  for (const double at : {-1.0, -0.95, -0.3, 0.0, 0.55, 1.9, 2.0}) {
    const PointJet found = evaluate(f, {at, 0}, 3, 2), expected = evaluate(exact, {at, 0}, 3, 2);
    for (int k = 0; k <= 3; ++k)
      EXPECT_NEAR(found.derivative(k), expected.derivative(k), 4e-12) << k << " at " << at;
    EXPECT_EQ(found.derivative(0, 1), 0);
  }
}

TEST(Table, OfTwoPointsIsTheLineAndOfThreeTheParabola) {
  const Field line = table({1, 3}, {5, 9}, x), parabola = table({0, 1, 3}, {0, 1, 9}, x);
  EXPECT_DOUBLE_EQ(value_at(line, {2.5, 0}), 8);
  EXPECT_NEAR(value_at(parabola, {2.2, 0}), 2.2 * 2.2, 2e-15);
}

TEST(Table, IsTwiceContinuouslyDifferentiable) {
  const Field f = tabulated(uneven, [](double s) { return std::exp(-s * s); });
  for (std::size_t i = 1; i + 1 < uneven.size(); ++i) {
    const PointJet left = evaluate(f, {uneven[i] - 1e-12, 0}, 2, 1);
    const PointJet right = evaluate(f, {uneven[i], 0}, 2, 1);
    for (int k = 0; k <= 2; ++k) EXPECT_NEAR(left.derivative(k), right.derivative(k), 1e-9) << k;
  }
}

TEST(Table, IsOfFourthOrderUpToTheEnds) {
  const auto error = [](int intervals) {
    std::vector<double> abscissae;
    for (int i = 0; i <= intervals; ++i) abscissae.push_back(2.0 * i / intervals);
    const Field f = tabulated(abscissae, [](double s) { return std::exp(s); });
    double largest = 0;
    for (double s = 0; s <= 2; s += 0.01)
      largest = std::max(largest, std::fabs(value_at(f, {s, 0}) - std::exp(s)));
    return largest;
  };
  const double order = std::log2(error(16) / error(32));
  EXPECT_GT(order, 3.7);
  EXPECT_LT(order, 4.3);
  EXPECT_LT(error(32), 4e-6);
}

TEST(Table, IsAFunctionOfItsOwnCoordinate) {
  const Field f = tabulated(
      uneven, [](double s) { return s * s; }, y);
  const PointJet jet = evaluate(f, {99, 0.5}, 2, 2);
  EXPECT_NEAR(jet.value(), 0.25, 1e-15);
  EXPECT_NEAR(jet.derivative(0, 1), 1, 1e-14);
  EXPECT_NEAR(jet.derivative(0, 2), 2, 1e-13);
  EXPECT_EQ(jet.derivative(1, 0), 0);
}

TEST(Table, OfAnyArgumentIsComposedExactly) {
  const Field inner = sin(x * y) + 0.5 * x;
  const Field f = tabulated(
      uneven, [](double s) { return s * s * (1 - s); }, inner);
  const Field exact = inner * inner * (1 - inner);
  for (const Point& point : {Point{0.3, 0.7}, Point{-0.4, 0.2}}) {
    const PointJet found = evaluate(f, point, 2, 2), expected = evaluate(exact, point, 2, 2);
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; i + j <= 2; ++j)
        EXPECT_NEAR(found.derivative(i, j), expected.derivative(i, j), 1e-12) << i << j;
  }
  EXPECT_NEAR(value_at(tabulated(
                           uneven, [](double s) { return s; }, time_coordinate()),
                       {}, 0.4),
              0.4, 1e-15);
  EXPECT_TRUE(std::isnan(value_at(f, {9, 0})));
}

TEST(Table, OutsideItIsNotANumberAndSaysSo) {
  const Field f = tabulated(uneven, [](double s) { return s; });
  EXPECT_TRUE(std::isnan(value_at(f, {2.1, 0})));
  EXPECT_TRUE(std::isnan(evaluate(f, {-1.1, 0}, 1, 1).derivative(1)));
  EXPECT_NEAR(value_at(f, {2 + 1e-10, 0}), 2, 1e-9);
  EXPECT_EQ(diagnose(1 + f, {2.1, 0}, 2), "a sampled field outside its region [-1, 2]");
}

TEST(Table, StaysWithinItsBounds) {
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(-1, 2);
  std::vector<double> values;
  for (std::size_t i = 0; i < uneven.size(); ++i) values.push_back(uniform(generator));
  const Table f(uneven, values);
  for (int trial = 0; trial < 200; ++trial) {
    const double a = uniform(generator), b = a + std::pow(0.5, trial % 8) * (2 - a);
    const FunctionBounds bounds = f.bounds({1, {a}, {b}});
    EXPECT_TRUE(bounds.smooth);
    double least = INFINITY, most = -INFINITY;
    for (int i = 0; i <= 200; ++i) {
      const auto terms = f.taylor(a + i / 200.0 * (b - a));
      least = std::min(least, terms[0]);
      most = std::max(most, terms[0]);
      EXPECT_TRUE(bounds.value.contains(terms[0]));
      EXPECT_TRUE(bounds.gradient[0].contains(terms[1]));
    }
    // The range itself, which 200 samples miss by the square of their distance.
    EXPECT_LT(bounds.value.width() - (most - least), 0.02 * (b - a) * (b - a) + 1e-12);
  }
  EXPECT_FALSE(f.bounds({1, {1.5}, {2.5}}).smooth);
  EXPECT_EQ(f.bounds({1, {1.5}, {2.5}}).value.high, INFINITY);
}

TEST(Table, StaysWithinItsBoundsWhateverTheSizeOfItsValues) {
  for (const double size : {1e-310, 1e-170, 1.0, 1e160, 1e300}) {
    const Table f({0, 1, 2}, {0, 3 * size, 2 * size});
    const Interval bounds = f.bounds({1, {1}, {1.5}}).value;
    for (int i = 0; i <= 100; ++i) EXPECT_TRUE(bounds.contains(f.taylor(1 + 0.005 * i)[0])) << size;
    EXPECT_LT(bounds.high, 3.2 * size);
  }
  EXPECT_THROW(Table({-1, 0, 1}, {-1e308, 1e308, -1e308}), InvalidArgument);
}

TEST(Table, BreaksWhereItsThirdDerivativeJumps) {
  const Table f(uneven, {0, 1, 0, 1, 0, 1, 0, 1});
  EXPECT_THAT(f.breakpoints(0), testing::ElementsAre(-0.1, 0.2, 0.9, 1.0));
  EXPECT_TRUE(f.breakpoints(1).empty());
  const auto jump = [&](double at) { return f.taylor(at)[3] - f.taylor(at - 1e-9)[3]; };
  EXPECT_NEAR(jump(-0.8), 0, 1e-9);
  EXPECT_NEAR(jump(1.7), 0, 1e-9);
  EXPECT_GT(std::fabs(jump(0.2)), 1);
}

TEST(Table, WrongPointsAreRefused) {
  EXPECT_THROW(Table({1}, {1}), InvalidArgument);
  EXPECT_THROW(Table({1, 2}, {1}), InvalidArgument);
  EXPECT_THROW(Table({1, 1}, {1, 2}), InvalidArgument);
  EXPECT_THROW(Table({2, 1}, {1, 2}), InvalidArgument);
  EXPECT_THROW(Table({1, NAN}, {1, 2}), InvalidArgument);
  EXPECT_THROW(Table({1, 2}, {1, INFINITY}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
