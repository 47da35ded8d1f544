#include "quadrature/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/error.hpp"
#include "quadrature/ray_crossings.hpp"

namespace rfm {
namespace {

// The region is seen in a box that is a little larger, so that faces in its sides are met.
constexpr double rim = 1e-6;

Box enlarged(const Box& bounds) {
  Box box = bounds;
  for (int axis = 0; axis < box.dimension; ++axis) {
    box.low[axis] -= rim * bounds.longest_side();
    box.high[axis] += rim * bounds.longest_side();
  }
  return box;
}

// The parameters at which a line is in a box; empty where low > high.
Interval part_within(const Box& box, const Line& line) {
  Interval part(0, std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < box.dimension; ++axis) {
    const double from = line.origin[axis], direction = line.direction[axis];
    if (direction == 0) {
      if (from < box.low[axis] || from > box.high[axis]) part.high = -1;
      continue;
    }
    const double a = (box.low[axis] - from) / direction, b = (box.high[axis] - from) / direction;
    part.low = std::max(part.low, std::min(a, b));
    part.high = std::min(part.high, std::max(a, b));
  }
  return part;
}

struct Event {
  double position;
  int variable;
};

// Reused between rays: what one part of a ray needs.
struct Scratch {
  RayCrossings crossings;
  std::vector<Event> events;
  std::unique_ptr<bool[]> signs;
  std::size_t capacity = 0;

  std::span<bool> sign_list(std::size_t count) {
    if (count > capacity) {
      signs = std::make_unique<bool[]>(count);
      capacity = count;
    }
    return {signs.get(), count};
  }
};

}  // namespace

RayCaster::RayCaster(const RegionEvaluator& region, const Box& bounds,
                     const RayCasterOptions& options)
    : region_(region),
      tree_(region, enlarged(bounds), options.max_depth),
      same_place_(1e-12 * bounds.longest_side()) {
  if (bounds.dimension != region.dimension())
    throw InvalidArgument("rays: region and bounds must have the same dimension");
}

std::optional<RayHit> RayCaster::first_entry(const Line& ray) const {
  static thread_local Scratch scratch;
  const Interval seen = part_within(tree_.bounds(), ray);
  if (!(seen.low <= seen.high)) return {};
  // From a point nearby, so that no digits are lost when the viewer is far away.
  const Line near{ray.at(seen.low), ray.direction};
  const double length = std::hypot(ray.direction[0], ray.direction[1], ray.direction[2]);
  const double same_place = same_place_ / length;
  bool started = false;
  double hit_position = -1;
  int hit_primitive = RayHit::none;
  const auto enter = [&](double position, int primitive) {
    hit_position = position;
    hit_primitive = primitive;
    return true;
  };
  // Inside at the start of a part: at the start of the ray, or where a surface lies between parts.
  const auto enter_at_start = [&](double position) {
    return enter(position, started ? nearest_primitive(near, position) : RayHit::none);
  };
  tree_.walk(
      near, 0, seen.high - seen.low,
      [&](const RegionPart& part, const RayTree::Gradient* gradients, double low, double high) {
        if (part.inside == Truth::yes) return enter_at_start(low);
        if (part.inside == Truth::unknown) {
          const std::size_t count = part.primitives.size();
          const std::span<bool> signs = scratch.sign_list(count);
          scratch.events.clear();
          for (std::size_t v = 0; v < count; ++v) {
            find_crossings(region_.level(part.primitives[v]), gradients[v], near, low, high,
                           scratch.crossings);
            signs[v] = scratch.crossings.starts_positive;
            for (const double position : scratch.crossings.positions)
              scratch.events.push_back({position, static_cast<int>(v)});
          }
          const auto inside = [&] {
            return part.expression.evaluate(std::span<const bool>(signs));
          };
          if (inside()) return enter_at_start(low);
          std::ranges::sort(scratch.events, {}, &Event::position);
          // Zeros at one place count by their total effect: w and −w leave no crack.
          for (std::size_t next = 0; next < scratch.events.size();) {
            const double position = scratch.events[next].position;
            int decisive = -1;
            for (; next < scratch.events.size() &&
                   scratch.events[next].position - position <= same_place;
                 ++next) {
              const int variable = scratch.events[next].variable;
              signs[variable] = !signs[variable];
              if (decisive < 0 && inside()) decisive = variable;
            }
            if (decisive >= 0 && inside()) return enter(position, part.primitives[decisive]);
          }
        }
        started = true;
        return false;
      });
  if (hit_position < 0) return {};
  RayHit hit = hit_at(near, hit_position, hit_primitive);
  hit.position += seen.low;
  return hit;
}

RayHit RayCaster::hit_at(const Line& ray, double position, int primitive) const {
  RayHit hit{position, ray.at(position), primitive, {}};
  Point normal{};
  if (primitive != RayHit::none) region_.level(primitive).value_and_gradient(hit.point, normal);
  const auto length = [](const Point& v) { return std::hypot(v[0], v[1], v[2]); };
  const double along =
      normal[0] * ray.direction[0] + normal[1] * ray.direction[1] + normal[2] * ray.direction[2];
  double scale = (along > 0 ? -1 : 1) / length(normal);
  if (!std::isfinite(scale)) {
    normal = ray.direction;
    scale = -1 / length(normal);
  }
  for (int axis = 0; axis < 3; ++axis) hit.normal[axis] = scale * normal[axis];
  return hit;
}

// The primitive whose zero is nearest to a point on a ray, to first order.
int RayCaster::nearest_primitive(const Line& ray, double position) const {
  int nearest = RayHit::none;
  double least = std::numeric_limits<double>::infinity();
  const Point point = ray.at(position);
  for (int k = 0; k < region_.primitive_count(); ++k) {
    Point gradient;
    const double value = region_.level(k).value_and_gradient(point, gradient);
    const double distance = std::fabs(value) / std::hypot(gradient[0], gradient[1], gradient[2]);
    if (!(distance < least)) continue;
    least = distance;
    nearest = k;
  }
  return nearest;
}

}  // namespace rfm
