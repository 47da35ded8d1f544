#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "core/bounding_box.hpp"
#include "core/regularity.hpp"
#include "problems/boundary_conditions.hpp"
#include "problems/eigen_study.hpp"
#include "problems/natural_structure.hpp"
#include "problems/periodic_sides.hpp"
#include "problems/problem_grid.hpp"
#include "problems/problem_interfaces.hpp"
#include "problems/result_scope.hpp"
#include "problems/scalar_physics.hpp"
#include "problems/structure_options.hpp"
#include "problems/windows.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/equations.hpp"
#include "solvers/form.hpp"
#include "solvers/linear_solver.hpp"
#include "solvers/linearity.hpp"
#include "solvers/newton.hpp"

namespace rfm {

struct UserStructure;

/// The number of coefficients of functions in all of the spaces.
int coefficient_count(std::span<const TensorProductSpace> spaces);

/// Seconds of wall time spent in the stages of one solve.
struct SolveSeconds {
  double quadrature = 0, assembly = 0, solve = 0;
};

/// A solved problem on one grid. Its results are fields like any other.
struct ScalarSolution {
  DomainRule rule;
  Grid grid;  ///< that of the problem; the rule's has the lines of windows, too
  ScalarResults results;
  int unknowns = 0;  ///< coefficients
  LinearSolution linear;
  /// ½ ∫ (∇u·K∇u + reaction u²); of custom physics the energy without its loads, or nothing where
  /// there is none.
  std::optional<double> energy{};
  double boundary_residual = 0;  ///< max |u − g| over the boundary points of value conditions
  bool mean_set_to_zero = false;
  /// What residuals at points leave free, as weights of `FreeFunctions`.
  Eigen::MatrixXd free_at_points{};
  /// Where a structure has several functions, which may describe nearly the same: how large a part
  /// of u the equations leave open, relative to u in L2 (an estimate by chance).
  std::optional<double> undetermined{};
  Linearity linearity = Linearity::by_form;
  /// The steps of a nonlinear problem, and the order of convergence that they show.
  std::vector<NewtonIteration> newton{};
  std::optional<double> newton_order{};
  /// What the user should know of how it was solved.
  std::vector<std::string> notes{};
  std::optional<EigenResult> eigen{};  ///< of an eigenproblem, whose first mode is the unknown
  SolveSeconds seconds;
};

class ScalarProblem;
/// That the bounds found by the program may be larger than the domain, and by how much; or nothing.
std::string bounds_note(const ScalarProblem& problem);

/// A problem of one or several unknown functions made ready once for any number of grids: geometry,
/// coefficients, structure.
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
  /// By unknown.
  const std::vector<DirichletPlan>& dirichlet() const { return plans_; }
  const ScalarCoefficients& coefficients() const { return coefficients_; }
  /// By unknown, on a grid: corrections near the boundary are as wide as its cells.
  std::vector<Structure> structures(const Grid& grid) const;
  /// The same as text (problems/structure_language.hpp).
  std::vector<std::optional<std::string>> structure_lines(const Grid& grid) const;
  /// Where the function of the domain is zero inside it, and dangling pieces.
  const std::vector<Irregularity>& irregularities() const { return irregularities_; }
  /// Whether zeros inside are zeros of a weight, too.
  bool has_irregular_weight() const;
  /// How far the bounds that the program found may lie beyond the domain, at most; 0 where they are
  /// exact or given.
  double bounds_excess() const { return bounds_excess_; }

  /// Of undetermined functions in all structures, the unknowns' number at least.
  int function_count() const;
  int unknown_count() const { return static_cast<int>(problem_.physics.unknowns.size()); }
  const std::vector<Window>& windows() const { return windows_; }
  Grid grid(std::optional<int> cells = {}) const { return problem_grid(problem_, bounds_, cells); }
  /// Quadrature for solving: p + 1 points per axis inside, p + 3 in cut cells and on boundaries;
  /// `more_points` beyond that for measuring errors. Its grid has the lines of all windows.
  DomainRule rule(const Grid& grid, int more_points = 0) const {
    return rule(region_, grid, more_points);
  }
  /// The same over another region: a part of the domain.
  DomainRule rule(const RegionEvaluator& region, const Grid& grid, int more_points = 0) const;
  /// The splines of every unknown on the grid of a rule, and of further functions of the
  /// structures: those where their factors do not vanish. With windows all are refined
  /// (solvers/refined_splines.hpp).
  std::vector<TensorProductSpace> spaces(const DomainRule& rule) const;
  /// Throws `ComputationError` if there is no solution (incompatible Neumann data) or it cannot be
  /// computed.
  ScalarSolution solve(const Grid& grid) const;
  /// The equations of an eigenproblem, which are homogeneous, or of a steady one, linear or not, on
  /// the grid of `rule`, which must outlive them; `grid` is that of the problem.
  Equations equations(const DomainRule& rule, const Grid& grid) const;

