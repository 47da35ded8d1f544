// The unit of length does not matter: a problem whose lengths are all L times as large has the same
// solution. What is in a weight or an interpolant besides lengths, as a 1, would show.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/evaluate.hpp"
#include "problems/reader.hpp"
#include "problems/scalar_problem.hpp"

using namespace rfm;

namespace {

struct Case {
  const char* name;
  int dimension;
  /// Geometry, sets, regions, conditions, in lengths of L.
  const char* text;
  Point probe;  ///< for L = 1
  const char* physics = "{type: poisson, source: 1/L^2}";
};

std::ostream& operator<<(std::ostream& stream, const Case& one) { return stream << one.name; }

const Case cases[] = {
    {"ellipse with two cuts",
     2,
     R"(
geometry:
  shapes:
    e: {ellipse: {center: [0, 0], radii: [2*L, L], angle: 20}}
    h: {half_plane: {point: [1.2*L, 0], normal: [-1, 0]}}
    k: {half_plane: {point: [0, 0.6*L], normal: [-0.4, -1]}}
  domain: e & h & k
conditions: [{at: all, value: 0}]
)",
     {-0.9, -0.3, 0}},
    {"wire with a value",
     2,
     R"(
sets: {wire: {segment: {from: [-0.5*L, 0], to: [0.3*L, 0.2*L]}}}
geometry:
  shapes: {a: {box: {min: [-L, -L], max: [L, L]}}}
  domain: a
conditions: [{at: all, value: 0}, {at: wire, value: 1}]
)",
     {0.1, 0.5, 0}},
    {"part of a side by structure",
     2,
     R"(
geometry:
  shapes: {a: {box: {min: [0, 0], max: [L, L]}}}
  domain: a
regions: {held: {of: a.bottom, where: 0.5*L - x}}
conditions: [{at: a.top, value: 0}, {at: held, value: 1, enforce: structure}, {at: rest, flux: 0}]
)",
     {0.3, 0.5, 0}},
    {"second derivatives on several sets",
     2,
     R"(
geometry:
  shapes:
    a: {box: {min: [0, 0], max: [3*L, 2*L]}}
    h: {circle: {center: [1.2*L, 0.9*L], radius: 0.4*L}}
  domain: a - h
conditions:
  - {at: a, value: 1 + x/L, normal_derivative: cos(2*y/L)/L, second_normal_derivative: exp(x/L)/L^2}
  - {at: h, value: 2, normal_derivative: x/L^2, second_normal_derivative: 0}
)",
     {2.9, 1, 0},
     "{type: interpolation}"},
    {"data of several sets",
     2,
     R"(
geometry:
  shapes:
    e: {ellipse: {center: [0, 0], radii: [2*L, L]}}
    c: {circle: {center: [0.4*L, 0], radius: 0.3*L}}
  domain: e - c
conditions: [{at: e, value: x/L}, {at: c, value: 1}]
)",
     {-0.9, -0.3, 0}},
    {"torus with a cut",
     3,
     R"(
geometry:
  shapes:
    ring: {torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: L, tube: 0.4*L}}
    h: {half_space: {point: [0, 0, 0], normal: [1, 0.2, 0.1]}}
  domain: ring & h
conditions: [{at: all, value: 0}]
)",
     {1, 0.1, 0.1}},
    {"cone",
     3,
     R"(
geometry:
  shapes: {c: {cone: {apex: [0, 0, 0], axis: [0.1, 0.2, 1], angle: 30, length: L}}}
  domain: c
conditions: [{at: all, value: 0}]
)",
     {0.05, 0.15, 0.7}},
    {"body of revolution",
     3,
     R"(
geometry:
  profiles: {e: {ellipse: {center: [L, 0], radii: [0.5*L, 0.3*L], angle: 30}}}
  shapes: {a: {revolution: {profile: e}}}
  domain: a
conditions: [{at: all, value: 0}]
)",
     {0.9, 0.5, 0.1}},
    {"interpolant of sides and sets",
     2,
     R"(
sets: {wire: {segment: {from: [0.4*L, 0.3*L], to: [0.9*L, 0.3*L]}}}
geometry:
  shapes:
    b: {box: {min: [0, 0], max: [2*L, L]}}
    h: {circle: {center: [1.5*L, 0.5*L], radius: 0.2*L}}
  domain: b - h
conditions:
  - {at: b, value: sin(2*x/L + y/L)}
  - {at: h, value: cos(x/L), normal_derivative: 3/L, second_normal_derivative: 2/L^2}
  - {at: wire, value: x/L, normal_derivative: 2/L}
)",
     {0.6, 0.8, 0},
     "{type: interpolation}"},
};

double value_in_unit(const Case& one, double unit) {
  const std::string text = fmt::format(
      "dimension: {}\nparameters: {{L: {}}}\nphysics: {}\n"
      "discretization: {{basis: {{bspline: 2, cells: 8}}}}{}",
      one.dimension, unit, one.physics, one.text);
  const Problem file = read_problem(make_source("units.yaml", text));
  const ScalarProblem problem(file);
  const ScalarSolution solution = problem.solve(problem.grid());
  const Point at{one.probe[0] * unit, one.probe[1] * unit, one.probe[2] * unit};
  return value_at(solution.results.unknowns[0].field, at);
}

class Units : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(OfLength, Units, testing::ValuesIn(cases));

TEST_P(Units, DoNotChangeTheSolution) {
  const double expected = value_in_unit(GetParam(), 1);
  EXPECT_GT(std::fabs(expected), 1e-3);
  // Where bodies touch planes of the grid, rules depend on how they are rounded.
  const double rounding = GetParam().dimension == 2 ? 1e-8 : 2e-5;
  for (const double unit : {1e-3, 1e3, 1e6})
    EXPECT_NEAR(value_in_unit(GetParam(), unit), expected, rounding * std::fabs(expected)) << unit;
}

}  // namespace
