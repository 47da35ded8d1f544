#include "core/composition.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>

#include "core/derivative_fields.hpp"
#include "core/evaluate.hpp"
#include "core/graph_derivative.hpp"
#include "core/spline_field.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
const Point point{0.4, 0.3, 0.7};

void expect_same_jets(const Field& a, const Field& b, int order, int dimension) {
  const std::vector<double> left = Tape({a}, {order}, dimension).jet(point);
  const std::vector<double> right = Tape({b}, {order}, dimension).jet(point);
  for (std::size_t i = 0; i < left.size(); ++i)
    EXPECT_NEAR(left[i], right[i], 1e-12 * (1 + std::fabs(right[i]))) << i;
}

TEST(Composition, SubstitutesCoordinates) {
  const Field f = x * x + sin(y) * z;
  EXPECT_TRUE(same_expression(compose(f, {y, x + 1}), y * y + sin(x + 1) * z));
  EXPECT_TRUE(same_expression(compose(f, {x, y, 2.0}), x * x + sin(y) * 2.0));
  const Field p = parameter(0);
  EXPECT_TRUE(compose(p, {y}).same_as(p));
}

TEST(Composition, KeepsNodesThatTheMapDoesNotTouch) {
  const Field untouched = sin(z);
  const Field f = compose(untouched * x, {y});
  EXPECT_TRUE(f.node().arguments[0].same_as(untouched));
}

TEST(Composition, OfCompositionsIsAssociative) {
  const Field f = exp(x) * cos(y);
  const std::vector<Field> inner{x * y, x - y}, outer{sin(x), y * y};
  expect_same_jets(compose(compose(f, inner), outer),
                   compose(f, {compose(inner[0], outer), compose(inner[1], outer)}), 4, 2);
}

TEST(Composition, RotationsCommuteWithTheLaplacian) {
  const double c = std::cos(0.6), s = std::sin(0.6);
  const std::vector<Field> turn{c * x + s * y, c * y - s * x};
  const Field f = exp(x * y) + x * x * x;
  expect_same_jets(compose(laplacian(f, 2), turn), laplacian(compose(f, turn), 2), 2, 2);
}

TEST(Composition, PartialWithinIsWithRespectToTheInnerCoordinate) {
  // f = x² y and μ = (2x, y + x): (∂f/∂x)(μ) = 2 (2x)(y + x), ∂/∂x f(μ) = ∂/∂x 4x² (y + x).
  const Field f = x * x * y;
  const std::vector<Field> map{2 * x, y + x};
  EXPECT_NEAR(value_at(compose(partial(f, 0), map), point), 4 * 0.4 * 0.7, 1e-15);
  EXPECT_NEAR(value_at(partial(compose(f, map), 0), point), 8 * 0.4 * 0.7 + 4 * 0.16, 1e-15);
  // The chain rule joins them.
  expect_same_jets(partial(compose(f, map), 0),
                   2 * compose(partial(f, 0), map) + compose(partial(f, 1), map), 3, 2);
}

TEST(Composition, HigherDerivativesWithinAreExact) {
  const Field f = sqrt(1 + x * x) * atan(y);
  const std::vector<Field> map{x * y, x - y};
  const Field mixed = compose(partial(f, MultiIndex{2, 1}), map);
  // ∂ₓ² √(1+x²) = (1+x²)^{−3/2}, ∂ᵧ atan y = 1/(1+y²)
  expect_same_jets(mixed, pow(1 + pow(x * y, 2), -1.5) / (1 + pow(x - y, 2)), 3, 2);
}

// A spline that is the polynomial (1 + 2x)(3y − 1), bilinear on one cell.
Field bilinear() {
  const Grid grid({2, {0, 0}, {1, 1}}, {1, 1});
  return field(std::make_shared<SplineField>(grid, 1, std::vector<double>{-1, -3, 2, 6}));
}

