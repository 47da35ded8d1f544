// Bounds of quadrics over boxes: plain arithmetic with one proven margin decides nearly always;
// where it cannot, intervals do.

#include <algorithm>
#include <cmath>

#include "core/quadric_evaluator.hpp"
#include "core/quadric_model.hpp"

namespace rfm {
namespace {

// The quadric about the centre of a box, v + g·d + dᵀAd with |dᵢ| ≤ rᵢ, in plain arithmetic. With
// T the largest |x − origin| per axis and M = |c| + Σ|bᵢ|Tᵢ + Σ|Aᵢⱼ|TᵢTⱼ: a term of v is at most
// its part of M and passes through fewer than 16 roundings of 2⁻⁵³; what is added to v for one
// axis is at most 3 times its part of M and passes through fewer than 20. That is an error below
// 76 · 1.12e-16 M < 1e-14 M. In the gradient there are fewer than 12 roundings, of terms bounded by
// |bᵢ| + 2 Σ|Aᵢⱼ|Tⱼ: an error below 2e-15 of that.
struct Expansion {
  static constexpr double value_margin = 1e-14, gradient_margin = 2e-15;

  Expansion(const Quadric& quadric, const Box& box) {
    const int dimension = box.dimension;
    std::array<double, 3> middle{}, reach{};
    for (int i = 0; i < dimension; ++i) {
      const double from = box.low[i] - quadric.origin[i], to = box.high[i] - quadric.origin[i];
      middle[i] = 0.5 * (from + to);
      radius[i] = 0.5 * (to - from);
      reach[i] = std::max(std::fabs(from), std::fabs(to));
    }
    double value = quadric.constant, size = std::fabs(quadric.constant);
    double above = 0, below = 0;
    for (int i = 0; i < dimension; ++i) {
      double half = 0, half_radius = 0, half_size = 0;
      for (int j = 0; j < dimension; ++j) {
        const double a = quadric.square[Quadric::square_index(i, j)];
        half += a * middle[j];
        half_radius += std::fabs(a) * radius[j];
        half_size += std::fabs(a) * reach[j];
        if (j > i) mixed += 2 * std::fabs(a) * radius[i] * radius[j];
      }
      gradient[i] = quadric.linear[i] + 2 * half;
      gradient_radius[i] = 2 * half_radius;
      gradient_size[i] = std::fabs(quadric.linear[i]) + 2 * half_size;
      value += (quadric.linear[i] + half) * middle[i];
      size += (std::fabs(quadric.linear[i]) + half_size) * reach[i];
      // g d + a d² for |d| ≤ r: extremes at the ends, and at the vertex if that is between them.
      const double a = quadric.square[Quadric::square_index(i, i)], r = radius[i];
      const double slope = std::fabs(gradient[i]), curve = a * r * r;
      double most = slope * r + curve, least = curve - slope * r;
      if (slope < 2 * std::fabs(a) * r) {
        const double vertex = -0.25 * slope * slope / a;
        most = std::max(most, vertex);
        least = std::min(least, vertex);
      }
      above += most;
      below += least;
      linear_extent += slope * r;
      curve_middle += 0.5 * curve;
      curve_radius += 0.5 * std::fabs(curve);
    }
    middle_value = value;
    margin = value_margin * size;
    range = {value + below - mixed, value + above + mixed};
  }

  Interval enclosed_gradient(int axis) const {
    // No term depends on this axis.
    if (gradient_size[axis] == 0) return {};
    const double reach = gradient_radius[axis] + gradient_margin * gradient_size[axis] + 0x1p-1000;
    return {gradient[axis] - reach, gradient[axis] + reach};
  }

  Interval enclosed_value(const Quadric& quadric, const Box& box) const {
    const Interval wide(range.low - margin, range.high + margin);
    // Where the box is large beside the quadric, bounds of mixed terms are poor.
    const bool loose = mixed > 0 && 2 * mixed > linear_extent;
    const bool decided =
        wide.excludes_zero() || (range.low + margin < 0 && range.high - margin > 0 && !loose);
    if (decided || !std::isfinite(wide.width())) return decided ? wide : quadric.value_bounds(box);
    return intersection(wide, quadric.value_bounds(box));
  }

  std::array<double, 3> radius{}, gradient{}, gradient_radius{}, gradient_size{};
  double mixed = 0, linear_extent = 0, margin = 0;
  // The value at the centre; Σ aᵢᵢ dᵢ² lies about `curve_middle`.
  double middle_value = 0, curve_middle = 0, curve_radius = 0;
  Interval range;
};

}  // namespace

// Twice the margins of plain bounds: the centre of the models is that of the box in rounded
// numbers.
QuadricModel::QuadricModel(const QuadricEvaluator& quadric, const Box& box) {
  constexpr double smallest = std::numeric_limits<double>::min();
  const Expansion expansion(quadric, box);
  value.value = expansion.middle_value + expansion.curve_middle;
  value.error = expansion.curve_radius + expansion.mixed + 2 * expansion.margin + smallest;
  value.range = expansion.enclosed_value(quadric, box);
  for (int i = 0; i < box.dimension; ++i) {
    value.slope[i] = expansion.gradient[i];
    if (expansion.gradient_size[i] == 0) continue;
    TaylorBound& slope = slopes[i];
    slope.value = expansion.gradient[i];
    for (int j = 0; j < box.dimension; ++j)
      slope.slope[j] = 2 * quadric.square[Quadric::square_index(i, j)];
    slope.error = 2 * Expansion::gradient_margin * expansion.gradient_size[i] + smallest;
    slope.range = expansion.enclosed_gradient(i);
  }
  const bool finite = std::isfinite(value.value) && std::isfinite(value.error);
  if (!finite || !value.range.contains(value.value))
    value = TaylorBound::of_range(value.range, true);
}

Interval QuadricEvaluator::value_bounds(const Box& box) const {
  return Expansion(*this, box).enclosed_value(*this, box);
}

FunctionBounds QuadricEvaluator::bounds(const Box& box) const {
  const Expansion expansion(*this, box);
  FunctionBounds bounds;
  bounds.value = expansion.enclosed_value(*this, box);
  for (int axis = 0; axis < box.dimension; ++axis)
    bounds.gradient[axis] = expansion.enclosed_gradient(axis);
  return bounds;
}

}  // namespace rfm
