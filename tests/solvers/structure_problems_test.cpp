// Problems whose difficulty is in the structure: clamped plates, a singularity, materials that
// meet. Closed forms are the truth.

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/thin_set.hpp"
#include "quadrature/gauss_legendre.hpp"
#include "solution_structures/interface_conditions.hpp"
#include "solution_structures/plate_conditions.hpp"
#include "solution_structures/singular_functions.hpp"
#include "solvers/discretized_region.hpp"
#include "solvers/ritz.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;
constexpr double pi = std::numbers::pi;
const Field x = x_coordinate(), y = y_coordinate();
const Structure psi1 = Structure::undetermined(0), psi2 = Structure::undetermined(1);

// ½ (Δw)² − w, the energy of a clamped plate of unit rigidity under unit load.
QuadraticEnergy plate_energy() {
  const Slot xx{0, {2, 0}}, yy{0, {0, 2}};
  QuadraticEnergy energy;
  energy.add_stiffness(xx, xx, 1);
  energy.add_stiffness(yy, yy, 1);
  energy.add_stiffness(xx, yy, 1);
  energy.add_load(value(), 1);
  return energy;
}

TEST(ClampedPlate, DeflectionOfTheDiskAtItsCentre) {
  const DiscretizedRegion disk(circle({0, 0}, 1), {.cells = 8, .degree = 4});
  const Field omega = (1 - x * x - y * y) / 2;
  const Field w = minimize({{plate_energy()}}, clamped(omega, 0.0, 0.0, 2), disk).u;
  EXPECT_NEAR(value_at(w, {0, 0}), 1.0 / 64, 1e-10);
  EXPECT_NEAR(value_at(w, {0.3, 0.4}), 0.75 * 0.75 / 64, 1e-10);
}

TEST(ClampedPlate, DeflectionOfTheEllipseInClosedForm) {
  // w = (1 − x²/a² − y²/b²)² / (8 (3/a⁴ + 2/a²b² + 3/b⁴)), but ω is normalised: Ψ is no polynomial.
  const double a = 1, b = 0.7;
  const Region region = ellipse({0, 0}, {a, b});
  const Field f = 1 - x * x / (a * a) - y * y / (b * b);
  const double factor = 8 * (3 / std::pow(a, 4) + 2 / (a * a * b * b) + 3 / std::pow(b, 4));
  const Field exact = f * f / factor;
  double before = 0;
  for (const int cells : {16, 32}) {
    const DiscretizedRegion domain(region, {.cells = cells, .degree = 5});
    const Field omega = region.primitives()[0]->function;
    const Field w = minimize({{plate_energy()}}, clamped(omega, 0.0, 0.0, 2), domain).u;
    const double error = norms(w - exact, domain.rule()).maximum / (1 / factor);
    if (cells == 32) {
      EXPECT_LT(error, 1e-8);
      EXPECT_GT(std::log2(before / error), 5);
    }
    before = error;
  }
}

// u with its functions in `spaces`, by the energy ½ k |∇u|².
Field solved(const Structure& structure, const std::vector<TensorProductSpace>& spaces,
             const Field& k, const DomainRule& rule, const LinearSolverOptions& options = {},
             Eigen::Index* unknowns = nullptr) {
  const std::vector<Structure> u{structure};
  const std::vector<Contribution> energy{{diffusion(2, k, 0, 0)}};
  const LinearSystem system = assemble(u, spaces, energy, rule);
  if (unknowns) *unknowns = system.size();
  return solution_fields(u, spaces, solve(system, options).coefficients)[0];
}

// H. Motz's problem: −1 < x < 1, 0 < y < 1, u = 0 on y = 0 > x, u = 500 on x = 1, no flux
// elsewhere. Near the origin u = Σ a_k r^{k−½} cos (k−½)θ, a₁ = 401.1624537452.
DomainRule motz_rule(int cells, int degree) {
  QuadratureOptions options;
  options.inside_points = degree + 3;
  options.cut_points = degree + 5;
  options.gradings.emplace_back();  // towards the origin
  const RegionEvaluator plate(box({-1, 0}, {1, 1}));
  return make_domain_rule(plate, Grid({2, {-1, 0}, {1, 1}}, {2 * cells, cells, 1}), options);
}

// a₁ from the half circle of radius ½, where the cosines are orthogonal.
double first_coefficient(const Field& u) {
  const double radius = 0.5;
  const GaussRule& gauss = gauss_legendre(40);
  double sum = 0;
  for (int i = 0; i < gauss.size(); ++i) {
    const double theta = pi * gauss.nodes[i];
    const Point at{radius * std::cos(theta), radius * std::sin(theta)};
    sum += pi * gauss.weights[i] * std::cos(theta / 2) * value_at(u, at);
  }
  return 2 / pi * sum / std::sqrt(radius);
}
constexpr double motz_coefficient = 401.1624537452;

