#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/box.hpp"
#include "quadrature/cell_measure.hpp"

namespace rfm {

/// Sums of the weights of a rule, and of weights times coordinates that run from −1 to 1 across the
/// cell.
struct CellMoments {
  CellMeasure measure;
  std::array<CellMeasure, 3> first;
};

/// Adds up the moments of a rule for a cell.
class MomentSums {
 public:
  MomentSums(const Box& cell, CellMoments& moments, bool with_first)
      : moments_(moments), axes_(with_first ? cell.dimension : 0), center_(cell.center()) {
    for (int axis = 0; axis < axes_; ++axis) scale_[axis] = 2 / cell.length(axis);
  }

  bool with_first() const { return axes_ > 0; }
  void add(double CellMeasure::*part, const Point& point, double weight) {
    moments_.measure.*part += weight;
    for (int axis = 0; axis < axes_; ++axis)
      moments_.first[axis].*part += weight * ((point[axis] - center_[axis]) * scale_[axis]);
  }

 private:
  CellMoments& moments_;
  /// Of which there are first moments.
  int axes_;
  Point center_;
  Point scale_{};
};

/// The length of a gradient at a surface, and by how much the surface is larger there than its
/// shadow across `height`: nothing if the gradient is zero or not finite, so that it has no
/// direction. Slopes of certified graphs are bounded; best efforts are cut off at `steepest`.
struct SurfaceStretch {
  static constexpr double steepest_graph = 1e4, steepest_guess = 100;

  SurfaceStretch(const Point& gradient, int dimension, int height, double steepest) {
    for (int axis = 0; axis < dimension; ++axis) length += gradient[axis] * gradient[axis];
    length = std::sqrt(length);
    constexpr double least = 1e-140, most = 1e140;  // whose squares are normal
    if (!(length > least && length < most)) {
      length = 0;
      for (int axis = 0; axis < dimension; ++axis) length = std::hypot(length, gradient[axis]);
    }
    if (length > 0 && std::isfinite(length))
      stretch = std::min(length / std::fabs(gradient[height]), steepest);
  }
  double length = 0;
  double stretch = 0;
};

}  // namespace rfm
