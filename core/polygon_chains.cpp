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

struct Direction {
  double x, y;
};

double dot(const Direction& a, const Direction& b) { return a.x * b.x + a.y * b.y; }

Direction unit(const Point& from, const Point& to) {
  const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
  return {dx / length, dy / length};
}

class ChainBuilder {
 public:
  ChainBuilder(std::span<const Point> vertices, std::span<const BooleanExpression> edges,
               std::span<const CurveHull> hulls)
      : vertices_(vertices),
        edges_(edges),
        hulls_(hulls),
        count_(static_cast<int>(vertices.size())) {
    for (const Point& vertex : vertices_)
      for (int axis = 0; axis < 2; ++axis)
        size_ = std::max(size_, std::fabs(vertex[axis] - vertices_[0][axis]));
    rounding_ = (hulls.empty() ? 0x1p-50 : 1e-10) * size_;
  }

  BooleanExpression run() {
    // Vertices are numbered from an extreme one, where the walk around ends, too.
    for (int i = 1; i < count_; ++i)
      if (vertices_[i] < vertices_[start_]) start_ = i;
    std::vector<int> splits = vertices_of(lower_hull({0, count_, 0, count_ - 1}, {0, 1}));
    const std::vector<int> above = vertices_of(lower_hull({0, count_, 0, count_ - 1}, {0, -1}));
    splits.insert(splits.end(), above.begin(), above.end());
    return BooleanExpression::of_nodes(nodes_, parts(0, count_, splits, Kind::conjunction));
  }

  /// Edges whose curves keep all vertices of a chain off its hull.
  std::vector<int> blocking() const { return {blocking_.begin(), blocking_.end()}; }

