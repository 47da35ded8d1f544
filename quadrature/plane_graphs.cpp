#include "quadrature/plane_graphs.hpp"

#include <cmath>
#include <limits>

namespace rfm {
namespace {

Point center_of(const Plane& plane, const PlaneGraph& graph) {
  Point center = plane.box.center();
  center[plane.third()] = graph.third;
  return center;
}

// Bounds of −w_base / w_height over the part of the graph between two places.
Interval local_slope(const Plane& plane, const PlaneGraph& graph, double from, double to) {
  // The graph is needed only where it can be: its height in the middle give or take its slope. With
  // the whole height of the box tangential contacts cost 1000 times more.
  const auto& wide = graph.bounds->gradient;
  const double middle =
      find_crossing(*graph.surface, height_line(plane, graph, 0.5 * (from + to))).position;
  const double reach = (wide[plane.base] / wide[plane.height]).magnitude() * 0.5 * (to - from);
  Box narrow = plane.box;
  narrow.low[plane.third()] = narrow.high[plane.third()] = graph.third;
  narrow.low[plane.base] = from;
  narrow.high[plane.base] = to;
  if (middle - reach > narrow.low[plane.height]) narrow.low[plane.height] = middle - reach;
  if (middle + reach < narrow.high[plane.height]) narrow.high[plane.height] = middle + reach;
  const auto local = graph.surface->bounds(narrow).gradient;
  return -(local[plane.base] / local[plane.height]);
}

}  // namespace

double Plane::rounding() const {
  double size = 0;
  for (const Point& corner : {box.low, box.high})
    for (const double coordinate : corner) size = std::max(size, std::fabs(coordinate));
  return 16 * std::numeric_limits<double>::epsilon() * size;
}

LineSegment height_line(const Plane& plane, const PlaneGraph& graph, double place) {
  LineSegment line;
  line.through[plane.third()] = graph.third;
  line.through[plane.base] = place;
  line.axis = plane.height;
  line.low = plane.box.low[plane.height];
  line.high = plane.box.high[plane.height];
  return line;
}

bool proven_apart(const Plane& plane, const PlaneGraph& first, const PlaneGraph& second) {
  const auto &p = first.bounds->gradient, &q = second.bounds->gradient;
  if (!p[plane.height].excludes_zero() || !q[plane.height].excludes_zero()) return false;
  const double radius = 0.5 * plane.base_length();
  const Interval difference =
      Interval(second.surface->value(center_of(plane, second))) / q[plane.height] -
      Interval(first.surface->value(center_of(plane, first))) / p[plane.height] +
      (q[plane.base] / q[plane.height] - p[plane.base] / p[plane.height]) *
          Interval(-radius, radius);
  return difference.excludes_zero();
}

bool isolate_level(const Plane& plane, const PlaneGraph& graph, double level,
                   std::vector<double>& found) {
  const Surface& function = *graph.surface;
  const double low = plane.box.low[plane.base], high = plane.box.high[plane.base];
  if (graph.bounds->gradient[plane.base].excludes_zero()) {
    // Monotone in the whole box: at most one root, and no bounds on the side are needed.
    LineSegment side{{}, plane.base, low, high};
    side.through[plane.third()] = graph.third;
    side.through[plane.height] = level;
    const Crossing crossing = find_crossing(function, side);
    if (crossing.exists) found.push_back(crossing.position);
    return true;
  }
  Box side = plane.box;
  side.low[plane.third()] = side.high[plane.third()] = graph.third;
  side.low[plane.height] = side.high[plane.height] = level;
  const FunctionBounds on_side = function.bounds(side);
  if (on_side.value.excludes_zero()) return true;
  Point point{};
  point[plane.third()] = graph.third;
  point[plane.height] = level;
  const auto value = [&](double t, double& slope) {
    point[plane.base] = t;
    return function.value_and_slope(point, plane.base, slope);
  };
  const auto slopes = [&](double from, double to) {
    if (from == low && to == high) return on_side.gradient[plane.base];
    side.low[plane.base] = from;
    side.high[plane.base] = to;
    return function.bounds(side).gradient[plane.base];
  };
  // From the side alone: the boxes on both sides of it find the same places.
  const auto& gradient = on_side.gradient;
  const double zero = 1e-14 * (gradient[plane.base].magnitude() * plane.base_length() +
                               gradient[plane.height].magnitude() * plane.height_length());
  IsolationBudget budget;
  isolate_roots(
      value, slopes, low, high, zero, [&](double root) { found.push_back(root); }, budget);
  return !budget.exhausted;
}

double height_difference(const Plane& plane, const PlaneGraph& first, const PlaneGraph& second,
                         double place, double& slope) {
  std::array<double, 2> heights{}, slopes{};
  for (int k = 0; k < 2; ++k) {
    const PlaneGraph& graph = k == 0 ? first : second;
    const LineSegment line = height_line(plane, graph, place);
    heights[k] = find_crossing(*graph.surface, line).position;
    Point gradient{};
    graph.surface->value_and_gradient(line.at(heights[k]), gradient);
    slopes[k] = -gradient[plane.base] / gradient[plane.height];
  }
  slope = slopes[0] - slopes[1];
  return heights[0] - heights[1];
}

bool isolate_crossings(const Plane& plane, const PlaneGraph& first, const PlaneGraph& second,
                       double from, double to, std::vector<double>& found,
                       std::vector<double>& contacts) {
  const auto difference = [&](double place, double& slope) {
    return height_difference(plane, first, second, place, slope);
  };
  const auto slopes = [&](double low, double high) {
    return local_slope(plane, first, low, high) - local_slope(plane, second, low, high);
  };
  const double zero = 1e-13 * plane.height_length();
  const auto add = [&](double root) { found.push_back(root); };
  const auto add_contact = [&](double low, double high) {
    switch (classify_contact(difference, from, to, low, high, zero, plane.rounding())) {
      case Contact::touches:
        return contacts.push_back(0.5 * (low + high));
      case Contact::crosses:
        return found.push_back(0.5 * (low + high));
      case Contact::vanishes:
        if (low > from) found.push_back(low);
        if (high < to) found.push_back(high);
    }
  };
  IsolationBudget budget;
  isolate_roots(difference, slopes, from, to, zero, add, add_contact, budget);
  return !budget.exhausted;
}

}  // namespace rfm
