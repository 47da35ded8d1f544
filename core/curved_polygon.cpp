#include "core/curved_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/contour_check.hpp"
#include "core/contour_nesting.hpp"
#include "core/curve_division.hpp"
#include "core/edge_primitives.hpp"
#include "core/error.hpp"
#include "core/line_groups.hpp"
#include "core/orientation.hpp"
#include "core/polygon_chains.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

// Contours, and where pieces of them begin.
using Beginnings = std::vector<std::pair<std::size_t, Point>>;

// Primitives and expressions of a curved polygon.
class CurvedPolygonBuilder {
 public:
  CurvedPolygonBuilder(std::vector<CurvedEdge> edges,
                       std::vector<std::vector<ContourLink>> contours)
      : edges_(std::move(edges)), contours_(std::move(contours)) {}

  // Nothing if arcs have to be divided: see `blocking`.
  std::optional<std::vector<BooleanExpression>> run() {
    add_lines();
    std::vector<BooleanExpression> expressions;
    std::size_t line = 0;
    for (std::size_t c = 0; c < contours_.size(); ++c) {
      const auto& links = contours_[c];
      std::vector<ChainLink> chain;
      std::vector<BooleanExpression> leaves;
      std::vector<std::size_t> numbers;
      for (std::size_t i = 0; i < links.size(); ++i) {
        const ContourLink& link = links[i];
        const std::size_t last = (i + links.size() - 1) % links.size();
        const int group = lines_.group[line + i];
        const bool straight_on = group == lines_.group[line + last];
        if (straight_on && link.piece.is_straight() && links[last].piece.is_straight()) continue;
        const Segment& along = lines_.lines[group];
        chain.push_back({link.piece.from,
                         {along.to[0] - along.from[0], along.to[1] - along.from[1]},
                         link.turn});
        if (!link.piece.is_straight()) chain.back().hull = link.piece.hull();
        leaves.push_back(leaf(link, BooleanExpression::variable(group)));
        numbers.push_back(i);
      }
      line += links.size();
      for (std::size_t i = 0; i < chain.size(); ++i)  // where straight edges meet
        if (chain[i].turn == 0)
          chain[i].turn = orientation(chain[(i + chain.size() - 1) % chain.size()].start,
                                      chain[i].start, chain[(i + 1) % chain.size()].start);
      const CurvedChains chains = curved_chain_expression(chain, leaves);
      for (const int edge : chains.blocking)
        blocking_.push_back({c, links[numbers[edge]].piece.from});
      expressions.push_back(chains.expression);
    }
    if (!blocking_.empty()) return std::nullopt;
    return expressions;
  }

  /// The contours and beginnings of pieces that have to be divided.
  const Beginnings& blocking() const { return blocking_; }

  std::vector<std::shared_ptr<const Primitive>> primitives() {
    mark_smooth_joints();
    std::vector<std::shared_ptr<const Primitive>> list;
    for (const Primitive& primitive : primitives_)
      list.push_back(std::make_shared<const Primitive>(primitive));
    return list;
  }

