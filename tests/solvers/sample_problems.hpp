#pragma once

#include <cmath>
#include <memory>

#include "core/primitives.hpp"
#include "quadrature/domain_rule.hpp"
#include "solvers/assembly.hpp"
#include "solvers/integrand.hpp"
#include "solvers/integrate.hpp"
#include "solvers/linear_solver.hpp"
#include "solvers/solution.hpp"

/// Small problems for tests of solvers.
namespace rfm::test {

inline Slot value(int component = 0) { return {component, {}}; }
inline Slot slope(int axis, int component = 0) { return {component, unit_index(axis)}; }

/// ½ k |∇u|² + ½ r u² − f u.
inline QuadraticEnergy diffusion(int dimension, const Field& k, const Field& r, const Field& f) {
  QuadraticEnergy energy;
  for (int axis = 0; axis < dimension; ++axis) energy.add_stiffness(slope(axis), slope(axis), k);
  energy.add_stiffness(value(), value(), r);
  energy.add_load(value(), f);
  return energy;
}

/// ∂u/∂n of a field, as a coefficient on the boundary.
inline Coefficient normal_derivative(const Field& u, int dimension) {
  Coefficient flux;
  for (int axis = 0; axis < dimension; ++axis)
    flux = flux + Coefficient::normal(axis) * partial(u, axis);
  return flux;
}

/// The unit interval, square or cube.
inline Region unit_box(int dimension) { return box({0, 0, 0}, {1, 1, 1}, dimension); }

/// Vanishes on the boundary of the unit box.
inline Field unit_box_weight(int dimension) {
  Field omega = 1.0;
  for (int axis = 0; axis < dimension; ++axis)
    omega = omega * coordinate(axis) * (1.0 - coordinate(axis));
  return omega;
}

inline DomainRule rule_for(const Region& region, const Grid& grid, int degree) {
  QuadratureOptions options;
  options.inside_points = degree + 1;
  options.cut_points = degree + 3;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

/// A triangle with oblique sides, and a grid that fits none of them.
inline Region triangle() {
  return half_plane({0, 0.02}, {0.1, 1}) & half_plane({1, 0}, {-1, -0.3}) &
         half_plane({0.1, 0}, {0.8, -0.7});
}
inline Grid triangle_grid(int cells = 7) {
  return Grid({2, {-0.9, -0.2}, {1.3, 1.3}}, {cells, cells - 1, 1});
}

inline Field solve_one(const Structure& structure, const TensorProductSpace& space,
                       std::span<const Contribution> contributions, const DomainRule& rule) {
  const LinearSystem system =
      assemble(std::span(&structure, 1), std::span(&space, 1), contributions, rule);
  LinearSolverOptions options;
  options.dimension = rule.dimension();
  const LinearSolution solution = solve(system, options);
  return solution_fields(std::span(&structure, 1), std::span(&space, 1), solution.coefficients)[0];
}

}  // namespace rfm::test
