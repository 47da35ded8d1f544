#include "quadrature/edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/point_algebra.hpp"
#include "core/quadric_pencil.hpp"
#include "quadrature/candidate_boxes.hpp"
#include "quadrature/compensated_sum.hpp"
#include "quadrature/gauss_legendre.hpp"
#include "quadrature/local_structure.hpp"
#include "quadrature/zero_isolation.hpp"

namespace rfm {
namespace {

Interval cross_component(const FunctionBounds& a, const FunctionBounds& b, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return a.gradient[i] * b.gradient[j] - a.gradient[j] * b.gradient[i];
}

// The coordinate over which the common zeros of two functions in a box form a graph of moderate
// slope, at most one for every value; −1 if that is not proved.
int graph_axis(const FunctionBounds& a, const FunctionBounds& b) {
  if (!a.smooth || !b.smooth) return -1;
  constexpr double flatness = 0.5;
  std::array<Interval, 3> tangent;
  for (int axis = 0; axis < 3; ++axis) tangent[axis] = cross_component(a, b, axis);
  int best = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (tangent[axis].mignitude() > tangent[best].mignitude()) best = axis;
  const double across =
      std::max(tangent[(best + 1) % 3].magnitude(), tangent[(best + 2) % 3].magnitude());
  return tangent[best].mignitude() > 0 && tangent[best].mignitude() >= flatness * across ? best
                                                                                         : -1;
}

// Traces the edge between two primitives through one part of the box.
class EdgeTracer {
 public:
  EdgeTracer(const RegionEvaluator& region, double size, const EdgeOptions& options, EdgeRule& rule)
      : region_(region),
        size_(size),
        tolerance_(options.tolerance * size),
        gauss_(gauss_legendre(options.points)),
        fewer_(gauss_legendre(std::max(1, options.points - 2))),
        rule_(rule) {}

  void trace(const CandidateBox& part, const PrimitivePair& pair) {
    part_ = &part;
    pair_ = pair;
    functions_ = {&level(pair.first), &level(pair.second)};
    boxes_left_ = most_boxes;
    visit(part.box, 0);
  }

 private:
  const LevelFunction& level(int variable) const {
    return region_.level(part_->primitives[variable]);
  }

  void visit(const Box& box, int depth) {
    // Sixteen times finer along each axis; bends too tight for that, 2¹⁸ times.
    constexpr int contact_depth = 12, most_depth = 54;
    --boxes_left_;
    const FunctionBounds a = functions_[0]->bounds(box), b = functions_[1]->bounds(box);
    if (a.value.excludes_zero() || b.value.excludes_zero() ||
        are_apart(functions_[0]->quadric(), functions_[1]->quadric(), box))
      return;
    axis_ = graph_axis(a, b);
    if (axis_ >= 0) return trace_graph(box);
    if (depth < contact_depth) {
      for (const Box& half : bisect(box, box.longest_axis())) visit(half, depth + 1);
    } else if (is_contact(box)) {
      follow_contact(box);
    } else if (depth < most_depth && boxes_left_ > 0) {
      for (const Box& half : bisect(box, box.longest_axis())) visit(half, depth + 1);
    } else {
      add_uncertified(box);
    }
  }

  // Gradients that are parallel in one point, as where two edges cross, leave a few boxes around it
  // on each level, and graphs in those beside them. Along a curve of contact boxes become more with
  // each level: there surfaces are taken to touch without forming an edge.
  void follow_contact(const Box& start) {
    constexpr int further = 42;
    constexpr std::size_t most = 100;
    std::vector<Box> now{start}, next;
    std::vector<std::pair<Box, int>> graphs;
    for (int level = 0; level < further && !now.empty(); ++level) {
      next.clear();
      for (const Box& box : now)
        for (const Box& half : bisect(box, box.longest_axis())) {
          const FunctionBounds a = functions_[0]->bounds(half), b = functions_[1]->bounds(half);
          if (a.value.excludes_zero() || b.value.excludes_zero()) continue;
          const int axis = graph_axis(a, b);
          if (axis >= 0)
            graphs.emplace_back(half, axis);
          else
            next.push_back(half);
        }
      std::swap(now, next);
      if (now.size() > most) {
        ++rule_.report.contact_boxes;
        return;
      }
    }
    around_point_ = true;
    for (const auto& [box, axis] : graphs) {
      axis_ = axis;
      trace_graph(box);
    }
    around_point_ = false;
    for (const Box& box : now) add_uncertified(box);
  }

  void add_uncertified(const Box& box) {
    ++rule_.report.uncertified_boxes;
    rule_.report.uncertified_length += box.longest_side();
  }

  // Whether gradients are parallel or vanish as nearly as a box of this size lets one see.
  bool is_contact(const Box& box) const {
    Point a{}, b{};
    functions_[0]->value_and_gradient(box.center(), a);
    functions_[1]->value_and_gradient(box.center(), b);
    constexpr double steep = 0.25;
    return norm(cross(a, b)) < steep * norm(a) * norm(b);
  }

