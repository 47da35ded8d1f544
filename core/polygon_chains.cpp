#include "core/polygon_chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/orientation.hpp"

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;
using Node = BooleanExpression::Node;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point back(const Point& direction) { return {-direction[0], -direction[1]}; }

// In 64 bits, so that directions that are multiples of each other are parallel.
double cross(const Point& a, const Point& b) {
  return static_cast<double>(static_cast<long double>(a[0]) * b[1] -
                             static_cast<long double>(a[1]) * b[0]);
}

Point unit(const Point& direction) {
  const double length = std::hypot(direction[0], direction[1]);
  return {direction[0] / length, direction[1] / length};
}

// Corners of hulls nearer to the chord by a little: a vertex at which curves pass into each other
// smoothly lies on the side that their hulls share, and would be hidden by rounding. What is left
// out of a hull that way is the square of it.
std::array<Point, 4> shrunk(const std::array<Point, 4>& hull, double size) {
  const Point along = unit(minus(hull[3], hull[0]));
  std::array<Point, 4> result = hull;
  for (const int corner : {1, 2}) {
    const double height = cross(along, minus(hull[corner], hull[0]));
    const double step = std::copysign(1e-6 * std::fabs(height) + 1e-13 * size, height);
    result[corner][0] += step * along[1];
    result[corner][1] -= step * along[0];
  }
  return result;
}

class ChainBuilder {
 public:
  ChainBuilder(std::span<const ChainLink> links, std::span<const BooleanExpression> edges)
      : links_(links.begin(), links.end()), edges_(edges), count_(static_cast<int>(links.size())) {
    for (const ChainLink& link : links_)
      for (int axis = 0; axis < 2; ++axis)
        size_ = std::max(size_, std::fabs(link.start[axis] - links_[0].start[axis]));
    whole_ = links_;
    for (ChainLink& link : links_)
      if (link.hull) link.hull = shrunk(*link.hull, size_);
    rounding_ = 0x1p-50 * size_;
  }

  BooleanExpression run() {
    const Range all{0, count_, 0, count_ - 1};
    std::vector<int> splits = vertices_of(lower_hull(all, {0, 1}), all, 1);
    const std::vector<int> above = vertices_of(lower_hull(all, {0, -1}), all, 1);
    splits.insert(splits.end(), above.begin(), above.end());
    // Vertices are numbered from one of these, where the walk around ends, too.
    if (splits.empty()) return edges_[0];  // of no use: edges are blocking
    start_ = splits[0];
    for (int& split : splits) split = (split + count_ - start_) % count_;
    return BooleanExpression::of_nodes(nodes_, parts(0, count_, splits, Kind::conjunction));
  }

  /// Edges whose curves keep all vertices of a chain off its hull.
  std::vector<int> blocking() const { return {blocking_.begin(), blocking_.end()}; }

 private:
  const ChainLink& link(int step) const { return links_[(start_ + step) % count_]; }
  const Point& at(int step) const { return link(step).start; }

  // The parts of a chain between `splits`, vertices of its hull in any order.
  int parts(int from, int to, std::vector<int>& splits, Kind kind) {
    splits.push_back(from);
    splits.push_back(to);
    std::ranges::sort(splits);
    const auto repeated = std::ranges::unique(splits);
    splits.erase(repeated.begin(), repeated.end());
    std::vector<int> list;
    for (std::size_t i = 0; i + 1 < splits.size(); ++i)
      list.push_back(chain(splits[i], splits[i + 1]));
    return joined(list, 0, list.size(), kind);
  }

  int chain(int from, int to) {
    if (to == from + 1) return leaf((start_ + from) % count_);
    const std::set<int> known_blocking = blocking_;
    std::vector<int> splits = vertices_on_hull(from, to);
    for (int i = from + 1; i < to && splits.empty(); ++i)
      if (is_free(from, to, i)) {
        splits.push_back(i);
        blocking_ = known_blocking;
      }
    if (splits.empty()) return leaf((start_ + from) % count_);  // of no use: edges are blocking
    const bool convex = link(splits[0]).turn > 0;
    return parts(from, to, splits, convex ? Kind::conjunction : Kind::disjunction);
  }

