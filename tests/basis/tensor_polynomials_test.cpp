#include "basis/tensor_polynomials.hpp"

#include <gmock/gmock.h>
#include <array>
#include <random>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

using Kind = PolynomialFamily::Kind;
const Box interval{1, {-1}, {1}};
const Box oblong{2, {-0.5, 1}, {2, 1.8}};

std::vector<double> line(Kind kind, int degree, double xi, int order) {
  const TensorPolynomials space(interval, {kind, degree, true});
  std::vector<double> values(std::size_t(order + 1) * space.line_size());
  space.evaluate_line(xi, order, values.data());
  return values;
}

TEST(TensorPolynomials, OfLegendreAreTheKnownOnes) {
  const double x = 0.37;
  const std::vector<double> p = line(Kind::legendre, 4, x, 2);
  EXPECT_DOUBLE_EQ(p[3], (5 * x * x * x - 3 * x) / 2);
  EXPECT_NEAR(p[4], (35 * std::pow(x, 4) - 30 * x * x + 3) / 8, 1e-15);
  EXPECT_DOUBLE_EQ(p[5 + 3], (15 * x * x - 3) / 2);
  EXPECT_NEAR(p[10 + 4], (420 * x * x - 60) / 8, 1e-13);
}

TEST(TensorPolynomials, OfChebyshevAreCosinesOfMultipleAngles) {
  const double angle = 1.1, x = std::cos(angle);
  const std::vector<double> t = line(Kind::chebyshev, 20, x, 1);
  for (int n = 0; n <= 20; ++n) {
    EXPECT_NEAR(t[n], std::cos(n * angle), 1e-13);
    EXPECT_NEAR(t[21 + n], n * std::sin(n * angle) / std::sin(angle), 1e-11);
  }
}

class EveryFamily : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(TensorPolynomials, EveryFamily,
                         testing::Values(Kind::legendre, Kind::chebyshev, Kind::power,
                                         Kind::trigonometric));

TEST_P(EveryFamily, HasDerivativesThatAreTheSlopesOfItsValues) {
  constexpr double step = 1e-4;
  const int order = 3;
  for (const double xi : {-0.9, 0.2, 0.75}) {
    const std::vector<double> middle = line(GetParam(), 5, xi, order);
    const std::vector<double> before = line(GetParam(), 5, xi - step, order);
    const std::vector<double> after = line(GetParam(), 5, xi + step, order);
    const std::size_t count = middle.size() / (order + 1);
    for (std::size_t i = 0; i < count * order; ++i)
      EXPECT_NEAR(middle[i + count], (after[i] - before[i]) / (2 * step),
                  1e-5 * (1 + std::abs(middle[i + count])))
          << i;
  }
}

TEST_P(EveryFamily, IsScaledToItsBoxAlongEveryAxis) {
  // ∂x∂y of f(ξ) g(η) is f' g' / (half widths): against the families on the reference interval.
  const TensorPolynomials space(oblong, {GetParam(), 3, false});
  const double x = 0.4, y = 1.7;
  std::vector<double> values(space.size());
  space.evaluate({&x, &y, nullptr}, 1, {1, 1}, values.data());
  const std::vector<double> f = line(GetParam(), 3, (x + 0.5) / 1.25 - 1, 1);
  const std::vector<double> g = line(GetParam(), 3, (y - 1) / 0.4 - 1, 1);
  const int count = static_cast<int>(f.size() / 2);
  ASSERT_EQ(space.size(), count * count);
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i)
      EXPECT_NEAR(values[i + j * count], f[count + i] * g[count + j] / (1.25 * 0.4), 1e-11);
}

TEST(TensorPolynomials, AreAsManyAsTheirDegreeSays) {
  const Box cube{3, {0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(TensorPolynomials(oblong, {Kind::legendre, 16, true}).size(), 153);
  EXPECT_EQ(TensorPolynomials(oblong, {Kind::legendre, 16, false}).size(), 289);
  EXPECT_EQ(TensorPolynomials(cube, {Kind::power, 4, true}).size(), 35);
  EXPECT_EQ(TensorPolynomials(interval, {Kind::trigonometric, 4, true}).size(), 9);
  EXPECT_EQ(TensorPolynomials(oblong, {Kind::trigonometric, 1, true}).size(), 5);
}

TEST(TensorPolynomials, NeedADegreeAndABox) {
  EXPECT_THROW(TensorPolynomials(oblong, {Kind::power, -1, true}), InvalidArgument);
  EXPECT_THROW(TensorPolynomials({1, {2}, {2}}, {Kind::power, 1, true}), InvalidArgument);
}

// Values and slopes of random combinations at random points of random boxes.
TEST(TensorPolynomials, BoundsHoldAndAreOfSecondOrder) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::array<MultiIndex, 4> derivatives{MultiIndex{}, unit_index(0), unit_index(1),
                                              unit_index(2)};
  for (const auto kind : {PolynomialFamily::Kind::legendre, PolynomialFamily::Kind::chebyshev,
                          PolynomialFamily::Kind::power})
    for (const int dimension : {1, 2, 3}) {
      const Box whole{dimension, {-1, 0, 2}, {2, 1, 5}};
      const TensorPolynomials space(whole, {kind, dimension == 3 ? 5 : 9, dimension != 2});
      std::vector<double> coefficients(static_cast<std::size_t>(space.size()));
      for (double& c : coefficients) c = uniform(generator);
      double width = 0;
      for (const double side : {0.3, 0.03, 0.003}) {
        double largest = 0;
        for (int repetition = 0; repetition < 20; ++repetition) {
          Box box{dimension, {}, {}};
          for (int axis = 0; axis < dimension; ++axis) {
            const double t = 0.5 * (1 - side) * (1 + uniform(generator));
            box.low[axis] = whole.low[axis] + t * whole.length(axis);
            box.high[axis] = box.low[axis] + side * whole.length(axis);
          }
          const FunctionBounds bounds = space.bounds(coefficients, box);
          EXPECT_TRUE(bounds.smooth);
          double least = INFINITY, most = -INFINITY;
          for (int sample = 0; sample < 40; ++sample) {
            Point at{};
            for (int axis = 0; axis < dimension; ++axis) {
              const double t = sample < 8 ? (sample >> axis & 1) : 0.5 * (1 + uniform(generator));
              at[axis] = box.low[axis] + t * (box.high[axis] - box.low[axis]);
            }
            const std::array<const double*, 3> coordinates{&at[0], &at[1], &at[2]};
            std::vector<double> values(coefficients.size());
            for (int part = 0; part <= dimension; ++part) {
              space.evaluate(coordinates, 1, derivatives[part], values.data());
              double sum = 0;
              for (std::size_t f = 0; f < values.size(); ++f) sum += coefficients[f] * values[f];
              EXPECT_TRUE((part == 0 ? bounds.value : bounds.gradient[part - 1]).contains(sum));
              if (part == 0) least = std::min(least, sum), most = std::max(most, sum);
            }
          }
          // Beyond what corners and samples show.
          largest = std::max(largest, bounds.value.width() - (most - least));
        }
        if (width > 0) {
          EXPECT_LT(largest, 0.05 * width + 1e-9);
        }
        width = largest;
      }
    }
}

TEST(TensorPolynomials, TellNothingOfSinesAndCosines) {
  const TensorPolynomials space({1, {0}, {1}}, {PolynomialFamily::Kind::trigonometric, 2});
  EXPECT_FALSE(space.bounds(std::vector<double>(5, 1.0), {1, {0}, {1}}).smooth);
  EXPECT_THROW(TensorPolynomials({1, {0}, {1}}, {}).bounds({}, {1, {0}, {1}}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
