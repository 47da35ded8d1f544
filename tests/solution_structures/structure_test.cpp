#include "solution_structures/structure.hpp"

#include <gtest/gtest.h>

#include "core/evaluate.hpp"

using namespace rfm;

namespace {

const Field x = x_coordinate(), y = y_coordinate();
const Point point{0.37, -0.81, 0};

// The structure with a function of our own put in for each undetermined one.
Field with(const Structure& structure, const std::vector<Field>& functions) {
  Field u = structure.inhomogeneous();
  for (const Structure::Term& term : structure.terms())
    u = u + term.coefficient * partial(functions[term.unknown], term.derivative);
  return u;
}

const Field psi1 = 1 + x * y - pow(x, 3) + sin(2 * y), psi2 = exp(x) - y * y * x;
const Field omega = 1 - x * x - 0.5 * y * y;
const Structure first = Structure::undetermined(0), second = Structure::undetermined(1);

void expect_equal(const Structure& structure, const Field& expected) {
  const PointJet u = evaluate(with(structure, {psi1, psi2}), point, 2, 2);
  const PointJet e = evaluate(expected, point, 2, 2);
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; i + j <= 2; ++j)
      EXPECT_NEAR(u.derivative(i, j), e.derivative(i, j),
                  1e-13 * (1 + std::abs(e.derivative(i, j))))
          << i << ", " << j;
}

TEST(Structure, SumsAndProductsAreThoseOfFunctions) {
  expect_equal(x * y + omega * first - 3.0 * second, x * y + omega * psi1 - 3 * psi2);
}

TEST(Structure, PartialDerivativesFollowTheProductRule) {
  const Structure u = sin(x * y) + omega * first + (y * y) * second;
  const Field f = sin(x * y) + omega * psi1 + y * y * psi2;
  expect_equal(partial(u, 0), partial(f, 0));
  expect_equal(partial(u, 1), partial(f, 1));
}

TEST(Structure, SecondDerivativesFollowTheProductRule) {
  const Structure u = omega * first;
  const PointJet value = evaluate(with(partial(partial(u, 0), 1), {psi1, psi2}), point, 0, 2);
  EXPECT_NEAR(value.value(), evaluate(omega * psi1, point, 2, 2).derivative(1, 1), 1e-13);
}

TEST(Structure, InwardDerivativeIsTheDirectionalDerivativeAlongTheGradientOfOmega) {
  expect_equal(D(omega, x + omega * first, 2), inward_derivative(x + omega * psi1, omega, 2));
}

TEST(Structure, NeumannStructureHasTheGivenInwardDerivative) {
  // u = Ψ₁ − ω D(ω, Ψ₁) + ω q + ω² Ψ₂ with ω normalised: D(ω, u) = q on {ω = 0}; eq. (7.13).
  const Field normalized = normalize(omega, 2), q = 1 + x;
  const Structure u =
      first - normalized * D(normalized, first, 2) + normalized * q + pow(normalized, 2) * second;
  const double t = 0.6;
  const Point on_boundary{std::cos(t), std::sqrt(2.0) * std::sin(t), 0};
  const Field derivative = inward_derivative(with(u, {psi1, psi2}), normalized, 2);
  EXPECT_NEAR(value_at(derivative, on_boundary), 1 + on_boundary[0], 1e-13);
}

TEST(Structure, TermsThatCancelDisappear) {
  EXPECT_TRUE((first - first).terms().empty());
  EXPECT_EQ((omega * first + second).terms().size(), 2u);
}

TEST(Structure, DerivativeOrderCountsDerivativesOfUndeterminedFunctions) {
  EXPECT_EQ(first.derivative_order(), 0);
  EXPECT_EQ(D(omega, first, 2).derivative_order(), 1);
}

}  // namespace
