#pragma once

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
/// shadow across `height`.
struct SurfaceStretch {
  SurfaceStretch(const Point& gradient, int dimension, int height) {
    for (int axis = 0; axis < dimension; ++axis) length += gradient[axis] * gradient[axis];
    length = std::sqrt(length);
    // Steeper than any certified graph; only best efforts are cut off.
    constexpr double steepest = 1e4;
    stretch = length / std::fabs(gradient[height]);
    if (!(stretch < steepest)) stretch = steepest;
  }
  double length = 0;
  double stretch = 0;
};

}  // namespace rfm
