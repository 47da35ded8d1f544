#include "quadrature/integrate.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "quadrature/compensated_sum.hpp"

namespace rfm {
namespace {

constexpr int block_size = QuadratureBlock::max_size;

int blocks_of(long points) { return static_cast<int>((points + block_size - 1) / block_size); }

QuadratureBlock cut_block(const VolumePoints& points, int k) {
  QuadratureBlock block;
  const int first = k * block_size;
  block.count = std::min(block_size, points.size() - first);
  for (int axis = 0; axis < 3; ++axis)
    if (!points.coordinates[axis].empty())
      block.coordinates[axis] = points.coordinates[axis].data() + first;
  block.weights = points.weights.data() + first;
  return block;
}

// Sums block by block into fixed places, then over the blocks in order.
template <class BlockSum>
double sum_over_blocks(int count, BlockSum&& block_sum) {
  std::vector<double> sums(count);
  tbb::parallel_for(0, count, [&](int k) { sums[k] = block_sum(k); });
  CompensatedSum total;
  for (const double sum : sums) total.add(sum);
  return total.value();
}

double weighted_sum(const QuadratureBlock& block, const Integrand& integrand) {
  std::array<double, block_size> values;
  integrand(block, values.data());
  CompensatedSum sum;
  for (int i = 0; i < block.count; ++i) sum.add(block.weights[i] * values[i]);
  return sum.value();
}

}  // namespace

VolumeBlocks::VolumeBlocks(const DomainRule& rule) : rule_(rule) {
  for (int axis = 0; axis < rule.dimension(); ++axis) points_per_cell_ *= rule.inside_rule().size();
  inside_points_ = static_cast<long>(points_per_cell_) * rule.inside_cells().size();
  inside_blocks_ = blocks_of(inside_points_);
  cut_blocks_ = blocks_of(rule.cut_points().size());
}

QuadratureBlock VolumeBlocks::block(int k, Buffer& buffer) const {
  return k < inside_blocks_ ? inside_block(k, buffer)
                            : cut_block(rule_.cut_points(), k - inside_blocks_);
}

QuadratureBlock VolumeBlocks::inside_block(int k, Buffer& buffer) const {
  const GaussRule& gauss = rule_.inside_rule();
  const Grid& grid = rule_.grid();
  QuadratureBlock block;
  const long first = static_cast<long>(k) * block_size;
  block.count = static_cast<int>(std::min<long>(block_size, inside_points_ - first));
  for (int i = 0; i < block.count; ++i) {
    const long cell = (first + i) / points_per_cell_;
    int rest = static_cast<int>((first + i) % points_per_cell_);
    const auto position = grid.position(rule_.inside_cells()[cell]);
    double weight = 1;
    for (int axis = 0; axis < grid.dimension(); ++axis, rest /= gauss.size()) {
      const int node = rest % gauss.size();
      const double low = grid.line(axis, position[axis]);
      const double length = grid.line(axis, position[axis] + 1) - low;
      buffer.coordinates[axis][i] = low + length * gauss.nodes[node];
      weight *= length * gauss.weights[node];
    }
    buffer.weights[i] = weight;
  }
  for (int axis = 0; axis < grid.dimension(); ++axis)
    block.coordinates[axis] = buffer.coordinates[axis].data();
  block.weights = buffer.weights.data();
  return block;
}

QuadratureBlock SurfaceBlocks::block(int k) const {
  const SurfacePoints& points = rule_.points;
  QuadratureBlock block;
  const int first = k * block_size;
  block.count = std::min(block_size, points.size() - first);
  for (int axis = 0; axis < 3; ++axis) {
    if (points.coordinates[axis].empty()) continue;
    block.coordinates[axis] = points.coordinates[axis].data() + first;
    block.normals[axis] = points.normals[axis].data() + first;
  }
  block.weights = points.weights.data() + first;
  block.numbers = points.numbers.data() + first;
  return block;
}

double integrate(const DomainRule& rule, const Integrand& integrand) {
  const VolumeBlocks blocks(rule);
  return sum_over_blocks(blocks.count(), [&](int k) {
    VolumeBlocks::Buffer buffer;
    return weighted_sum(blocks.block(k, buffer), integrand);
  });
}

double integrate(const SurfaceRule& rule, const Integrand& integrand) {
  const SurfaceBlocks blocks(rule);
  return sum_over_blocks(blocks.count(),
                         [&](int k) { return weighted_sum(blocks.block(k), integrand); });
}

}  // namespace rfm
