#pragma once

#include <memory>
#include <ranges>
#include <span>
#include <vector>

#include "core/level_function.hpp"
#include "core/part_ends.hpp"

namespace rfm {

/// Interfaces begin ≤ k < end are where parts of the boundary end: rules of the boundary are split
/// there, and cells inside stay whole.
struct BoundaryEnds {
  int begin = 0;
  int end = 0;
  /// Tells where they matter, counting from `begin`; null: everywhere.
  std::shared_ptr<const EndLocator> locator = nullptr;
};

/// The surfaces across which integrands jump: a view of level functions, of which some may concern
/// the boundary only.
class Interfaces {
 public:
  Interfaces() = default;
  /// All of them of volume and boundary.
  Interfaces(std::span<const LevelFunction> levels) : levels_(levels) {}     // NOLINT
  Interfaces(const std::vector<LevelFunction>& levels) : levels_(levels) {}  // NOLINT
  Interfaces(std::span<const LevelFunction> levels, std::span<const BoundaryEnds> ends)
      : levels_(levels), ends_(ends) {}

  std::span<const LevelFunction> levels() const { return levels_; }
  int count() const { return static_cast<int>(levels_.size()); }
  /// Removes from `numbers`, which ascend, those that do not split rules in the box: `inside` is
  /// what is known of the box. `tight` asks for the better and dearer bounds.
  void narrow(const Box& box, Truth inside, bool tight, std::vector<int>& numbers) const;

 private:
  std::span<const LevelFunction> levels_;
  std::span<const BoundaryEnds> ends_;
};

}  // namespace rfm