 private:
  const Point& at(int step) const { return vertices_[(start_ + step) % count_]; }

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
    const int one = splits[0];
    const bool convex = orientation(at(one - 1), at(one), at(one + 1)) > 0;
    return parts(from, to, splits, convex ? Kind::conjunction : Kind::disjunction);
  }

  // The vertices between `from` and `to` on the hull of the chain with both ends extended.
  std::vector<int> vertices_on_hull(int from, int to) {
    const Direction back = unit(at(from + 1), at(from)), forth = unit(at(to - 1), at(to));
    Direction up{back.x + forth.x, back.y + forth.y};
    // Below this the extensions are opposite to each other, up to rounding.
    if (dot(up, up) > 1e-24) {
      std::vector<HullPoint> hull = lower_hull({from, to, from + 1, to - 1}, up);
      trim(hull, back, forth);
      return vertices_of(hull);
    }
    // Then all lies between two lines along them. Where both ends lie on the lower of these, edges
    // extended along it would meet the ends; there are other vertices on the upper one.
    up = {-back.y, back.x};
    std::vector<HullPoint> hull = lowest({from, to, from + 1, to - 1}, up);
    const double line = height(up, hull[0].point) + rounding_;
    if (height(up, at(from)) <= line && height(up, at(to)) <= line)
      hull = lowest({from, to, from + 1, to - 1}, {-up.x, -up.y});
    return vertices_of(hull);
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
    if (hulls_.empty()) return points;
    for (int step = range.from; step < range.to; ++step) {
      const int edge = (start_ + step) % count_;
      if (!hulls_[edge]) continue;
      for (const int corner : {1, 2}) points.push_back({(*hulls_[edge])[corner], -1, edge});
    }
    return points;
  }

  // The vertices among the points of a hull; edges block if there are none.
  std::vector<int> vertices_of(const std::vector<HullPoint>& hull) {
    std::vector<int> vertices;
    for (const HullPoint& point : hull)
      if (point.vertex >= 0) vertices.push_back(point.vertex);
    if (vertices.empty())
      for (const HullPoint& point : hull) blocking_.insert(point.edge);
    return vertices;
  }

  double height(const Direction& up, const Point& point) const {
    return up.x * (point[0] - vertices_[0][0]) + up.y * (point[1] - vertices_[0][1]);
  }

  std::vector<HullPoint> lowest(const Range& range, const Direction& up) const {
    double least = INFINITY;
    const std::vector<HullPoint> all = points_of(range);
    for (const HullPoint& point : all) least = std::min(least, height(up, point.point));
    std::vector<HullPoint> result;
    for (const HullPoint& point : all)
      if (height(up, point.point) <= least + rounding_) result.push_back(point);
    return result;
  }

  // Points on their convex hull as seen from below, from left to right, those on its straight parts
  // included (Andrew 1979). Corners of curves only count where they lie outside by more than
  // rounding, so that they do not hide vertices at which the curve is tangent to its chain.
  std::vector<HullPoint> lower_hull(const Range& range, const Direction& up) const {
    const Direction right{up.y, -up.x};
    std::vector<std::pair<std::array<double, 2>, HullPoint>> order;
    for (const HullPoint& point : points_of(range))
      order.push_back({{height(right, point.point), height(up, point.point)}, point});
    std::ranges::sort(order, {}, [](const auto& entry) { return entry.first; });
    std::vector<HullPoint> hull;
    const auto turns_right = [&](const HullPoint& next) {
      const HullPoint &a = hull[hull.size() - 2], &b = hull.back();
      if (hulls_.empty()) return orientation(a.point, b.point, next.point) < 0;
      const Direction along = unit(a.point, next.point);
      const double above =
          along.x * (b.point[1] - a.point[1]) - along.y * (b.point[0] - a.point[0]);
      return above > (b.vertex >= 0 ? 1e-10 : -1e-10) * size_;
    };
    for (const auto& [place, point] : order) {
      while (hull.size() > 1 && turns_right(point)) hull.pop_back();
      hull.push_back(point);
    }
    return hull;
  }

  // Removes the points of a lower hull that lie above what the extensions add to it.
  void trim(std::vector<HullPoint>& hull, const Direction& back, const Direction& forth) const {
    const bool back_is_left = back.x * forth.y - back.y * forth.x < 0;
    const Direction left = back_is_left ? back : forth, right = back_is_left ? forth : back;
    const double tolerance = hulls_.empty() ? 0 : 1e-10 * size_;
    const auto turn = [&](const Direction& d, const HullPoint& from, const HullPoint& to) {
      return d.x * (to.point[1] - from.point[1]) - d.y * (to.point[0] - from.point[0]);
    };
    while (hull.size() > 1 && turn(left, hull[0], hull[1]) >= tolerance) hull.erase(hull.begin());
    while (hull.size() > 1 && turn(right, hull.back(), hull[hull.size() - 2]) <= -tolerance)
      hull.pop_back();
  }

  // Whether the edges at a vertex extended beyond it meet nothing of the chain, which vertices on
  // the hull are spared to ask.
  bool is_free(int from, int to, int vertex) const {
    const Point& origin = at(vertex);
    const std::array<Direction, 2> rays = {unit(at(vertex - 1), origin),
                                           unit(at(vertex + 1), origin)};
    const auto meets = [&](const Direction& ray, const Point& a, const Point& b) {
      const double ax = a[0] - origin[0], ay = a[1] - origin[1];
      const double bx = b[0] - origin[0], by = b[1] - origin[1];
      const double p = ray.x * ay - ray.y * ax, q = ray.x * by - ray.y * bx;
      if (p * q > 0) return false;
      const double t = p == q ? 0 : p / (p - q);
      return dot(ray, {ax + t * (bx - ax), ay + t * (by - ay)}) >= 0;
    };
    const auto far = [&](const Point& end, const Direction& d) {
      return Point{end[0] + 1e3 * size_ * d.x, end[1] + 1e3 * size_ * d.y};
    };
    for (int step = from; step < to; ++step) {
      if (step == vertex || step == vertex - 1) continue;
      std::vector<Point> corners = {at(step), at(step + 1)};
      if (step == from) corners[0] = far(at(from), unit(at(from + 1), at(from)));
      if (step == to - 1) corners[1] = far(at(to), unit(at(to - 1), at(to)));
      if (const CurveHull& hull = hulls_[(start_ + step) % count_]; hull)
        corners.insert(corners.end(), hull->begin(), hull->end());
      for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        for (const Direction& ray : rays)
          if (meets(ray, corners[i], corners[i + 1])) return false;
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

  std::span<const Point> vertices_;
  std::span<const BooleanExpression> edges_;
  std::span<const CurveHull> hulls_;
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
  return ChainBuilder(vertices, edges, {}).run();
}

CurvedChains curved_chain_expression(std::span<const Point> vertices,
                                     std::span<const BooleanExpression> edges,
                                     std::span<const CurveHull> hulls) {
  ChainBuilder builder(vertices, edges, hulls);
  CurvedChains result{builder.run(), {}};
  result.blocking = builder.blocking();
  return result;
}

}  // namespace rfm
