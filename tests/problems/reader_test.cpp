#include "problems/reader.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/evaluate.hpp"
#include "core/tape.hpp"
#include "problems/resolved_document.hpp"
#include "problems/result_scope.hpp"

using namespace rfm;
using testing::ElementsAre;

namespace {

constexpr const char* plate = R"yaml(
rfm: 1
title: Plate with a hole, heated from below
dimension: 2
parameters: {r: d / 2, d: 0.5, k: 45}
fields: {profile: "bump(x, 1.5) * bump(y, 0.5)", outward: n.x}
functions:
  bump(s, middle): exp(-(s - middle)^2 / 0.02)
geometry:
  shapes:
    plate: {box: {min: [0, 0], max: [2, 1]}}
    hole: {circle: {center: [0.7, "2*r"], radius: r}}
    roof: {expression: "0.9 + 0.1*sin(3*x) - y"}
    insert: {circle: {center: [1.5, 0.3], radius: 0.1}}
  domain: (plate & roof) - hole
regions:
  warm_wall: {of: plate.left, where: "y - 0.5"}
physics:
  type: heat
  conductivity: k
  source: 100*profile
  materials:
    - {in: insert, conductivity: [[2, 0], [0, "1 + x"]]}
conditions:
  - {at: plate.bottom, value: 350}
  - {at: hole, convection: {coefficient: 25, ambient: 290}, enforce: weak}
  - {at: warm_wall, flux: -10*n.x, priority: 2}
  - {at: rest, robin: {a: 1, b: 2, c: x}}
discretization:
  basis: {bspline: 2, cells: [16, 8]}
  grid: {min: [-0.1, -0.2], max: [2.1, 1.2]}
  quadrature: {order: 5}
  solver: {linear: direct, threads: 2}
probes:
  centre: {point: [1, 0.6], value: [u, grad(u), "grad(u)[1]"]}
  cut: {line: [[0, 0.1], [2, 0.1]], points: 11, value: {temperature: u, slope: dx(u)}}
  heat_in: {integral: flux.n, over: plate.bottom}
  mean: {average: u, over: insert}
  hottest: {max: u}
verify:
  exact: {u: x^2 + k}
  expect:
    - {quantity: probes.centre.u, value: 2*k, relative_tolerance: 1e-4}
  convergence: {cells: [16, 32], order: {L2: [2.8, 3.2]}, minimum_order: {H1: 1.8}}
outputs: {fields: [u, profile], vtu: {resolution: 64}, picture: true}
)yaml";

Problem read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return read_problem(make_source("plate.yaml", text), overrides);
}

double value(const Field& field, const Point& point = {0.3, 0.4}) { return value_at(field, point); }

std::vector<std::string> messages(const std::string& text,
                                  const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> messages;
  try {
    read(text, overrides);
  } catch (const ProblemFileErrors& errors) {
    for (const Mistake& mistake : errors.mistakes)
      messages.push_back(mistake.place.text() + ": " + mistake.message);
  }
  return messages;
}

}  // namespace

TEST(ReadProblem, ParametersMayUseEachOtherInAnyOrder) {
  const Problem problem = read(plate);
  EXPECT_EQ(problem.title, "Plate with a hole, heated from below");
  EXPECT_EQ(problem.dimension, 2);
  EXPECT_EQ(problem.parameters,
            (std::map<std::string, double>{{"d", 0.5}, {"k", 45}, {"r", 0.25}}));
}

TEST(ReadProblem, ShapesHaveTheirSidesAndTheDomainItsPrimitives) {
  const Problem problem = read(plate);
  std::vector<std::string> names;
  for (const auto& primitive : problem.domain->primitives()) names.push_back(primitive->name);
  EXPECT_THAT(
      names, ElementsAre("plate.left", "plate.right", "plate.bottom", "plate.top", "roof", "hole"));
  const RegionEvaluator domain(*problem.domain);
  EXPECT_TRUE(domain.contains(Point{0.1, 0.1}));
  EXPECT_FALSE(domain.contains(Point{0.7, 0.5}));   // the hole, of radius 0.25
  EXPECT_TRUE(domain.contains(Point{0.96, 0.5}));   // beside it
  EXPECT_FALSE(domain.contains(Point{1.6, 0.85}));  // above the roof
  EXPECT_TRUE(std::holds_alternative<AutomaticRule>(problem.combine.rule));
  EXPECT_FALSE(problem.bounds);
}

