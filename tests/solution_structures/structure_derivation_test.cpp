#include "solution_structures/structure_derivation.hpp"

#include <gmock/gmock.h>

#include "solution_structures/structure_text.hpp"
#include "solution_structures/verification.hpp"
#include "tests/solution_structures/boundary_points.hpp"

namespace rfm {
namespace {

using namespace test;
const Ring ring;
const Field &x = ring.x, &y = ring.y;
const StructureNames names{{"omega(outer)", ring.outer}, {"omega(inner)", ring.inner}};

std::string text(const std::vector<StructureCondition>& conditions,
                 const DerivationOptions& options = {}) {
  return to_text(derived_structure(conditions, options), names);
}

TEST(StructureDerivation, SingleConditionsGiveTheirStructures) {
  EXPECT_EQ(text({{ValueCondition{x}, ring.outer}}), "x + omega(outer)*psi1");
  EXPECT_EQ(text({{SlopeCondition{y}, ring.outer}}),
            "psi1 - omega(outer)*(D(omega(outer), psi1) + y) + omega(outer)^2*psi2");
  EXPECT_EQ(text({{ClampedCondition{0.0, 0.0}, ring.outer}}), "omega(outer)^2*psi1");
  EXPECT_EQ(text({}), "psi1");
}

TEST(StructureDerivation, EqualValuesAreOnePart) {
  EXPECT_EQ(text({{ValueCondition{1.0}, ring.outer}, {ValueCondition{1.0}, ring.inner}}),
            "1 + omega(outer)*omega(inner)*psi1");
  EXPECT_EQ(text({{ValueCondition{1.0}, ring.outer}, {ValueCondition{2.0}, ring.inner}}),
            "transfinite(1, omega(outer), 1, 2, omega(inner), 1) + "
            "omega(outer)*omega(inner)*psi1");
}

TEST(StructureDerivation, NaturalPartsShareTheFunctionForTheValue) {
  const Structure u =
      derived_structure({{SlopeCondition{y}, ring.outer}, {RobinData{1.0, 2.0, x}, ring.inner}});
  EXPECT_EQ(u.unknown_count(), 2);
  EXPECT_EQ(u.derivative_order(), 1);
  const Structure plate =
      derived_structure({{SupportData{y, 0.0}, ring.outer}, {SupportData{x, 0.0}, ring.inner}});
  EXPECT_EQ(plate.unknown_count(), 3) << "a slope for each edge";
}

TEST(StructureDerivation, RemainderMayBeGiven) {
  EXPECT_EQ(text({{ValueCondition{x}, ring.outer}}, {.remainder = ring.outer * y}),
            "x + omega(outer)*y*psi1");
}

TEST(StructureDerivation, ConditionsOfDifferentKindsHoldTogether) {
  const Field g = sin(x), c = cos(y), h = x * y;
  const Structure u = derived_structure({{ObliqueData{{2 * x + y, y - x}, 1.0, c}, ring.outer},
                                         {ClampedCondition{g, h}, ring.inner}});
  const auto oblique = [&](const std::vector<Field>& v) {
    return v[0] + along({2 * x + y, y - x}, v[0]);
  };
  const auto slope = [&](const std::vector<Field>& v) { return along(ring.inner_normal, v[0]); };
  const auto value = [](const std::vector<Field>& v) { return v[0]; };
  EXPECT_LT(largest_deviation({u}, oblique, c, ring.outer_points).largest, 1e-11);
  EXPECT_LT(largest_deviation({u}, slope, h, ring.inner_points).largest, 1e-10);
  EXPECT_LT(largest_deviation({u}, value, g, ring.inner_points).largest, 1e-12);
}

TEST(StructureDerivation, CorrectionsBesideSeveralValuesKeepAllOfThem) {
  const Field x = x_coordinate(), y = y_coordinate(), edge = 2 - y;
  const std::vector<Point> on_edge{{-1, 2}, {0.25, 2}, {1, 2}};
  const Structure u = derived_structure({{ValueCondition{sin(x)}, ring.outer},
                                         {ValueCondition{cos(y)}, edge},
                                         {SlopeCondition{x * y}, ring.inner}},
                                        {.reach = 4});
  const auto value = [](const std::vector<Field>& v) { return v[0]; };
  const auto slope = [&](const std::vector<Field>& v) { return along(ring.inner_normal, v[0]); };
  EXPECT_LT(largest_deviation({u}, value, sin(x), ring.outer_points).largest, 1e-13);
  EXPECT_LT(largest_deviation({u}, value, cos(y), on_edge).largest, 1e-13);
  EXPECT_LT(largest_deviation({u}, slope, x * y, ring.inner_points).largest, 1e-11);
}

TEST(StructureDerivation, DerivativesMayBeCorrectionsNearTheBoundary) {
  const Field g = sin(x), c = cos(y);
  const std::vector<StructureCondition> conditions{{ValueCondition{g}, ring.outer},
                                                   {RobinData{1.0, 2.0, c}, ring.inner}};
  const Structure u = derived_structure(conditions, {.reach = 0.1});
  const auto value = [](const std::vector<Field>& v) { return v[0]; };
  const auto robin = [&](const std::vector<Field>& v) {
    return v[0] + 2 * along(ring.inner_normal, v[0]);
  };
  EXPECT_LT(largest_deviation({u}, value, g, ring.outer_points).largest, 1e-13);
  EXPECT_LT(largest_deviation({u}, robin, c, ring.inner_points).largest, 1e-11);
  EXPECT_EQ(u.unknown_count(), 2);
  EXPECT_EQ(text({{SlopeCondition{y}, ring.outer}}, {.reach = 0.5}),
            "psi1 - exp(-(omega(outer)/0.5)^4)*omega(outer)*(D(omega(outer), psi1) + y) + "
            "exp(-(omega(outer)/0.5)^4)*omega(outer)^2*psi2");
}

}  // namespace
}  // namespace rfm
