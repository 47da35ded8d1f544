#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/box.hpp"
#include "core/multi_index.hpp"

namespace rfm {

/// Bounds of a function and its gradient over a box, in up to four variables. `smooth` is false
/// where the function may fail to be differentiable somewhere in the box.
struct FunctionBounds {
  Interval value;
  std::array<Interval, maximum_variables> gradient{};
  bool smooth = true;
};

/// The door for fields that are not expressions: a solved u, a sampled distance, a mesh.
class FieldSource {
 public:
  virtual ~FieldSource() = default;

  /// Jets at a block of points. `coordinates[axis]` holds `count` values; coefficient c of the jet
  /// in `variables` variables up to `order` goes to `jets[c * stride + i]`, i < count. Points
  /// outside the region of validity give NaN: a source does not extrapolate.
  virtual void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                        int order, double* jets, int stride) const = 0;
  /// Rigorous bounds over a box.
  virtual FunctionBounds bounds(const Box& box) const = 0;
  /// Coordinates along `axis` where the function is not smooth, ascending (knots of a spline):
  /// quadrature splits cells there.
  virtual std::vector<double> breakpoints(int axis) const = 0;
  /// Where the source may be evaluated.
  virtual Box valid() const = 0;
};

}  // namespace rfm
