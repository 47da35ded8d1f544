#include "solution_structures/condition_part.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "core/function_shaping.hpp"
#include "solution_structures/normal_conditions.hpp"
#include "solution_structures/structure_text.hpp"
#include "solution_structures/verification.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Ring ring;
const Field &x = ring.x, &y = ring.y;
const Structure psi1 = Structure::undetermined(0), psi2 = Structure::undetermined(1);
const Field g = sin(2 * x) + y, a = 2 + x * y, b = 3 + cos(x), c = exp(y);

BoundaryOperator value() {
  return [](const std::vector<Field>& u) { return u[0]; };
}
// a u + b ∂u/∂n.
BoundaryOperator robin_of(const std::vector<Field>& normal) {
  return [normal](const std::vector<Field>& u) { return a * u[0] + b * along(normal, u[0]); };
}
double deviation(const Structure& structure, const BoundaryOperator& condition, const Field& data,
                 const std::vector<Point>& points) {
  return largest_deviation({structure}, condition, data, points).largest;
}

TEST(Mixed, ValueAndRobinHoldOnTheirParts) {
  const Structure u = mixed({{g, ring.outer, 1}, robin_part(psi1, ring.inner, {a, b, c}, 2)}, psi2);
  EXPECT_LT(deviation(u, value(), g, ring.outer_points), 1e-12);
  EXPECT_LT(deviation(u, robin_of(ring.inner_normal), c, ring.inner_points), 1e-11);
  EXPECT_GT(deviation(u, value(), g, ring.inner_points), 0.1);
}

TEST(Mixed, OfTwoPartsIsTheFormulaOfTheSurvey) {
  // (7.15): (P₁ ω₂² + P₂ ω₁)/(ω₁ + ω₂²) + Ψ ω₁ ω₂², with P₂ = Ψ₁ − ω₂ D Ψ₁ − ω₂ h Ψ₁ + ω₂ ψ.
  const Field &one = ring.outer, &two = ring.inner, h = -a / b, data = -c / b;
  const Structure second = psi1 - two * D(two, psi1, 2) - (two * h) * psi1 + two * data;
  const Structure printed =
      ((g * pow(two, 2)) + one * second) / (one + pow(two, 2)) + (one * pow(two, 2)) * psi2;
  const Structure general = mixed({{g, one, 1}, robin_part(psi1, two, {a, b, c}, 2)}, psi2);
  const std::vector<Point> inside{{0.7, 0.1}, {-0.5, 0.3}, {0.1, -0.6}, {0.2, 0.7}};
  const Field expected = random_solution({printed}, 2, 1)[0];
  EXPECT_LT(largest_deviation({general}, value(), expected, inside, {.count = 1}).largest, 1e-13);
}

TEST(Mixed, ExponentsBelowThoseOfTheConditionsLoseThem) {
  // With k instead of k + 1, as misprinted in (7.12), the derivative on part 2 is lost.
  ConditionPart natural = robin_part(psi1, ring.inner, {a, b, c}, 2);
  natural.exponent = 1;
  const Structure u = mixed({{g, ring.outer, 1}, natural}, psi2);
  EXPECT_LT(deviation(u, value(), g, ring.outer_points), 1e-12);
  EXPECT_GT(deviation(u, robin_of(ring.inner_normal), c, ring.inner_points), 0.1);
}

// The square of side 2 about the origin: left and right, bottom and top.
struct Square {
  Field left = 1 + x, right = 1 - x, bottom = 1 + y, top = 1 - y;
  std::vector<Point> left_points = on_segment({-1, -1}, {-1, 1});
  std::vector<Point> right_points = on_segment({1, -1}, {1, 1});
  std::vector<Point> bottom_points = on_segment({-1, -1}, {1, -1});
  std::vector<Point> top_points = on_segment({-1, 1}, {1, 1});
};

TEST(Mixed, FourPartsOfFourKindsHoldOnTheirSides) {
  const Square square;
  const Field slope = x * x - 1;
  const Structure u = mixed({{g, square.left, 1},
                             normal_derivative_part(psi1, square.right, slope, 2),
                             robin_part(psi1, square.bottom, {a, b, c}, 2),
                             oblique_part(psi1, square.top, {{0.5, 1.0}, a, c})},
                            psi2);
  EXPECT_LT(deviation(u, value(), g, square.left_points), 1e-11);
  EXPECT_LT(deviation(
                u,
                [](const auto& v) {
                  return along({1.0, 0.0}, v[0]);
                },
                slope, square.right_points),
            1e-10);
  EXPECT_LT(deviation(u, robin_of({0.0, -1.0}), c, square.bottom_points), 1e-10);
  EXPECT_LT(deviation(
                u,
                [](const auto& v) {
                  return a * v[0] + along({0.5, 1.0}, v[0]);
                },
                c, square.top_points),
            1e-10);
}

TEST(Corrected, DerivativesHoldOnTopOfValues) {
  const Square square;
  const Field ends = square.left * square.right / 2;
  const Structure w = g + ends * psi1;
  for (const bool near : {false, true}) {
    const auto natural = [&](const Field& omega, const Field& slope) {
      return NaturalPart{normal_derivative_excess(w, omega, slope, 2), omega,
                         near ? cutoff(omega, 0.2) : 1.0};
    };
    const Structure u = corrected(w, {natural(square.bottom, c), natural(square.top, a)}, psi2,
                                  PrescribedValues{ends, ends});
    const auto upward = [](const auto& v) { return partial(v[0], 1); };
    EXPECT_LT(deviation(u, value(), g, square.left_points), 1e-12);
    EXPECT_LT(deviation(u, value(), g, square.right_points), 1e-12);
    EXPECT_LT(deviation(u, upward, -c, square.bottom_points), 1e-11);
    EXPECT_LT(deviation(u, upward, a, square.top_points), 1e-11);
  }
}

TEST(Mixed, RemainderMayBeGiven) {
  const Field factor = ring.outer * exp(x);
  const Structure u = mixed({{g, ring.outer, 1}}, psi1, factor);
  EXPECT_TRUE(u.terms()[0].coefficient.same_as(factor));
  EXPECT_LT(deviation(u, value(), g, ring.outer_points), 1e-12);
}

TEST(Mixed, IsWrittenAsTransfiniteInterpolationAndARemainder) {
  const StructureNames names{{"omega(outer)", ring.outer}, {"omega(inner)", ring.inner}, {"g", g}};
  const Structure u =
      mixed({{g, ring.outer, 1}, normal_derivative_part(psi1, ring.inner, 0.0, 2)}, psi2);
  EXPECT_EQ(to_text(u, names),
            "transfinite(g, omega(outer), 1, psi1 - omega(inner)*D(omega(inner), psi1), "
            "omega(inner), 2) + omega(outer)*omega(inner)^2*psi2");
}

TEST(Mixed, NoPartsAreRefused) { EXPECT_THROW(mixed({}, psi1), InvalidArgument); }

}  // namespace
}  // namespace rfm
