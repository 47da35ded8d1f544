#include "solution_structures/plate_conditions.hpp"

#include <gmock/gmock.h>

#include "solution_structures/normal_conditions.hpp"
#include "solution_structures/verification.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Ring ring;
const Field &x = ring.x, &y = ring.y;
const Field deflection = sin(2 * x) * y + 1, rotation = cos(y) - x, moment = x * y + 2;
const Structure psi1 = Structure::undetermined(0), psi2 = Structure::undetermined(1);
const Field whole = ring.outer * ring.inner / (ring.outer + ring.inner);

BoundaryOperator value() {
  return [](const std::vector<Field>& u) { return u[0]; };
}
BoundaryOperator slope(const std::vector<Field>& normal) {
  return [normal](const std::vector<Field>& u) { return along(normal, u[0]); };
}
// nᵢ nⱼ ∂ᵢ∂ⱼ u with a normal that knows nothing of ω.
Field curvature(const std::vector<Field>& n, const Field& u) {
  return n[0] * n[0] * partial(u, {2, 0}) + 2 * n[0] * n[1] * partial(u, {1, 1}) +
         n[1] * n[1] * partial(u, {0, 2});
}
double deviation(const Structure& structure, const BoundaryOperator& condition, const Field& data,
                 const std::vector<Point>& points) {
  return largest_deviation({structure}, condition, data, points).largest;
}

TEST(Clamped, DeflectionAndRotationHoldForAnyUnknown) {
  const Structure w = clamped(whole, deflection, rotation, 2);
  EXPECT_LT(deviation(w, value(), deflection, ring.outer_points), 1e-13);
  EXPECT_LT(deviation(w, value(), deflection, ring.inner_points), 1e-13);
  EXPECT_LT(deviation(w, slope(ring.outer_normal), rotation, ring.outer_points), 1e-12);
  EXPECT_LT(deviation(w, slope(ring.inner_normal), rotation, ring.inner_points), 1e-12);
}

TEST(Clamped, TheDeflectionMustBeNormalised) {
  const Structure without = deflection - ring.outer * rotation + pow(ring.outer, 2) * psi1;
  EXPECT_GT(deviation(without, slope(ring.outer_normal), rotation, ring.outer_points), 0.1);
}

TEST(SecondDerivative, HoldsOnACurvedBoundaryBesideAValue) {
  const Structure u =
      mixed({second_derivative_part(deflection + ring.outer * psi1, ring.outer, moment, 2)}, psi2);
  EXPECT_LT(deviation(u, value(), deflection, ring.outer_points), 1e-13);
  EXPECT_LT(deviation(
                u, [](const auto& v) { return curvature(ring.outer_normal, v[0]); }, moment,
                ring.outer_points),
            1e-11);
}

TEST(SecondDerivative, IsAlongTheStraightNormalAndNotTheIteratedOne) {
  // On the unit circle ω = (1 − r²)/2 gives D(ω, D(ω, u)) = u_rr + u_r.
  const Field u = exp(x) * y;
  const Field straight = second_normal_derivative(u, ring.outer, 2);
  const Field iterated = inward_derivative(inward_derivative(u, ring.outer, 2), ring.outer, 2);
  const Field radial = curvature(ring.outer_normal, u);
  EXPECT_LT(largest_deviation({straight - radial}, value(), 0.0, ring.outer_points).largest, 1e-13);
  EXPECT_GT(largest_deviation({iterated - radial}, value(), 0.0, ring.outer_points).largest, 0.1);
}

TEST(SimplySupported, DeflectionAndMomentHoldOnCurvedEdges) {
  const double poisson_ratio = 0.3;
  for (const auto& [omega, normal, points] :
       {std::tuple(ring.outer, ring.outer_normal, ring.outer_points),
        std::tuple(ring.inner, ring.inner_normal, ring.inner_points)}) {
    const auto moment_of = [&, n = normal](const std::vector<Field>& v) {
      const Field across = curvature(n, v[0]);
      return -across - poisson_ratio * (laplacian(v[0], 2) - across);
    };
    const SupportData data{deflection, moment, poisson_ratio};
    for (const Structure& w : {mixed({simply_supported_part(omega, data, 2, psi1)}, psi2),
                               simply_supported(omega, data, 2)}) {
      EXPECT_EQ(w.unknown_count(), 2);
      EXPECT_LT(deviation(w, value(), deflection, points), 1e-13);
      EXPECT_LT(deviation(w, moment_of, moment, points), 1e-10);
    }
  }
}

TEST(PlateConditions, OfDifferentKindsMayBeMixed) {
  const ConditionPart supported = simply_supported_part(ring.inner, {deflection, moment}, 2, psi1);
  const Structure w = mixed({clamped_part(ring.outer, deflection, rotation, 2), supported}, psi2);
  EXPECT_LT(deviation(w, value(), deflection, ring.inner_points), 1e-12);
  EXPECT_LT(deviation(w, slope(ring.outer_normal), rotation, ring.outer_points), 1e-10);
  EXPECT_LT(deviation(
                w, [](const auto& v) { return normal_moment(v[0], ring.inner, 0.3, 2); }, moment,
                ring.inner_points),
            1e-9);
}

}  // namespace
}  // namespace rfm
