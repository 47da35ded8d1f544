#include "core/stroke_region.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/curved_polygon.hpp"
#include "core/error.hpp"
#include "core/line_groups.hpp"
#include "core/primitives.hpp"
#include "core/stroke.hpp"

namespace rfm {
namespace {

Point shifted_left(const Point& point, const Point& direction, double distance) {
  return {point[0] - distance * direction[1], point[1] + distance * direction[0]};
}

double distance_from(const std::vector<CircularEdge>& chain, const Point& point) {
  double least = INFINITY;
  for (const CircularEdge& edge : chain) least = std::min(least, edge.distance(point));
  return least;
}

// Parts of a chain of segments and arcs, as primitives and an expression.
class StrokeUnion {
 public:
  StrokeUnion(const std::vector<CircularEdge>& chain, bool closed, double radius)
      : chain_(chain), closed_(closed), radius_(radius) {
    find_lines();
    for (std::size_t i = 0; i < chain.size(); ++i)
      whole_ = whole_ | (chain[i].bulge == 0 ? band(i) : ring(i));
    for (std::size_t i = 0; i < chain.size(); ++i) add_joint(i);
  }

  Outline outline() const {
    std::vector<std::shared_ptr<const Primitive>> primitives;
    for (const Primitive& primitive : primitives_)
      primitives.push_back(std::make_shared<const Primitive>(primitive));
    Box box{2, chain_[0].from, chain_[0].from};
    for (const CircularEdge& edge : chain_) {
      const Box own = edge.bounding_box();
      for (int axis = 0; axis < 2; ++axis) {
        box.low[axis] = std::min(box.low[axis], own.low[axis] - radius_);
        box.high[axis] = std::max(box.high[axis], own.high[axis] + radius_);
      }
    }
    std::vector<OutlineSide> sides;
    for (const auto& [name, pieces] : sides_)
      sides.push_back({name, {pieces.begin(), pieces.end()}, std::nullopt});
    return {Region(2, std::move(primitives), whole_).within(box), std::move(sides)};
  }

 private:
  // The offsets of the segments to the right, walked forwards, and to the left, walked back: those
  // on one line with the stroke on the same side share a half-plane.
  void find_lines() {
    std::vector<Segment> offsets;
    for (const CircularEdge& edge : chain_) {
      if (edge.bulge != 0) continue;
      const Point along = edge.start_direction();
      offsets.push_back(
          {shifted_left(edge.from, along, -radius_), shifted_left(edge.to, along, -radius_)});
      offsets.push_back(
          {shifted_left(edge.to, along, radius_), shifted_left(edge.from, along, radius_)});
    }
    if (!offsets.empty()) lines_ = group_by_line(offsets);
  }

  BooleanExpression band(std::size_t i) {
    const BooleanExpression right = offset_line("right"), left = offset_line("left");
    return right & left & ends(chain_[i]);
  }

  BooleanExpression offset_line(const std::string& side) {
    const int group = lines_.group[next_offset_++];
    const auto known = line_.find(group);
    if (known != line_.end()) {
      sides_[side].insert(primitives_[known->second].name);
      return BooleanExpression::variable(known->second);
    }
    const auto& [from, to] = lines_.lines[group];
    return BooleanExpression::variable(
        line_[group] = add(half_plane(from, {from[1] - to[1], to[0] - from[0]}), side, false));
  }

  // Beyond its beginning and before its end; of more than half a circle, one of both.
  BooleanExpression ends(const CircularEdge& edge) {
    const Point in = edge.start_direction(), out = edge.end_direction();
    const int after = add(half_plane(edge.from, in), "", true),
              before = add(half_plane(edge.to, {-out[0], -out[1]}), "", true);
    const BooleanExpression a = BooleanExpression::variable(after),
                            b = BooleanExpression::variable(before);
    return std::fabs(edge.bulge) <= 1 ? a & b : a | b;
  }

  BooleanExpression ring(std::size_t i) {
    const CircularEdge& edge = chain_[i];
    const double radius = 1 / std::fabs(edge.curvature());
    const std::string outer = edge.bulge > 0 ? "right" : "left",
                      inner = edge.bulge > 0 ? "left" : "right";
    BooleanExpression result = disk(edge.center(), radius + radius_, outer) & ends(edge);
    if (radius > radius_ * (1 + 1e-12)) {
      result = result & !disk(edge.center(), radius - radius_, inner);
    }
    return result;
  }

