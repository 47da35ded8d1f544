#include "problems/schema_text.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"

using namespace rfm;
using testing::HasSubstr;
using testing::Not;

TEST(ExplainKey, TellsWhatTheTableKnows) {
  EXPECT_EQ(explain_key("geometry.shapes.circle.radius"),
            "geometry.shapes.NAME.circle.radius\n"
            "  The radius.\n"
            "  takes: a number\n"
            "  range: greater than 0\n"
            "  presence: required\n");
  EXPECT_THAT(explain_key("discretization.basis.cells"), HasSubstr("default: 64"));
  EXPECT_THAT(explain_key("physics.type"),
              HasSubstr("words: poisson, heat, torsion, membrane, interpolation, custom\n"));
  EXPECT_THAT(explain_key("physics.conductivity"), HasSubstr("goes with: heat"));
  EXPECT_THAT(explain_key("geometry.shapes.blend"), HasSubstr("(not supported yet)"));
}
TEST(ExplainKey, TakesPathsAsInFiles) {
  EXPECT_EQ(explain_key("geometry.shapes.hole.circle.radius"), explain_key("circle.radius"));
  EXPECT_EQ(explain_key("conditions.0.value"), explain_key("conditions[0].value"));
  EXPECT_THAT(explain_key("conditions.0.value"), HasSubstr("Dirichlet"));
  EXPECT_EQ(explain_key("probes.centre.point"), explain_key("probes.point"));
}
TEST(ExplainKey, ListsWhatHasTheSameName) {
  EXPECT_THAT(explain_key("radius"), HasSubstr("geometry.shapes.NAME.torus.radius\n"));
  EXPECT_THAT(explain_key("radius"), HasSubstr("sets.NAME.arc.radius"));
}
TEST(ExplainKey, SuggestsWhatAMisspeltKeyMeans) {
  try {
    explain_key("circle.raduis");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown key 'circle.raduis' (did you mean 'radius'?)");
  }
  EXPECT_THROW(explain_key(""), InputError);
  EXPECT_THROW(explain_key("..."), InputError);
}

/// Every key and type name of the format, supported or not, is in the table.
class EveryWordOfTheFormat : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(
    Keys, EveryWordOfTheFormat,
    testing::Values("rfm", "title", "dimension", "parameters", "fields", "functions", "units",
                    "include", "geometry.shapes", "geometry.domain", "geometry.combine.rule",
                    "geometry.bounds.min", "geometry.profiles", "regions.of", "regions.where",
                    "regions.touching", "regions.near", "regions.normal", "regions.within",
                    "conditions.at", "conditions.enforce", "conditions.priority", "points.at",
                    "sets.curve.of", "cracks.tip", "enrich.exponents", "windows.basis", "remainder",
                    "materials.in", "study.initial", "study.frequencies", "discretization.grid.max",
                    "discretization.method", "discretization.structure", "quadrature.order",
                    "refine.levels", "accuracy.target", "accuracy.max_unknowns", "solver.linear",
                    "solver.tolerance", "solver.threads", "sweep", "probes.point", "probes.line",
                    "probes.points", "probes.value", "probes.integral", "probes.average",
                    "probes.max", "probes.min", "probes.over", "probes.at_times", "verify.exact",
                    "expect.quantity", "expect.relative_tolerance", "convergence.cells",
                    "minimum_order.L2", "convergence.order.H1", "outputs.fields", "vtu.resolution",
                    "picture.field", "picture.contours", "combine.corner_scales",
                    "saturate.alpha"));
INSTANTIATE_TEST_SUITE_P(
    Shapes, EveryWordOfTheFormat,
    testing::Values("half_plane.normal", "circle.center", "ellipse.angle", "box.max", "strip.width",
                    "sector.inner_radius", "polygon.holes", "curved_polygon.points.bulge",
                    "polyline.width", "spline.file", "half_space", "sphere", "ellipsoid.rotate",
                    "cylinder.length", "cone.apex", "torus.tube", "capsule.to", "extrusion.profile",
                    "revolution.center", "mesh.file", "image.level", "shapes.expression",
                    "shapes.combine", "transform.about", "offset.distance", "minkowski_sum",
                    "blend.operation", "pattern", "rule.plateau", "rule.R0m", "rule.Rp"));
INSTANTIATE_TEST_SUITE_P(
    Conditions, EveryWordOfTheFormat,
    testing::Values("conditions.value", "conditions.flux", "convection.ambient", "robin.c",
                    "conditions.displacement", "conditions.traction", "conditions.pressure",
                    "normal_displacement", "symmetry", "spring", "free", "clamped",
                    "simply_supported", "deflection", "conditions.rotation", "moment", "shear",
                    "velocity", "no_slip", "slip", "outflow", "conditions.normal_derivative",
                    "second_normal_derivative", "tangential", "oblique.direction", "periodic.to",
                    "interface.resistance", "outgoing"));
INSTANTIATE_TEST_SUITE_P(
    Physics, EveryWordOfTheFormat,
    testing::Values("physics.type.poisson", "type.heat", "type.torsion", "type.membrane",
                    "type.helmholtz", "type.biharmonic", "type.elasticity", "type.plate",
                    "type.stokes", "type.navier_stokes", "type.interpolation", "type.custom",
                    "physics.diffusivity", "physics.advection", "physics.reaction",
                    "physics.source", "physics.conductivity", "physics.density", "heat_capacity",
                    "modulus", "twist", "tension", "load", "wavenumber", "complex",
                    "model.plane_stress", "model.axisymmetric", "young", "poisson_ratio",
                    "orthotropic", "body_force", "physics.rotation", "thermal.expansion",
                    "thickness", "rigidity", "foundation", "in_plane_force.xy", "viscosity",
                    "unknowns", "physics.energy", "residuals", "weak", "physics.boundary",
                    "type.eigen", "type.buckling", "type.transient", "type.harmonic", "count",
                    "shift", "scheme"));

TEST_P(EveryWordOfTheFormat, IsKnown) { EXPECT_NO_THROW(explain_key(GetParam())); }

TEST(JsonSchema, DescribesWhatIsSupportedAndNothingElse) {
  const auto schema = nlohmann::json::parse(json_schema_text());
  EXPECT_EQ(schema["type"], "object");
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_THAT(schema["required"].dump(), HasSubstr("conditions"));
  EXPECT_TRUE(schema["properties"].contains("geometry"));
  EXPECT_FALSE(schema["properties"].contains("units"));
  const auto& shape =
      schema["properties"]["geometry"]["properties"]["shapes"]["additionalProperties"];
  EXPECT_TRUE(shape["properties"].contains("circle"));
  EXPECT_TRUE(shape["properties"].contains("polygon"));
  EXPECT_FALSE(shape["properties"].contains("blend"));
  EXPECT_EQ(shape["oneOf"].size(), shape["properties"].size());
  const auto& type = schema["properties"]["physics"]["properties"]["type"];
  EXPECT_EQ(type["enum"],
            nlohmann::json::parse(
                R"(["poisson", "heat", "torsion", "membrane", "interpolation", "custom"])"));
  EXPECT_EQ(schema["properties"]["dimension"]["enum"], nlohmann::json::parse("[1, 2, 3]"));
}
