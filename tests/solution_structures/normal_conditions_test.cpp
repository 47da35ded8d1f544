#include "solution_structures/normal_conditions.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/function_shaping.hpp"
#include "solution_structures/structure_text.hpp"
#include "solution_structures/verification.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Ring ring;
const Field &x = ring.x, &y = ring.y;
const Structure psi1 = Structure::undetermined(0), psi2 = Structure::undetermined(1);

// The whole boundary of the ring in one normalised function.
const Field whole = ring.outer * ring.inner / (ring.outer + ring.inner);

double deviation(const Structure& structure, const BoundaryOperator& condition, const Field& data,
                 const std::vector<Point>& points) {
  return largest_deviation({structure}, condition, data, points).largest;
}

// a u + l·∇u.
BoundaryOperator condition(const std::vector<Field>& l, const Field& a = 0.0) {
  return
      [l, a](const std::vector<Field>& u) { return product_or_nothing(a, u[0]) + along(l, u[0]); };
}

TEST(NormalConditions, NeumannHasItsSlopeOnBothCirclesForAnyUnknowns) {
  const Field slope = cos(3 * x) + y * exp(x);
  const Structure u = neumann(whole, slope, 2);
  EXPECT_LT(deviation(u, condition(ring.outer_normal), slope, ring.outer_points), 1e-12);
  EXPECT_LT(deviation(u, condition(ring.inner_normal), slope, ring.inner_points), 1e-12);
  // The inward derivative has the other sign, and the value is free.
  EXPECT_GT(deviation(u, condition({-x, -y}), slope, ring.outer_points), 0.1);
  EXPECT_GT(deviation(
                u, [](const auto& v) { return v[0]; }, 0.0, ring.outer_points),
            0.1);
}

TEST(NormalConditions, CorrectionsMayBeKeptNearTheBoundary) {
  const Field slope = cos(3 * x) + y, a = 1 + x * x, near = cutoff(ring.outer, 0.1);
  const Structure u = neumann(ring.outer, slope, 2, near);
  EXPECT_LT(deviation(u, condition(ring.outer_normal), slope, ring.outer_points), 1e-12);
  const Structure v = robin(ring.outer, {a, 1.0, slope}, 2, near);
  EXPECT_LT(deviation(v, condition(ring.outer_normal, a), slope, ring.outer_points), 1e-12);
  // Inside u is Ψ1.
  for (const Structure::Term& term : u.terms())
    EXPECT_NEAR(value_at(term.coefficient, {0.1, 0.2}),
                term.unknown == 0 && degree(term.derivative) == 0, 1e-100);
}

TEST(NormalConditions, NeumannReadsAsInTheLiterature) {
  const StructureNames names{{"omega(ring)", whole}, {"slope", sin(x)}};
  EXPECT_EQ(to_text(neumann(whole, names[1].second, 2), names),
            "psi1 - omega(ring)*(D(omega(ring), psi1) + slope) + omega(ring)^2*psi2");
}

TEST(NormalConditions, RobinHoldsWithCoefficientsThatVary) {
  const Field a = 1 + x * x, b = 2 + sin(y), c = x * y + 3;
  const Structure u = robin(whole, {a, b, c}, 2);
  const auto times_b = [&](const std::vector<Field>& n) {
    return std::vector<Field>{b * n[0], b * n[1]};
  };
  EXPECT_LT(deviation(u, condition(times_b(ring.outer_normal), a), c, ring.outer_points), 1e-12);
  EXPECT_LT(deviation(u, condition(times_b(ring.inner_normal), a), c, ring.inner_points), 1e-12);
  EXPECT_GT(deviation(u, condition(times_b({-x, -y}), a), c, ring.outer_points), 0.1);
}

TEST(NormalConditions, ObliqueHoldsAlongADirectionThatTurns) {
  // 0.6 radians from the normal, so that l·n = |l| cos 0.6 everywhere; and anisotropic flux.
  const double cosine = std::cos(0.6), sine = std::sin(0.6);
  const std::vector<Field> turned{cosine * x - sine * y, sine * x + cosine * y};
  const std::vector<Field> flux{2 * x + 0.5 * y, 0.5 * x + y};
  const Field a = 1 + y * y, c = sin(2 * x) - y;
  for (const auto& l : {turned, flux})
    for (const double length : {1.0, 0.1}) {
      const Structure u = mixed({oblique_part(psi1, ring.outer, {l, a, c, length})}, psi2);
      EXPECT_LT(deviation(u, condition(l, a), c, ring.outer_points), 1e-12);
    }
  EXPECT_THROW(oblique_part(psi1, ring.outer, {turned, a, c, 0}), InvalidArgument);
}

TEST(NormalConditions, ObliqueStaysBoundedWhereItsDirectionIsTangentialToOmega) {
  // l = (1, 0) is tangential to the level curves of the disk's function on x = 0.
  const ConditionPart part = oblique_part(psi1, ring.outer, {{1.0, 0.0}, 0.0, 1.0});
  for (const Structure::Term& term : part.polynomial.terms())
    for (double b = -0.9; b < 0.95; b += 0.1)
      EXPECT_LE(std::fabs(value_at(term.coefficient, {1e-3, b})), 1.0);
}

TEST(NormalConditions, AConditionMayBeAddedToAValueOfOnesChoice) {
  // The value on the part is g + y Ψ1 here: ∂u/∂n = h where x² + y² = 1, u = g on y = 0 still holds
  // next to it only if the correction vanished there, which is what `mixed` is for.
  const Field h = x + 2;
  const ConditionPart part = normal_derivative_part(sin(x) + y * psi1, ring.outer, h, 2);
  EXPECT_EQ(part.exponent, 2);
  EXPECT_LT(deviation(part.polynomial, condition(ring.outer_normal), h, ring.outer_points), 1e-12);
}

TEST(NormalConditions, HoldInSpace) {
  const Field z = z_coordinate(), ball = (1 - x * x - y * y - z * z) / 2, slope = x * y - z;
  const auto outward = [&](const std::vector<Field>& u) {
    return x * partial(u[0], 0) + y * partial(u[0], 1) + z * partial(u[0], 2);
  };
  std::vector<Point> points;
  for (double t = 0.1; t < 3; t += 0.3)
    for (double p = 0.2; p < 6; p += 0.7)
      points.push_back({std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)});
  const StructureTrials in_space{.dimension = 3};
  EXPECT_LT(largest_deviation({neumann(ball, slope, 3)}, outward, slope, points, in_space).largest,
            1e-11);
}

}  // namespace
}  // namespace rfm
