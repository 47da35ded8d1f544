#include "core/polygon.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/contour_nesting.hpp"
#include "core/error.hpp"
#include "core/line_groups.hpp"
#include "core/polygon_chains.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

// All edges of all contours, those of a contour one after the other.
struct Edges {
  std::vector<Segment> segments;
  std::vector<int> next;
  std::vector<std::string> names;
  std::vector<int> contour;
  std::vector<int> number;  ///< in the contour as given
};

Edges edges_of(const std::vector<Contour>& contours, const std::vector<CleanContour>& clean) {
  Edges edges;
  for (std::size_t c = 0; c < clean.size(); ++c) {
    const auto& points = clean[c].points;
    const int first = static_cast<int>(edges.segments.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      edges.segments.push_back({points[i], points[(i + 1) % points.size()]});
      edges.next.push_back(first + static_cast<int>((i + 1) % points.size()));
      edges.names.push_back(contours[c].name(clean[c].edges[i]));
      edges.contour.push_back(static_cast<int>(c));
      edges.number.push_back(clean[c].edges[i]);
    }
  }
  return edges;
}

// The disk over a segment: of its line, exactly the segment.
Field disk_over(const Segment& segment) {
  const Field x = x_coordinate(), y = y_coordinate();
  return (x - segment.from[0]) * (segment.to[0] - x) + (y - segment.from[1]) * (segment.to[1] - y);
}

// A contour as a whole.
OutlineSide side_of_contour(int contour, const std::string& name, const Edges& edges,
                            const LineGroups& groups, const std::vector<std::string>& group_names) {
  std::set<std::string> pieces;
  std::optional<Field> where;
  bool shared = false;
  for (std::size_t i = 0; i < edges.segments.size(); ++i) {
    if (edges.contour[i] != contour) continue;
    const int group = groups.group[i];
    pieces.insert(group_names[group]);
    shared = shared || std::ranges::any_of(groups.members[group], [&](int other) {
               return edges.contour[other] != contour;
             });
    const Field own = disk_over(edges.segments[i]);
    where = where ? max(*where, own) : own;
  }
  if (!shared) where.reset();
  return {name, {pieces.begin(), pieces.end()}, where};
}

std::vector<OutlineSide> sides_of(const std::vector<Contour>& contours, const Edges& edges,
                                  const LineGroups& groups,
                                  const std::vector<std::string>& group_names) {
  std::vector<OutlineSide> sides;
  for (std::size_t i = 0; i < edges.segments.size(); ++i)
    if (groups.members[groups.group[i]].size() > 1)
      sides.push_back(
          {edges.names[i], {group_names[groups.group[i]]}, disk_over(edges.segments[i])});
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const std::string& prefix = contours[c].prefix;
    if (prefix.ends_with("_"))
      sides.push_back(side_of_contour(static_cast<int>(c), prefix.substr(0, prefix.size() - 1),
                                      edges, groups, group_names));
  }
  return sides;
}

// One half-plane per line, named after its first edge.
std::vector<std::shared_ptr<const Primitive>> half_planes(const Edges& edges,
                                                          const LineGroups& groups) {
  std::vector<std::shared_ptr<const Primitive>> primitives;
  for (std::size_t g = 0; g < groups.members.size(); ++g) {
    const auto& members = groups.members[g];
    const int first = std::ranges::min(
        members, {}, [&](int i) { return std::pair(edges.contour[i], edges.number[i]); });
    const auto& [from, to] = groups.lines[g];
    Primitive primitive = *half_plane(from, {from[1] - to[1], to[0] - from[0]}).primitives()[0];
    primitive.name = edges.names[first] + (members.size() > 1 ? "_line" : "");
    primitives.push_back(std::make_shared<const Primitive>(std::move(primitive)));
  }
  return primitives;
}

// Each contour as an expression over the lines of its edges.
std::vector<BooleanExpression> expressions_of(const std::vector<CleanContour>& contours,
                                              const LineGroups& groups) {
  std::vector<BooleanExpression> expressions;
  int first = 0;
  for (const CleanContour& contour : contours) {
    const int count = static_cast<int>(contour.points.size());
    std::vector<Point> vertices;
    std::vector<BooleanExpression> leaves;
    for (int i = 0; i < count; ++i) {
      const int group = groups.group[first + i];
      if (group == groups.group[first + (i + count - 1) % count]) continue;  // on a straight edge
      vertices.push_back(contour.points[i]);
      leaves.push_back(BooleanExpression::variable(group));
    }
    if (vertices.size() < 3) throw InvalidArgument("the polygon has no area");
    expressions.push_back(chain_expression(vertices, leaves));
    first += count;
  }
  return expressions;
}

Box box_of(const std::vector<std::vector<Point>>& contours) {
  Box box{2, contours[0][0], contours[0][0]};
  for (const std::vector<Point>& points : contours)
    for (const Point& point : points)
      for (int axis = 0; axis < 2; ++axis) {
        box.low[axis] = std::min(box.low[axis], point[axis]);
        box.high[axis] = std::max(box.high[axis], point[axis]);
      }
  return box;
}

}  // namespace

Outline polygon(const std::vector<Contour>& contours) {
  if (contours.empty()) throw InvalidArgument("a polygon needs a contour");
  std::vector<CleanContour> clean;
  for (const Contour& contour : contours) clean.push_back(cleaned(contour));
  const Edges edges = edges_of(contours, clean);
  if (const auto pair = intersecting_pair(edges.segments, edges.next))
    throw InvalidArgument(edges.names[pair->first] + " and " + edges.names[pair->second] +
                          " cross or touch each other");
  const LineGroups groups = group_by_line(edges.segments);
  auto primitives = half_planes(edges, groups);
  std::vector<std::string> names;
  for (const auto& primitive : primitives) names.push_back(primitive->name);
  const std::vector<BooleanExpression> expressions = expressions_of(clean, groups);
  std::vector<std::vector<Point>> points;
  for (const CleanContour& contour : clean) points.push_back(contour.points);
  BooleanExpression whole = nested_expression(points, expressions);
  return {Region(2, std::move(primitives), std::move(whole)).within(box_of(points)),
          sides_of(contours, edges, groups, names)};
}

Region polygon(const std::vector<Point>& points) { return polygon({Contour{points}}).region; }

}  // namespace rfm
