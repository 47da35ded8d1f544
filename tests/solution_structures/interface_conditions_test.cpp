#include "solution_structures/interface_conditions.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/evaluate.hpp"
#include "solution_structures/verification.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Field x = x_coordinate(), y = y_coordinate();
// Positive outside of the circle of radius ½.
const Field omega = x * x + y * y - 0.25;
const Field plus = 2 + x, minus = 50 + y * y, jump = sin(x) + 2, flux_jump = x * y;

// Where one side has its limits: a part of 10⁻¹³ beside the interface, for slopes of order 1.
std::vector<Point> beside(double side) { return on_circle({0, 0}, 0.5 * (1 + side * 1e-13)); }

double limit(const Structure& structure, const BoundaryOperator& what, const Point& point) {
  return value_at(what(random_solution({structure}, 2, 1)), point);
}

TEST(Interface, JumpsOfValueAndFluxAreThoseGiven) {
  const Structure u = interface_structure(omega, {plus, minus, jump, flux_jump}, 2);
  const auto value = [](const std::vector<Field>& v) { return v[0]; };
  const auto slope = [](const std::vector<Field>& v) {
    return 2 * (x * partial(v[0], 0) + y * partial(v[0], 1));
  };
  const std::vector<Point> outside = beside(1), inside = beside(-1);
  for (std::size_t i = 0; i < outside.size(); i += 7) {
    const Point& at = outside[i];
    EXPECT_NEAR(limit(u, value, at) - limit(u, value, inside[i]), value_at(jump, at), 1e-11);
    EXPECT_NEAR(
        value_at(plus, at) * limit(u, slope, at) - value_at(minus, at) * limit(u, slope, inside[i]),
        value_at(flux_jump, at), 1e-10);
  }
}

// What ω² Ψ2 adds has one second derivative on both sides.
TEST(Interface, ThirdFunctionFreesTheSecondDerivativesOfBothSides) {
  const Structure u = interface_structure(omega, {plus, minus, jump, flux_jump}, 2);
  int terms = 0;
  for (const Structure::Term& term : u.terms()) {
    if (term.unknown != 2) continue;
    ++terms;
    EXPECT_GT(value_at(term.coefficient, {0.6, 0}), 0);
    EXPECT_LT(value_at(term.coefficient, {0.4, 0}), 0);
  }
  EXPECT_EQ(terms, 1);
}

TEST(Interface, AKinkIsContinuousAndItsSlopeFree) {
  const Structure u = kinked(omega);
  const auto value = [](const std::vector<Field>& v) { return v[0]; };
  const auto slope = [](const std::vector<Field>& v) { return partial(v[0], 0); };
  const Point outside = beside(1)[3], inside = beside(-1)[3];
  EXPECT_NEAR(limit(u, value, outside), limit(u, value, inside), 1e-12);
  EXPECT_GT(std::fabs(limit(u, slope, outside) - limit(u, slope, inside)), 1e-2);
}

}  // namespace
}  // namespace rfm
