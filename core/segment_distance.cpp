#include "core/segment_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/multi_index.hpp"
#include "core/point_algebra.hpp"

namespace rfm {

SegmentDistance::SegmentDistance(const Point& from, const Point& to, int dimension)
    : dimension_(dimension), from_(from), to_(to) {
  if (dimension < 2 || dimension > 3)
    throw InvalidArgument("segments lie in 2 or 3 dimensions, not in " + std::to_string(dimension));
  for (int axis = dimension; axis < 3; ++axis) from_[axis] = to_[axis] = 0;
  for (int axis = 0; axis < 3; ++axis) direction_[axis] = to_[axis] - from_[axis];
  length_ = std::hypot(direction_[0], direction_[1], direction_[2]);
  if (!(length_ > 0)) throw InvalidArgument("the ends of a segment must differ");
  for (double& component : direction_) component /= length_;
}

SegmentDistance::Nearest SegmentDistance::nearest(const Point& point) const {
  Nearest result;
  for (int axis = 0; axis < dimension_; ++axis) result.offset[axis] = point[axis] - from_[axis];
  const double along = dot(result.offset, direction_);
  if (along > length_) {
    for (int axis = 0; axis < dimension_; ++axis) result.offset[axis] = point[axis] - to_[axis];
  } else if (along >= 0) {
    result.beside = 1;
    for (int axis = 0; axis < dimension_; ++axis) result.offset[axis] -= along * direction_[axis];
  }
  return result;
}

void SegmentDistance::evaluate(const std::array<const double*, 3>& coordinates, int count,
                               int variables, int order, double* jets, int stride) const {
  const int size = jet_size(variables, order), own = std::min(variables, dimension_);
  const auto coefficient = [&](const MultiIndex& index, int point) -> double& {
    return jets[std::ptrdiff_t(jet_index(variables, index)) * stride + point];
  };
  for (int c = 0; c < size; ++c) std::fill_n(jets + std::ptrdiff_t(c) * stride, count, 0.0);
  for (int i = 0; i < count; ++i) {
    Point point{};
    for (int axis = 0; axis < dimension_; ++axis) point[axis] = coordinates[axis][i];
    const auto [offset, beside] = nearest(point);
    coefficient({}, i) = dot(offset, offset);
    for (int a = 0; a < own && order >= 1; ++a) {
      coefficient(unit_index(a), i) = 2 * offset[a];
      // The matrix 2 (I − beside d dᵀ), halved on its diagonal by the factor 1 / α!.
      for (int b = 0; b <= a && order >= 2; ++b)
        coefficient(unit_index(a) + unit_index(b), i) =
            (a == b ? 1.0 : 0.0) - beside * (a == b ? 1.0 : 2.0) * direction_[a] * direction_[b];
    }
  }
}

FunctionBounds SegmentDistance::bounds(const Box& box) const {
  const Point center = box.center();
  Point radius{};
  double along = 0, reach = 0, size = length_;
  for (int axis = 0; axis < dimension_; ++axis) {
    radius[axis] =
        std::max(box.high[axis] - center[axis], center[axis] - box.low[axis]) * (1 + 0x1p-50);
    along += direction_[axis] * (center[axis] - from_[axis]);
    reach += std::fabs(direction_[axis]) * radius[axis];
    size += std::fabs(from_[axis]) + std::fabs(center[axis]) + radius[axis];
  }
  if (!std::isfinite(size))
    return {Interval(0, std::numeric_limits<double>::infinity()),
            {Interval::entire(), Interval::entire(), Interval::entire()}};
  // A power of 16, so that boxes in a row along the segment have equal bounds: a search for
  // extremes must see that none of them is farther out than the others.
  size = std::ldexp(1.0, 4 * (std::ilogb(size) / 4 + 1));
  // Whether all points have their nearest one beside the segment, or none has.
  const double slack = 2e-15 * size;
  const bool all = along - reach > slack && along + reach < length_ - slack;
  const bool none = along + reach < -slack || along - reach > length_ + slack;

  const Point offset = nearest(center).offset;
  FunctionBounds bounds;
  // The offset x − p component by component, and the tangent at the centre: the first is exact for
  // segments along an axis, the second is of second order for all.
  double natural = 0, tangent = dot(offset, offset), highest = 0;
  const Interval moved =
      Interval(std::clamp(along - reach, 0.0, length_), std::clamp(along + reach, 0.0, length_));
  for (int a = 0; a < dimension_; ++a) {
    double spread = 0;
    for (int b = 0; b < dimension_; ++b) {
      const double still = a == b ? 1.0 : 0.0, slid = still - direction_[a] * direction_[b];
      const double slope = std::fabs(all ? slid : none ? still : std::max(still, std::fabs(slid)));
      spread += slope * radius[b];
    }
    Interval component(offset[a] - spread - slack, offset[a] + spread + slack);
    if (!all) {
      const Interval foot = Interval(from_[a]) + Interval(direction_[a]) * moved;
      component = intersection(component, box.interval(a) - foot + Interval(-slack, slack));
    }
    bounds.gradient[a] = Interval(2) * component;
    natural += component.mignitude() * component.mignitude();
    tangent -= 2 * std::fabs(offset[a]) * radius[a];
  }
  for (int corner = 0; corner < 1 << dimension_; ++corner) {
    Point point{};
    for (int axis = 0; axis < dimension_; ++axis)
      point[axis] = (corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis];
    const Nearest there = nearest(point);
    highest = std::max(highest, dot(there.offset, there.offset));
  }
  bounds.value = {std::max(0.0, std::max(natural, tangent) - slack * size), highest + slack * size};
  return bounds;
}

std::vector<double> SegmentDistance::breakpoints(int axis) const {
  if (axis >= dimension_ || std::fabs(direction_[axis]) != 1) return {};
  return {std::min(from_[axis], to_[axis]), std::max(from_[axis], to_[axis])};
}

Box SegmentDistance::valid() const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {dimension_, {-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
}

}  // namespace rfm
