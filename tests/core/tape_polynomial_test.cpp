#include "core/tape_polynomial.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <random>

#include "core/evaluate.hpp"
#include "core/expression_text.hpp"
#include "core/primitives.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

Field level_of(const Region& region) { return region.primitives()[0]->level; }

struct Case {
  const char* name;
  Field field;
};
void PrintTo(const Case& polynomial, std::ostream* out) { *out << polynomial.name; }

const Case sums[] = {{"Coordinate", y},
                     {"Offset", x - 3},
                     {"Opposite", 0.3 - z},
                     {"HalfPlane", level_of(half_plane({1, 2}, {3, -4}))},
                     {"HalfSpace", level_of(half_space({1, 2, 3}, {3, -4, 1}))},
                     {"Circle", level_of(circle({0.3, -0.2}, 0.7))},
                     {"Sphere", level_of(sphere({0.3, -0.2, 100}, 0.7))},
                     {"SphereInAnotherOrder", z* z + (y - 2) * (y - 2) + x* x - 1},
                     {"ConstantFirst", 1 - x* x - 3 * y},
                     {"ConstantAmong", x* x - 0.7 + 3 * y},
                     {"Saddle", x* x - y* y},
                     {"Paraboloid", z - 0.3 * pow(x - 1, 2) - y* y},
                     {"Slab", 0.25 - pow(0.1 - x, 2)},
                     {"OppositeOfASum", z - -(x* x + y * y)},
                     {"Slope", partial((x + 2 * y) * (x - z), 0)},
                     {"SlopeOfAConstant", partial(3 * x, 0)}};
const Case others[] = {{"Ellipse", level_of(ellipse({0.3, -0.2}, {1.5, 0.4}, 0.6))},
                       {"Expanded", 3 - 2 * x + 5 * x* y - (x - y) * (2 * x + 1) / 4},
                       {"Product", (x - 1) * (2 - x)},
                       {"TwoOrigins", 0.6 * (x - 1) + 0.8 * (x - 3) + y},
                       {"Cancelling", x + y - x},
                       {"Cylinder", level_of(cylinder({1, 2, 3}, {1, 1, 0.3}, 0.5, INFINITY))},
                       {"Saddle3", x* y + y* z - 2 * z* x + 0.5},
                       {"Quotient", (x - 0.3) / 7 + y},
                       {"SquareOfASum", pow(x - 3 * y + 1, 2) + z},
                       {"ScaledSum", 2 - 0.3 * (x * x + y * y)},
                       {"ScaledTwice", 0.3 * (0.7 * x) + 0.1 * (0.3 * (x * x + y * y))}};

// Derivatives are not evaluated operation by operation.
bool is_slope(const Case& polynomial) { return std::string(polynomial.name).starts_with("Slope"); }

std::vector<Case> all_cases() {
  std::vector<Case> cases(std::begin(sums), std::end(sums));
  cases.insert(cases.end(), std::begin(others), std::end(others));
  return cases;
}

// A block of random points with coordinates in [−range, range].
struct Points {
  explicit Points(unsigned seed, double range = 3) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-range, range);
    for (auto& axis : coordinates)
      for (double& value : axis) value = uniform(generator);
  }
  Point operator[](int i) const {
    return {coordinates[0][i], coordinates[1][i], coordinates[2][i]};
  }
  PointBlock block() const {
    return {{coordinates[0].data(), coordinates[1].data(), coordinates[2].data()}, 64};
  }
  std::array<std::array<double, 64>, 3> coordinates;
};

