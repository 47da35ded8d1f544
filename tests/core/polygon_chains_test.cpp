#include "core/polygon_chains.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "core/contour.hpp"
#include "core/curve_piece.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {
namespace {

std::vector<BooleanExpression> variables(std::size_t count) {
  std::vector<BooleanExpression> edges;
  for (std::size_t i = 0; i < count; ++i)
    edges.push_back(BooleanExpression::variable(static_cast<int>(i)));
  return edges;
}

/// Whether the expression of the half-planes to the left of the edges holds at a point.
bool holds(const BooleanExpression& expression, const std::vector<Point>& v, const Point& p) {
  const auto signs = std::make_unique<bool[]>(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Point &a = v[i], &b = v[(i + 1) % v.size()];
    signs[i] = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) >= 0;
  }
  return expression.evaluate(std::span<const bool>(signs.get(), v.size()));
}

TEST(PolygonChains, AreThePolygonAndUseEveryEdgeOnceWithoutNegation) {
  RandomPolygons random(3);
  int inside = 0, outside = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto kind = trial % 2 ? RandomPolygons::Kind::star : RandomPolygons::Kind::spiral;
    const std::vector<Point> vertices = cleaned({random.next(kind)}).points;
    const BooleanExpression expression = chain_expression(vertices, variables(vertices.size()));
    std::vector<int> uses(vertices.size(), 0);
    for (const auto& node : expression.nodes()) {
      EXPECT_NE(node.kind, BooleanExpression::Kind::negation);
      if (node.kind == BooleanExpression::Kind::variable)
        ++uses[static_cast<std::size_t>(node.first)];
    }
    EXPECT_THAT(uses, testing::Each(1));
    for (int i = 0; i < 100; ++i) {
      const Point p{random.real(-1.2, 1.2), random.real(-1.2, 1.2)};
      const bool expected = winds_around(vertices, p);
      EXPECT_EQ(holds(expression, vertices, p), expected);
      ++(expected ? inside : outside);
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 500);
}

TEST(PolygonChains, OfAConvexPolygonAreAConjunctionAndOfADentADisjunction) {
  const std::vector<Point> convex{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  const BooleanExpression of_convex = chain_expression(convex, variables(4));
  for (const auto& node : of_convex.nodes())
    EXPECT_NE(node.kind, BooleanExpression::Kind::disjunction);
  const std::vector<Point> dented{{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}};
  const BooleanExpression of_dented = chain_expression(dented, variables(5));
  EXPECT_EQ(std::ranges::count(of_dented.nodes(), BooleanExpression::Kind::disjunction,
                               &BooleanExpression::Node::kind),
            1);
}

TEST(PolygonChains, BlockingCurvesAreThoseOnTheHullOfAChainWithoutAVertexThere) {
  const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  std::vector<ChainLink> links;
  for (int i = 0; i < 4; ++i) {
    const Point &p = square[i], &q = square[(i + 1) % 4];
    links.push_back({p, {q[0] - p[0], q[1] - p[1]}, 1});
  }
  const auto edges = variables(4);
  EXPECT_TRUE(curved_chain_expression(links, edges).blocking.empty());
  // A bulge outwards between two extreme vertices blocks nothing.
  links[0].hull =
      std::array<Point, 4>{Point{0, 0}, Point{0.5, -0.5}, Point{1.5, -0.5}, Point{2, 0}};
  const CurvedChains bulged = curved_chain_expression(links, edges);
  EXPECT_TRUE(bulged.blocking.empty());
  for (const Point& p : {Point{1, 1}, Point{3, 1}, Point{1, -1}})
    EXPECT_EQ(holds(bulged.expression, square, p), winds_around(square, p));
}

TEST(PolygonChains, TangentsOfLengthZeroTurnOneWayAndThenTheOther) {
  // A square whose upper side has an S in its middle: a cap outwards, then one inwards, and in (1,
  // 2), where they meet, their tangent.
  const double slope = 0.5;
  std::vector<ChainLink> links{{{0, 0}, {2, 0}, 1},   {{2, 0}, {0, 2}, 1},
                               {{2, 2}, {-1, 0}, 1},  {{1, 2}, {-1, -slope}, 1},
                               {{1, 2}, {-1, 0}, -1}, {{0, 2}, {0, -2}, 1}};
  links[2].hull = {Point{2, 2}, Point{1.5, 2.25}, Point{1.5, 2.25}, Point{1, 2}};
  links[4].hull = {Point{1, 2}, Point{0.5, 1.75}, Point{0.5, 1.75}, Point{0, 2}};
  const CurvedChains chains = curved_chain_expression(links, variables(6));
  EXPECT_TRUE(chains.blocking.empty());
  // Curves left out, the tangent cuts nothing off and adds nothing.
  const auto holds_at = [&](const Point& p) {
    bool signs[6];
    for (int i = 0; i < 6; ++i)
      signs[i] =
          cross(links[i].direction, {p[0] - links[i].start[0], p[1] - links[i].start[1]}) >= 0;
    return chains.expression.evaluate(std::span<const bool>(signs, 6));
  };
  for (const double x : {-0.5, 0.2, 0.9, 1.1, 1.8, 2.5})
    for (const double y : {-0.5, 0.2, 1.9, 2.1, 3.0})
      EXPECT_EQ(holds_at({x, y}), x > 0 && x < 2 && y > 0 && y < 2) << x << ", " << y;
}

}  // namespace
}  // namespace rfm
