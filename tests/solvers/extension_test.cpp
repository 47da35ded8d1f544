#include "solvers/extension.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const Field x = x_coordinate(), y = y_coordinate();

// The best approximation of a function in H1 on a disk that reaches beyond the grid lines at ±1 by
// `excess`: it cuts lenses off cells there, as thin as that and as long as its root.
struct Approximation {
  Approximation(const Field& f, double excess, int cells, int degree)
      : exact(f),
        rule(rule_for(circle({0, 0}, 1 + excess), grid_of(cells), degree)),
        spaces{TensorProductSpace(rule.grid(), degree, cells_in_region(rule))} {
    Contribution part{diffusion(2, 1.0, 1.0, f)};
    for (int axis = 0; axis < 2; ++axis) part.energy.add_load(slope(axis), partial(f, axis));
    system = assemble(structures, spaces, std::span(&part, 1), rule);
  }
  // 2 cells beyond the lines at ±1, half of them on each side.
  static Grid grid_of(int cells) {
    const double end = 1 + 2.0 / cells;
    return Grid(Box{2, {-end, -end, 0}, {end, end, 0}}, {cells + 2, cells + 2, 1});
  }
  LinearSolution plain() const { return solve(system); }
  LinearSolution extended() const {
    const SplineExtension extension(spaces, rule);
    LinearSolution solution = solve(extension.folded(system));
    solution.coefficients = extension.matrix * solution.coefficients;
    return solution;
  }
  double error(const LinearSolution& solution) const {
    return norms(solution_fields(structures, spaces, solution.coefficients)[0] - exact, rule).l2;
  }
  Field exact;
  DomainRule rule;
  std::vector<TensorProductSpace> spaces;
  std::vector<Structure> structures{Structure::undetermined()};
  LinearSystem system;
};

TEST(SplineExtension, ConditionDoesNotDependOnHowThinlyCellsAreCut) {
  const Field f = sin(2 * x + y);
  const double thick = Approximation(f, 1e-2, 10, 3).extended().smallest_eigenvalue;
  const double plainly_thick = Approximation(f, 1e-2, 10, 3).plain().smallest_eigenvalue;
  for (const double excess : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const Approximation thin(f, excess, 10, 3);
    EXPECT_GT(thin.extended().smallest_eigenvalue, 0.5 * thick) << excess;
    EXPECT_LT(thin.extended().smallest_eigenvalue, 2 * thick) << excess;
  }
  // Without it splines on a lens are nearly dependent.
  EXPECT_LT(Approximation(f, 1e-6, 10, 3).plain().smallest_eigenvalue, 1e-2 * plainly_thick);
}

TEST(SplineExtension, KeepsTheOrderOfApproximation) {
  const Field f = sin(2 * x + y) * exp(0.3 * y);
  for (const int degree : {1, 2}) {  // 3: tests/verification, annulus_inhomogeneous/extended
    const Approximation coarse(f, 1e-3, 24, degree), fine(f, 1e-3, 48, degree);
    const double order = std::log2(coarse.error(coarse.extended()) / fine.error(fine.extended()));
    EXPECT_GT(order, degree + 0.6) << degree;
    EXPECT_LT(order, degree + 1.6) << degree;
  }
}

TEST(SplineExtension, HoldsPolynomialsOfItsDegree) {
  const Field f = 1 + x - 2 * x * y + x * x * y - y * y * y;
  const Approximation cubic(f, 1e-4, 10, 3);
  EXPECT_LT(cubic.error(cubic.extended()), 1e-12);
  const Approximation quadratic(f, 1e-4, 10, 2);
  EXPECT_GT(quadratic.error(quadratic.extended()), 1e-6);
}

TEST(SplineExtension, SystemsWithoutSymmetryAreExtendedToo) {
  const Approximation own(sin(2 * x + y), 1e-3, 10, 2);
  LinearSystem whole = own.system;
  whole.matrix = SparseMatrix(own.system.matrix.selfadjointView<Eigen::Lower>());
  whole.symmetric = false;
  const SplineExtension extension(own.spaces, own.rule);
  const Eigen::VectorXd a = solve(extension.folded(whole)).coefficients;
  const Eigen::VectorXd b = solve(extension.folded(own.system)).coefficients;
  EXPECT_LT((a - b).norm(), 1e-11 * b.norm());
}

}  // namespace
}  // namespace rfm