class Polynomials : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(TapePolynomial, Polynomials, testing::ValuesIn(all_cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(Polynomials, HaveTheDerivativesOfTheirExpressions) {
  // Single points are evaluated operation by operation, derivatives of them by jets.
  const int highest = is_slope(GetParam()) ? 2 : 3;
  const Points points(5);
  for (int dimension = 1; dimension <= 3; ++dimension)
    for (int order = 0; order <= highest; ++order) {
      const Tape tape({GetParam().field}, {order}, dimension);
      Tape::Workspace workspace(tape);
      tape.evaluate(points.block(), workspace);
      for (int a = 0; a <= order; ++a)
        for (int b = 0; b <= (dimension > 1 ? order - a : 0); ++b)
          for (int c = 0; c <= (dimension > 2 ? order - a - b : 0); ++c) {
            const MultiIndex alpha{static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                                   static_cast<std::uint8_t>(c)};
            const Tape derivative({partial(GetParam().field, alpha)}, {0}, dimension);
            const double* const found = workspace.coefficient(0, jet_index(dimension, alpha));
            // Sizes with the sphere about z = 100: 10⁴, 200, and all else is moderate.
            const double tolerance = 4e-16 * (a + b + c == 0 ? 1e4 : 200);
            for (int i = 0; i < 64; ++i)
              EXPECT_NEAR(found[i] * factorial(alpha), derivative.value(points[i]), tolerance)
                  << dimension << "D order " << order << ": " << a << b << c;
          }
    }
}

class Sums : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(TapePolynomial, Sums, testing::ValuesIn(sums),
                         [](const auto& info) { return info.param.name; });

TEST_P(Sums, AreRoundedAsTheirOperationsAre) {
  for (int order = 0; order <= 2; ++order) {
    const Tape tape({GetParam().field}, {order}, 3);
    Tape::Workspace workspace(tape);
    const Points points(7, 1.5);
    tape.evaluate(points.block(), workspace);
    for (int i = 0; i < 64; ++i) {
      if (is_slope(GetParam()))
        EXPECT_NEAR(workspace.coefficient(0)[i], tape.value(points[i]), 1e-14);
      else
        EXPECT_EQ(workspace.coefficient(0)[i], tape.value(points[i]));
    }
  }
}

TEST(TapePolynomial, ASumIsOneStep) {
  for (const auto& [name, field] : sums) {
    SCOPED_TRACE(name);
    const Tape alone({sqrt(field)}, {2}, 3);
    EXPECT_LE(alone.step_count(), 2);
  }
}

TEST(TapePolynomial, ExactZerosStayExact) {
  const Field fields[] = {x * x - y * y, (x - y) * (x + y), x - y, y, (x - 0.3) * (y - 0.7)};
  const double a = 0.1 + 0.2, b = 1 / 3.0;
  const double zeros[][2] = {{b, -b}, {a, a}, {a, a}, {a, 0}, {0.3, a}};
  for (int k = 0; k < 5; ++k) {
    const Tape tape({fields[k]}, {2}, 2);
    Tape::Workspace workspace(tape);
    tape.evaluate({{&zeros[k][0], &zeros[k][1]}, 1}, workspace);
    EXPECT_EQ(workspace.coefficient(0)[0], 0);
  }
}

TEST(TapePolynomial, ASmallCircleFarAwayLosesNoDigits) {
  // At exactly representable offsets from the centre all is exact.
  const double center = 0x1p30 + 0.5, radius = 0x1p-10;
  const Field u = x - center, v = y + center;
  const Tape tape({radius * radius - u * u - v * v}, {2}, 2);
  Tape::Workspace workspace(tape);
  const double px = center + radius, py = -center + radius / 2;
  tape.evaluate({{&px, &py}, 1}, workspace);
  EXPECT_EQ(workspace.coefficient(0)[0], -radius * radius / 4);
  EXPECT_EQ(workspace.coefficient(0, 1)[0], -2 * radius);
  EXPECT_EQ(workspace.coefficient(0, 2)[0], -radius);
  EXPECT_EQ(workspace.coefficient(0, jet_index(2, {2}))[0], -1);
  EXPECT_EQ(workspace.coefficient(0, jet_index(2, {1, 1}))[0], 0);
}

// Slopes in a block against those of the operations, relative to the terms of the gradient.
void expect_slopes_of_operations(const Field& f, const Point& point) {
  const Tape tape({f}, {1}, 2);
  Tape::Workspace workspace(tape);
  tape.evaluate({{&point[0], &point[1]}, 1}, workspace);
  const std::vector<double> jet = tape.jet(point);
  const std::vector<double> second = Tape({f}, {2}, 2).jet(point);
  for (const int axis : {0, 1}) {
    const double xx = 2 * second[3 + 2 * axis], xy = second[4];
    const double condition =
        std::fabs(jet[1 + axis]) + std::fabs(point[axis] * xx) + std::fabs(point[1 - axis] * xy);
    EXPECT_NEAR(workspace.coefficient(0, 1 + axis)[0], jet[1 + axis], 8 * 0x1p-53 * condition);
  }
}

TEST(TapePolynomial, SmallTermsAboutDistantOriginsLoseNoDigits) {
  const auto at = [](double place) { return (x - place) * (y - place); };
  const auto round = [](double place) { return pow(x - place, 2) + pow(y - place, 2); };
  const Field small[] = {x * y + 1e-6 * at(1000),
                         x * y + 1e-12 * at(1e6),
                         1e-12 * at(1e6) + x * y,
                         x * y + 1e-18 * at(1e9),
                         x * x + y * y - 1 + 1e-18 * round(1e9),
                         1e-18 * round(1e9) + x * x + y * y,
                         x * x + y * y - 1 + 1e-12 * x * (x - 1e6),
                         (x - 1e-3) * (x + 1e-3) + 1e-12 * (x - 1e6) * (x + 3),
                         (x - 1e6 + 1e-6 * y) * (x + y),
                         (x + y) * (1e-3 * y + (x - 1e6)),
                         1e-3 * at(1e3) + 1e-6 * at(1e6) + at(1)};
  for (const Field& f : small)
    for (const Point& point :
         {Point{0.7, 0.3}, Point{1e-3, 1e-3}, Point{1000.5, 999}, Point{1e6, 1}})
      expect_slopes_of_operations(f, point);
}

// A random expression of sums, differences and products in x and y, with the value and the
// derivatives that its operations have at a point, and their conditions: what rounding each
// operation, also those for the derivatives, changes in units of u.
struct Measured {
  Field field;
  long double value = 0;
  std::array<long double, 2> slopes{};
  long double condition = 0;
  std::array<long double, 2> conditions{};
};

Measured random_expression(int depth, const Point& at, std::mt19937& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  if (depth == 0 || below(5) == 0) {
    const int axis = below(5);
    if (axis < 2)
      return {.field = coordinate(axis),
              .value = at[axis],
              .slopes = {axis == 0 ? 1.0L : 0, axis == 1 ? 1.0L : 0}};
    constexpr double sizes[] = {1, 1e8, 1e-3, 3.3, 0.1};
    double number = std::uniform_real_distribution(-1.0, 1.0)(random) * sizes[below(5)];
    if (below(3) == 0) number = at[below(2)];
    return {.field = number, .value = number};
  }
  const Measured a = random_expression(depth - 1, at, random);
  const Measured b = random_expression(depth - 1, at, random);
  const int operation = below(3);
  if (operation < 2) {
    const long double sign = operation == 0 ? 1 : -1;
    Measured sum{.field = operation == 0 ? a.field + b.field : a.field - b.field,
                 .value = a.value + sign * b.value};
    sum.condition = a.condition + b.condition + std::fabs(sum.value);
    for (int i = 0; i < 2; ++i) {
      sum.slopes[i] = a.slopes[i] + sign * b.slopes[i];
      sum.conditions[i] = a.conditions[i] + b.conditions[i] + std::fabs(sum.slopes[i]);
    }
    return sum;
  }
  Measured product{.field = a.field * b.field, .value = a.value * b.value};
  const auto of_product = [](long double f, long double cf, long double g, long double cg) {
    return std::fabs(f) * cg + cf * std::fabs(g) + std::fabs(f * g);
  };
  product.condition = of_product(a.value, a.condition, b.value, b.condition);
  for (int i = 0; i < 2; ++i) {
    product.slopes[i] = a.value * b.slopes[i] + b.value * a.slopes[i];
    product.conditions[i] = of_product(a.value, a.condition, b.slopes[i], b.conditions[i]) +
                            of_product(b.value, b.condition, a.slopes[i], a.conditions[i]);
  }
  return product;
}

TEST(TapePolynomial, RandomSumsAndProductsLoseNoDigitsOfTheirExpressions) {
  constexpr double sizes[] = {1, 1e8, 1e3, 1e-5};
  std::mt19937 random;
  for (int i = 0; i < 60'000; ++i) {
    if (i % 5'000 == 0) random.seed(i / 5'000);
    Point at{};
    for (int axis = 0; axis < 2; ++axis)
      at[axis] = std::uniform_real_distribution(-1.0, 1.0)(random) * sizes[random() % 4];
    const Measured f = random_expression(4, at, random);
    if (f.field.is_constant()) continue;
    const auto jet = evaluate(f.field, at, 1, 2);
    // The reference itself is rounded: 2⁻⁶⁴ of the condition.
    const auto allowed = [](long double condition) { return 8 * 0x1p-53L * condition + 1e-290L; };
    ASSERT_LE(std::fabs(jet.value() - f.value), allowed(f.condition)) << to_text(f.field);
    for (int axis = 0; axis < 2; ++axis)
      ASSERT_LE(std::fabs(jet.derivative(axis == 0, axis == 1) - f.slopes[axis]),
                allowed(f.conditions[axis]))
          << to_text(f.field) << " along axis " << axis << " at " << at[0] << ", " << at[1];
  }
}

TEST(TapePolynomial, DifferencesOfQuadraticsThatAreLinearLoseNoDigitsAsFactors) {
  const Field f = ((x + 1000000.9) * y - x * (y - 100000000.3)) * (x - 1e-9);
  const Field g = ((x - 3.3) * y - x * (y - 1.7)) * x;
  for (const Point& at : {Point{1e-14, 2e-9}, Point{1e-12, 0}})
    for (const Field& product : {f, g}) {
      const auto jet = Tape({product}, {1}, 2).jet(at);
      const auto block = evaluate(product, at, 1, 2);
      for (int axis = 0; axis < 2; ++axis)
        EXPECT_NEAR(block.derivative(axis == 0, axis == 1), jet[1 + axis],
                    1e-14 * std::fabs(jet[1 + axis]));
    }
}

TEST(TapePolynomial, CoordinatesThatDoNotOccurMayBeOfAnySize) {
  const Point far{1e200, 2, -1e300};
  for (const Field& f : {y * y + 1, x + y * y, 3 - x - 2 * y * y}) {
    const Tape tape({f}, {1}, 3);
    Tape::Workspace workspace(tape);
    tape.evaluate({{&far[0], &far[1], &far[2]}, 1}, workspace);
    const std::vector<double> jet = tape.jet(far);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(workspace.coefficient(0, k)[0], jet[k]);
  }
}

TEST(TapePolynomial, CoefficientsThatOverflowAreLeftToTheOperations) {
  const Tape tape({pow(1e200 * (x - 1), 2) * 1e-300}, {1}, 1);
  Tape::Workspace workspace(tape);
  const double at = 1 + 0x1p-40;
  tape.evaluate({{&at}, 1}, workspace);
  Point gradient;
  EXPECT_EQ(workspace.coefficient(0)[0], tape.value_and_gradient({at}, gradient));
  EXPECT_EQ(workspace.coefficient(0, 1)[0], gradient[0]);
}

}  // namespace
}  // namespace rfm
