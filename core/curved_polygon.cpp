#include "core/curved_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/contour_check.hpp"
#include "core/contour_nesting.hpp"
#include "core/curve_division.hpp"
#include "core/curved_polygon_primitives.hpp"
#include "core/error.hpp"
#include "core/orientation.hpp"
#include "core/polygon_chains.hpp"

namespace rfm {
namespace {

// Contours, and where pieces of them begin.
using Beginnings = std::vector<std::pair<std::size_t, Point>>;

// The Boolean expression of each contour; nothing if pieces have to be divided, which `blocking`
// tells.
std::optional<std::vector<BooleanExpression>> expressions_of(
    const std::vector<std::vector<ContourLink>>& contours, CurvedPolygonPrimitives& primitives,
    Beginnings& blocking) {
  const LineGroups& lines = primitives.lines();
  std::vector<BooleanExpression> expressions;
  std::size_t line = 0;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const auto& links = contours[c];
    std::vector<ChainLink> chain;
    std::vector<BooleanExpression> leaves;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const ContourLink& link = links[i];
      const std::size_t last = (i + links.size() - 1) % links.size();
      const int group = lines.group[line + i];
      const bool straight_on = group == lines.group[line + last];
      if (straight_on && link.piece.is_straight() && links[last].piece.is_straight()) continue;
      const Segment& along = lines.lines[group];
      chain.push_back(
          {link.piece.from, {along.to[0] - along.from[0], along.to[1] - along.from[1]}, link.turn});
      if (!link.piece.is_straight()) chain.back().hull = link.piece.hull();
      leaves.push_back(primitives.leaf(link, BooleanExpression::variable(group)));
      numbers.push_back(i);
    }
    line += links.size();
    for (std::size_t i = 0; i < chain.size(); ++i)  // where straight edges meet
      if (chain[i].turn == 0)
        chain[i].turn = orientation(chain[(i + chain.size() - 1) % chain.size()].start,
                                    chain[i].start, chain[(i + 1) % chain.size()].start);
    const CurvedChains chains = curved_chain_expression(chain, leaves);
    for (const int edge : chains.blocking) blocking.push_back({c, links[numbers[edge]].piece.from});
    expressions.push_back(chains.expression);
  }
  if (!blocking.empty()) return std::nullopt;
  return expressions;
}

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
    CurvedPolygonPrimitives primitives(edges, links);
    Beginnings blocking;
    const auto expressions = expressions_of(links, primitives, blocking);
    if (expressions) {
      std::vector<OutlineSide> sides = primitives.sides();
      const Region region(2, primitives.primitives(),
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
