#include "core/variables.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/further_coordinate.hpp"
#include "core/jet_shape.hpp"
#include "core/spline_field.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate(), t = time_coordinate();

// ∂^α of sin(x) e^{2y} cosh(z) / (1 + t).
double derivative_of_product(const MultiIndex& alpha, const Point& p, double time) {
  const double sines[] = {std::sin(p[0]), std::cos(p[0]), -std::sin(p[0]), -std::cos(p[0])};
  double reciprocal = 1 / (1 + time);
  for (int k = 1; k <= alpha[3]; ++k) reciprocal *= -k / (1 + time);
  return sines[alpha[0] % 4] * std::pow(2, alpha[1]) * std::exp(2 * p[1]) *
         (alpha[2] % 2 == 0 ? std::cosh(p[2]) : std::sinh(p[2])) * reciprocal;
}

const Field product = sin(x) * exp(2 * y) * cosh(z) / (1 + t);

TEST(TapeVariables, JetsInSpaceAndTimeHaveAllDerivativesToOrderEight) {
  const Tape tape({product}, {8}, {0, 1, 2, 3});
  Tape::Workspace workspace(tape);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<std::vector<double>, 3> coordinates;
  for (auto& axis : coordinates)
    for (int i = 0; i < 9; ++i) axis.push_back(uniform(generator));
  const double time = 0.3;
  tape.evaluate(
      {.coordinates = {coordinates[0].data(), coordinates[1].data(), coordinates[2].data()},
       .count = 9,
       .time = time},
      workspace);
  const JetShape& shape = JetShape::get(4, 8);
  for (int i = 0; i < 9; ++i) {
    const Point point{coordinates[0][i], coordinates[1][i], coordinates[2][i]};
    const std::vector<double> alone = tape.jet(point, 0, time);
    for (int k = 0; k < shape.size(); ++k) {
      const MultiIndex& alpha = shape.exponent(k);
      const double expected = derivative_of_product(alpha, point, time) / factorial(alpha);
      EXPECT_NEAR(workspace.coefficient(0, k)[i], expected, 1e-13 * (1 + std::fabs(expected)));
      EXPECT_NEAR(alone[k], expected, 1e-13 * (1 + std::fabs(expected)));
    }
  }
}

TEST(TapeVariables, AnyCoordinatesInAnyOrderWhileOthersAreHeld) {
  const Tape tape({product}, {2}, {3, 1});
  const Point point{0.4, -0.2, 0.7};
  const std::vector<double> jet = tape.jet(point, 0, 0.5);
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; i + j <= 2; ++j) {
      const MultiIndex inner{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)};
      const MultiIndex outer{0, static_cast<std::uint8_t>(j), 0, static_cast<std::uint8_t>(i)};
      EXPECT_NEAR(jet[jet_index(2, inner)] * factorial(inner),
                  derivative_of_product(outer, point, 0.5), 1e-13);
    }
}

TEST(TapeVariables, FieldsMayDependOnMoreThanFourCoordinates) {
  // x + 2 y + … weighted by the number of the coordinate, squared.
  Field sum = 0.0;
  for (int i = 0; i < 7; ++i)
    sum = sum + (i + 1.0) * (i < 4 ? coordinate(i) : further_coordinate(i));
  const Tape tape({sum * sum}, {2}, {6, 1, 4});
  const double further[] = {0.1, 0.2, 0.3};
  const Point point{1, 2, 3};
  const double value = 1 + 2 * 2 + 3 * 3 + 4 * 0.7 + 5 * 0.1 + 6 * 0.2 + 7 * 0.3;
  const std::vector<double> jet = tape.jet(point, 0, {0.7, {}, further});
  const double slopes[] = {7, 2, 5};
  EXPECT_NEAR(jet[0], value * value, 1e-12);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(jet[1 + i], 2 * value * slopes[i], 1e-12);
    for (int j = i; j < 3; ++j)
      EXPECT_NEAR(jet[jet_index(3, unit_index(i) + unit_index(j))],
                  (i == j ? 1 : 2) * slopes[i] * slopes[j], 1e-12);
  }
  Tape::Workspace workspace(tape);
  const double* const rows[] = {&further[0], &further[1], &further[2]};
  tape.evaluate(
      {.coordinates = {&point[0], &point[1], &point[2]}, .count = 1, .time = 0.7, .further = rows},
      workspace);
  for (int k = 0; k < jet_size(3, 2); ++k)
    EXPECT_NEAR(workspace.coefficient(0, k)[0], jet[k], 1e-12);
}

