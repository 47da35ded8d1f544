#include "core/derivative_fields.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/jet_shape.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

TEST(DerivativeFields, HessianIsSymmetricAndItsTraceTheLaplacian) {
  const Field f = exp(x * y) * sin(z);
  const std::vector<Field> h = hessian(f, 3);
  const Point point{0.3, -0.7, 0.4};
  const double e = std::exp(-0.21);
  EXPECT_NEAR(value_at(h[0], point), 0.49 * e * std::sin(0.4), 1e-15);
  EXPECT_NEAR(value_at(h[1], point), (1 - 0.21) * e * std::sin(0.4), 1e-15);
  EXPECT_NEAR(value_at(h[5], point), 0.3 * e * std::cos(0.4), 1e-15);
  EXPECT_TRUE(h[1].same_as(h[3]) && h[2].same_as(h[6]) && h[5].same_as(h[7]));
  EXPECT_NEAR(value_at(h[0] + h[4] + h[8], point), value_at(laplacian(f, 3), point), 1e-15);
}

TEST(DerivativeFields, DivergenceOfAGradientIsTheLaplacian) {
  const Field f = x * x * y + cos(z * x);
  const Point point{0.3, -0.7, 0.4};
  EXPECT_NEAR(value_at(divergence(gradient(f, 3)), point), value_at(laplacian(f, 3), point), 1e-14);
}

TEST(DerivativeFields, DirectionalDerivativesOfAnExponential) {
  // D_v^m e^{a·x} = (a·v)^m e^{a·x} for held v.
  const Field f = exp(0.5 * x - 0.8 * y + 0.3 * z);
  const std::vector<Field> v{x + 1, 2 * y, x * z};
  const Point point{0.3, -0.7, 0.4};
  const double along = 0.5 * 1.3 - 0.8 * -1.4 + 0.3 * 0.12;
  for (int m = 0; m <= 8; ++m)
    EXPECT_NEAR(value_at(directional_derivative(f, v, m), point),
                std::pow(along, m) * std::exp(0.15 + 0.56 + 0.12), 1e-12 * std::pow(2, m));
}

TEST(DerivativeFields, IteratedDerivativesDifferentiateTheDirectionToo) {
  // (v·∇)² f = D_v² f + ((v·∇) v)·∇f; with v = (x, 0) and f = x³: 6x³ + 3x³.
  const std::vector<Field> v{x, 0.0};
  const Field f = x * x * x;
  EXPECT_NEAR(value_at(directional_derivative(f, v, 2), {2, 0}), 48, 1e-13);
  EXPECT_NEAR(value_at(iterated_directional_derivative(f, v, 2), {2, 0}), 72, 1e-13);
  EXPECT_TRUE(
      same_expression(iterated_directional_derivative(f, v, 1), directional_derivative(f, v, 1)));
}

TEST(DerivativeFields, WrongOrdersAndDirectionsAreRefused) {
  EXPECT_THROW(directional_derivative(x, {}, 1), InvalidArgument);
  EXPECT_THROW(directional_derivative(x, {1.0}, -1), InvalidArgument);
  EXPECT_THROW(directional_derivative(x, {1.0}, 17), InvalidArgument);
  EXPECT_THROW(iterated_directional_derivative(x, {1.0}, -1), InvalidArgument);
  EXPECT_THROW(iterated_directional_derivative(x, {1.0}, 17), InvalidArgument);
  EXPECT_THROW(normalize(x, 2, 0), InvalidArgument);
  EXPECT_THROW(normalize(x, 2, 5), InvalidArgument);
}

struct Shape {
  const char* name;
  int dimension;
  Field function;
  friend void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }
};

// Regular points of {f = 0}, by Newton's method along gradients from random starts.
std::vector<Point> boundary_points(const Shape& shape, int count) {
  const Tape tape({shape.function}, {1}, shape.dimension);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.6, 1.6);
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count) {
    Point point{}, slope;
    for (int axis = 0; axis < shape.dimension; ++axis) point[axis] = uniform(generator);
    double value = 0, square = 0;
    for (int step = 0; step < 60; ++step) {
      value = tape.value_and_gradient(point, slope);
      square = slope[0] * slope[0] + slope[1] * slope[1] + slope[2] * slope[2];
      for (int axis = 0; axis < shape.dimension; ++axis)
        point[axis] -= value * slope[axis] / square;
    }
    if (std::fabs(value) < 1e-15 && square > 0.5) points.push_back(point);
  }
  return points;
}

