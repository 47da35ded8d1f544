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

/// Adds up the moments of a rule for `cell`.
struct MomentSums {
  const Box& cell;
  CellMoments& moments;
  bool with_first;

  void add(double CellMeasure::*part, const Point& point, double weight) {
    moments.measure.*part += weight;
    if (!with_first) return;
    for (int axis = 0; axis < cell.dimension; ++axis)
      moments.first[axis].*part +=
          weight * (2 * (point[axis] - cell.low[axis]) / cell.length(axis) - 1);
  }
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