TEST(ReadProblem, CoefficientsAreFieldsAndMatrices) {
  const Problem problem = read(plate);
  EXPECT_EQ(problem.physics.type, PhysicsType::heat);
  EXPECT_EQ(value(problem.physics.coefficients.at("conductivity").entries[0]), 45);
  const double bumps =
      std::exp(-(0.3 - 1.5) * (0.3 - 1.5) / 0.02) * std::exp(-(0.4 - 0.5) * (0.4 - 0.5) / 0.02);
  EXPECT_NEAR(value(problem.physics.coefficients.at("source").entries[0]), 100 * bumps,
              1e-14 * bumps);
  EXPECT_EQ(value(problem.physics.coefficients.at("density").entries[0]), 1);
  ASSERT_EQ(problem.physics.materials.size(), 1u);
  const Material& insert = problem.physics.materials[0];
  EXPECT_TRUE(RegionEvaluator(*insert.region).contains(Point{1.5, 0.25}));
  const PhysicalCoefficient& conductivity = insert.coefficients.at("conductivity");
  EXPECT_TRUE(conductivity.is_matrix);
  EXPECT_EQ(value(conductivity.entries[0]), 2);
  EXPECT_EQ(value(conductivity.entries[1]), 0);
  EXPECT_EQ(value(conductivity.entries[3]), 1.3);
}

TEST(ReadProblem, ConditionsNamePiecesOfTheBoundary) {
  const Problem problem = read(plate);
  ASSERT_EQ(problem.conditions.size(), 4u);
  const Condition& value_condition = problem.conditions[0];
  EXPECT_EQ(value_condition.kind, Condition::Kind::value);
  EXPECT_THAT(value_condition.targets[0].pieces, ElementsAre("plate.bottom"));
  EXPECT_EQ(value(value_condition.data.at("u").field(problem.scope)), 350);
  EXPECT_EQ(value_condition.enforcement, Condition::Enforcement::automatic);

  const Condition& convection = problem.conditions[1];
  EXPECT_EQ(convection.kind, Condition::Kind::convection);
  EXPECT_EQ(convection.enforcement, Condition::Enforcement::weak);
  EXPECT_EQ(value(convection.data.at("ambient").field(problem.scope)), 290);

  const Condition& flux = problem.conditions[2];
  EXPECT_THAT(flux.targets[0].pieces, ElementsAre("plate.left"));
  EXPECT_EQ(flux.targets[0].name, "warm_wall");
  EXPECT_NEAR(value(*flux.targets[0].where), 0.4 - 0.5, 1e-16);
  EXPECT_EQ(flux.priority, 2);
  // The normal has a meaning on the boundary only.
  EXPECT_THROW(flux.data.at("flux").field(problem.scope), ProblemFileErrors);
  ExpressionScope boundary = problem.scope;
  define_normal(boundary, {Field(-1.0), Field(0.0)});
  EXPECT_EQ(value(flux.data.at("flux").field(boundary)), 10);

  EXPECT_EQ(problem.conditions[3].targets[0].kind, BoundaryTarget::Kind::rest);
  EXPECT_EQ(value(problem.conditions[3].data.at("c").field(problem.scope)), 0.3);
}

TEST(ReadProblem, DiscretizationHasTheFilesChoices) {
  const Discretization discretization = read(plate).discretization;
  EXPECT_EQ(discretization.degree, 2);
  EXPECT_THAT(discretization.cells, ElementsAre(16, 8));
  EXPECT_FALSE(discretization.cell_size);
  EXPECT_EQ(discretization.grid->low[1], -0.2);
  EXPECT_EQ(discretization.grid->high[0], 2.1);
  EXPECT_EQ(discretization.quadrature_order, 5);
  EXPECT_EQ(discretization.linear_solver, Discretization::LinearSolver::direct);
  EXPECT_EQ(discretization.tolerance, 1e-12);
  EXPECT_EQ(discretization.threads, 2);
}

