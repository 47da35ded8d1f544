#include "solution_structures/verification.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Field x = x_coordinate(), y = y_coordinate(), disk = (1 - x * x - y * y) / 2;
const Structure psi = Structure::undetermined(0), chi = Structure::undetermined(1);

double deviation(const Structure& structure, const Field& flux) {
  const auto normal_derivative = [](const std::vector<Field>& u) {
    return x * partial(u[0], 0) + y * partial(u[0], 1);
  };
  return largest_deviation({structure}, normal_derivative, flux, on_circle({0, 0}, 1)).largest;
}

TEST(Verification, TellsARightStructureFromWrongOnes) {
  const Field flux = cos(3 * x) + y;
  const Structure remainder = disk * disk * chi;
  EXPECT_LT(deviation(psi - disk * D(disk, psi, 2) - disk * flux + remainder, flux), 1e-13);
  EXPECT_GT(deviation(psi + disk * D(disk, psi, 2) - disk * flux + remainder, flux), 0.1) << "sign";
  EXPECT_GT(deviation(psi - disk * D(disk, psi, 2) + disk * flux + remainder, flux), 0.1) << "data";
  EXPECT_GT(deviation(psi - disk * D(disk, psi, 2) - disk * flux + disk * chi, flux), 0.1)
      << "a remainder of too low an order";
}

TEST(Verification, SaysWhereAndForWhichFunctions) {
  // u = x Ψ vanishes where x = 0 alone.
  const std::vector<Point> points{{0, 0.5}, {0.25, 0.5}, {0, 1}};
  const auto value = [](const std::vector<Field>& u) { return u[0]; };
  const StructureDeviation worst = largest_deviation({x * psi}, value, 0.0, points);
  EXPECT_EQ(worst.place, points[1]);
  EXPECT_NEAR(
      worst.largest,
      std::fabs(value_at(random_solution({x * psi}, 2, 1 + unsigned(worst.trial))[0], points[1])),
      1e-15);
}

TEST(Verification, EveryTrialPutsInFunctionsOfItsOwn) {
  const auto value = [](const std::vector<Field>& u) { return u[0]; };
  const std::vector<Point> points{{0.25, 0.5}};
  const auto alone = [&](unsigned seed) {
    return largest_deviation({psi}, value, 0.0, points, {.count = 1, .seed = seed}).largest;
  };
  std::vector<double> largest;
  for (unsigned seed = 1; seed <= 6; ++seed) largest.push_back(alone(seed));
  const auto worst = std::ranges::max_element(largest);
  const StructureDeviation all = largest_deviation({psi}, value, 0.0, points, {.count = 6});
  EXPECT_EQ(all.largest, *worst);
  EXPECT_EQ(all.trial, worst - largest.begin());
  EXPECT_GT(*worst, largest.front()) << "or the first functions decide, and nothing is tested";
}

TEST(Verification, FunctionsOfADomainAreTheSameInEveryUnit) {
  const Field f = random_function(2, 5), scaled = random_function(2, 5, {3, -2, 0}, 1000);
  EXPECT_NEAR(value_at(f, {0.3, 0.4}), value_at(scaled, {303, 398}), 1e-13);
  EXPECT_NEAR(value_at(partial(f, 0), {0.3, 0.4}), 1000 * value_at(partial(scaled, 0), {303, 398}),
              1e-12);
}

TEST(Verification, WithoutFunctionsTheDataAreLeft) {
  const auto value = [](const std::vector<Field>& u) { return u[0]; };
  const std::vector<Point> points{{0.25, 0.5}};
  EXPECT_EQ(largest_deviation({psi + 1e-9}, value, 0.0, points, {.amplitude = 0}).largest, 1e-9);
}

TEST(Verification, WhatIsNotANumberIsADeviation) {
  const auto value = [](const std::vector<Field>& u) { return u[0]; };
  EXPECT_TRUE(std::isnan(
      largest_deviation({log(x) * psi}, value, 0.0, std::vector<Point>{{-1, 0}, {2, 0}}).largest));
  EXPECT_THROW(largest_deviation({psi}, value, 0.0, {}), InvalidArgument);
}

TEST(Verification, FunctionsPutInDependOnEveryCoordinateAndOnTheSeed) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const Field f = random_function(dimension, 7);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::fabs(value_at(partial(f, axis), {0.3, 0.2, 0.1})) > 1e-3, axis < dimension);
    EXPECT_NE(value_at(f, {0.3}), value_at(random_function(dimension, 8), {0.3}));
  }
}

}  // namespace
}  // namespace rfm
