#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bounding_box.hpp"
#include "core/regularity.hpp"
#include "problems/boundary_conditions.hpp"
#include "problems/scalar_physics.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/linear_solver.hpp"

namespace rfm {

/// The background grid of a problem: `cells` along the longest side where given, else as the file
/// says (`discretization.grid`, `.basis.cells`, `.basis.size`).
Grid problem_grid(const Problem& problem, const Box& bounds, std::optional<int> cells = {});

/// Seconds of wall time spent in the stages of one solve.
struct SolveSeconds {
  double quadrature = 0, assembly = 0, solve = 0;
};

/// A solved scalar problem on one grid. `u` is a field like any other.
struct ScalarSolution {
  DomainRule rule;
  Field u;
  std::vector<Field> flux;  ///< +K ∇u
  int unknowns = 0;
  LinearSolution linear;
  double energy = 0;             ///< ½ ∫ (∇u·K∇u + reaction u²)
  double boundary_residual = 0;  ///< max |u − g| over the boundary points of value conditions
  bool mean_set_to_zero = false;
  SolveSeconds seconds;
};

/// A scalar problem made ready once for any number of grids: geometry, coefficients, structure.
///
///     ScalarProblem scalar(problem);
///     ScalarSolution solution = scalar.solve(scalar.grid());
class ScalarProblem {
 public:
  /// Throws `ProblemFileErrors` where conditions do not fit the boundary or the domain is empty or
  /// unbounded.
  explicit ScalarProblem(const Problem& problem);

  const Problem& problem() const { return problem_; }
  const RegionEvaluator& region() const { return region_; }
  const Box& bounds() const { return bounds_; }
  const std::vector<int>& bounding_primitives() const { return bounding_primitives_; }
  const std::vector<PieceCondition>& conditions() const { return conditions_; }
  const DirichletPlan& dirichlet() const { return plan_; }
  const ScalarCoefficients& coefficients() const { return coefficients_; }
  const Structure& structure() const { return structure_; }
  /// Where the function of the domain is zero inside it, and dangling pieces.
  const std::vector<Irregularity>& irregularities() const { return irregularities_; }

  Grid grid(std::optional<int> cells = {}) const { return problem_grid(problem_, bounds_, cells); }
  /// Quadrature for solving: p + 1 points per axis inside, p + 3 in cut cells and on boundaries;
  /// `more_points` beyond that for measuring errors.
  DomainRule rule(const Grid& grid, int more_points = 0) const {
    return rule(region_, grid, more_points);
  }
  /// The same over another region: a part of the domain.
  DomainRule rule(const RegionEvaluator& region, const Grid& grid, int more_points = 0) const;
  /// Throws `ComputationError` if there is no solution (incompatible Neumann data) or it cannot be
  /// computed.
  ScalarSolution solve(const Grid& grid) const;

 private:
  std::vector<Contribution> contributions(const Grid& grid) const;
  bool fixed_up_to_constant() const;
  void check_within_grid(const DomainRule& rule) const;
  void check_no_robin() const;
  void check_compatible(const DomainRule& rule) const;
  double stored_energy(const LinearSystem& system, const std::vector<Contribution>& parts,
                       const ScalarSolution& solution) const;

  const Problem& problem_;
  RegionEvaluator region_;
  Box bounds_;
  std::vector<LevelFunction> interfaces_;
  ScalarCoefficients coefficients_;
  std::vector<int> bounding_primitives_;
  std::vector<PieceCondition> conditions_;
  DirichletPlan plan_;
  std::vector<Irregularity> irregularities_;
  Structure structure_;
};

}  // namespace rfm