 private:
  void plan_values(const DomainRule& probe);
  bool interpolates() const { return problem_.physics.type == PhysicsType::interpolation; }
  void plan_interpolation();
  void plan_own_structures(const std::vector<UserStructure>& own, const DomainRule& probe);
  void require_natural(const DomainRule& probe) const;
  DirichletPlan automatic_plan(int component, const DomainRule& probe,
                               const std::optional<BooleanExpression>& form) const;
  NaturalStructure natural_structure(const Grid& grid) const;
  /// By which errors of quadrature are told from what holds a function softly.
  DomainRule finer_rule(const Grid& grid) const { return rule(grid, 4); }
  /// The points of collocation: p − 1 per axis (2 at least), enough for more equations than
  /// unknowns, p on boundaries.
  DomainRule collocation_rule(const Grid& grid) const;
  std::vector<Contribution> contributions(const Grid& grid) const;
  /// Combinations of splines in which solutions are looked for; nothing: in all.
  std::optional<SplineExtraction> extraction(const std::vector<TensorProductSpace>& functions,
                                             const DomainRule& rule, const Grid& grid) const;
  std::vector<TensorProductSpace> own_spaces(const DomainRule& rule, const Grid& grid) const;
  int function_degree(int function) const;
  /// By function, where its splines are wanted.
  std::vector<std::vector<std::uint8_t>> function_cells(const DomainRule& rule) const;
  void add_windows(int& functions);
  void check_windows() const;
  bool solves_in_turn() const;
  std::vector<Eigen::Index> blocks(const SplineExtraction& extraction) const;
  LinearSystem solve_linear(const std::vector<Contribution>& parts,
                            const std::vector<TensorProductSpace>& functions, bool free_constant,
                            ScalarSolution& solution) const;
  bool is_solved(const std::vector<Form>& equations,
                 const std::vector<TensorProductSpace>& functions, const LinearSystem& system,
                 ScalarSolution& solution) const;
  void solve_forms(const std::vector<Form>& equations,
                   const std::vector<TensorProductSpace>& functions,
                   ScalarSolution& solution) const;
  void solve_at_points(const std::vector<Form>& equations,
                       const std::vector<TensorProductSpace>& functions,
                       ScalarSolution& solution) const;
  /// Least squares by normal equations, which `solve_system` solves, or where these have lost six
  /// digits by Q R: returns whether they have.
  bool solve_least_squares(const std::vector<Form>& equations,
                           const std::vector<TensorProductSpace>& functions,
                           const std::function<void()>& solve_system,
                           ScalarSolution& solution) const;
  /// Whether least squares may be solved by Q R, and whether they must.
  bool may_use_qr() const;
  bool must_use_qr() const;
  bool has_global_functions() const;
  GlobalSpaces global_spaces(const Grid& grid) const;
  void solve_global_energy(ScalarSolution& solution) const;
  void solve_global_forms(ScalarSolution& solution) const;
  void solve_eigen(ScalarSolution& solution) const;
  LinearSolverOptions linear_options() const;
  bool fixed_up_to_constant() const;
  /// Then a rule is not one for the domain.
  static bool misses_divergence_theorem(const DomainRule& rule);
  void check_within_grid(const DomainRule& rule) const;
  void check_no_robin() const;
  void check_torsion(const DomainRule& rule) const;
  void check_modes() const;
  void plan_periodic(const DomainRule& probe);
  void check_directions(const DomainRule& rule) const;
  void check_compatible(const DomainRule& rule) const;
  double stored_energy(const LinearSystem& system, const std::vector<Contribution>& parts,
                       const ScalarSolution& solution) const;
  double undetermined_part(const LinearSystem& system,
                           const std::vector<TensorProductSpace>& functions,
                           const ScalarSolution& solution, const LinearSolverOptions& options,
                           const SplineExtraction* extraction = nullptr) const;
  LinearSolution solve_determined(const LinearSystem& system,
                                  const std::vector<TensorProductSpace>& functions,
                                  ScalarSolution& solution) const;
  void add_singular_functions(const DomainRule& probe, int& functions);
  double boundary_residual(const ScalarSolution& solution) const;
  double boundary_residual(const std::vector<Field>& fields, const DomainRule& rule) const;

  const Problem& problem_;
  RegionEvaluator region_;
  Box bounds_;
  double bounds_excess_ = 0;
  ProblemInterfaces interfaces_;
  ScalarCoefficients coefficients_;
  std::vector<int> bounding_primitives_;
  std::vector<PieceCondition> conditions_;
  std::vector<DirichletPlan> plans_;
  std::vector<Irregularity> irregularities_;
  std::vector<Structure> structures_;  // without corrections for natural conditions
  std::vector<NaturalPiece> natural_;
  std::vector<PeriodicPair> periodic_;
  std::vector<Window> windows_;
  StructureOptions inner_;
  bool own_use_cells_ = false;  // structures of the user's own depend on the grid
};

}  // namespace rfm
