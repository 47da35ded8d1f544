#include "solution_structures/structure.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();
const Structure psi = Structure::undetermined(0), chi = Structure::undetermined(1);

// The structure with fields put in for its undetermined functions.
Field assembled(const Structure& structure, const std::vector<Field>& unknowns) {
  Field sum = structure.inhomogeneous();
  for (const Structure::Term& term : structure.terms())
    sum = sum + term.coefficient * partial(unknowns[term.unknown], term.derivative);
  return sum;
}

// A random polynomial of degree 4.
Field random_polynomial(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Field sum = 0.0;
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; i + j <= 4; ++j) sum = sum + uniform(generator) * pow(x, i) * pow(y, j);
  return sum;
}
const std::vector<Field> unknowns{random_polynomial(1), random_polynomial(2)};

void expect_equal(const Field& a, const Field& b) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 20; ++i) {
    const Point at{uniform(generator), uniform(generator)};
    const double expected = value_at(b, at);
    EXPECT_NEAR(value_at(a, at), expected, 2e-12 * (1 + std::fabs(expected)));
  }
}

const Field omega = 1 - x * x - 2 * y * y, g = sin(x) * exp(y);
const Structure example = g + omega * psi + sin(y) * partial(chi, 0) - x * partial(psi, 1);

TEST(Structure, TermsAreSortedAndEachPairOccursOnce) {
  const Structure sum = x * chi + partial(psi, 0) + y * chi + psi;
  ASSERT_EQ(sum.terms().size(), 3u);
  EXPECT_EQ(sum.terms()[0].unknown, 0);
  EXPECT_EQ(sum.terms()[0].derivative, MultiIndex{});
  EXPECT_EQ(sum.terms()[1].unknown, 0);
  EXPECT_EQ(sum.terms()[1].derivative, unit_index(0));
  EXPECT_EQ(sum.terms()[2].unknown, 1);
  expect_equal(sum.terms()[2].coefficient, x + y);
}

TEST(Structure, TermsThatVanishAreDropped) {
  EXPECT_TRUE((psi - psi).terms().empty());
  EXPECT_TRUE((Field(0.0) * example).terms().empty());
  EXPECT_TRUE(Structure(g).terms().empty());
}

TEST(Structure, DerivativeOrderIsTheHighestOfAnyTerm) {
  EXPECT_EQ(psi.derivative_order(), 0);
  EXPECT_EQ(example.derivative_order(), 1);
  EXPECT_EQ(partial(example, {1, 1}).derivative_order(), 3);
  EXPECT_EQ(Structure(g).derivative_order(), 0);
}

TEST(Structure, IsALinearSpaceOverFields) {
  const Field u = assembled(example, unknowns), v = assembled(y + chi, unknowns);
  expect_equal(assembled(example + (y + chi), unknowns), u + v);
  expect_equal(assembled(example - (y + chi), unknowns), u - v);
  expect_equal(assembled(-example, unknowns), -u);
  expect_equal(assembled(exp(x) * example, unknowns), exp(x) * u);
  expect_equal(assembled(2.0 + psi, unknowns), 2.0 + unknowns[0]);
}

TEST(Structure, PartialDerivativesFollowTheProductRule) {
  // The jets of the assembled expression know nothing of structures.
  const Field u = assembled(example, unknowns);
  for (int axis = 0; axis < 2; ++axis)
    expect_equal(assembled(partial(example, axis), unknowns), partial(u, axis));
  expect_equal(assembled(partial(example, {2, 0}), unknowns), partial(u, {2, 0}));
  expect_equal(assembled(partial(example, {1, 1}), unknowns), partial(u, {1, 1}));
}

TEST(Structure, DIsTheDerivativeAlongTheGradientOfOmega) {
  const Field u = assembled(example, unknowns);
  expect_equal(assembled(D(omega, example, 2), unknowns), inward_derivative(u, omega, 2));
}

// Largest |∂u/∂n − flux| on the unit circle, for u with undetermined functions put in.
double largest_defect(const Structure& structure, const Field& normalized, const Field& flux) {
  const Field defect = inward_derivative(assembled(structure, unknowns), normalized, 2) - flux;
  double largest = 0;
  for (double t = 0; t < 6.28; t += 0.1)
    largest = std::max(largest, std::fabs(value_at(defect, {std::cos(t), std::sin(t)})));
  return largest;
}

TEST(Structure, NeumannStructureHasItsFluxForAnyUnknowns) {
  // Ψ₁ − ω D(Ψ₁) + ω h + ω² Ψ₂ with normalised ω: ∂u/∂ν = h along the inward normal.
  const Field disk = (1 - x * x - y * y) / 2, flux = cos(3 * x) + y;
  const auto neumann = [&](double sign) {
    return psi - sign * disk * D(disk, psi, 2) + disk * flux + disk * disk * chi;
  };
  EXPECT_LT(largest_defect(neumann(1), disk, flux), 1e-13);
  // A wrong sign is seen: the test can fail.
  EXPECT_GT(largest_defect(neumann(-1), disk, flux), 0.1);
}

}  // namespace
}  // namespace rfm