TEST(ReadProblem, ProbesKeepTheirTextsAndWaitForResults) {
  const Problem problem = read(plate);
  ASSERT_EQ(problem.probes.size(), 5u);
  const Probe& centre = problem.probes[0];
  EXPECT_EQ(centre.kind, Probe::Kind::point);
  EXPECT_EQ(centre.values[1].first, "grad(u)");
  ExpressionScope scope = problem.scope;
  const Field u = x_coordinate() * y_coordinate();
  const ScalarResults results{{{"u", u}}, gradient(u, 2), 2};
  define_results(scope, results);
  const ExpressionValue slope = centre.values[1].second.value(scope);
  ASSERT_TRUE(slope.is_vector);
  EXPECT_EQ(value(slope.components[0]), 0.4);
  EXPECT_EQ(value(centre.values[2].second.field(scope)), 0.3);

  const Probe& cut = problem.probes[1];
  EXPECT_EQ(cut.kind, Probe::Kind::line);
  EXPECT_EQ(cut.point_count, 11);
  EXPECT_EQ(cut.points[1][0], 2);
  EXPECT_EQ(cut.values[1].first, "slope");

  const Probe& heat = problem.probes[2];
  EXPECT_EQ(heat.over, Probe::Over::boundary);
  EXPECT_THAT(heat.boundary->pieces, ElementsAre("plate.bottom"));
  define_boundary_results(scope, results, {Field(0.0), Field(-1.0)});
  EXPECT_NEAR(value(heat.values[0].second.field(scope)), -0.3, 1e-16);

  EXPECT_EQ(problem.probes[3].over, Probe::Over::shape);
  EXPECT_TRUE(RegionEvaluator(*problem.probes[3].region).contains(Point{1.5, 0.3}));
  EXPECT_EQ(problem.probes[4].over, Probe::Over::domain);
}

TEST(ReadProblem, VerificationAndOutputs) {
  const Problem problem = read(plate);
  EXPECT_EQ(value(problem.verification.exact.at("u")), 0.09 + 45);
  ASSERT_EQ(problem.verification.expectations.size(), 1u);
  EXPECT_EQ(problem.verification.expectations[0].value, 90);
  EXPECT_FALSE(problem.verification.expectations[0].tolerance);
  const ConvergenceCheck& convergence = *problem.verification.convergence;
  EXPECT_THAT(convergence.cells, ElementsAre(16, 32));
  ASSERT_EQ(convergence.orders.size(), 2u);
  EXPECT_EQ(convergence.orders[0].norm, "L2");
  EXPECT_EQ(convergence.orders[0].most, 3.2);
  EXPECT_EQ(convergence.orders[1].least, 1.8);
  EXPECT_FALSE(convergence.orders[1].most);
  EXPECT_THAT(problem.outputs.fields, ElementsAre("u", "profile"));
  EXPECT_EQ(problem.outputs.resolution, 64);
  EXPECT_TRUE(problem.outputs.picture);
}

constexpr const char* disk = R"yaml(
dimension: 2
geometry:
  shapes:
    disk: {circle: {center: [0, 0], radius: 1}}
  domain: disk
physics: {type: poisson}
conditions: [{at: disk, value: 0}]
)yaml";

TEST(ReadProblem, AShortFileHasGoodDefaults) {
  const Problem problem = read(disk);
  EXPECT_EQ(problem.discretization.degree, 3);
  EXPECT_THAT(problem.discretization.cells, ElementsAre(64));
  EXPECT_EQ(value(problem.physics.coefficients.at("diffusivity").entries[0]), 1);
  EXPECT_EQ(value(problem.physics.coefficients.at("source").entries[0]), 0);
  EXPECT_THAT(problem.outputs.fields, testing::IsEmpty());
  EXPECT_FALSE(problem.outputs.picture);
  EXPECT_FALSE(problem.verification.convergence);
  EXPECT_TRUE(problem.probes.empty());
}

