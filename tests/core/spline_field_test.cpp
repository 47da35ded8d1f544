#include "core/spline_field.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <random>

#include "core/bspline.hpp"
#include "core/error.hpp"
#include "core/multi_index.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

double binomial(int n, int k) {
  double product = 1;
  for (int i = 1; i <= k; ++i) product = product * (n - k + i) / i;
  return product;
}

// Coefficients of x^power along one axis (Marsden): the symmetric polynomial of degree `power` in
// the interior knots of each spline, over binomial(p, power).
std::vector<double> monomial_coefficients(const Grid& grid, int axis, int degree, int power) {
  std::vector<double> result;
  for (int j = 0; j < grid.cells(axis) + degree; ++j) {
    std::vector<double> symmetric(degree + 1, 0.0);
    symmetric[0] = 1;
    for (int n = 1; n <= degree; ++n)
      for (int m = n; m >= 1; --m)
        symmetric[m] += grid.knot(axis, j - degree + n) * symmetric[m - 1];
    result.push_back(symmetric[power] / binomial(degree, power));
  }
  return result;
}

SplineField monomial(const Grid& grid, int degree, const MultiIndex& power) {
  std::vector<double> coefficients{1};
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    std::vector<double> product;
    for (const double outer : monomial_coefficients(grid, axis, degree, power[axis]))
      for (const double inner : coefficients) product.push_back(outer * inner);
    coefficients = product;
  }
  return SplineField(grid, degree, coefficients);
}

SplineField random_spline(const Grid& grid, int degree) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> coefficients(SplineField::coefficient_count(grid, degree));
  for (double& coefficient : coefficients) coefficient = uniform(generator);
  return SplineField(grid, degree, coefficients);
}

std::vector<double> jet_at(const SplineField& spline, const Point& point, int variables,
                           int order) {
  std::vector<double> jet(jet_size(variables, order), INFINITY);  // all is to be written
  spline.evaluate({&point[0], &point[1], &point[2]}, 1, variables, order, jet.data(), 1);
  return jet;
}

const Grid oblong({3, {-0.3, 0.1, 0.4}, {0.9, 0.7, 1.3}}, {5, 3, 4});
const Grid rectangle({2, {-0.3, 0.1}, {0.9, 0.7}}, {5, 3, 1});
const Grid interval({1, {-0.3}, {0.9}}, {5, 1, 1});

// The same boxes with cells that differ by a factor of 20.
Grid unequal(int dimension) {
  const std::vector<double> lines[] = {
      {-0.3, -0.1, 0.3, 0.32, 0.38, 0.9}, {0.1, 0.45, 0.47, 0.7}, {0.4, 0.5, 0.7, 1.2, 1.3}};
  return Grid::with_lines(std::span(lines, static_cast<std::size_t>(dimension)));
}

class Splines : public testing::TestWithParam<std::tuple<int, int, bool>> {
 protected:
  int dimension() const { return std::get<0>(GetParam()); }
  int degree() const { return std::get<1>(GetParam()); }
  Grid grid() const {
    if (!std::get<2>(GetParam())) return unequal(dimension());
    return dimension() == 1 ? interval : dimension() == 2 ? rectangle : oblong;
  }
};
INSTANTIATE_TEST_SUITE_P(SplineField, Splines,
                         testing::Combine(testing::Values(1, 2, 3), testing::Values(1, 2, 3, 5, 8),
                                          testing::Bool()));

TEST_P(Splines, WithMarsdensCoefficientsAreMonomialsInAllTheirDerivatives) {
  const int dimension = this->dimension(), degree = this->degree();
  const Grid grid = this->grid();
  const int order = std::min(4, degree);
  MultiIndex power{};
  for (int axis = 0; axis < dimension; ++axis)
    power[axis] = static_cast<std::uint8_t>(std::max(0, degree - axis));
  const SplineField spline = monomial(grid, degree, power);
  for (const Point& point :
       {Point{-0.3, 0.1, 0.4}, Point{0.05, 0.51, 0.73}, Point{0.9, 0.7, 1.3}}) {
    const std::vector<double> jet = jet_at(spline, point, dimension, order);
    for (int i = 0; i <= order; ++i)
      for (int j = 0; j <= (dimension > 1 ? order - i : 0); ++j)
        for (int k = 0; k <= (dimension > 2 ? order - i - j : 0); ++k) {
          const MultiIndex alpha{std::uint8_t(i), std::uint8_t(j), std::uint8_t(k)};
          double expected = 1, scale = 1;
          for (int axis = 0; axis < dimension; ++axis) {
            const int n = power[axis], m = alpha[axis];
            expected *= m > n ? 0 : binomial(n, m) * std::pow(point[axis], n - m);
            scale *= std::pow(4 / grid.smallest_width(axis), m);
          }
          EXPECT_NEAR(jet[jet_index(dimension, alpha)], expected, 1e-15 * scale * 16)
              << i << j << k;
        }
  }
}

