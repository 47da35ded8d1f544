#pragma once

#include <cmath>
#include <vector>

#include "core/derivative_fields.hpp"
#include "solvers/assembly.hpp"
#include "solvers/discretized_region.hpp"
#include "solvers/integrate.hpp"
#include "solvers/linear_solver.hpp"
#include "solvers/solution.hpp"

/// How near a structure comes to a function: its completeness.
namespace rfm::test {

/// All α with |α| ≤ order in the plane.
inline std::vector<MultiIndex> derivatives_up_to(int order) {
  std::vector<MultiIndex> all;
  for (int i = 0; i <= order; ++i)
    for (int j = 0; i + j <= order; ++j)
      all.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)});
  return all;
}

/// The splines that do not vanish within `layers` cells of the boundary: where a remainder ω² Ψ is
/// needed beside what Ψ1 can do by itself.
inline TensorProductSpace near_boundary(const DiscretizedRegion& domain, int degree, int layers) {
  const Grid& grid = domain.grid();
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(grid.cell_count()), 0);
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    if (domain.rule().state(cell) != CellState::cut) continue;
    const auto at = grid.position(cell);
    for (int i = std::max(0, at[0] - layers); i <= std::min(grid.cells(0) - 1, at[0] + layers); ++i)
      for (int j = std::max(0, at[1] - layers); j <= std::min(grid.cells(1) - 1, at[1] + layers);
           ++j)
        cells[static_cast<std::size_t>(grid.number({i, j, 0}))] = 1;
  }
  return {grid, degree, cells};
}

struct Approximation {
  double error = 0;  ///< √Σ_{|α| ≤ order} ∫ (∂^α (u − f))²
  LinearSolution linear;
};

/// The function of the form `structure` that is nearest to f in H^order, by least squares over the
/// domain.
inline Approximation best_approximation(const std::vector<Structure>& structure,
                                        const std::vector<Field>& f,
                                        const DiscretizedRegion& domain,
                                        const std::vector<TensorProductSpace>& spaces, int order,
                                        const LinearSolverOptions& options = {}) {
  QuadraticEnergy distance;
  for (int c = 0; c < static_cast<int>(f.size()); ++c)
    for (const MultiIndex& alpha : derivatives_up_to(order)) {
      distance.add_stiffness({c, alpha}, {c, alpha}, 1);
      distance.add_load({c, alpha}, partial(f[static_cast<std::size_t>(c)], alpha));
    }
  const std::vector<Contribution> contributions{{distance}};
  Approximation result;
  result.linear = solve(assemble(structure, spaces, contributions, domain.rule()), options);
  const std::vector<Field> u = solution_fields(structure, spaces, result.linear.coefficients);
  Field square = 0.0;
  for (std::size_t c = 0; c < f.size(); ++c)
    for (const MultiIndex& alpha : derivatives_up_to(order)) {
      const Field difference = partial(u[c] - f[c], alpha);
      square = square + difference * difference;
    }
  result.error = std::sqrt(integrate(square, domain.rule()));
  return result;
}

}  // namespace rfm::test