TEST(Motz, SingularFactorIsAThousandTimesBetterAtEqualUnknowns) {
  const Field s = corner_cosine({{0, 0}, 0, pi}, 0.5), r = sqrt(x * x + y * y), right = 1 - x;
  // s on x = 1, so that 500 s / s₁ is 500 there and has the singularity of s at the origin. u/s is
  // smooth + r · smooth.
  const Field s1 = sqrt((sqrt(1 + y * y) + 1) / 2);
  const DomainRule coarse = motz_rule(6, 4), fine = motz_rule(10, 4);
  const TensorProductSpace space(coarse.grid(), 4), finer(fine.grid(), 4);
  const Structure singular = 500 * s / s1 + (right * s) * (psi1 + r * psi2);
  const Field slit = segment_set({-1, 0}, {0, 0}).function;
  const Structure plain = 500 * slit / (slit + right) + (slit * right) * psi1;
  // Away from the origin r Ψ2 is nearly what Ψ1 can do.
  const LinearSolverOptions nearly_dependent{.regularization = 1e-13};
  Eigen::Index with_unknowns = 0, without_unknowns = 0;
  const Field with =
      solved(singular, {space, space}, 1.0, coarse, nearly_dependent, &with_unknowns);
  const Field without = solved(plain, {finer}, 1.0, fine, {}, &without_unknowns);
  const double error = std::fabs(first_coefficient(with) - motz_coefficient);
  const double error_without = std::fabs(first_coefficient(without) - motz_coefficient);
  EXPECT_LT(error, 1e-6 * motz_coefficient);
  EXPECT_GE(without_unknowns, with_unknowns);
  EXPECT_GT(error_without, 1000 * error);
}

// Concentric rings of two materials: u = 1 at r = 0.4, 0 at r = 1, conductivity 1 within r = 0.7
// and `ratio` outside.
double ring_error(double ratio, int cells, int degree, bool with_kink) {
  const Region region = circle({0, 0}, 1) - circle({0, 0}, 0.4);
  const RegionEvaluator interface(circle({0, 0}, 0.7));
  QuadratureOptions options;
  options.inside_points = degree + 1;
  options.cut_points = degree + 3;
  const Grid grid({2, {-1.03, -1.01}, {1.02, 1.04}}, {cells, cells, 1});
  const DomainRule rule =
      make_domain_rule(RegionEvaluator(region), grid, options, std::span(&interface.level(0), 1));
  const Field square = x * x + y * y, omega = (square - 0.49) / 1.4;
  const Field k = select(apply(Operation::less, {omega, 0.0}), 1.0, ratio);
  // Slopes of log r are as 1 : 1/ratio.
  const double scale = 1 / (std::log(0.7 / 0.4) + std::log(1 / 0.7) / ratio);
  const Field log_r = 0.5 * log(square);
  const Field exact = select(apply(Operation::less, {omega, 0.0}),
                             1 - scale * (log_r - std::log(0.4)), -(scale / ratio) * log_r);
  const Field weight = (1 - square) * (square - 0.16), g = (1 - square) / 0.84;
  const TensorProductSpace space(grid, degree, cells_in_region(rule, degree));
  const Structure u = with_kink ? g + weight * kinked(omega) : g + weight * psi1;
  std::vector<TensorProductSpace> spaces{space};
  if (with_kink) spaces.push_back(space);
  const double error = norms(solved(u, spaces, k, rule) - exact, rule).l2 / norms(exact, rule).l2;
  return error;
}

TEST(TwoMaterials, KinkTermGivesTheOrderOfTheSplines) {
  for (const double ratio : {5.0, 1000.0}) {
    const double coarse = ring_error(ratio, 16, 3, true), fine = ring_error(ratio, 32, 3, true);
    EXPECT_GT(std::log2(coarse / fine), 3);  // at least p, the other part has p + 1
    EXPECT_LT(std::log2(coarse / fine), 5);
    EXPECT_LT(fine, 2e-5);
  }
}

TEST(TwoMaterials, WithoutItTheOrderIsLost) {
  const double coarse = ring_error(5, 16, 3, false), fine = ring_error(5, 32, 3, false);
  EXPECT_LT(std::log2(coarse / fine), 2.2);
  EXPECT_GT(fine, 100 * ring_error(5, 32, 3, true));
}

}  // namespace
}  // namespace rfm