TEST(SplineField, HasJetsOfEveryOrderInWhichDerivativesAboveTheDegreeAreZero) {
  for (const int degree : {0, 2, 8}) {
    // (x + ½)^p (y + ½)^p by its monomials would have to be summed; x^p y^p has all the orders.
    const auto p = static_cast<std::uint8_t>(degree);
    const SplineField spline = monomial(rectangle, degree, {p, p});
    const Point point{0.3, 0.4};
    for (const int order : {8, 9, 16}) {
      const std::vector<double> jet = jet_at(spline, point, 2, order);
      for (int i = 0; i <= order; ++i)
        for (int j = 0; j <= order - i; ++j) {
          const double found = jet[jet_index(2, {std::uint8_t(i), std::uint8_t(j)})];
          if (i > p || j > p) {
            EXPECT_EQ(found, 0) << i << " " << j;
            continue;
          }
          const double expected = binomial(p, i) * std::pow(0.3, p - i) *  //
                                  binomial(p, j) * std::pow(0.4, p - j);
          const double scale =
              std::pow(4 / rectangle.spacing(0), i) * std::pow(4 / rectangle.spacing(1), j);
          EXPECT_NEAR(found, expected, 2e-14 * scale) << degree << " " << i << " " << j;
        }
    }
    EXPECT_THROW(jet_at(spline, point, 2, 17), InvalidArgument);
  }
  const Field cubic = field(std::make_shared<SplineField>(monomial(rectangle, 3, {3, 3})));
  EXPECT_EQ(Tape({cubic}, {12}, 2).jet({0.3, 0.4})[jet_index(2, {4, 5})], 0);
  for (const double coefficient : jet_at(random_spline(rectangle, 2), {2, 2}, 2, 12))
    EXPECT_TRUE(std::isnan(coefficient));
}

TEST(SplineField, DerivativesAlongAxesBeyondItsDimensionAreZero) {
  const SplineField plane = random_spline(rectangle, 3);
  const Point point{0.2, 0.4, 99};
  const std::vector<double> jet = jet_at(plane, point, 3, 2), own = jet_at(plane, point, 2, 2);
  EXPECT_EQ(jet[jet_index(3, {1, 1})], own[jet_index(2, {1, 1})]);
  for (const MultiIndex& alpha : {MultiIndex{0, 0, 1}, MultiIndex{1, 0, 1}, MultiIndex{0, 0, 2}})
    EXPECT_EQ(jet[jet_index(3, alpha)], 0);
}

TEST(SplineField, DoesNotExtrapolate) {
  const SplineField spline = random_spline(rectangle, 2);
  EXPECT_TRUE(std::isfinite(jet_at(spline, {0.9 + 1e-10, 0.1 - 1e-11}, 2, 1)[2]));
  for (const Point& point : {Point{0.9 + 1e-8, 0.3}, Point{0.1, 0.09}, Point{NAN, 0.3}})
    for (const double coefficient : jet_at(spline, point, 2, 1))
      EXPECT_TRUE(std::isnan(coefficient));
}

TEST_P(Splines, StayWithinTheirBounds) {
  const int dimension = this->dimension(), degree = this->degree();
  const Grid grid = this->grid();
  const SplineField spline = random_spline(grid, degree);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int box_number = 0; box_number < 60; ++box_number) {
    Box box;
    box.dimension = dimension;
    const double size = std::pow(0.5, box_number % 6);
    for (int axis = 0; axis < dimension; ++axis) {
      const double length = size * grid.box().length(axis);
      box.low[axis] =
          grid.box().low[axis] + uniform(generator) * (grid.box().length(axis) - length);
      box.high[axis] = box.low[axis] + length;
    }
    const FunctionBounds bounds = spline.bounds(box);
    for (int sample = 0; sample < 20; ++sample) {
      Point point{};
      for (int axis = 0; axis < dimension; ++axis)
        point[axis] = box.low[axis] + uniform(generator) * box.length(axis);
      const std::vector<double> jet = jet_at(spline, point, dimension, 1);
      EXPECT_TRUE(bounds.value.contains(jet[0]));
      for (int axis = 0; axis < dimension; ++axis)
        EXPECT_TRUE(bounds.gradient[axis].contains(jet[1 + axis])) << axis;
    }
  }
}