  // Sides that are parts of a primitive.
  std::vector<OutlineSide> sides() const {
    std::vector<OutlineSide> sides;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const Primitive& primitive = primitives_[curve_of_.at(static_cast<int>(e))];
      if (primitive.name != edges_[e].name)
        sides.push_back({edges_[e].name, {primitive.name}, part_of_curve(edges_[e])});
    }
    add_groups(sides);
    return sides;
  }

 private:
  // Sides of several edges; only parts of primitives that edges of other groups share.
  void add_groups(std::vector<OutlineSide>& sides) const {
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

  void mark_smooth_joints() {
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
  void add_lines() {
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

  BooleanExpression leaf(const ContourLink& link, const BooleanExpression& chord) {
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

  // Whether all pieces lie inside a circle.
  bool holds_everything(int primitive) const {
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
  int curve(int number) {
    if (const auto known = curve_of_.find(number); known != curve_of_.end()) return known->second;
    const CurvedEdge& edge = edges_[number];
    const int next = static_cast<int>(primitives_.size());
    if (edge.center) {
      for (const auto& [other, primitive] : curve_of_)
        if (same_circle(edge, edges_[other])) {
          if (!primitives_[primitive].name.ends_with("_line"))
            primitives_[primitive].name += "_line";
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

  static bool same_circle(const CurvedEdge& a, const CurvedEdge& b) {
    if (!a.center || !b.center) return false;
    const double distance =
        std::hypot((*a.center)[0] - (*b.center)[0], (*a.center)[1] - (*b.center)[1]);
    return distance + std::fabs(a.radius - b.radius) <= 1e-13 * (a.radius + b.radius);
  }

  std::vector<CurvedEdge> edges_;
  std::vector<std::vector<ContourLink>> contours_;
  LineGroups lines_;
  std::vector<Primitive> primitives_;
  Beginnings blocking_;
  std::map<int, int> curve_of_;   // of an edge, its primitive
  std::map<int, int> branch_of_;  // of a conic, the separator of its branches, or −1
};

// A box around the corners of the hulls of all pieces.
Box box_of(const std::vector<std::vector<CurvePiece>>& contours) {
  Box box{2, contours[0][0].from, contours[0][0].from};
  for (const std::vector<CurvePiece>& pieces : contours)
    for (const Point& point : outline_of(pieces))
      for (int axis = 0; axis < 2; ++axis) {
        box.low[axis] = std::min(box.low[axis], point[axis]);
        box.high[axis] = std::max(box.high[axis], point[axis]);
      }
  return box;
}

std::vector<std::vector<Point>> chords_of(const std::vector<std::vector<ContourLink>>& contours) {
  std::vector<std::vector<Point>> chords;
  for (const auto& contour : contours)
    for (auto& points = chords.emplace_back(); const ContourLink& link : contour)
      if (!link.is_tangent) points.push_back(link.piece.from);
  return chords;
}

// What division may mend: curves that are wrong themselves, or follow those; else all curves.
Beginnings to_divide(const std::vector<std::vector<ContourLink>>& contours,
                     const std::vector<std::pair<std::size_t, std::size_t>>& wrong) {
  Beginnings result, all;
  for (std::size_t c = 0; c < contours.size(); ++c)
    for (const ContourLink& link : contours[c])
      if (!link.piece.is_straight()) all.push_back({c, link.piece.from});
  for (const auto& [c, i] : wrong)
    for (int step = -2; step <= 2; ++step) {  // tangents lie between
      const std::size_t count = contours[c].size();
      const CurvePiece& piece = contours[c][(i + count + step) % count].piece;
      if (!piece.is_straight()) result.push_back({c, piece.from});
    }
  return result.empty() ? all : result;
}

// The contours without tangents, some of their pieces divided.
std::vector<std::vector<CurvePiece>> halved(const std::vector<std::vector<ContourLink>>& contours,
                                            const Beginnings& beginnings) {
  std::vector<std::vector<CurvePiece>> pieces(contours.size());
  for (std::size_t c = 0; c < contours.size(); ++c)
    for (const ContourLink& link : contours[c]) {
      if (link.is_tangent) continue;
      if (std::ranges::find(beginnings, std::pair(c, link.piece.from)) == beginnings.end()) {
        pieces[c].push_back(link.piece);
      } else {
        for (const CurvePiece& half : link.piece.halves()) pieces[c].push_back(half);
      }
    }
  return pieces;
}

}  // namespace

Outline curved_polygon(const std::vector<CurvedContour>& contours) {
  if (contours.empty()) throw InvalidArgument("a curved polygon needs a contour");
  std::vector<CurvedEdge> edges;
  std::vector<std::vector<CurvePiece>> pieces;
  for (const CurvedContour& contour : contours) pieces.push_back(cleaned(contour, edges));
  std::vector<std::string> names;
  for (const CurvedEdge& edge : edges) names.push_back(edge.group.empty() ? edge.name : edge.group);
  const Box enclosure = box_of(pieces);
  constexpr int most_rounds = 12, most_corrections = 4;
  int corrections = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const auto links = divided(pieces, names);
    CurvedPolygonBuilder builder(edges, links);
    const auto expressions = builder.run();
    Beginnings blocking = builder.blocking();
    if (expressions) {
      std::vector<OutlineSide> sides = builder.sides();
      const Region region(2, builder.primitives(),
                          nested_expression(chords_of(links), *expressions));
      const auto wrong = wrong_links(RegionEvaluator(region), links, edges);
      if (wrong.empty()) return {region.within(enclosure), std::move(sides)};
      blocking = to_divide(links, wrong);
      if (++corrections > most_corrections || blocking.empty())
        throw InvalidArgument("inside and outside cannot be told apart beside " +
                              names[links[wrong[0].first][wrong[0].second].piece.edge] +
                              ": edges nearly touch each other");
    }
    pieces = halved(links, blocking);
  }
  throw InvalidArgument("edges of the curved polygon nearly touch each other");
}

}  // namespace rfm
