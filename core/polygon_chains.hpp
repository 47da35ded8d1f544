#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/boolean.hpp"
#include "core/box.hpp"

namespace rfm {

/// A simple polygon as a Boolean expression of its edges, each of which occurs exactly once,
/// without negations: Dobkin, Guibas, Hershberger & Snoeyink, "An efficient algorithm for finding
/// the CSG representation of a simple polygon" (1988).
///
/// A chain of edges, its first and last edge extended to infinity, divides the plane if it does not
/// cross itself; what lies on its left is the intersection (at a convex vertex) or the union (at a
/// reflex one) of the same for its two parts at any vertex on the convex hull of the *extended*
/// chain, because edges extended beyond such a vertex leave the hull and hence meet nothing. The
/// polygon is the intersection of its two parts between extreme vertices. (Rvachev's method of 1973
/// takes the hulls of chains that are not extended, and fails on Peterson's counter-example: the
/// extended parts may cross themselves.)
///
/// `vertices` run counter-clockwise around a simple polygon, no three consecutive ones on a line;
/// edge i, from vertex i to vertex i + 1, stands for the half-plane on its left and is replaced by
/// edges[i]. All vertices of a hull divide at once, and what they join is a balanced tree. Time
/// O(n log n) for each level of the tree.
BooleanExpression chain_expression(std::span<const Point> vertices,
                                   std::span<const BooleanExpression> edges);

/// An edge of a polygon of chords.
struct ChainLink {
  Point start{};
  /// Of its line. Edges may have length zero (tangents): neighbours then start in one point.
  Point direction{};
  /// Which way the polygon turns where it begins: 1 left, −1 right.
  int turn = 0;
  /// Corners of a convex polygon that holds the curve over it, first and last its ends; nothing for
  /// a straight edge.
  std::optional<std::array<Point, 4>> hull = {};
};

struct CurvedChains {
  BooleanExpression expression;
  /// Curved edges that have to be divided, as they lie on the hull of a chain that has no vertex on
  /// it; the expression is of use only if there are none.
  std::vector<int> blocking;
};

/// The same for a polygon of chords of curves: hulls of chains are those of the curves, too, so
/// that chords extended beyond a vertex do not meet curves either.
CurvedChains curved_chain_expression(std::span<const ChainLink> links,
                                     std::span<const BooleanExpression> edges);

}  // namespace rfm