TEST(Composition, SampledFieldsFollowTheChainRule) {
  const Field s = bilinear(), f = (1 + 2 * x) * (3 * y - 1);
  const std::vector<Field> map{0.5 + 0.4 * sin(x * y), x * x};
  const auto expression = [](const Field& u) { return u * u + partial(u, 0) * exp(partial(u, 1)); };
  for (const int order : {0, 2, 3, 6})
    expect_same_jets(compose(expression(s), map), compose(expression(f), map), order, 2);
  // In blocks too, with constants among the images.
  for (const std::vector<Field>& image : {map, {x * y, 0.25}, {0.5, 0.75}}) {
    const Tape tape({compose(expression(s), image), compose(expression(f), image)}, {2}, 2);
    Tape::Workspace workspace(tape);
    const double xs[] = {0.1, 0.2, 0.5, 0.9, 0.7}, ys[] = {0.3, 0.8, 0.1, 0.6, 0.9};
    tape.evaluate({.coordinates = {xs, ys}, .count = 5}, workspace);
    for (int k = 0; k < jet_size(2, 2); ++k)
      for (int i = 0; i < 5; ++i)
        EXPECT_NEAR(workspace.coefficient(0, k)[i], workspace.coefficient(1, k)[i],
                    1e-13 * (1 + std::fabs(workspace.coefficient(1, k)[i])));
  }
}

TEST(Composition, BoundsOfSampledFieldsAreTakenWhereTheMapLeads) {
  const Field s = bilinear(), g = compose(s, {0.5 * x, y * y});
  const Tape tape({g}, {1}, 2);
  const FunctionBounds bounds = tape.bounds({2, {0.2, 0.5}, {0.4, 0.6}});
  for (const double a : {0.2, 0.3, 0.4})
    for (const double b : {0.5, 0.55, 0.6}) {
      EXPECT_TRUE(bounds.value.contains((1 + a) * (3 * b * b - 1)));
      EXPECT_TRUE(bounds.gradient[0].contains(3 * b * b - 1));
      EXPECT_TRUE(bounds.gradient[1].contains((1 + a) * 6 * b));
    }
  EXPECT_LT(bounds.value.width(), 1.5);
}

TEST(Composition, DerivativesByParametersOfMapsGoThroughSampledFields) {
  // s((p x, y)) = (1 + 2 p x)(3 y − 1)
  const Field p = parameter(0), moved = compose(bilinear(), {p * x, y});
  const double at[] = {0.8};
  EXPECT_NEAR(Tape({derivative_with_respect_to(moved, p)}, {0}, 2).value(point, 0, {0, at}),
              2 * 0.4 * (0.9 - 1), 1e-14);
}

TEST(Composition, NormalizersHaveNoNormalDerivativeOnTheBoundary) {
  const Field omega = normalize(1 - x * x - y * y, 2);
  for (const Field& f : {exp(x) * y, bilinear()}) {
    const Field star = normalizer(f, omega, 2);
    for (const double angle : {0.2, 0.9, 1.4}) {
      const Point boundary{std::cos(angle), std::sin(angle)};
      EXPECT_NEAR(value_at(star, boundary), value_at(f, boundary), 1e-14);
      EXPECT_NEAR(value_at(inward_derivative(star, omega, 2), boundary), 0, 1e-13);
    }
  }
}

TEST(Composition, DeepGraphsDoNotOverflowTheStack) {
  Field f = x;
  for (int i = 0; i < 100000; ++i) f = f + y;
  EXPECT_NEAR(value_at(compose(f, {y, x}), {0.5, 2, 0}), 2 + 50000, 1e-9);
}

TEST(Composition, FoldsAndChoosesOperationsAsBuildersDo) {
  // x² is defined for x < 0, x^y for y = 2 was not.
  const Field square = compose(pow(x, y), {x, 2.0});
  EXPECT_EQ(value_at(square, {-3, 0.5}), 9);
  EXPECT_TRUE(compose(cbrt(x), {8.0}).is_constant(2));
}

}  // namespace
}  // namespace rfm
