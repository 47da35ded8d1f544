#include "core/polygon.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <ctime>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/polygon_chains.hpp"
#include "core/r_functions.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Kind = BooleanExpression::Kind;

// a & (b | c): letters for variables, chains of one operation without brackets.
std::string text_of(const BooleanExpression& expression, int node = -1,
                    Kind outer = Kind::constant) {
  const auto& nodes = expression.nodes();
  const auto& own = nodes[node < 0 ? static_cast<int>(nodes.size()) - 1 : node];
  if (own.kind == Kind::variable) return {static_cast<char>('a' + own.first)};
  if (own.kind == Kind::negation) return "!" + text_of(expression, own.first, Kind::negation);
  const std::string sign = own.kind == Kind::conjunction ? " & " : " | ";
  const std::string text =
      text_of(expression, own.first, own.kind) + sign + text_of(expression, own.second, own.kind);
  return own.kind == outer || outer == Kind::constant ? text : "(" + text + ")";
}

std::vector<BooleanExpression> letters(std::size_t count) {
  std::vector<BooleanExpression> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(BooleanExpression::variable(static_cast<int>(i)));
  return list;
}

std::string chain_text(const std::vector<Point>& vertices) {
  return text_of(chain_expression(vertices, letters(vertices.size())));
}

TEST(PolygonChains, OfAConvexPolygonAreAnIntersection) {
  EXPECT_EQ(chain_text({{0, 0}, {2, 0}, {2, 1}, {0, 1}}), "a & b & c & d");
}

TEST(PolygonChains, OfAnLShapeUniteAtTheReflexCorner) {
  EXPECT_EQ(chain_text({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}),
            "a & b & (c | d) & e & f");
}

// The 15-gon of figure 5.6 of Shapiro (2007), whose drawing is lost: hull vertices between a and b,
// e and f, j and k, n and o, o and a.
TEST(PolygonChains, OfFigure56AreAsPublished) {
  const std::vector<Point> points = {
      {0, 0},  {10, 0},  {8, 3}, {8.6, 4}, {8, 5},  // a b c d e: pocket on the right
      {10, 9}, {8, 8},   {7, 5}, {5, 5},   {4, 8},  // f g h i j: pocket above
      {2, 10}, {1.5, 8}, {2, 6}, {1, 3},            // k l m n: pocket on the left
      {-1, 2}};                                     // o
  EXPECT_EQ(chain_text(points),
            "o & a & (b | (c & d) | e) & ((f & g) | h | (i & j)) & ((k & l) | m | n)");
}

TEST(Polygons, HaveOneExactDistancePerEdge) {
  const Outline outline = polygon({Contour{{{0, 0}, {0, 2}, {3, 0}}}});  // clockwise
  const auto& primitives = outline.region.primitives();
  ASSERT_EQ(primitives.size(), 3u);
  const RegionEvaluator region(outline.region);
  EXPECT_TRUE(region.contains(Point{1, 0.5}));
  EXPECT_FALSE(region.contains(Point{2, 1.5}));
  std::vector<std::string> names;
  for (const auto& primitive : primitives) names.push_back(primitive->name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("edge1", "edge2", "edge3"));
  for (int k = 0; k < 3; ++k) {
    const std::string& name = primitives[k]->name;  // from (1, 0.5)
    const double expected = name == "edge1"   ? 1
                            : name == "edge3" ? 0.5
                                              : (2 - 0.5 - 2.0 / 3) * 3 / std::sqrt(13);
    EXPECT_NEAR(region.level(k).value({1, 0.5}), expected, 1e-15) << name;
  }
  EXPECT_TRUE(outline.sides.empty());
}

TEST(Polygons, MergeRepeatedPoints) {
  const Region region = polygon({{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 1}, {0, 0}});
  ASSERT_EQ(region.primitives().size(), 4u);
  std::vector<std::string> names;
  for (const auto& primitive : region.primitives()) names.push_back(primitive->name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("edge2", "edge3", "edge6", "edge7"));
}