TEST(TapeVariables, CoordinatesThatAreNotGivenAreRefused) {
  const Tape tape({further_coordinate(5) + y}, {0}, {0});
  Tape::Workspace workspace(tape);
  const double values[] = {1.0}, further[] = {1.0, 2.0};
  const double* const rows[] = {values, values};
  EXPECT_THROW(further_coordinate(3), InvalidArgument);
  EXPECT_THROW(tape.value({}), InvalidArgument);
  EXPECT_EQ(tape.value({0, 3}, 0, {0, {}, further}), 5);
  EXPECT_THROW(
      tape.evaluate({.coordinates = {values, values}, .count = 1, .further = std::span(rows, 1)},
                    workspace),
      InvalidArgument);
  EXPECT_THROW(tape.evaluate({.coordinates = {values}, .count = 1, .further = rows}, workspace),
               InvalidArgument);
  EXPECT_NO_THROW(
      tape.evaluate({.coordinates = {values, values}, .count = 1, .further = rows}, workspace));
}

TEST(TapeVariables, DerivativesAlongHeldCoordinatesAreExpressions) {
  const Field f = sin(x * y) + y * y * t;
  const Tape tape({partial(f, 1)}, {2}, {0, 3}), formula({x * cos(x * y) + 2 * y * t}, {2}, {0, 3});
  const Point point{0.4, 0.9, 0};
  const std::vector<double> found = tape.jet(point, 0, 0.3), expected = formula.jet(point, 0, 0.3);
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-14);
}

TEST(TapeVariables, WrongVariablesAreRefused) {
  EXPECT_THROW(Variables(0), InvalidArgument);
  EXPECT_THROW(Variables(4), InvalidArgument);
  EXPECT_THROW(Variables(std::vector<int>{}), InvalidArgument);
  EXPECT_THROW(Variables({0, 1, 0}), InvalidArgument);
  EXPECT_THROW(Variables({0, -1}), InvalidArgument);
  EXPECT_THROW(Variables({0, 1, 2, 3, 4}), InvalidArgument);
}

TEST(TapeVariables, BoundsEncloseValueAndGradientInSpaceAndTime) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1), unit(0, 1);
  for (const int order : {1, 5}) {  // compiled for three variables, and tables at run time
    for (const std::vector<int>& chosen :
         std::vector<std::vector<int>>{{0, 1, 2, 3}, {3, 2}, {1, 3, 0}}) {
      const Variables variables(chosen);
      const Tape tape({product}, {order}, variables);
      for (int repeat = 0; repeat < 20; ++repeat) {
        Box box{3, {}, {}};
        for (int axis = 0; axis < 3; ++axis) {
          box.low[axis] = uniform(generator);
          box.high[axis] = box.low[axis] + 0.2 * unit(generator);
        }
        const double early = uniform(generator) * 0.5;
        const Interval time(early, early + 0.2 * unit(generator));
        const FunctionBounds bounds = tape.bounds(box, 0, time);
        const Interval plain = tape.value_bounds(box, 0, time);
        EXPECT_TRUE(bounds.smooth);
        EXPECT_LT(bounds.value.width(), 30);
        for (int sample = 0; sample < 20; ++sample) {
          Point point{};
          for (int axis = 0; axis < 3; ++axis)
            point[axis] = std::lerp(box.low[axis], box.high[axis], unit(generator));
          const double now = std::lerp(time.low, time.high, unit(generator));
          const std::vector<double> jet = tape.jet(point, 0, now);
          EXPECT_TRUE(bounds.value.contains(jet[0]));
          EXPECT_TRUE(plain.contains(jet[0]));
          for (int i = 0; i < variables.count(); ++i)
            EXPECT_TRUE(bounds.gradient[i].contains(jet[1 + i]))
                << "slope " << i << " of " << variables.count() << ", order " << order << ": "
                << jet[1 + i] << " is not in " << bounds.gradient[i].low << ", "
                << bounds.gradient[i].high;
        }
      }
    }
  }
}