TEST(SplineField, BoundsAreSharpToSecondOrderInTheSizeOfTheBox) {
  // x² on a box of half width r about 0.5: range [(0.5−r)², (0.5+r)²], Bernstein coefficients
  // add r² below the lower end at most.
  const SplineField spline = monomial(rectangle, 2, {2, 0});
  for (const double r : {1e-2, 1e-4, 1e-6}) {
    const Box box{2, {0.5 - r, 0.4}, {0.5 + r, 0.4 + r}};
    const FunctionBounds bounds = spline.bounds(box);
    EXPECT_LE(bounds.value.width(), 2 * r + 2 * r * r + 1e-13);
    EXPECT_GE(bounds.value.width(), 2 * r);
    EXPECT_NEAR(bounds.gradient[0].low, 1 - 2 * r, 1e-13);
    EXPECT_NEAR(bounds.gradient[0].high, 1 + 2 * r, 1e-13);
  }
}

TEST(SplineField, BoundsExceedTheRangeByTheSquareOfTheBox) {
  // x² about its minimum has the range [0, r²] and the Bernstein coefficients
  // r² ((2k − p)² − p) / (p (p − 1)), k = 0 … p: the excess is of second order exactly.
  const Grid grid({1, {-1}, {1}}, {1, 1, 1});
  for (const int p : {2, 3, 4, 5})
    for (const double r : {0.5, 0.25, 0x1p-6}) {
      double least = 0;
      for (int k = 0; k <= p; ++k)
        least = std::min(least, r * r * ((2.0 * k - p) * (2.0 * k - p) - p) / (p * (p - 1.0)));
      const FunctionBounds bounds = monomial(grid, p, {2}).bounds({1, {-r}, {r}});
      EXPECT_NEAR(bounds.value.low, least, 1e-12) << p;
      EXPECT_NEAR(bounds.value.high, r * r, 1e-12) << p;
      EXPECT_LT(least, -0.05 * r * r);
    }
}

TEST(SplineField, BoundsOutsideTheGridAreUnbounded) {
  const SplineField spline = random_spline(rectangle, 2);
  const FunctionBounds bounds = spline.bounds({2, {0.8, 0.2}, {0.91, 0.3}});
  EXPECT_EQ(bounds.value.width(), INFINITY);
  EXPECT_FALSE(bounds.smooth);
}

TEST(SplineField, IsSmoothWithinACellAndFromDegreeTwoOnEverywhere) {
  const Box across{2, {-0.1, 0.2}, {0.0, 0.25}}, within{2, {-0.05, 0.2}, {0.0, 0.25}};
  EXPECT_TRUE(random_spline(rectangle, 2).bounds(across).smooth);
  EXPECT_FALSE(random_spline(rectangle, 1).bounds(across).smooth);
  EXPECT_TRUE(random_spline(rectangle, 1).bounds(within).smooth);
  EXPECT_THAT(random_spline(rectangle, 1).breakpoints(1),
              testing::ElementsAre(testing::DoubleEq(0.3), testing::DoubleEq(0.5)));
}

TEST(SplineField, WrongNumbersAreRefused) {
  EXPECT_THROW(SplineField(rectangle, 9, {}), InvalidArgument);
  EXPECT_THROW(SplineField(rectangle, 2, std::vector<double>(34)), InvalidArgument);
  std::vector<double> coefficients(SplineField::coefficient_count(rectangle, 2));
  EXPECT_NO_THROW(SplineField(rectangle, 2, coefficients));
  for (const double bad : {double(NAN), double(INFINITY)}) {
    coefficients[3] = bad;
    EXPECT_THROW(SplineField(rectangle, 2, coefficients), InvalidArgument);
  }
}

}  // namespace
}  // namespace rfm
