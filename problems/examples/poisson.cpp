// −Δu = f in a disk with a hole, u = g on both circles. Region, structure, energy: as in the
// theory.

#include <cstdio>

#include "core/primitives.hpp"
#include "problems/write_fields.hpp"
#include "solution_structures/dirichlet.hpp"
#include "solvers/integrate.hpp"
#include "solvers/ritz.hpp"

int main() {
  using namespace rfm;
  const Field x = x_coordinate(), y = y_coordinate();

  // The region {ω ≥ 0}: a Boolean expression of primitives.
  const Region ring = circle({0, 0}, 1) - circle({0.2, 0.1}, 0.4);
  const DiscretizedRegion domain(ring, {.cells = 64, .degree = 3});
  const Field omega = domain.weight().function;

  // A solution to compare with. What is prescribed equals it on the circles, and only there.
  const Field exact = sin(2 * x) * exp(y);
  const Field f = -laplacian(exact, 2);
  const Field g = exact + omega * cos(3 * x + y);

  // The structure u = g + ω Ψ takes the values g on the boundary, whatever Ψ is.
  const Structure u = dirichlet(g, omega);

  // The energy ∫ ½ |∇u|² − f u, which the solution makes least.
  const Slot value{0, {}}, dx{0, unit_index(0)}, dy{0, unit_index(1)};
  QuadraticEnergy energy;
  energy.add_stiffness(dx, dx, 1);
  energy.add_stiffness(dy, dy, 1);
  energy.add_load(value, f);

  // Ψ is a spline on a square grid that does not know the circles.
  const RitzSolution solution = minimize({{energy}}, u, domain);

  const double error = norms(solution.u - exact, domain.rule()).l2 / norms(exact, domain.rule()).l2;
  std::printf("%d unknowns, area %.12f, relative error %.1e\n", domain.space().size(),
              domain.rule().measure(), error);
  write_vtu(domain, {{"u", {solution.u}}, {"gradient", gradient(solution.u, 2)}}, "poisson.vtu");
}