  // The vertices between `from` and `to` on the hull of the chain with both ends extended.
  std::vector<int> vertices_on_hull(int from, int to) {
    const Point behind = back(link(from).direction), ahead = link(to - 1).direction;
    const Point one = unit(behind), other = unit(ahead);
    const Range range{from, to, from + 1, to - 1};
    Point up{one[0] + other[0], one[1] + other[1]};
    // Below this the extensions are opposite to each other, up to rounding.
    if (dot(up, up) > 1e-24) {
      std::vector<HullPoint> hull = lower_hull(range, up);
      trim(hull, behind, ahead);
      // The hull is above: whoever walks along it to the right turns left.
      return vertices_of(hull, range, cross(behind, ahead) < 0 ? 1 : -1);
    }
    // Then all lies between two lines along them. Where both ends lie on the lower of these, edges
    // extended along it would meet the ends; there are other vertices on the upper one.
    up = {-one[1], one[0]};
    std::vector<HullPoint> hull = lowest(range, up);
    const double line = height(up, hull[0].point) + rounding_;
    const bool is_above = height(up, at(from)) <= line && height(up, at(to)) <= line;
    if (is_above) hull = lowest(range, back(up));
    return vertices_of(hull, range, is_above ? 1 : -1);
  }

  // A vertex, or (−1) a corner of the hull of a curve.
  struct HullPoint {
    Point point;
    int vertex;
    int edge;
  };
  // Edges from … to − 1, vertices first … last.
  struct Range {
    int from, to, first, last;
  };

  std::vector<HullPoint> points_of(const Range& range) const {
    std::vector<HullPoint> points;
    for (int i = range.first; i <= range.last; ++i) points.push_back({at(i), i, -1});
    for (int step = range.from; step < range.to; ++step)
      if (const auto& hull = link(step).hull)
        for (const int corner : {1, 2})
          points.push_back({(*hull)[corner], -1, (start_ + step) % count_});
    return points;
  }

  // The vertices among the points of a hull that turn with it, which tells apart those that a
  // tangent joins in one point; edges block if there are none.
  std::vector<int> vertices_of(const std::vector<HullPoint>& hull, const Range& range, int turn) {
    std::vector<int> vertices;
    const auto add = [&](int vertex) {
      if (link(vertex).turn != -turn) vertices.push_back(vertex);
    };
    for (const HullPoint& point : hull) {
      if (point.vertex < 0) continue;
      add(point.vertex);
      for (const int step : {1, -1})
        for (int i = point.vertex + step;
             i >= range.first && i <= range.last && at(i) == point.point; i += step)
          add(i);
    }
    if (!vertices.empty()) return vertices;
    bool any = false;
    for (const HullPoint& point : hull)
      if (point.edge >= 0) {
        blocking_.insert(point.edge);
        any = true;
      }
    for (int step = range.from; step < range.to && !any; ++step)
      if (link(step).hull) blocking_.insert((start_ + step) % count_);
    return vertices;
  }

  double height(const Point& up, const Point& point) const {
    return dot(up, minus(point, links_[0].start));
  }

  std::vector<HullPoint> lowest(const Range& range, const Point& up) const {
    double least = INFINITY;
    const std::vector<HullPoint> all = points_of(range);
    for (const HullPoint& point : all) least = std::min(least, height(up, point.point));
    std::vector<HullPoint> result;
    for (const HullPoint& point : all)
      if (height(up, point.point) <= least + rounding_) result.push_back(point);
    return result;
  }

