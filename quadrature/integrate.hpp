#pragma once

#include <functional>

#include "quadrature/domain_rule.hpp"

namespace rfm {

/// Up to `max_size` quadrature points side by side.
struct QuadratureBlock {
  static constexpr int max_size = 64;

  int count = 0;
  /// Null beyond the dimension.
  std::array<const double*, 3> coordinates{};
  const double* weights = nullptr;
  /// On boundaries and interfaces only: unit normals and number of the primitive or interface.
  std::array<const double*, 3> normals{};
  const int* numbers = nullptr;
};

/// All volume points of a rule in blocks that fill up across cells: those of cells inside first,
/// then those of cut cells. The order never changes.
class VolumeBlocks {
 public:
  explicit VolumeBlocks(const DomainRule& rule);

  int count() const { return inside_blocks_ + cut_blocks_; }
  /// Memory for the points of cells inside, which are made on the fly.
  struct Buffer {
    std::array<std::array<double, QuadratureBlock::max_size>, 3> coordinates;
    std::array<double, QuadratureBlock::max_size> weights;
  };
  /// Block `k`; valid as long as rule and buffer are.
  QuadratureBlock block(int k, Buffer& buffer) const;

 private:
  QuadratureBlock inside_block(int k, Buffer& buffer) const;

  const DomainRule& rule_;
  int points_per_cell_ = 1;
  long inside_points_ = 0;
  int inside_blocks_ = 0;
  int cut_blocks_ = 0;
};

/// The points of a boundary or of interfaces in blocks.
class SurfaceBlocks {
 public:
  explicit SurfaceBlocks(const SurfaceRule& rule) : rule_(rule) {}

  int count() const {
    return (rule_.points.size() + QuadratureBlock::max_size - 1) / QuadratureBlock::max_size;
  }
  QuadratureBlock block(int k) const;

 private:
  const SurfaceRule& rule_;
};

/// Fills `values` with the integrand at the points of a block. Called by several threads at a time.
using Integrand = std::function<void(const QuadratureBlock& block, double* values)>;

/// ∫ over the region. Parallel; the same to the last bit for any number of threads.
double integrate(const DomainRule& rule, const Integrand& integrand);
/// ∫ over the boundary, or over interfaces inside the region.
double integrate(const SurfaceRule& rule, const Integrand& integrand);

}  // namespace rfm
