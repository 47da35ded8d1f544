#include <cmath>
#include <rfm/core/primitives.hpp>
#include <rfm/problems/write_fields.hpp>
#include <rfm/solution_structures/dirichlet.hpp>
#include <rfm/solvers/integrate.hpp>
#include <rfm/solvers/ritz.hpp>

// Torsion of a disk of radius 1, −Δu = 2 with u = 0: ∫ u = π / 4.
int main() {
  using namespace rfm;
  const DiscretizedRegion domain(circle({0, 0}, 1), {.cells = 8, .degree = 2});
  QuadraticEnergy energy;
  for (int axis : {0, 1}) energy.add_stiffness({0, unit_index(axis)}, {0, unit_index(axis)}, 1);
  energy.add_load({0, {}}, 2);
  const Field u = minimize({{energy}}, dirichlet(0, domain.weight().function), domain).u;
  write_vtu(domain, {{"u", {u}}}, "torsion.vtu");
  return std::abs(integrate(u, domain.rule()) - std::acos(-1) / 4) < 1e-9 ? 0 : 1;
}
