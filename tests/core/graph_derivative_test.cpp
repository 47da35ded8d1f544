#include "core/graph_derivative.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/expression_text.hpp"
#include "core/spline_field.hpp"
#include "core/tape.hpp"
#include "tests/core/operation_rows.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), p = parameter(0), q = parameter(1);

double value(const Field& f, const Point& point, const std::vector<double>& parameters) {
  return Tape({f}, {0}, 2).value(point, 0, {0, parameters});
}

class DerivedOperation : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(GraphDerivative, DerivedOperation, testing::ValuesIn(all_rows()),
                         [](const auto& info) { return info.param.identifier; });

TEST_P(DerivedOperation, HasTheDerivativesOfJets) {
  const OperationRow& row = *find_operation(GetParam().operation);
  std::vector<Field> arguments{0.7 * x + 0.2 * y * y, sin(y) - 0.4 * x, x * y};
  arguments.resize(row.arity);
  const Field f = apply(row.operation, arguments,
                        row.numbers ? std::optional(GetParam().number) : std::nullopt);
  GraphDerivative along_x(x), along_y(y);
  const Field fx = along_x.of(f), fxy = along_y.of(fx), fxx = along_x.of(fx);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.2, 1.2);
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Point point{uniform(generator), uniform(generator)};
    const PointJet jet = evaluate(f, point, 2, 2);
    if (!std::isfinite(jet.value())) continue;
    ++compared;
    const double size = 1 + std::fabs(jet.value()) + std::fabs(jet.derivative(1, 0)) +
                        std::fabs(jet.derivative(2, 0)) + std::fabs(jet.derivative(1, 1));
    EXPECT_NEAR(value_at(fx, point), jet.derivative(1, 0), 1e-12 * size);
    EXPECT_NEAR(value_at(fxx, point), jet.derivative(2, 0), 1e-11 * size);
    EXPECT_NEAR(value_at(fxy, point), jet.derivative(1, 1), 1e-11 * size);
  }
  EXPECT_GT(compared, 15);
}

TEST(GraphDerivative, PowersHaveTheDerivativesOfJets) {
  for (const double exponent : {-2.0, 3.0, 0.5, 2.5, -0.7}) {
    const Field f = pow(1.5 + x * y, exponent), fx = derivative_with_respect_to(f, x);
    const PointJet jet = evaluate(f, {0.3, -0.4}, 1, 2);
    EXPECT_NEAR(value_at(fx, {0.3, -0.4}), jet.derivative(1, 0), 1e-14);
  }
}

TEST(GraphDerivative, SingularDerivativesAreZeroAsInJets) {
  for (const Field& f :
       {sqrt(x), cbrt(x), asin(1 + x), hypot(x, y), atan2(y, x), pow(x, 0.3), pow(x, y), abs(x),
        min(x, y), max(x, y), apply(Operation::r0_conjunction, {x, y}),
        apply(Operation::r0_disjunction, {x, y})})
    EXPECT_EQ(value_at(derivative_with_respect_to(f, x), {0, 0}),
              evaluate(f, {0, 0}, 1, 2).derivative(1, 0));
}

TEST(GraphDerivative, PowersOfZeroHaveTheDerivativesOfJets) {
  const Field slope = derivative_with_respect_to(pow(x, y), x);
  EXPECT_EQ(value_at(slope, {0, 1}), 1);
  EXPECT_EQ(value_at(slope, {0, 2}), 0);
  EXPECT_EQ(value_at(slope, {0, 0}), 0);
  EXPECT_TRUE(std::isnan(value_at(slope, {0, -1})));
}

TEST(GraphDerivative, AreUndefinedWhereTheFunctionIs) {
  const Field root = sqrt(x);
  for (const Field& f : {log(x),
                         step(root),
                         floor(root),
                         sign(root),
                         floor(log(x)),
                         asin(x - 1),
                         acos(x - 1),
                         apply(Operation::less, {root, 1.0}),
                         apply(Operation::equal, {1.0, root}),
                         apply(Operation::less_equal, {root, y}),
                         mod(root, 2.0),
                         mod(x, y - y),
                         min(root, 3.0),
                         max(3.0, root),
                         abs(root),
                         select(root, x, x),
                         pow(x, 0.5),
                         pow(x, 1.5),
                         pow(x, -0.5),
                         pow(x, y),
                         0.0 * log(x),
                         y * step(root)}) {
    EXPECT_FALSE(std::isfinite(value_at(f, {-1, 0.5})));
    EXPECT_FALSE(std::isfinite(value_at(derivative_with_respect_to(f, x), {-1, 0.5})));
  }
  for (const Field& f : {log(x), pow(x, -1.0), pow(x, -0.5), pow(x, y - 1)})
    EXPECT_FALSE(std::isfinite(value_at(derivative_with_respect_to(f, x), {0, 0.5})));
}

