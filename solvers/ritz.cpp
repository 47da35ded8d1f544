#include "solvers/ritz.hpp"

#include "solvers/assembly.hpp"
#include "solvers/solution.hpp"

namespace rfm {

RitzSolution minimize(const std::vector<Contribution>& energy, const Structure& structure,
                      const DiscretizedRegion& domain) {
  const std::vector<Structure> structures{structure};
  const std::vector<TensorProductSpace> spaces{domain.space()};
  LinearSolverOptions options;
  options.dimension = domain.dimension();
  RitzSolution solution;
  solution.linear = solve(assemble(structures, spaces, energy, domain.rule()), options);
  solution.u = solution_fields(structures, spaces, solution.linear.coefficients)[0];
  return solution;
}

}  // namespace rfm
