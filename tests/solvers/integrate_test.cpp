#include "solvers/integrate.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <numbers>

#include "core/error.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;
using Place = Contribution::Place;
constexpr double pi = std::numbers::pi;
const Field x = x_coordinate(), y = y_coordinate();
const Grid disk_grid({2, {-1.03, -1.01}, {1.02, 1.04}}, {17, 16, 1});

TEST(Integrate, MeasuresAndMomentsOfADisk) {
  const DomainRule rule = rule_for(circle({0, 0}, 1), disk_grid, 5);
  EXPECT_NEAR(integrate(1.0, rule), pi, 1e-13);
  EXPECT_NEAR(integrate(x * x, rule), pi / 4, 1e-13);
  EXPECT_NEAR(integrate(1.0, rule, {Place::boundary}), 2 * pi, 1e-12);
  EXPECT_NEAR(integrate(y * y, rule, {Place::boundary}), pi, 1e-12);
}

TEST(Integrate, KnowsTheOutwardNormal) {
  // On the unit circle n = (x, y): ∮ n_x x = π, ∮ n_x² n_y² = ∮ cos² sin² = π/4.
  const DomainRule rule = rule_for(circle({0, 0}, 1), disk_grid, 5);
  const Coefficient n_x = Coefficient::normal(0), n_y = Coefficient::normal(1);
  EXPECT_NEAR(integrate(n_x * x, rule, {Place::boundary}), pi, 1e-12);
  EXPECT_NEAR(integrate(n_x * n_x * n_y * n_y, rule, {Place::boundary}), pi / 4, 1e-12);
  EXPECT_THROW(integrate(n_x, rule), InvalidArgument);
}

TEST(Integrate, SelectsPiecesOfTheBoundary) {
  const DomainRule rule = rule_for(unit_box(2), disk_grid, 3);
  const std::vector<Coefficient> integrands{1.0, y, Coefficient::normal(0)};
  const auto on = [&](std::vector<int> sides) {
    return integrate(integrands, rule, {Place::boundary, std::move(sides)});
  };
  using testing::DoubleNear, testing::ElementsAre;
  // Sides of a box: x−, x+, y−, y+.
  EXPECT_THAT(on({0}),
              ElementsAre(DoubleNear(1, 1e-14), DoubleNear(0.5, 1e-14), DoubleNear(-1, 1e-14)));
  EXPECT_THAT(on({1, 3}),
              ElementsAre(DoubleNear(2, 1e-14), DoubleNear(1.5, 1e-14), DoubleNear(1, 1e-14)));
  EXPECT_NEAR(on({})[0], 4, 1e-14);
}

TEST(Integrate, GaussTheoremHoldsForAnyField) {
  const Field u = sin(2.0 * x) * exp(y) + pow(x, 3) * y;
  const DomainRule rule = rule_for(triangle(), triangle_grid(20), 6);
  EXPECT_NEAR(integrate(normal_derivative(u, 2), rule, {Place::boundary}),
              integrate(laplacian(u, 2), rule), 1e-13);
}

TEST(Integrate, IsTheSameBitByBitForAnyNumberOfThreads) {
  const DomainRule rule = rule_for(circle({0, 0}, 1), disk_grid, 5);
  const auto integral = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return integrate(exp(x) * sin(y + 0.1), rule);
  };
  EXPECT_EQ(integral(1), integral(2));
}

TEST(Integrate, NamesThePointThatIsNotFinite) {
  const DomainRule rule = rule_for(unit_box(2), disk_grid, 2);
  EXPECT_THAT([&] { integrate(log(x - 0.5), rule); },
              testing::ThrowsMessage<ComputationError>(testing::HasSubstr("at the point (")));
  EXPECT_THROW(maximum(1.0 / (x - x), rule), ComputationError);
}

TEST(Maximum, IsTakenOverTheAbsoluteValues) {
  const DomainRule rule = rule_for(unit_box(2), disk_grid, 5);
  const double inside = maximum(x - 3.0 * y, rule);
  EXPECT_LE(inside, 3);
  EXPECT_GT(inside, 2.9);
  EXPECT_NEAR(maximum(x - 3.0 * y, rule, {Place::boundary, {1}}), 2, 0.02);
  EXPECT_EQ(maximum(1.0, rule, {Place::interface}), 0);  // there are none
}

TEST(Norms, OfAProductOfSines) {
  // On the unit square: ∫ sin²(πx) sin²(πy) = 1/4, ∫ |∇|² = π²/2.
  const DomainRule rule = rule_for(unit_box(2), disk_grid, 8);
  const FieldNorms size = norms(sin(pi * x) * sin(pi * y), rule);
  EXPECT_NEAR(size.l2, 0.5, 1e-14);
  EXPECT_NEAR(size.h1_seminorm, pi / std::numbers::sqrt2, 1e-13);
  EXPECT_NEAR(size.h1(), std::sqrt(0.25 + pi * pi / 2), 1e-13);
  EXPECT_NEAR(size.maximum, 1, 1e-2);
}

}  // namespace
}  // namespace rfm