  // Common zeros of functions on a part of the box. Where some are not simple the graph touches a
  // side or a third surface: what is beyond is seen on the parts between, and false is returned.
  bool add_stops(std::span<const LevelFunction* const> functions, const Box& where,
                 std::span<const int> axes, std::vector<Point>& stops) const {
    constexpr ZeroSearchOptions search{.smallest = 0x1p-12, .max_unresolved = 200};
    const ZeroSet zeros = isolate_zeros(functions, where, axes, search);
    stops.insert(stops.end(), zeros.zeros.begin(), zeros.zeros.end());
    if (zeros.unresolved.empty()) return true;
    const auto [first, last] = std::ranges::minmax(
        zeros.unresolved, {}, [&](const Box& touched) { return touched.low[axis_]; });
    stops.push_back(first.center());
    stops.push_back(last.center());
    return false;
  }

  void trace_graph(const Box& box) {
    std::vector<Point> stops;
    for (int across = 0; across < 3; ++across) {
      const std::array<int, 2> axes{(across + 1) % 3, (across + 2) % 3};
      for (const double side : {box.low[across], box.high[across]}) {
        Box face = box;
        face.low[across] = face.high[across] = side;
        if (add_stops(functions_, face, axes, stops)) continue;
        // Next to a contact, zeros on the side differ by less than rounding tells.
        const bool contact = is_contact(box);
        if (contact && around_point_)
          add_uncertified(box);
        else
          ++rule_.report.contact_boxes;
        if (contact) return;
      }
    }
    if (stops.size() < 2) return;
    const auto position = [&](const Point& point) { return point[axis_]; };
    std::ranges::sort(stops, {}, position);
    const Point first = stops.front(), last = stops.back();
    for (int v = 0; v < static_cast<int>(part_->primitives.size()); ++v)
      if (is_third(v) && !contains_edge(v, first, last)) {
        const std::array<const LevelFunction*, 3> three{functions_[0], functions_[1], &level(v)};
        static constexpr std::array<int, 3> axes{0, 1, 2};
        if (!add_stops(three, box, axes, stops)) ++rule_.report.contact_boxes;
      }
    std::ranges::sort(stops, {}, position);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
      if (stops[i + 1][axis_] - stops[i][axis_] > 1e-13 * size_)
        add_part(box, stops[i], stops[i + 1]);
  }

  bool is_third(int variable) const {
    const int surface = part_->surfaces[variable];
    return surface != part_->surfaces[pair_.first] && surface != part_->surfaces[pair_.second];
  }

  // The point of the graph near the chord from `from` to `to`.
  bool graph_point(const Point& from, const Point& to, double t, Point& point) const {
    const std::array<int, 2> axes{(axis_ + 1) % 3, (axis_ + 2) % 3};
    for (int axis = 0; axis < 3; ++axis) point[axis] = from[axis] + t * (to[axis] - from[axis]);
    return newton_zero(functions_, axes, norm(along(to, -1, from)), point);
  }

  // Whether a third primitive vanishes on the whole edge, as far as samples tell.
  bool contains_edge(int variable, const Point& from, const Point& to) const {
    for (const double t : {0.0, 0.17, 0.41, 0.73, 1.0}) {
      Point point = t == 0 ? from : to, gradient{};
      if (t > 0 && t < 1 && !graph_point(from, to, t, point)) return false;
      const double value = level(variable).value_and_gradient(point, gradient);
      if (std::fabs(value) > rounding * size_ * norm(gradient)) return false;
    }
    return true;
  }

  void add_part(const Box& box, const Point& from, const Point& to) {
    Point middle{};
    if (!graph_point(from, to, 0.5, middle)) return add_uncertified(box);
    if (box.contains(middle) && is_edge(middle)) add_rule(box, from, to, 0);
  }

  // Length by a rule, and its points; none where Newton's method does not find one.
  std::optional<double> length_by(const GaussRule& gauss, const Point& from, const Point& to,
                                  std::vector<Point>& points) const {
    points.resize(gauss.size());
    double sum = 0;
    for (int i = 0; i < gauss.size(); ++i) {
      if (!graph_point(from, to, gauss.nodes[i], points[i])) return std::nullopt;
      const Point t = tangent_at(points[i]);
      sum += gauss.weights[i] * norm(t) / std::fabs(t[axis_]);
    }
    return sum * (to[axis_] - from[axis_]);
  }

