#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/region.hpp"

namespace rfm {

template <class Number>
using Hessian = std::array<std::array<Number, 3>, 3>;

/// Second derivatives of the level functions of a region, at points and as bounds over boxes. Those
/// of quadrics are constants; those of other primitives are compiled when they are first asked for,
/// so that one object serves one thread.
class SecondDerivatives {
 public:
  explicit SecondDerivatives(const RegionEvaluator& region);

  /// Whether the primitive is given by an expression: sampled fields have no bounds of theirs.
  bool exist(int primitive) const { return exist_[primitive]; }
  Hessian<double> at(int primitive, const Point& point);
  /// Nothing where the function may not be twice differentiable.
  std::optional<Hessian<Interval>> bounds(int primitive, const Box& box);

 private:
  const std::vector<LevelFunction>& slopes(int primitive);

  const RegionEvaluator& region_;
  std::vector<bool> exist_;
  std::vector<std::vector<LevelFunction>> slopes_;  ///< ∂/∂(axis) of primitives, empty until asked
};

}  // namespace rfm