TEST(Polygons, ShareAPrimitiveAlongALine) {
  // Two teeth of equal height, and a point on the straight edge below.
  const Outline outline =
      polygon({Contour{{{0, 0}, {1, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}});
  EXPECT_EQ(outline.region.primitives().size(), 7u);
  ASSERT_EQ(outline.sides.size(), 4u);
  EXPECT_EQ(outline.sides[0].name, "edge1");
  EXPECT_THAT(outline.sides[0].pieces, ElementsAre("edge1_line"));
  EXPECT_EQ(outline.sides[1].name, "edge2");
  EXPECT_EQ(outline.sides[2].name, "edge4");
  EXPECT_THAT(outline.sides[2].pieces, ElementsAre("edge4_line"));
  EXPECT_EQ(outline.sides[3].name, "edge8");
  const LevelFunction where(*outline.sides[2].where, 2);
  EXPECT_GT(where.value({2.5, 2}), 0);
  EXPECT_LT(where.value({0.5, 2}), 0);
  EXPECT_EQ(where.value({2, 2}), 0);
}

TEST(Polygons, NestAsHolesAndIslands) {
  const auto square = [](double half) {
    return std::vector<Point>{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  };
  const Outline outline = polygon({{square(3)},
                                   {square(1), "hole2_"},
                                   {square(2), "hole1_"},
                                   {{{5, 0}, {6, 0}, {5, 1}}, "other_"}});
  const RegionEvaluator region(outline.region);
  EXPECT_TRUE(region.contains(Point{0, 0}));
  EXPECT_FALSE(region.contains(Point{1.5, 0}));
  EXPECT_TRUE(region.contains(Point{2.5, 0}));
  EXPECT_TRUE(region.contains(Point{5.2, 0.2}));
  EXPECT_FALSE(region.contains(Point{4, 0}));
  ASSERT_EQ(outline.sides.size(), 3u);
  EXPECT_EQ(outline.sides[0].name, "hole2");
  EXPECT_EQ(outline.sides[0].pieces.size(), 4u);
}

void expect_refused(const std::vector<Contour>& contours, const std::string& reason) {
  try {
    polygon(contours);
    FAIL() << "accepted";
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), HasSubstr(reason));
  }
}

TEST(Polygons, ThatAreNotSimpleAreRefused) {
  expect_refused({Contour{{{0, 0}, {2, 2}, {2, 0}, {0, 3}}}}, "edge1 and edge3 cross or touch");
  // Bow ties without area: the triangles on both sides of the crossing are equally large.
  expect_refused({Contour{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}}, "edge1 and edge3 cross or touch");
  expect_refused({Contour{{{0, 0}, {2, 0}, {0, 1}, {2, 1}}}}, "edge2 and edge4 cross or touch");
  expect_refused({Contour{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}},
                 "edge1 and edge4 cross or touch");
  expect_refused({Contour{{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}}, "edge1 and edge2 cross or touch");
  expect_refused({Contour{{{0, 0}, {4, 0}, {0, 4}}}, Contour{{{1, 1}, {2, 1}, {9, 2}}, "hole1_"}},
                 "edge2 and hole1_edge");
  expect_refused({Contour{{{0, 0}, {1, 0}, {0, 0}}}}, "at least three different points");
  expect_refused({Contour{{{0, 0}, {1, 1}, {2, 2}}}}, "no area");
  expect_refused({Contour{{{0, 0}, {NAN, 1}, {2, 0}}}}, "point 2 is not finite");
}

// The bound is the contract's; measured are 5 ms.
TEST(Polygons, OfAThousandEdgesBuildInATenthOfASecond) {
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 1000, radius = i % 2 == 0 ? 1 : 0.9;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const std::clock_t start = std::clock();
  const Region region = polygon(points);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_EQ(region.primitives().size(), 1000u);
  EXPECT_LT(seconds, 0.1);
}

}  // namespace
}  // namespace rfm