  // Points on their convex hull as seen from below, from left to right, those on its straight parts
  // included (Andrew 1979), each once.
  std::vector<HullPoint> lower_hull(const Range& range, const Point& up) const {
    const Point right{up[1], -up[0]};
    std::vector<std::pair<std::array<double, 2>, HullPoint>> order;
    for (const HullPoint& point : points_of(range))
      order.push_back({{height(right, point.point), height(up, point.point)}, point});
    std::ranges::sort(order, {}, [](const auto& entry) { return entry.first; });
    std::vector<HullPoint> hull;
    for (const auto& [place, point] : order) {
      while (hull.size() > 1 &&
             orientation(hull[hull.size() - 2].point, hull.back().point, point.point) < 0)
        hull.pop_back();
      if (hull.empty() || hull.back().point != point.point)
        hull.push_back(point);
      else if (point.vertex >= 0)
        hull.back() = point;
    }
    return hull;
  }

  // Removes the points of a lower hull that lie above what the extensions add to it.
  static void trim(std::vector<HullPoint>& hull, const Point& behind, const Point& ahead) {
    const bool starts_left = cross(behind, ahead) < 0;
    const Point left = starts_left ? behind : ahead, right = starts_left ? ahead : behind;
    while (hull.size() > 1 && cross(left, minus(hull[1].point, hull[0].point)) >= 0)
      hull.erase(hull.begin());
    while (hull.size() > 1 &&
           cross(right, minus(hull[hull.size() - 2].point, hull.back().point)) <= 0)
      hull.pop_back();
  }

  // Whether the edges at a vertex extended beyond it meet nothing of the chain, which vertices on
  // the hull are spared to ask.
  bool is_free(int from, int to, int vertex) const {
    const Point& origin = at(vertex);
    const std::array<Point, 2> rays = {unit(link(vertex - 1).direction),
                                       back(unit(link(vertex).direction))};
    const auto meets = [&](const Point& ray, const Point& p, const Point& q) {
      const Point a = minus(p, origin), b = minus(q, origin);
      const double u = cross(ray, a), v = cross(ray, b);
      if (u * v > 0 && std::min(std::fabs(u), std::fabs(v)) > rounding_) return false;
      const double one = dot(ray, a), other = dot(ray, b);
      if (std::max(std::fabs(u), std::fabs(v)) <= rounding_) return std::max(one, other) >= 0;
      return one + std::clamp(u / (u - v), 0.0, 1.0) * (other - one) >= 0;
    };
    const auto far = [&](const Point& end, const Point& direction) {
      const Point d = unit(direction);
      return Point{end[0] + 1e3 * size_ * d[0], end[1] + 1e3 * size_ * d[1]};
    };
    for (int step = from; step < to; ++step) {
      if (step == vertex || step == vertex - 1) continue;
      const ChainLink& edge = whole_[(start_ + step) % count_];
      std::vector<Point> corners = {at(step), at(step + 1)};
      if (step == from) corners[0] = far(at(from), back(edge.direction));
      if (step == to - 1) corners[1] = far(at(to), edge.direction);
      if (corners[0] == corners[1]) continue;
      const bool begins = at(step) == origin, ends = at(step + 1) == origin;
      if (begins || ends) {
        for (const Point& ray : rays)
          if (enters(ray, edge, begins, corners) ||
              (runs_along(ray, begins, corners) &&
               !parts_from(ray, from, to, step, begins, link(vertex).turn)))
            return false;
        continue;
      }
      if (edge.hull) corners.insert(corners.end(), edge.hull->begin(), edge.hull->end());
      for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        for (const Point& ray : rays)
          if (meets(ray, corners[i], corners[i + 1])) return false;
    }
    return true;
  }