TEST(GraphDerivative, IsUndefinedAlsoWhereThePartThatIsDoesNotDependOnTheVariable) {
  for (const Field& f :
       {log(x), y + sqrt(x), y - 1 / (x + 1), y * y + log(x), y * sqrt(x), sqrt(x) * y, y / sqrt(x),
        exp(y + sqrt(x)), -(sqrt(x) + y), sqrt(x) * 2, min(y, sqrt(x)), abs(y + log(x)),
        select(y, y + log(x), y), hypot(y, log(x)), pow(y + sqrt(x), 2.0), partial(y + log(x), 1),
        asin(x - 1) + apply(Operation::r0_conjunction, {y, y})}) {
    EXPECT_FALSE(std::isfinite(value_at(f, {-1, 0.5})));
    EXPECT_TRUE(std::isfinite(value_at(f, {0.7, 0.5})));
    for (const Field& slope : {derivative_with_respect_to(f, y), partial(f, 1)}) {
      EXPECT_FALSE(std::isfinite(value_at(slope, {-1, 0.5}))) << to_text(f);
      EXPECT_TRUE(std::isfinite(value_at(slope, {0.7, 0.5}))) << to_text(f);
    }
    const Field again = derivative_with_respect_to(derivative_with_respect_to(f, y), y);
    EXPECT_FALSE(std::isfinite(value_at(again, {-1, 0.5}))) << to_text(f);
    EXPECT_NEAR(value_at(derivative_with_respect_to(f, y), {0.7, 0.5}),
                value_at(partial(f, 1), {0.7, 0.5}), 1e-15);
  }
  // Infinite values are none either: the derivative of the finite part does not pass for one.
  for (const Field& f : {y + log(x), sqrt(y + 1 / x), min(y, log(x)), abs(log(x) + y)})
    EXPECT_FALSE(std::isfinite(value_at(derivative_with_respect_to(f, y), {0, 0.5}))) << to_text(f);
}

TEST(GraphDerivative, SaysNothingTwiceOfADomain) {
  const auto text = [](const Field& f) { return to_text(derivative_with_respect_to(f, y)); };
  EXPECT_EQ(text(y * sqrt(x)), "sqrt(x)");
  EXPECT_EQ(text(exp(y)), "exp(y)");
  EXPECT_EQ(text(log(y)), "1/y + 0*log(y)");
  EXPECT_EQ(text(y + log(x)), "1 + 0*(y + log(x))");
  EXPECT_TRUE(derivative_with_respect_to(hypot(x, 1), y).is_constant(0));
}

TEST(GraphDerivative, WhereTheFunctionIsDefinedZerosAreConstants) {
  GraphDerivative along_y(y);
  EXPECT_TRUE(along_y.where_defined(x + log(x)).is_constant(0));
  EXPECT_TRUE(along_y.where_defined(y + log(x)).is_constant(1));
  EXPECT_FALSE(along_y.of(y + log(x)).is_constant());
}

TEST(GraphDerivative, OfAParameterIsTheSensitivity) {
  // The weight of a disk of radius p moved by q, and its derivatives.
  const Field r = hypot(x - q, y), f = (p * p - r * r) / (2 * p);
  const std::vector<double> at{1.5, 0.2};
  const Point point{0.7, -0.3};
  const double square = 0.5 * 0.5 + 0.09;
  EXPECT_NEAR(value(derivative_with_respect_to(f, p), point, at), 0.5 + square / (2 * 2.25), 1e-15);
  EXPECT_NEAR(value(derivative_with_respect_to(f, q), point, at), 0.5 / 1.5, 1e-15);
  const Field fp = derivative_with_respect_to(f, p);
  EXPECT_NEAR(value(derivative_with_respect_to(fp, p), point, at), -square / std::pow(1.5, 3),
              1e-15);
  EXPECT_NEAR(value(derivative_with_respect_to(fp, q), point, at), -0.5 / 2.25, 1e-15);
  EXPECT_EQ(value(derivative_with_respect_to(f, parameter(2)), point, at), 0);
  EXPECT_TRUE(derivative_with_respect_to(r, parameter(2)).is_constant(0));
}

TEST(GraphDerivative, CommutesWithPartialDerivatives) {
  const Field f = sin(p * x) * exp(q * y);
  const Field slope = derivative_with_respect_to(partial(f, 0), p);  // (cos px − px sin px) e^{qy}
  const double a = 1.3 * 0.4;
  EXPECT_NEAR(value(slope, {0.4, 0.6}, {1.3, 0.7}),
              (std::cos(a) - a * std::sin(a)) * std::exp(0.42), 1e-14);
  const Field both = partial(derivative_with_respect_to(f, p), 0);
  EXPECT_NEAR(value(both, {0.4, 0.6}, {1.3, 0.7}), value(slope, {0.4, 0.6}, {1.3, 0.7}), 1e-15);
}

TEST(GraphDerivative, SampledFieldsDoNotDependOnParameters) {
  const Grid grid({2, {0, 0}, {1, 1}}, {1, 1});
  const Field s = field(std::make_shared<SplineField>(grid, 1, std::vector<double>{0, 1, 2, 3}));
  const Field f = p * p * s + partial(p * s, 1);  // s = x + 2 y
  EXPECT_NEAR(value(derivative_with_respect_to(f, p), {0.3, 0.4}, {1.5}), 3 * 1.1 + 2, 1e-14);
  EXPECT_NEAR(value(derivative_with_respect_to(s * s, y), {0.3, 0.4}, {}), 4 * 1.1, 1e-14);
}

TEST(GraphDerivative, OnlyCoordinatesAndParametersAreVariables) {
  EXPECT_THROW(derivative_with_respect_to(x, x * y), InvalidArgument);
  EXPECT_TRUE(derivative_with_respect_to(x * y, y).same_as(x));
}

TEST(GraphDerivative, DeepGraphsDoNotOverflowTheStack) {
  Field f = p;
  for (int i = 0; i < 100000; ++i) f = f + x;
  EXPECT_TRUE(derivative_with_respect_to(f, p).is_constant(1));
}

}  // namespace
}  // namespace rfm
