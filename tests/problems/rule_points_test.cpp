#include "problems/rule_points.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/primitives.hpp"

using namespace rfm;

namespace {

constexpr double pi = std::numbers::pi;

TEST(RulePoints, WeightsOfPiecesAddUpToTheirMeasures) {
  const Region ring = circle({0, 0}, 1) - circle({0.2, 0}, 0.5);
  std::vector<LevelFunction> interfaces;
  interfaces.emplace_back(x_coordinate() + y_coordinate(), 2);
  const DomainRule rule = make_domain_rule(
      RegionEvaluator(ring), Grid({2, {-1, -1}, {1, 1}}, {12, 12, 1}), {}, interfaces);
  const FieldMesh mesh = rule_points(rule);
  ASSERT_EQ(mesh.data.size(), 7u);
  EXPECT_EQ(mesh.data[0].name, "weight");
  EXPECT_EQ(mesh.data[1].name, "piece");
  EXPECT_EQ(mesh.data[2].name, "normal");
  std::map<int, double> measures;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const int piece = static_cast<int>(mesh.data[1].values[i]);
    measures[piece] += mesh.data[0].values[i];
    const double* normal = &mesh.data[2].values[3 * i];
    EXPECT_NEAR(std::hypot(normal[0], normal[1]), piece == -1 ? 0 : 1, 1e-14);
    EXPECT_EQ(normal[2], 0);
  }
  ASSERT_EQ(measures.size(), 4u);
  EXPECT_NEAR(measures[-1], 0.75 * pi, 1e-9);
  EXPECT_NEAR(measures[0], 2 * pi, 1e-9);
  EXPECT_NEAR(measures[1], pi, 1e-9);
  // The line x + y = 0 within the disk, without its chord in the hole: 2 √(1/4 − (0.2 / √2)²).
  EXPECT_NEAR(measures[-2], 2 - 2 * std::sqrt(0.25 - 0.02), 1e-9);
}

TEST(RulePoints, TellWhatTheReportSaysOfTheirCells) {
  // The apex of a cone cannot be certified; the disk above it can.
  const Field r = sqrt(x_coordinate() * x_coordinate() + y_coordinate() * y_coordinate());
  const Field above = z_coordinate() - r, below = 1 - z_coordinate();
  const Region body =
      Region(Primitive{"cone", above, above}, 3) & Region(Primitive{"lid", below, below}, 3);
  const DomainRule rule = make_domain_rule(
      RegionEvaluator(body), Grid({3, {-1.1, -1.2, -0.2}, {1.1, 1.2, 1.3}}, {7, 7, 5}));
  const FieldMesh mesh = rule_points(rule);
  ASSERT_GT(rule.report().uncertified.measure, 0);
  const auto values = [&](const char* name) -> const std::vector<double>& {
    return std::ranges::find(mesh.data, name, &FieldMesh::PointData::name)->values;
  };
  // Each cell once.
  std::map<int, double> differences, uncertified;
  int in_their_cells = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const int cell = static_cast<int>(values("cell")[i]);
    in_their_cells += rule.grid().cell(rule.grid().position(cell)).contains(mesh.points[i]);
    EXPECT_GE(values("divergence_defect")[i], 0);
    uncertified[cell] = values("uncertified")[i];
    if (values("piece")[i] == -1) differences[cell] = values("order_difference")[i];
  }
  EXPECT_EQ(in_their_cells, static_cast<int>(mesh.points.size()));
  double difference = 0, measure = 0;
  for (const auto& [cell, value] : differences) difference += value;
  for (const auto& [cell, value] : uncertified) measure += value;
  EXPECT_NEAR(difference, rule.report().order_difference.volume, 1e-17);
  EXPECT_DOUBLE_EQ(measure, rule.report().uncertified.measure);
}

}  // namespace
