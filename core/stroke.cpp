#include "core/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/edge_intersections.hpp"
#include "core/error.hpp"

namespace rfm {
namespace {

// A part of the boundary of the stroke, which lies on its left, or so it seems until it is compared
// with the others.
struct Side {
  CircularEdge edge;
  const char* group;
};

Point shifted_left(const Point& point, const Point& direction, double distance) {
  return {point[0] - distance * direction[1], point[1] + distance * direction[0]};
}

// The edge moved to its left; nothing where that leads to the centre of its circle or beyond.
std::optional<CircularEdge> offset_left(const CircularEdge& edge, double distance) {
  if (edge.curvature() * distance >= 1 - 1e-12) return {};
  return CircularEdge{shifted_left(edge.from, edge.start_direction(), distance),
                      shifted_left(edge.to, edge.end_direction(), distance), edge.bulge};
}

// Sides of an outline before they are cut.
class SideList {
 public:
  SideList(const std::vector<CircularEdge>& chain, bool closed, double radius) : radius_(radius) {
    const std::size_t count = chain.size();
    for (std::size_t i = 0; i < count; ++i) {
      // The stroke is on the left of its right side, walked forwards, and of its left one, walked
      // back.
      if (const auto right = offset_left(chain[i], -radius)) add(*right, "right");
      if (const auto left = offset_left(chain[i].reversed(), -radius)) add(*left, "left");
      if (closed || i + 1 < count) add_corner(chain[i], chain[(i + 1) % count]);
    }
    if (closed) return;
    const Point first = chain.front().start_direction(), last = chain.back().end_direction();
    add_turn(chain.back().to, last, pi_, "end");
    add_turn(chain.front().from, {-first[0], -first[1]}, pi_, "start");
  }

  const std::vector<Side>& sides() const { return sides_; }

 private:
  void add(const CircularEdge& edge, const char* group) { sides_.push_back({edge, group}); }

  // About a point, from the right of a direction counter-clockwise.
  void add_turn(const Point& center, const Point& direction, double angle, const char* group) {
    const int parts = angle > pi_ / 2 ? 2 : 1;
    for (int i = 0; i < parts; ++i) {
      const auto at = [&](int k) {
        const double turned = angle * k / parts, c = std::cos(turned), s = std::sin(turned);
        return shifted_left(
            center, {c * direction[0] - s * direction[1], s * direction[0] + c * direction[1]},
            -radius_);
      };
      add({at(i), at(i + 1), std::tan(angle / parts / 4)}, group);
    }
  }

  void add_corner(const CircularEdge& before, const CircularEdge& after) {
    const Point in = before.end_direction(), out = after.start_direction();
    const double angle =
        std::atan2(in[0] * out[1] - in[1] * out[0], in[0] * out[0] + in[1] * out[1]);
    if (std::fabs(angle) < smallest_turn_) return;
    if (angle > 0)
      add_turn(before.to, in, angle, "right");
    else
      add_turn(before.to, {-out[0], -out[1]}, -angle, "left");
  }

  static constexpr double pi_ = 3.14159265358979323846;
  static constexpr double smallest_turn_ = 1e-9;  // then the sides meet within their rounding
  double radius_;
  std::vector<Side> sides_;
};

double distance_from(const std::vector<CircularEdge>& chain, const Point& point) {
  double least = INFINITY;
  for (const CircularEdge& edge : chain) least = std::min(least, edge.distance(point));
  return least;
}

bool overlap(const Box& a, const Box& b, double margin) {
  for (int axis = 0; axis < 2; ++axis)
    if (a.low[axis] > b.high[axis] + margin || b.low[axis] > a.high[axis] + margin) return false;
  return true;
}

double apart(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

// Where along an edge a point of it lies: its length, or the angle.
double place_on(const CircularEdge& edge, const Point& point) {
  if (edge.bulge == 0) return apart(edge.from, point) / edge.chord();
  return std::atan(CircularEdge::leaving(edge.from, edge.start_direction(), point).bulge /
                   (edge.bulge > 0 ? 1 : -1));
}

// For each side the points where it is cut, along it: where it crosses others, and where others
// begin and end on it, as those that lie on the same line or circle do.
std::vector<std::vector<Point>> cuts_of(const std::vector<Side>& sides, double tolerance) {
  std::vector<Box> boxes;
  for (const Side& side : sides) boxes.push_back(side.edge.bounding_box());
  std::vector<std::vector<Point>> cuts(sides.size());
  const auto add = [&](std::size_t side, const Point& point) {
    const CircularEdge& edge = sides[side].edge;
    if (edge.distance(point) <= tolerance && apart(point, edge.from) > tolerance &&
        apart(point, edge.to) > tolerance)
      cuts[side].push_back(point);
  };
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (!overlap(boxes[i], boxes[j], tolerance)) continue;
      const CircularEdge &a = sides[i].edge, &b = sides[j].edge;
      for (const Point& point : crossings(a, b)) {
        if (a.distance(point) > tolerance || b.distance(point) > tolerance) continue;
        add(i, point);
        add(j, point);
      }
      for (const Point& end : {a.from, a.to}) add(j, end);
      for (const Point& end : {b.from, b.to}) add(i, end);
    }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::ranges::sort(cuts[i], {}, [&](const Point& p) { return place_on(sides[i].edge, p); });
    const auto [first, last] = std::ranges::unique(
        cuts[i], [&](const Point& p, const Point& q) { return apart(p, q) <= tolerance; });
    cuts[i].erase(first, last);
  }
  return cuts;
}

CircularEdge part(const CircularEdge& edge, const Point& from, const Point& to) {
  CircularEdge result = to == edge.to ? edge : edge.divided_at(to)[0];
  return from == edge.from ? result : result.divided_at(from)[1];
}

// A part of a side that may be part of the boundary.
struct Part {
  CircularEdge edge;
  std::size_t side;
};

// What no point of the chain is nearer to than the radius.
void add_parts(const std::vector<Side>& sides, std::size_t side, std::vector<Point> cuts,
               const std::vector<CircularEdge>& chain, double radius, std::vector<Part>& kept) {
  const CircularEdge& edge = sides[side].edge;
  cuts.insert(cuts.begin(), edge.from);
  cuts.push_back(edge.to);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const CircularEdge piece = part(edge, cuts[i], cuts[i + 1]);
    if (distance_from(chain, piece.middle()) >= radius * (1 - 1e-9)) kept.push_back({piece, side});
  }
}

