#include "quadrature/rotated_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rfm {
namespace {

constexpr int side_count = 4;

// Unit gradients at the centre; false if some curve is unsuitable.
bool unit_gradients(const Point& center, const ActiveSet& active,
                    std::array<Point, ActiveSet::capacity>& gradients) {
  for (int i = 0; i < active.count; ++i) {
    Point& gradient = gradients[i];
    active.surfaces[i]->value_and_gradient(center, gradient);
    const double length = std::hypot(gradient[0], gradient[1]);
    if (!(length > 1e-300) || gradient[0] == 0 || gradient[1] == 0) return false;
    gradient[0] /= length;
    gradient[1] /= length;
  }
  return true;
}

// Whether a curve touches a side of the box within rounding.
bool is_tangent_to_side(const Box& box, const Surface& curve) {
  constexpr double rounding = 1e-12, flat = 1e-6;
  for (int along = 0; along < 2; ++along)
    for (const double level : {box.low[1 - along], box.high[1 - along]}) {
      Point point{}, low{}, high{};
      point[1 - along] = level;
      point[along] = box.low[along];
      curve.value_and_gradient(point, low);
      point[along] = box.high[along];
      curve.value_and_gradient(point, high);
      // Where the curve would be parallel to the side.
      const double size = std::hypot(low[0], low[1]), from = low[along], to = high[along];
      double t = std::fabs(from) < std::fabs(to) ? 0 : 1;
      if ((from > 0) != (to > 0))
        t = from / (from - to);
      else if (std::min(std::fabs(from), std::fabs(to)) > flat * size)
        continue;
      point[along] = box.low[along] + t * box.length(along);
      if (std::fabs(curve.value(point)) <= rounding * size * box.length(1 - along)) return true;
    }
  return false;
}

// The height direction: the largest smallest component of the gradients among some directions. The
// sides of the box are to be graphs too, but matter less.
std::optional<Point> best_direction(const std::array<Point, ActiveSet::capacity>& gradients,
                                    int count) {
  constexpr int directions = 12;
  constexpr double least = 0.1, side_weight = 2.5;
  double best = least;
  std::optional<Point> direction;
  for (int i = 0; i < directions; ++i) {
    const double angle = std::numbers::pi * (i + 0.37) / directions;
    const Point candidate{std::cos(angle), std::sin(angle), 0};
    double worst = side_weight * std::min(std::fabs(candidate[0]), std::fabs(candidate[1]));
    for (int k = 0; k < count; ++k)
      worst = std::min(worst,
                       std::fabs(candidate[0] * gradients[k][0] + candidate[1] * gradients[k][1]));
    if (worst > best) {
      best = worst;
      direction = candidate;
    }
  }
  return direction;
}

}  // namespace

std::optional<RotatedBox> RotatedBox::around(const Box& box, const ActiveSet& active) {
  if (active.region_count() < 2 || active.region_count() + side_count > TruthTable::max_variables ||
      active.count + side_count > ActiveSet::capacity)
    return std::nullopt;
  std::array<Point, ActiveSet::capacity> gradients;
  const Point center = box.center();
  if (!unit_gradients(center, active, gradients)) return std::nullopt;
  const std::optional<Point> height = best_direction(gradients, active.count);
  if (!height) return std::nullopt;

  auto parts = std::make_unique<Parts>();
  Frame& frame = parts->frame;
  frame.origin = center;
  frame.axes[1] = *height;
  frame.axes[0] = {(*height)[1], -(*height)[0], 0};

  RotatedBox result;
  result.box_.dimension = 2;
  for (int axis = 0; axis < 2; ++axis) {
    const double reach = 0.5 * (1 + 1e-7) *
                         (std::fabs(frame.axes[axis][0]) * box.length(0) +
                          std::fabs(frame.axes[axis][1]) * box.length(1));
    result.box_.low[axis] = -reach;
    result.box_.high[axis] = reach;
  }
  parts->surfaces.reserve(active.count + side_count);
  ActiveSet& seen = result.active_;
  seen.table = active.table.with_conditions(side_count);
  const auto add = [&](const Surface& surface, int number) {
    parts->surfaces.push_back(surface);
    seen.add(parts->surfaces.back(), number);
  };
  for (int i = 0; i < active.region_count(); ++i)
    add(active.surfaces[i]->in_frame(frame), active.numbers[i]);
  for (int axis = 0; axis < 2; ++axis) {
    const Point along{frame.axes[0][axis], frame.axes[1][axis], 0};
    add(Surface(center[axis] - box.low[axis], along), ActiveSet::no_piece);
    add(Surface(box.high[axis] - center[axis], {-along[0], -along[1], 0}), ActiveSet::no_piece);
  }
  for (int i = active.region_count(); i < active.count; ++i)
    add(active.surfaces[i]->in_frame(frame), active.numbers[i]);
  for (int i = 0; i < active.count; ++i)
    result.touches_side_ |= is_tangent_to_side(box, *active.surfaces[i]);
  result.parts_ = std::move(parts);
  return result;
}

}  // namespace rfm
