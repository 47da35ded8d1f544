#include "quadrature/integrate.hpp"

#include <gmock/gmock.h>

#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule disk_rule(int inside_points) {
  QuadratureOptions options;
  options.inside_points = inside_points;
  return make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1.1, 10), options);
}

TEST(Integrate, VolumeBlocksHoldEveryPointOnceInOrder) {
  for (const int points : {1, 3, 9}) {
    const DomainRule rule = disk_rule(points);
    VolumePoints all;
    for (const int cell : rule.inside_cells()) rule.add_inside_points(cell, all);
    all.append(rule.cut_points());
    const VolumeBlocks blocks(rule);
    VolumeBlocks::Buffer buffer;
    int next = 0;
    for (int k = 0; k < blocks.count(); ++k) {
      const QuadratureBlock block = blocks.block(k, buffer);
      ASSERT_GT(block.count, 0);
      ASSERT_LE(block.count, QuadratureBlock::max_size);
      for (int i = 0; i < block.count; ++i, ++next) {
        EXPECT_DOUBLE_EQ(block.coordinates[0][i], all.coordinates[0][next]);
        EXPECT_DOUBLE_EQ(block.coordinates[1][i], all.coordinates[1][next]);
        EXPECT_DOUBLE_EQ(block.weights[i], all.weights[next]);
      }
    }
    EXPECT_EQ(next, all.size());
  }
}

TEST(Integrate, SurfaceBlocksHoldEveryPointOnceInOrder) {
  const DomainRule rule = disk_rule(2);
  const SurfacePoints& points = rule.boundary().points;
  const SurfaceBlocks blocks(rule.boundary());
  int next = 0;
  for (int k = 0; k < blocks.count(); ++k) {
    const QuadratureBlock block = blocks.block(k);
    for (int i = 0; i < block.count; ++i, ++next) {
      EXPECT_EQ(block.coordinates[1][i], points.coordinates[1][next]);
      EXPECT_EQ(block.normals[0][i], points.normals[0][next]);
      EXPECT_EQ(block.numbers[i], points.numbers[next]);
    }
  }
  EXPECT_EQ(next, points.size());
}

TEST(Integrate, TheDivergenceTheoremHoldsForACubicField) {
  // ∫ div (x³, y³) = ∮ (x³, y³) · n = 3 ∫ (x² + y²) = 3π/2 on the unit disk.
  const DomainRule rule = disk_rule(6);
  const double volume = integrate(rule, [](const QuadratureBlock& block, double* values) {
    for (int i = 0; i < block.count; ++i)
      values[i] = 3 * (block.coordinates[0][i] * block.coordinates[0][i] +
                       block.coordinates[1][i] * block.coordinates[1][i]);
  });
  const double flux = integrate(rule.boundary(), [](const QuadratureBlock& block, double* values) {
    for (int i = 0; i < block.count; ++i)
      values[i] = std::pow(block.coordinates[0][i], 3) * block.normals[0][i] +
                  std::pow(block.coordinates[1][i], 3) * block.normals[1][i];
  });
  EXPECT_NEAR(volume, 1.5 * pi, 1e-8);
  EXPECT_NEAR(flux, 1.5 * pi, 1e-7);
}

}  // namespace