// Of parts that coincide the first; none where the stroke lies on both sides.
std::vector<Part> without_repetitions(const std::vector<Part>& parts, double tolerance) {
  const auto coincide = [&](const CircularEdge& a, const CircularEdge& b) {
    return apart(a.from, b.from) <= tolerance && apart(a.to, b.to) <= tolerance &&
           apart(a.middle(), b.middle()) <= tolerance;
  };
  std::vector<Part> once;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    bool is_boundary = true;
    for (std::size_t k = 0; k < parts.size() && is_boundary; ++k)
      is_boundary = !(k < i && coincide(parts[k].edge, parts[i].edge)) &&
                    !(k != i && coincide(parts[k].edge, parts[i].edge.reversed()));
    if (is_boundary) once.push_back(parts[i]);
  }
  return once;
}

// The part that goes on where `before` ends; where several do, the one farthest to the left.
std::size_t next_part(const std::vector<Part>& parts, const std::vector<bool>& used,
                      const CircularEdge& before, double tolerance) {
  std::size_t next = parts.size();
  double leftmost = 0;
  const Point in = before.end_direction();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (used[k] || apart(before.to, parts[k].edge.from) > tolerance) continue;
    const Point out = parts[k].edge.start_direction();
    const double turn =
        std::atan2(in[0] * out[1] - in[1] * out[0], in[0] * out[0] + in[1] * out[1]);
    if (next < parts.size() && turn <= leftmost) continue;
    next = k;
    leftmost = turn;
  }
  return next;
}

// Parts one after the other, each beginning where another one ends; those of a side that follow
// each other as one.
std::vector<CurvedContour> joined(const std::vector<Part>& parts, const std::vector<Side>& sides,
                                  double tolerance) {
  std::vector<CurvedContour> contours;
  std::vector<bool> used(parts.size(), false);
  std::map<std::string, int> counts;
  for (std::size_t first = 0; first < parts.size(); ++first) {
    if (used[first]) continue;
    std::vector<Part> loop;
    for (std::size_t i = first; i < parts.size();) {
      used[i] = true;
      if (!loop.empty() && loop.back().side == parts[i].side)
        loop.back().edge = part(sides[parts[i].side].edge, loop.back().edge.from, parts[i].edge.to);
      else
        loop.push_back(parts[i]);
      if (apart(parts[i].edge.to, parts[first].edge.from) <= tolerance) break;
      i = next_part(parts, used, parts[i].edge, tolerance);
      if (i == parts.size()) throw InvalidArgument("the stroke touches itself");
    }
    if (loop.size() > 1 && loop.front().side == loop.back().side) {
      const CircularEdge& edge = sides[loop.front().side].edge;
      loop.front().edge = part(edge, loop.back().edge.from, loop.front().edge.to);
      loop.pop_back();
    }
    CurvedContour& contour = contours.emplace_back();
    for (const Part& piece : loop) {
      const std::string group = sides[piece.side].group;
      contour.points.push_back(piece.edge.from);
      contour.edges.push_back({piece.edge.bulge, {}});
      contour.groups.push_back(group);
      contour.names.push_back(group + std::to_string(++counts[group]));
    }
  }
  return contours;
}

}  // namespace

std::vector<CircularEdge> polyline_edges(const std::vector<Point>& points, bool closed) {
  std::vector<CircularEdge> edges;
  const auto add = [&](const Point& from, const Point& to) {
    if (from != to) edges.push_back({from, to, 0});
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1]))
      throw InvalidArgument("the coordinates of point " + std::to_string(i + 1) +
                            " are not finite");
    if (i > 0) add(points[i - 1], points[i]);
  }
  if (closed && !points.empty()) add(points.back(), points.front());
  if (edges.empty()) throw InvalidArgument("a polyline needs two different points");
  return edges;
}

std::vector<CurvedContour> stroke_outline(const std::vector<CircularEdge>& chain, bool closed,
                                          double width) {
  if (!(width > 0) || chain.empty())
    throw InvalidArgument("a stroke needs a curve and a positive width");
  const double radius = width / 2;
  const SideList all(chain, closed, radius);
  double size = radius;
  for (const Side& side : all.sides())
    size = std::max({size, std::fabs(side.edge.from[0]), std::fabs(side.edge.from[1])});
  const double tolerance = 1e-10 * size;
  const auto cuts = cuts_of(all.sides(), tolerance);
  std::vector<Part> kept;
  for (std::size_t i = 0; i < cuts.size(); ++i)
    add_parts(all.sides(), i, cuts[i], chain, radius, kept);
  return joined(without_repetitions(kept, 10 * tolerance), all.sides(), 10 * tolerance);
}

}  // namespace rfm