TEST(ReadProblem, OverridesReachEveryKey) {
  const Problem problem =
      read(disk, {"parameters.k=3", "physics.source=k*x", "conditions.0.value=k",
                  "geometry.shapes.disk.circle.radius=2", "discretization.basis.size=0.25"});
  EXPECT_NEAR(value(problem.physics.coefficients.at("source").entries[0]), 0.9, 1e-15);
  EXPECT_EQ(value(problem.conditions[0].data.at("u").field(problem.scope)), 3);
  EXPECT_TRUE(RegionEvaluator(*problem.domain).contains(Point{1.9, 0}));
  EXPECT_EQ(problem.discretization.cell_size, 0.25);
  EXPECT_TRUE(problem.discretization.cells.empty());
}

TEST(ReadProblem, OmegaIsTheFunctionOfAShape) {
  const Problem problem = read(disk, {"fields.d=omega(disk)", "physics.source=d + omega(domain)"});
  // (1 − |x|²)/2 of the circle, twice.
  const double expected = 1 - (0.09 + 0.16);
  EXPECT_NEAR(value(problem.physics.coefficients.at("source").entries[0]), expected, 1e-15);
  EXPECT_NEAR(value(to_field(Expression("omega(disk)"), problem.scope)), expected / 2, 1e-15);
}

TEST(ReadProblem, AShapeMayBeMadeOfOthersAndOfTheirFunctions) {
  const Problem problem = read(
      disk, {"geometry.shapes.half.half_plane={point: [0, 0], normal: [1, 0]}",
             "geometry.shapes.right.combine=disk & half",
             "geometry.shapes.core.expression=omega(disk) - 0.375", "geometry.domain=right - core",
             "conditions=[{at: right, value: 0}, {at: core, flux: 0}]"});
  EXPECT_THAT(problem.conditions[0].targets[0].pieces, ElementsAre("disk", "half"));
  const RegionEvaluator domain(*problem.domain);
  EXPECT_TRUE(domain.contains(Point{0.6, 0}));
  EXPECT_FALSE(domain.contains(Point{-0.6, 0}));
  EXPECT_FALSE(domain.contains(Point{0.4, 0}));  // omega = 0.375 on the circle of radius 1/2
}

TEST(ReadProblem, AnEllipseIsTurnedByDegreesCounterClockwise) {
  const Problem problem =
      read(disk, {"geometry.shapes.disk={ellipse: {center: [1, 0], radii: [2, 1], angle: 30}}"});
  const RegionEvaluator domain(*problem.domain);
  const double cosine = std::sqrt(3.0) / 2, sine = 0.5;
  for (const double along : {1.99, 2.01})
    EXPECT_EQ(domain.contains(Point{1 + along * cosine, along * sine}), along < 2);
  for (const double across : {0.99, 1.01})
    EXPECT_EQ(domain.contains(Point{1 - across * sine, across * cosine}), across < 1);
}

TEST(ReadProblem, AProbeOverAShapeThatBoundsTheDomainIsOverItsBoundary) {
  const Problem problem = read(disk, {"probes={a: {integral: u, over: disk}, b: {integral: flux.n, "
                                      "over: boundary}}"});
  EXPECT_EQ(problem.probes[0].over, Probe::Over::boundary);
  EXPECT_THAT(problem.probes[0].boundary->pieces, ElementsAre("disk"));
  EXPECT_EQ(problem.probes[1].boundary->kind, BoundaryTarget::Kind::all);
}

TEST(ReadProblem, AnArgumentHidesAParameterOfTheSameName) {
  const Problem problem = read(disk, {"functions={f(k): k + 1}", "parameters={k: f(2)}"});
  EXPECT_EQ(problem.parameters.at("k"), 3);
}

