#include "solution_structures/wall_conditions.hpp"

#include <gmock/gmock.h>

#include "solution_structures/verification.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Ring ring;
const Field &x = ring.x, &y = ring.y;

BoundaryOperator component(std::size_t i) {
  return [i](const std::vector<Field>& u) { return u[i]; };
}

TEST(Displacement, ComponentsHaveTheirValuesOrAreFree) {
  const std::vector<Structure> u = displacement(ring.outer, {sin(x), {}});
  EXPECT_LT(largest_deviation(u, component(0), sin(x), ring.outer_points).largest, 1e-13);
  EXPECT_TRUE(u[1].terms()[0].coefficient.is_constant(1));
  EXPECT_EQ(u[1].unknown_count(), 2) << "of its own";
}

TEST(NormalDisplacement, HoldsOnACurvedWallAndLeavesTheTangentialOneFree) {
  const Field value = cos(3 * x) + y;
  const std::vector<Structure> u = normal_displacement(ring.inner, value, 2);
  const auto normal = [](const std::vector<Field>& v) {
    return ring.inner_normal[0] * v[0] + ring.inner_normal[1] * v[1];
  };
  const auto tangential = [](const std::vector<Field>& v) {
    return ring.inner_normal[0] * v[1] - ring.inner_normal[1] * v[0];
  };
  EXPECT_LT(largest_deviation(u, normal, value, ring.inner_points).largest, 1e-12);
  EXPECT_GT(largest_deviation(u, tangential, 0.0, ring.inner_points).largest, 0.1);
}

TEST(Symmetry, NormalDisplacementAndShearVanishOnAPlane) {
  const Field omega = 0.6 * x + 0.8 * y + 0.1;
  std::vector<Point> points;
  for (double t = -1; t < 1; t += 0.13) points.push_back({-0.06 - 0.8 * t, -0.08 + 0.6 * t});
  const std::vector<Structure> u = symmetry(omega, 2);
  const auto normal = [](const std::vector<Field>& v) { return 0.6 * v[0] + 0.8 * v[1]; };
  const auto slope = [&](const std::vector<Field>& v) {
    return inward_derivative(0.8 * v[0] - 0.6 * v[1], omega, 2);
  };
  EXPECT_LT(largest_deviation(u, normal, 0.0, points).largest, 1e-13);
  EXPECT_LT(largest_deviation(u, slope, 0.0, points).largest, 1e-12);
  EXPECT_GT(largest_deviation(normal_displacement(omega, 0.0, 2), slope, 0.0, points).largest, 0.1);
}

}  // namespace
}  // namespace rfm