TEST(TapeVariables, TaylorBoundsAreOfSecondOrderInEveryVariable) {
  // Along the fourth variable as along the others: width of the error term falls by 4 with h / 2.
  const Tape tape({exp(x + 2 * t) - x - 2 * t}, {1}, {0, 1, 2, 3});
  const auto excess = [&](double h) {
    const FunctionBounds bounds = tape.bounds({3, {0, 0, 0}, {h, h, h}}, 0, Interval(0, h));
    return bounds.value.width();
  };
  EXPECT_NEAR(std::log2(excess(0.02) / excess(0.01)), 2, 0.1);
}

TEST(TapeVariables, SourcesKnowSpaceOnly) {
  // A spline that is the polynomial x² y (degree 3 reproduces it): coefficients by interpolation
  // are avoided with a product of linear ones, s = x + 2 y on a grid of one cell.
  const Grid grid({2, {0, 0}, {1, 1}}, {1, 1});
  const auto spline = std::make_shared<SplineField>(grid, 1, std::vector<double>{0, 1, 2, 3});
  const Field s = field(spline);  // bilinear: x + 2 y
  const Point point{0.3, 0.4, 0.9};
  for (const std::vector<int>& chosen :
       std::vector<std::vector<int>>{{3, 1}, {3}, {2, 0}, {1, 0, 3}, {0, 1, 2, 3}}) {
    const Variables variables(chosen);
    const Tape source({exp(s) * t + z}, {3}, variables);
    const Tape formula({exp(x + 2 * y) * t + z}, {3}, variables);
    const std::vector<double> found = source.jet(point, 0, 0.6),
                              expected = formula.jet(point, 0, 0.6);
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_NEAR(found[k], expected[k], 1e-13) << k << " in " << variables.count();
    const FunctionBounds bounds = source.bounds({2, {0.2, 0.3}, {0.4, 0.5}}, 0, Interval(0.5, 0.7));
    const Tape held({exp(s) * t}, {1}, variables);
    EXPECT_TRUE(bounds.value.contains(found[0] - 0.9));
    for (int i = 0; i < variables.count(); ++i)
      EXPECT_TRUE(bounds.gradient[i].contains(expected[1 + i]));
  }
}

TEST(TapeVariables, ParametersHaveValuesAtPointsAndInBounds) {
  const Field a = parameter(0), b = parameter(1);
  const Tape tape({a * x * x + b}, {1}, 2);
  const double values[] = {3, 0.5};
  Point gradient;
  EXPECT_EQ(tape.value({2, 0}, 0, {0, values}), 12.5);
  EXPECT_EQ(tape.value_and_gradient({2, 0}, gradient, 0, {0, values}), 12.5);
  EXPECT_EQ(gradient[0], 12);
  EXPECT_THROW(tape.value({2, 0}), InvalidArgument);
  EXPECT_THROW(tape.value({2, 0}, 0, {0, std::span(values, 1)}), InvalidArgument);
  const Box box{2, {1, 0}, {1.5, 1}};
  const Interval fixed[] = {3.0, 0.5};
  const FunctionBounds known = tape.bounds(box, 0, {0.0, fixed});
  EXPECT_TRUE(known.value.contains(3.5) && known.value.contains(7.25));
  EXPECT_LT(known.value.width(), 4.6);
  EXPECT_TRUE(known.gradient[0].contains(6) && known.gradient[0].contains(9));
  EXPECT_LT(known.gradient[0].width(), 3.001);
  const Interval ranges[] = {{2, 4}, {-1, 1}};
  const FunctionBounds wide = tape.bounds(box, 0, {0.0, ranges});
  EXPECT_TRUE(wide.value.contains(2 - 1) && wide.value.contains(4 * 2.25 + 1));
  EXPECT_LT(wide.value.width(), 12);
  EXPECT_EQ(tape.value_bounds(box).high, INFINITY);  // nothing is known of the parameters
  EXPECT_EQ(tape.bounds(box).value.high, INFINITY);
}

}  // namespace
}  // namespace rfm