TEST(ReadProblem, OneMistakeInADefinitionIsReportedOnce) {
  EXPECT_THAT(messages(disk, {"parameters.a=1 +", "physics.source=a*2", "conditions.0.value=a"}),
              ElementsAre("--set parameters.a=1 +: expected a number, a name or '(' but found the "
                          "end"));
  EXPECT_THAT(messages(disk, {"fields.f=2*missing", "physics.source=f", "conditions.0.value=f"}),
              ElementsAre("--set fields.f=2*missing: unknown name 'missing'"));
  EXPECT_THAT(messages(disk, {"geometry.shapes.disk.circle.radius=0"}),
              ElementsAre("--set geometry.shapes.disk.circle.radius=0: expected a number greater "
                          "than 0 but found 0"));
}

TEST(ReadProblem, WhatIsNotSupportedYetIsNeverIgnored) {
  for (const char* override_text :
       {"units={length: mm}", "sweep={r: [1, 2]}", "points=[{at: [0, 0], value: 1}]",
        "discretization.refine=[{where: x}]", "discretization.accuracy={target: 1e-3}",
        "study={type: transient, to: 1, step: 0.1}", "cracks=[{on: p, tip: [0, 0]}]",
        "include=[a.yaml]", "probes={p: {point: [0, 0], value: u, at_times: [1]}}"}) {
    const std::vector<std::string> found = messages(disk, {override_text});
    EXPECT_THAT(found, testing::Each(testing::HasSubstr("is not supported yet"))) << override_text;
    EXPECT_FALSE(found.empty()) << override_text;
  }
}

TEST(ReadProblem, TheResolvedFileIsTheSameProblem) {
  const Problem problem = read(plate, {"parameters.k=7"});
  const std::string resolved = document_text(problem.document);
  const Problem again = read_problem(make_source("input.resolved.yaml", resolved));
  EXPECT_EQ(again.parameters.at("k"), 7);
  EXPECT_EQ(again.conditions.size(), problem.conditions.size());
  EXPECT_EQ(document_text(again.document), resolved);
  EXPECT_THAT(resolved, testing::HasSubstr("tolerance: 1e-12"));  // a default
}

TEST(ReadProblem, HostileFilesAreMistakesAndNotCrashes) {
  std::string chain = disk;
  chain += "parameters:\n  p0: 1\n";
  for (int i = 1; i < 3000; ++i)
    chain += "  p" + std::to_string(i) + ": p" + std::to_string(i - 1) + " + 1\n";
  EXPECT_EQ(read(chain).parameters.at("p2999"), 3000);

  std::string shapes =
      "dimension: 2\nphysics: {type: poisson}\nconditions: [{at: all, value: 0}]\n"
      "geometry:\n  domain: s2999\n  shapes:\n"
      "    s0: {circle: {center: [0, 0], radius: 1}}\n";
  for (int i = 1; i < 3000; ++i)
    shapes += "    s" + std::to_string(i) + ": {combine: s" + std::to_string(i - 1) + "}\n";
  EXPECT_FALSE(messages(shapes).empty());

  std::string wrong = disk;
  for (int i = 0; i < 20'000; ++i) wrong += "k" + std::to_string(i) + ": 1\n";
  EXPECT_GE(messages(wrong).size(), 100u);
}

TEST(Reader, FormulasOfAFileMayKeepTheirParametersAndChangeThem) {
  const Problem problem = read(plate);
  const Expression formula("k*x*r + profile");
  const Point point{1.2, 0.4};
  const double numbers = value_at(to_field(formula, problem.scope), point);
  ExpressionScope scope = problem.scope;
  scope.keep_parameters();
  const Tape tape({to_field(formula, scope)}, {0}, 2);
  Parameters parameters = scope.parameters();
  EXPECT_DOUBLE_EQ(tape.value(point, 0, {0, parameters}), numbers);
  parameters.set("k", 46);
  EXPECT_NEAR(tape.value(point, 0, {0, parameters}), numbers + 1.2 * 0.25, 1e-14);
  // d(f, k), by differences that are exact: f is affine in k.
  EXPECT_NEAR(value_at(to_field(Expression("d(k*x*r + profile, k)"), problem.scope), point),
              1.2 * 0.25, 1e-16);
}