// D_n^k of `field` along the straight unit normal n of its own zero set, k = 0 … order.
std::vector<double> normal_derivatives(const Field& field, int dimension, const Point& point,
                                       int order) {
  const Tape tape({field}, {order}, dimension);
  const std::vector<double> jet = tape.jet(point);
  const JetShape& shape = JetShape::get(dimension, order);
  double length = 0;
  for (int axis = 0; axis < dimension; ++axis) length = std::hypot(length, jet[1 + axis]);
  std::vector<double> derivatives(order + 1);
  double factorial = 1;
  for (int k = 0; k <= order; factorial *= ++k)
    for (int i = k > 0 ? shape.size(k - 1) : 0; i < shape.size(k); ++i) {
      double term = factorial * jet[i];
      for (int axis = 0; axis < dimension; ++axis)
        term *= std::pow(jet[1 + axis] / length, shape.exponent(i)[axis]);
      derivatives[k] += term;
    }
  return derivatives;
}

class NormalizedShapes : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(DerivativeFields, NormalizedShapes,
                         testing::Values(Shape{"circle", 2, 1.44 - x* x - y* y},
                                         Shape{"ellipse", 2, 1 - x* x / 2.25 - y* y},
                                         Shape{"cubic", 2, y* y - x* x* x + x - 0.6},
                                         Shape{"ellipsoid", 3,
                                               1 - x* x / 2.25 - y* y - z* z / 1.44}));

TEST_P(NormalizedShapes, HaveUnitSlopeAndNoHigherNormalDerivatives) {
  const Shape& shape = GetParam();
  const Field first = normalize(shape.function, shape.dimension, 1);
  for (int order = 1; order <= 4; ++order) {
    const Field omega = normalize(shape.function, shape.dimension, order);
    for (const Point& point : boundary_points(shape, order < 4 ? 12 : 4)) {
      // What must cancel: the derivatives of the function normalised to first order.
      const std::vector<double> before = normal_derivatives(first, shape.dimension, point, order);
      const std::vector<double> d = normal_derivatives(omega, shape.dimension, point, order);
      EXPECT_NEAR(d[0], 0, 1e-15);
      EXPECT_NEAR(d[1], 1, 1e-12) << "order " << order;
      for (int k = 2; k <= order; ++k)
        EXPECT_NEAR(d[k], 0, 1e-12 * (1 + std::fabs(before[k]))) << "order " << order << ", " << k;
    }
  }
}

TEST_P(NormalizedShapes, AreNormalizedToTheirOrderAndNotBeyond) {
  const Shape& shape = GetParam();
  for (int order = 1; order <= 3; ++order) {
    const Field omega = normalize(shape.function, shape.dimension, order);
    double next = 0;
    for (const Point& point : boundary_points(shape, 4))
      next = std::max(
          next, std::fabs(normal_derivatives(omega, shape.dimension, point, order + 1)[order + 1]));
    EXPECT_GT(next, 1e-2) << "order " << order;
  }
}

TEST(DerivativeFields, TheIteratedDerivativeDoesNotNormalizeAnEllipse) {
  const Shape ellipse{"ellipse", 2, 1 - x * x / 4 - y * y};
  const Field omega = normalize(ellipse.function, 2);
  const std::vector<Field> normal = gradient(omega, 2);
  const Field frozen = omega - 0.5 * omega * omega * directional_derivative(omega, normal, 2);
  const Field iterated =
      omega - 0.5 * omega * omega * iterated_directional_derivative(omega, normal, 2);
  double worst = 0;
  for (const Point& point : boundary_points(ellipse, 20)) {
    EXPECT_NEAR(normal_derivatives(frozen, 2, point, 2)[2], 0, 1e-12);
    EXPECT_NEAR(normal_derivatives(normalize(ellipse.function, 2, 2), 2, point, 2)[2], 0, 1e-12);
    worst = std::max(worst, std::fabs(normal_derivatives(iterated, 2, point, 2)[2]));
  }
  EXPECT_GT(worst, 0.5);
}

TEST(DerivativeFields, OrdersTwoAndThreeAreTheRecursion) {
  // (4.10) itself, with all its derivatives: the same to the order of normalisation, so that the
  // difference is O(ω^{m+1}), m = 3.
  const Shape ellipse{"ellipse", 2, 1 - x * x / 2.25 - y * y};
  const Field first = normalize(ellipse.function, 2);
  const std::vector<Field> normal = gradient(first, 2);
  Field length = sqrt(inward_derivative(first, first, 2));
  const std::vector<Field> unit{normal[0] / length, normal[1] / length};
  const Field second = first - pow(first, 2) / 2 * directional_derivative(first, unit, 2);
  const Field third = second - pow(first, 3) / 6 * directional_derivative(second, unit, 3);
  const Field difference = third - normalize(ellipse.function, 2, 3);
  for (const Point& point : boundary_points(ellipse, 3)) {
    const auto inside = [&](double depth) {
      const Point within{point[0] * (1 - depth), point[1] * (1 - depth)};
      return std::fabs(value_at(difference, within));
    };
    EXPECT_GT(std::log2(inside(0.02) / inside(0.01)), 3.8);
  }
}

}  // namespace
}  // namespace rfm
