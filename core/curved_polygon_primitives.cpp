#include "core/curved_polygon_primitives.hpp"

#include <cmath>
#include <set>

#include "core/edge_primitives.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

bool same_circle(const CurvedEdge& a, const CurvedEdge& b) {
  if (!a.center || !b.center) return false;
  const double distance =
      std::hypot((*a.center)[0] - (*b.center)[0], (*a.center)[1] - (*b.center)[1]);
  return distance + std::fabs(a.radius - b.radius) <= 1e-13 * (a.radius + b.radius);
}

}  // namespace

CurvedPolygonPrimitives::CurvedPolygonPrimitives(
    const std::vector<CurvedEdge>& edges, const std::vector<std::vector<ContourLink>>& contours)
    : edges_(edges), contours_(contours) {
  add_lines();
}

BooleanExpression CurvedPolygonPrimitives::leaf(const ContourLink& link,
                                                const BooleanExpression& chord) {
  const CurvePiece& piece = link.piece;
  if (piece.is_straight()) return chord;
  const int number = curve(piece.edge);
  BooleanExpression inside = BooleanExpression::variable(number);
  if (const int branch = branch_of_[number]; branch >= 0)
    inside = inside & BooleanExpression::variable(branch);
  if (piece.turn < 0) return chord & !inside;
  if (edges_[piece.edge].center && holds_everything(number)) return inside;
  return chord | inside;
}

std::vector<std::shared_ptr<const Primitive>> CurvedPolygonPrimitives::primitives() {
  mark_smooth_joints();
  std::vector<std::shared_ptr<const Primitive>> list;
  for (const Primitive& primitive : primitives_)
    list.push_back(std::make_shared<const Primitive>(primitive));
  return list;
}

std::vector<OutlineSide> CurvedPolygonPrimitives::sides() const {
  std::vector<OutlineSide> sides;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Primitive& primitive = primitives_[curve_of_.at(static_cast<int>(e))];
    if (primitive.name != edges_[e].name)
      sides.push_back({edges_[e].name, {primitive.name}, part_of_curve(edges_[e])});
  }
  add_groups(sides);
  return sides;
}

// Sides of several edges; only parts of primitives that edges of other groups share.
void CurvedPolygonPrimitives::add_groups(std::vector<OutlineSide>& sides) const {
  std::map<std::string, std::vector<int>> groups;
  std::map<int, std::set<std::string>> groups_of;  // of primitives
  for (const auto& [edge, primitive] : curve_of_) {
    groups_of[primitive].insert(edges_[edge].group);
    if (!edges_[edge].group.empty()) groups[edges_[edge].group].push_back(edge);
  }
  for (const auto& [name, edges] : groups) {
    std::set<std::string> pieces;
    std::optional<Field> where;
    bool shared = false;
    for (const int edge : edges) {
      const int primitive = curve_of_.at(edge);
      pieces.insert(primitives_[primitive].name);
      shared = shared || groups_of[primitive].size() > 1;
      where = where ? max(*where, part_of_curve(edges_[edge])) : part_of_curve(edges_[edge]);
    }
    sides.push_back({name, {pieces.begin(), pieces.end()}, shared ? where : std::nullopt});
  }
}

void CurvedPolygonPrimitives::mark_smooth_joints() {
  // Splines through rounded points turn by less than this where they pass into a line.
  constexpr double gentle = 0.01;
  for (const auto& contour : contours_)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const CurvePiece& piece = contour[i].piece;
      std::size_t next = (i + 1) % contour.size();
      while (contour[next].is_tangent) next = (next + 1) % contour.size();
      const CurvePiece& other = contour[next].piece;
      if (contour[i].is_tangent || curve_of_.at(piece.edge) == curve_of_.at(other.edge)) continue;
      if (std::fabs(cross(piece.end_direction(), other.start_direction())) > gentle) continue;
      for (const int edge : {piece.edge, other.edge})
        primitives_[curve_of_.at(edge)].joins_smoothly = true;
    }
}

// Chords of all links, grouped by line; a group without a straight edge is a separator.
void CurvedPolygonPrimitives::add_lines() {
  std::vector<Segment> segments;
  std::vector<const ContourLink*> links;
  for (const auto& contour : contours_)
    for (const ContourLink& link : contour) {
      segments.push_back({link.piece.from, link.piece.to});
      links.push_back(&link);
    }
  lines_ = group_by_line(segments);
  for (std::size_t g = 0; g < lines_.members.size(); ++g) {
    std::set<int> straight;
    for (const int i : lines_.members[g])
      if (links[i]->piece.is_straight() && !links[i]->is_tangent)
        straight.insert(links[i]->piece.edge);
    const auto& [from, to] = lines_.lines[g];
    Primitive primitive = *half_plane(from, {from[1] - to[1], to[0] - from[0]}).primitives()[0];
    primitive.selects_only = straight.empty();
    const int first =
        straight.empty() ? links[lines_.members[g][0]]->piece.edge : *straight.begin();
    primitive.name = edges_[first].name;
    if (straight.empty()) primitive.name += "_separator" + std::to_string(g + 1);
    if (straight.size() > 1) primitive.name += "_line";
    for (const int edge : straight) curve_of_[edge] = static_cast<int>(g);
    primitives_.push_back(std::move(primitive));
  }
}

// Whether all pieces lie inside a circle.
bool CurvedPolygonPrimitives::holds_everything(int primitive) const {
  const LevelFunction level(primitives_[primitive].level, 2);
  for (const auto& contour : contours_)
    for (const ContourLink& link : contour) {
      const auto own = curve_of_.find(link.piece.edge);
      if (link.is_tangent || (own != curve_of_.end() && own->second == primitive)) continue;
      for (const Point& corner : link.piece.hull()) {
        const double size = std::hypot(corner[0], corner[1]) + 1;
        if (level.value(corner) < -1e-14 * size) return false;
      }
    }
  return true;
}

// The primitive of a curved edge: its own, or that of an edge on the same circle.
int CurvedPolygonPrimitives::curve(int number) {
  if (const auto known = curve_of_.find(number); known != curve_of_.end()) return known->second;
  const CurvedEdge& edge = edges_[number];
  const int next = static_cast<int>(primitives_.size());
  if (edge.center) {
    for (const auto& [other, primitive] : curve_of_)
      if (same_circle(edge, edges_[other])) {
        if (!primitives_[primitive].name.ends_with("_line")) primitives_[primitive].name += "_line";
        return curve_of_[number] = primitive;
      }
    primitives_.push_back(disk_primitive(edge));
  } else {
    primitives_.push_back(conic_primitive(edge.whole));
  }
  primitives_.back().name = edge.name;
  branch_of_[next] = -1;
  if (!edge.center && edge.whole.weight > 1) {
    branch_of_[next] = next + 1;
    primitives_.push_back(branch_primitive(edge.whole));
    primitives_.back().name = edge.name + "_branch";
  }
  return curve_of_[number] = next;
}

}  // namespace rfm