  // Whether a ray from the point where an edge begins (or ends) runs between its chord and its
  // tangent there; along the chord it does not.
  static bool enters(const Point& ray, const ChainLink& edge, bool begins,
                     const std::vector<Point>& ends) {
    const Point chord = unit(begins ? minus(ends[1], ends[0]) : minus(ends[0], ends[1]));
    if (dot(ray, chord) <= 0) return false;
    const double past_chord = cross(chord, ray);
    if (!edge.hull) return std::fabs(past_chord) <= rounding_of_directions_;
    const auto& hull = *edge.hull;
    const Point tangent = unit(begins ? minus(hull[1], hull[0]) : minus(hull[2], hull[3]));
    const double side = cross(chord, tangent) > 0 ? 1 : -1;
    return side * past_chord > rounding_of_directions_ &&
           side * cross(ray, tangent) >= -rounding_of_directions_;
  }

  // Whether a ray runs along a chord, beyond whose other end the chain may go on to either side.
  static bool runs_along(const Point& ray, bool begins, const std::vector<Point>& ends) {
    const Point chord = unit(begins ? minus(ends[1], ends[0]) : minus(ends[0], ends[1]));
    return dot(ray, chord) > 0 && std::fabs(cross(chord, ray)) <= rounding_of_directions_;
  }

  // Whether the chain turns off a ray that runs along one of its chords, from the vertex where that
  // begins (or ends), so that the ray stays on the side of the chain on which it began. Nothing
  // turns off where the chord is itself extended.
  bool parts_from(const Point& ray, int from, int to, int along, bool begins, int turn) const {
    const auto is_aside = [&](const Point& direction) {
      return turn * cross(ray, unit(direction)) > rounding_of_directions_;
    };
    const int step = begins ? 1 : -1;
    for (int i = along + step; i >= from && i < to; i += step) {
      const ChainLink& edge = whole_[(start_ + i) % count_];
      if (!is_aside(edge.direction)) return false;
      if (edge.hull) {
        const auto& hull = *edge.hull;
        return turn * cross(ray, unit(begins ? minus(hull[1], hull[0]) : minus(hull[3], hull[2]))) >
               -rounding_of_directions_;
      }
      if (at(i) != at(i + 1)) return true;
    }
    return true;
  }

  int leaf(int edge) {
    const int shift = static_cast<int>(nodes_.size());
    for (Node node : edges_[edge].nodes()) {
      if (node.kind != Kind::constant && node.kind != Kind::variable) {
        node.first += shift;
        node.second += shift;
      }
      nodes_.push_back(node);
    }
    return static_cast<int>(nodes_.size()) - 1;
  }

  int joined(const std::vector<int>& list, std::size_t begin, std::size_t end, Kind kind) {
    if (end - begin == 1) return list[begin];
    const std::size_t middle = (begin + end) / 2;
    const int first = joined(list, begin, middle, kind), second = joined(list, middle, end, kind);
    nodes_.push_back({kind, first, second});
    return static_cast<int>(nodes_.size()) - 1;
  }

  static constexpr double rounding_of_directions_ = 1e-13;
  std::vector<ChainLink> links_, whole_;  // with hulls shrunk, and as given
  std::span<const BooleanExpression> edges_;
  int count_;
  int start_ = 0;
  double size_ = 0;
  double rounding_ = 0;  ///< within which heights are equal
  std::vector<Node> nodes_;
  std::set<int> blocking_;
};

}  // namespace

BooleanExpression chain_expression(std::span<const Point> vertices,
                                   std::span<const BooleanExpression> edges) {
  const std::size_t count = vertices.size();
  std::vector<ChainLink> links(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point &before = vertices[(i + count - 1) % count], &after = vertices[(i + 1) % count];
    links[i] = {vertices[i], minus(after, vertices[i]), orientation(before, vertices[i], after)};
  }
  return ChainBuilder(links, edges).run();
}

CurvedChains curved_chain_expression(std::span<const ChainLink> links,
                                     std::span<const BooleanExpression> edges) {
  ChainBuilder builder(links, edges);
  CurvedChains result{builder.run(), {}};
  result.blocking = builder.blocking();
  return result;
}

}  // namespace rfm