  void add_rule(const Box& box, const Point& from, const Point& to, int depth) {
    constexpr int most_depth = 8;
    std::vector<Point> points;
    const std::optional<double> coarse = length_by(fewer_, from, to, points);
    const std::optional<double> fine = length_by(gauss_, from, to, points);
    if (!coarse || !fine) return add_uncertified(box);
    const double difference = std::fabs(*fine - *coarse);
    Point middle{};
    if (difference > tolerance_ && depth < most_depth && graph_point(from, to, 0.5, middle)) {
      add_rule(box, from, middle, depth + 1);
      return add_rule(box, middle, to, depth + 1);
    }
    rule_.report.order_difference += difference;
    const double width = to[axis_] - from[axis_];
    for (int i = 0; i < gauss_.size(); ++i) add_point(points[i], width * gauss_.weights[i]);
  }

  // Its length is that of the gradients times the sine between them.
  Point tangent_at(const Point& point) const {
    Point a{}, b{};
    functions_[0]->value_and_gradient(point, a);
    functions_[1]->value_and_gradient(point, b);
    return cross(a, b);
  }

  LocalStructure structure_at(const Point& point) const {
    return LocalStructure(region_, part_->table, part_->primitives, point, rounding * size_);
  }

  // Where more than two surfaces meet in one curve, the first pair of them has it.
  bool is_edge(const Point& point) const {
    const LocalStructure structure = structure_at(point);
    const auto vanishes = [&](int variable) {
      return std::ranges::find(structure.primitives, part_->primitives[variable]) !=
             structure.primitives.end();
    };
    for (const PrimitivePair& pair : part_->pairs) {
      if (!vanishes(pair.first) || !vanishes(pair.second)) continue;
      Point a{}, b{};
      level(pair.first).value_and_gradient(point, a);
      level(pair.second).value_and_gradient(point, b);
      if (norm(cross(a, b)) <= 1e-9 * norm(a) * norm(b)) continue;
      if (pair.first != pair_.first || pair.second != pair_.second) return false;
      const Point t = cross(a, b);
      const auto [u, v] = plane_across(scaled(1 / norm(t), t));
      return walk_sectors(structure, u, v).is_corner;
    }
    return false;
  }

  void add_point(const Point& point, double weight) {
    const Point t = tangent_at(point);
    const double length = norm(t);
    const Point tangent = scaled(1 / length, t);
    const auto [u, v] = plane_across(tangent);
    EdgePoints& points = rule_.points;
    for (int axis = 0; axis < 3; ++axis) {
      points.coordinates[axis].push_back(point[axis]);
      points.tangents[axis].push_back(tangent[axis]);
    }
    points.weights.push_back(weight * length / std::fabs(t[axis_]));
    points.first.push_back(part_->primitives[pair_.first]);
    points.second.push_back(part_->primitives[pair_.second]);
    points.angles.push_back(walk_sectors(structure_at(point), u, v).angle);
  }

  static constexpr double rounding = 1e-12;
  // For one pair of primitives in one part of the box.
  static constexpr int most_boxes = 20000;
  int boxes_left_ = 0;
  const RegionEvaluator& region_;
  double size_, tolerance_;
  const GaussRule &gauss_, &fewer_;
  EdgeRule& rule_;
  const CandidateBox* part_ = nullptr;
  PrimitivePair pair_{};
  std::array<const LevelFunction*, 2> functions_{};
  int axis_ = 0;
  // The surfaces touch in a point of the box, not along a curve.
  bool around_point_ = false;
};

template <class Include>
double sum_of_weights(const EdgePoints& points, Include&& include) {
  CompensatedSum sum;
  for (int i = 0; i < points.size(); ++i)
    if (include(i)) sum.add(points.weights[i]);
  return sum.value();
}

}  // namespace

Point EdgePoints::point(int i) const {
  return {coordinates[0][i], coordinates[1][i], coordinates[2][i]};
}

Point EdgePoints::tangent(int i) const { return {tangents[0][i], tangents[1][i], tangents[2][i]}; }

double EdgePoints::length() const {
  return sum_of_weights(*this, [](int) { return true; });
}

double EdgePoints::length(int primitive, int other) const {
  return sum_of_weights(*this, [&](int i) {
    return (first[i] == primitive && second[i] == other) ||
           (first[i] == other && second[i] == primitive);
  });
}

EdgeRule make_edge_rule(const RegionEvaluator& region, const Box& box, const EdgeOptions& options) {
  if (region.dimension() != 3) throw InvalidArgument("edges are those of bodies in space");
  if (options.cells < 1) throw InvalidArgument("edges need one cell or more");
  if (!(options.tolerance >= 0)) throw InvalidArgument("a tolerance is not negative");
  EdgeRule rule;
  const double size = box.longest_side();
  EdgeTracer tracer(region, size, options, rule);
  const int crowded =
      visit_candidate_boxes(region, box, size / options.cells, [&](const CandidateBox& part) {
        for (const PrimitivePair& pair : part.pairs) tracer.trace(part, pair);
      });
  rule.report.uncertified_boxes += crowded;
  rule.report.uncertified_length += crowded * 0x1p-10 * size / options.cells;
  return rule;
}

}  // namespace rfm