  void add_joint(std::size_t i) {
    const CircularEdge &edge = chain_[i], &next = chain_[(i + 1) % chain_.size()];
    if (!closed_ && i == 0) whole_ = whole_ | disk(edge.from, radius_, "start");
    const bool last = !closed_ && i + 1 == chain_.size();
    const Point in = edge.end_direction(), out = next.start_direction();
    const bool turns_left = in[0] * out[1] - in[1] * out[0] > 0;
    whole_ = whole_ | disk(edge.to, radius_, last ? "end" : turns_left ? "right" : "left");
  }

  BooleanExpression disk(const Point& center, double radius, const std::string& side) {
    const auto same = [&](const auto& circle) {
      return std::hypot(circle.center[0] - center[0], circle.center[1] - center[1]) +
                 std::fabs(circle.radius - radius) <=
             1e-12 * radius;
    };
    const auto known = std::ranges::find_if(circles_, same);
    if (known != circles_.end()) {
      sides_[side].insert(primitives_[known->primitive].name);
      return BooleanExpression::variable(known->primitive);
    }
    const int number = add(circle(center, radius), side, false);
    circles_.push_back({center, radius, number});
    return BooleanExpression::variable(number);
  }

  int add(const Region& region, const std::string& side, bool selects_only) {
    Primitive primitive = *region.primitives()[0];
    primitive.selects_only = selects_only;
    const std::string kind = selects_only ? "separator" : side;
    primitive.name = kind + std::to_string(++counts_[kind]);
    if (!selects_only) sides_[side].insert(primitive.name);
    primitives_.push_back(std::move(primitive));
    return static_cast<int>(primitives_.size()) - 1;
  }

  struct Circle {
    Point center;
    double radius;
    int primitive;
  };
  const std::vector<CircularEdge>& chain_;
  bool closed_;
  double radius_;
  LineGroups lines_;
  std::size_t next_offset_ = 0;
  std::map<int, int> line_;  // of a group, its primitive
  std::vector<Circle> circles_;
  std::vector<Primitive> primitives_;
  std::map<std::string, int> counts_;
  std::map<std::string, std::set<std::string>> sides_;
  BooleanExpression whole_ = BooleanExpression::constant(false);
};

std::vector<CircularEdge> edges_of(const std::vector<CurvedContour>& contours) {
  std::vector<CircularEdge> edges;
  for (const CurvedContour& contour : contours)
    for (std::size_t i = 0; i < contour.points.size(); ++i)
      edges.push_back({contour.points[i], contour.points[(i + 1) % contour.points.size()],
                       contour.edges[i].bulge});
  return edges;
}

}  // namespace

bool is_stroke(const Region& region, const std::vector<CircularEdge>& chain,
               const std::vector<CircularEdge>& outline, double width) {
  const RegionEvaluator evaluator(region);
  const double radius = width / 2;
  const auto agrees = [&](const Point& x) {
    const double distance = distance_from(chain, x);
    return std::fabs(distance - radius) <= 1e-9 * radius ||
           (distance < radius) == evaluator.contains(x);
  };
  // Both sides of an edge at a distance: in its middle and in the middles of its halves.
  const auto agrees_beside = [&](const CircularEdge& edge, double step) {
    const auto halves = edge.divided_at(edge.middle());
    for (const CircularEdge& part : {edge, halves[0], halves[1]}) {
      const Point m = part.middle();
      const Point along{(part.to[0] - part.from[0]) / part.chord(),
                        (part.to[1] - part.from[1]) / part.chord()};
      if (!agrees(shifted_left(m, along, step)) || !agrees(shifted_left(m, along, -step)))
        return false;
    }
    return true;
  };
  return std::ranges::all_of(outline,
                             [&](const CircularEdge& edge) {
                               return agrees_beside(edge, 1e-4 * std::min(edge.chord(), radius));
                             }) &&
         std::ranges::all_of(chain, [&](const CircularEdge& edge) {
           return agrees_beside(edge, 0.01 * radius) && agrees_beside(edge, 0.99 * radius) &&
                  agrees_beside(edge, 1.01 * radius);
         });
}

Outline stroke_union(const std::vector<CircularEdge>& chain, bool closed, double width) {
  if (!(width > 0) || chain.empty())
    throw InvalidArgument("a stroke needs a curve and a positive width");
  return StrokeUnion(chain, closed, width / 2).outline();
}

Outline stroke(const std::vector<CircularEdge>& chain, bool closed, double width) {
  if (!(width > 0) || chain.empty())
    throw InvalidArgument("a stroke needs a curve and a positive width");
  try {
    const std::vector<CurvedContour> contours = stroke_outline(chain, closed, width);
    Outline outline = curved_polygon(contours);
    if (is_stroke(outline.region, chain, edges_of(contours), width)) return outline;
  } catch (const InvalidArgument&) {
    // The outline touches itself.
  }
  return stroke_union(chain, closed, width);
}

}  // namespace rfm
