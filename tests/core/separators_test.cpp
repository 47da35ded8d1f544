#include "core/separators.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/curved_polygon.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_functions.hpp"
#include "core/winding_sign.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<std::string> numbered(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back("p" + std::to_string(i));
  return names;
}

// The region is the inside of the closed curves, on a grid that no piece follows.
void expect_inside(const DescribedSolid& solid, const std::vector<ThinSet>& pieces, double half) {
  const WindingSign winding(pieces);
  const RegionEvaluator region(solid.region);
  int inside = 0;
  for (double x = -1.0013 * half; x < half; x += 0.0371 * half)
    for (double y = -1.0017 * half; y < half; y += 0.0367 * half) {
      const Point at{x, y};
      EXPECT_EQ(region.contains(at), winding.is_inside(at)) << x << ", " << y;
      inside += winding.is_inside(at);
    }
  EXPECT_GT(inside, 100);
}

TEST(Separators, OfFigure59AllGo) {
  // V. Shapiro (2007), figure 5.9: the boundary of the union of three disks through one point.
  // Each two circles cross again at distance 1 from the origin, seen from a centre 120° from the
  // middle of its arc.
  std::vector<ThinSet> arcs;
  for (int k = 0; k < 3; ++k) {
    const double t = 0.4 + 2 * pi * k / 3;
    arcs.push_back(arc_set({std::cos(t), std::sin(t)}, 1, t - 2 * pi / 3, t + 2 * pi / 3));
  }
  const DescribedSolid solid = described_solid(arcs, numbered(3));
  EXPECT_FALSE(solid.conflict);
  EXPECT_TRUE(solid.separators.empty());
  expect_inside(solid, arcs, 2.2);
}

TEST(Separators, AreNotAddedWhereThePiecesDescribeTheSolid) {
  const double t = pi / 6;
  // A disk without a disk; a part of a ring; a plate with a round bite.
  const std::vector<ThinSet> moon{arc_set({0, 0}, 2, t, 2 * pi - t),
                                  arc_set({4 * std::cos(t), 0}, 2, pi - t, pi + t)};
  const Point inner{std::cos(2 * t), std::sin(2 * t)}, outer{2 * inner[0], 2 * inner[1]};
  const std::vector<ThinSet> ring{arc_set({0, 0}, 1, -2 * t, 2 * t), segment_set(inner, outer),
                                  arc_set({0, 0}, 2, -2 * t, 2 * t),
                                  segment_set({inner[0], -inner[1]}, {outer[0], -outer[1]})};
  const std::vector<ThinSet> bitten{arc_set({0, 0}, 1, 0, pi),      segment_set({-1, 0}, {-2, 0}),
                                    segment_set({-2, 0}, {-2, -2}), segment_set({-2, -2}, {2, -2}),
                                    segment_set({2, -2}, {2, 0}),   segment_set({2, 0}, {1, 0})};
  for (const auto& pieces : {moon, ring, bitten}) {
    const DescribedSolid solid = described_solid(pieces, numbered(pieces.size()));
    EXPECT_FALSE(solid.conflict);
    EXPECT_EQ(solid.candidates, 0);
    expect_inside(solid, pieces, 2.3);
  }
}

TEST(Separators, AreTheChordsThatTellTwoPartsOfACellApart) {
  // As in figure 5.8. A half disk below, with a half disk added and one taken away along its
  // straight side: what is outside of both small circles and inside the large one is inside below
  // y = 0 and outside above. All chords lie on that line; one is enough.
  const std::vector<ThinSet> wave{arc_set({0.5, 0}, 0.5, 0, pi), arc_set({1.5, 0}, 0.5, pi, 2 * pi),
                                  arc_set({1, 0}, 1, pi, 2 * pi)};
  const DescribedSolid solid = described_solid(wave, numbered(3));
  ASSERT_TRUE(solid.conflict);
  EXPECT_LE(solid.conflict->first[1], 1e-9);  // inside
  EXPECT_GE(solid.conflict->second[1], -1e-9);
  EXPECT_EQ(solid.candidates, 1);
  ASSERT_EQ(solid.separators.size(), 1u);
  EXPECT_THAT(solid.separators[0], testing::HasSubstr("the chord of p"));
  expect_inside(solid, wave, 2.2);
}

TEST(Separators, AreTriedAndTakenAwayByName) {
  // The chords of the wave lie on one line: one is tried, and needed.
  const std::vector<ThinSet> wave{arc_set({0.5, 0}, 0.5, 0, pi), arc_set({1.5, 0}, 0.5, pi, 2 * pi),
                                  arc_set({1, 0}, 1, pi, 2 * pi)};
  const DescribedSolid solid = described_solid(wave, {"bump", "bite", "bowl"});
  EXPECT_THAT(solid.separators, testing::ElementsAre("the chord of bump"));
  EXPECT_TRUE(solid.needless.empty());
  // Only those that are needed are primitives, and they bound nothing.
  ASSERT_EQ(solid.region.primitives().size(), 4u);
  EXPECT_EQ(solid.region.primitives()[2]->name, "bowl");
  EXPECT_TRUE(solid.region.primitives()[3]->selects_only);
}

TEST(Separators, PiecesOnOneCurveShareAPrimitive) {
  // A disk without two bites that do not touch: two arcs of the rim.
  const double t = pi / 6;
  std::vector<ThinSet> pieces;
  for (const double turn : {0.0, pi}) {
    pieces.push_back(arc_set({0, 0}, 2, turn + t, turn + pi - t));
    const Point at{4 * std::cos(t) * std::cos(turn), 0};
    pieces.push_back(arc_set(at, 2, turn + pi - t, turn + pi + t));
  }
  const DescribedSolid solid = described_solid(pieces, {"top", "right", "bottom", "left"});
  ASSERT_EQ(solid.region.primitives().size(), 3u);
  EXPECT_EQ(solid.region.primitives()[0]->name, "top_line");
  ASSERT_EQ(solid.sides.size(), 2u);
  EXPECT_EQ(solid.sides[1].name, "bottom");
  EXPECT_THAT(solid.sides[1].pieces, testing::ElementsAre("top_line"));
  EXPECT_GT(value_at(*solid.sides[0].where, {0, 2}), 0);
  EXPECT_LT(value_at(*solid.sides[1].where, {0, 2}), 0);
  expect_inside(solid, pieces, 2.3);
}

TEST(Separators, SelectOnlyWhilePiecesBoundWithUnitSlope) {
  const std::vector<ThinSet> wave{arc_set({0.5, 0}, 0.5, 0, pi), arc_set({1.5, 0}, 0.5, pi, 2 * pi),
                                  arc_set({1, 0}, 1, pi, 2 * pi)};
  const Region region = described_solid(wave, numbered(3)).region;
  const std::vector<Point> on_pieces{{0.5, 0.5}, {1.5, -0.5}, {1, -1}};
  ASSERT_GT(region.primitives().size(), 3u);
  for (std::size_t k = 0; k < region.primitives().size(); ++k) {
    const Primitive& primitive = *region.primitives()[k];
    EXPECT_EQ(primitive.selects_only, k >= 3) << primitive.name;
    if (k >= 3) continue;
    const PointJet jet = evaluate(primitive.function, on_pieces[k], 1, 2);
    EXPECT_NEAR(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 1, 1e-12);
  }
}

// A half disk with a half disk added and one taken away along its straight side, as curves that
// are trimmed by formulas; in space the prism over it.
std::vector<ThinSet> trimmed_wave(int dimension) {
  const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
  const auto circle_about = [&](double center, double radius) {
    return (radius * radius - (x - center) * (x - center) - y * y) / (2 * radius);
  };
  std::vector<ThinSet> pieces{level_curve_set(circle_about(0.5, 0.5), y, dimension),
                              level_curve_set(circle_about(1.5, 0.5), -y, dimension),
                              level_curve_set(circle_about(1, 1), -y, dimension)};
  if (dimension == 3)
    for (const Field& end : {z, 1 - z}) pieces.push_back(level_curve_set(end, {}, 3));
  return pieces;
}

Truth is_in_the_wave(const Point& at) {
  const auto power = [&](double center, double radius) {
    return radius * radius - (at[0] - center) * (at[0] - center) - at[1] * at[1];
  };
  const double bump = power(0.5, 0.5), bite = power(1.5, 0.5), bowl = power(1, 1);
  const double inside = at[1] > 0 ? bump : std::min(bowl, -bite);
  return inside > 1e-9 ? Truth::yes : inside < -1e-9 ? Truth::no : Truth::unknown;
}

TEST(Separators, OfPiecesThatAreNoArcsAreWhatTrimsThem) {
  const Box bounds{2, {0, -1}, {2, 0.5}};
  const DescribedSolid solid =
      described_solid(trimmed_wave(2), {"bump", "bite", "bowl"}, is_in_the_wave, bounds);
  ASSERT_TRUE(solid.conflict);
  EXPECT_EQ(solid.candidates, 1);  // all are trimmed by one line
  EXPECT_THAT(solid.separators, testing::ElementsAre("what trims bump at its ends"));
  const RegionEvaluator region(solid.region);
  int inside = 0;
  for (double s = -0.21; s < 2.2; s += 0.037)
    for (double t = -1.17; t < 0.7; t += 0.041) {
      EXPECT_EQ(region.contains(Point{s, t}), is_in_the_wave({s, t}) == Truth::yes);
      inside += region.contains(Point{s, t});
    }
  EXPECT_GT(inside, 500);
}

TEST(Separators, OfFacesInSpaceAreWhatTrimsThem) {
  const Membership prism = [](const Point& at) {
    const Truth level = at[2] > 1e-9 && at[2] < 1 - 1e-9    ? Truth::yes
                        : at[2] < -1e-9 || at[2] > 1 + 1e-9 ? Truth::no
                                                            : Truth::unknown;
    return std::min(level, is_in_the_wave(at));
  };
  const Box bounds{3, {0, -1, 0}, {2, 0.5, 1}};
  const DescribedSolid solid =
      described_solid(trimmed_wave(3), {"bump", "bite", "bowl", "floor", "lid"}, prism, bounds);
  ASSERT_TRUE(solid.conflict);
  EXPECT_THAT(solid.separators, testing::ElementsAre("what trims bump at its ends"));
  const RegionEvaluator region(solid.region);
  int inside = 0;
  for (double s = -0.21; s < 2.2; s += 0.087)
    for (double t = -1.17; t < 0.7; t += 0.081)
      for (double u = -0.31; u < 1.4; u += 0.193) {
        EXPECT_EQ(region.contains(Point{s, t, u}), prism({s, t, u}) == Truth::yes);
        inside += region.contains(Point{s, t, u});
      }
  EXPECT_GT(inside, 300);
}

// What docs/design.md proves: chords are enough for any closed curves of segments and arcs.
TEST(Separators, OfRandomCurvesOfSegmentsAndArcsAreChords) {
  std::mt19937 generator(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(generator);
  };
  int described = 0, separated = 0;
  for (int trial = 0; trial < 60; ++trial) {
    CurvedContour contour;
    const int corners = 3 + trial % 3;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * pi * (k + uniform(-0.3, 0.3)) / corners, size = uniform(0.4, 1);
      contour.points.push_back({size * std::cos(angle), size * std::sin(angle)});
      contour.edges.push_back({k % 3 == 2 ? 0 : uniform(-1.4, 1.4)});
    }
    try {
      curved_polygon({contour});  // refuses curves that cross themselves
    } catch (const InvalidArgument&) {
      continue;
    }
    std::vector<ThinSet> pieces;
    for (int k = 0; k < corners; ++k) {
      const Point &p = contour.points[k], &q = contour.points[(k + 1) % corners];
      const double b = contour.edges[k].bulge;
      if (b == 0) {
        pieces.push_back(segment_set(p, q));
        continue;
      }
      const double s = (1 - b * b) / (4 * b);
      const Point center{0.5 * (p[0] + q[0]) - s * (q[1] - p[1]),
                         0.5 * (p[1] + q[1]) + s * (q[0] - p[0])};
      const double radius = std::hypot(p[0] - center[0], p[1] - center[1]);
      const Point& first = b > 0 ? p : q;
      const double from = std::atan2(first[1] - center[1], first[0] - center[0]);
      pieces.push_back(arc_set(center, radius, from, from + 4 * std::atan(std::fabs(b))));
    }
    const DescribedSolid solid = described_solid(pieces, numbered(pieces.size()));
    ++described;
    separated += !solid.separators.empty();
    for (const std::string& separator : solid.separators)
      EXPECT_THAT(separator, testing::StartsWith("the chord of"));
    expect_inside(solid, pieces, 1.4);
  }
  EXPECT_GT(described, 20);
  EXPECT_GT(separated, 2);
}

TEST(Separators, OfATetrahedronAreNotNeeded) {
  const Point o{0, 0, 0}, a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1};
  const std::vector<ThinSet> faces{triangle_set(o, b, a), triangle_set(o, a, c),
                                   triangle_set(o, c, b), triangle_set(a, b, c)};
  const DescribedSolid solid = described_solid(faces, numbered(4));
  EXPECT_FALSE(solid.conflict);
  EXPECT_TRUE(solid.separators.empty());
  const RegionEvaluator region(solid.region);
  EXPECT_TRUE(region.contains(Point{0.2, 0.2, 0.2}));
  EXPECT_FALSE(region.contains(Point{0.4, 0.4, 0.4}));
  EXPECT_FALSE(region.contains(Point{-0.1, 0.2, 0.2}));
}

std::vector<ThinSet> half_circles(const Point& center, double radius) {
  return {arc_set(center, radius, 0, pi), arc_set(center, radius, pi, 2 * pi)};
}

TEST(Separators, SmallHolesAreFoundDownToAMillionthOfTheWhole) {
  for (const double radius : {0.1, 0.03, 1e-2, 1e-3, 1e-5, 1e-6}) {
    std::vector<ThinSet> pieces = half_circles({0, 0}, 1);
    const Point center{0.3123, 0.2217};
    for (const ThinSet& half : half_circles(center, radius)) pieces.push_back(half);
    const DescribedSolid solid = described_solid(pieces, {"big1", "big2", "small1", "small2"});
    const RegionEvaluator region(solid.region);
    EXPECT_FALSE(region.contains(center)) << radius;
    EXPECT_FALSE(region.contains(Point{center[0], center[1] - 0.9 * radius})) << radius;
    EXPECT_TRUE(region.contains(Point{center[0], center[1] - 1.1 * radius})) << radius;
    EXPECT_FALSE(region.contains(Point{1.01, 0})) << radius;
  }
}

TEST(Separators, SmallBitesAndSlotsAreFound) {
  // A disk with a bite of 2 % at its rim, and one with a slot of 0.1 % of its size.
  const double r = 0.02, t = 2 * std::asin(r / 2);  // the bite's centre lies on the rim
  const double turn = 0.5 * (pi + t);               // seen from there, where the rim begins
  const std::vector<ThinSet> bitten{arc_set({0, 0}, 1, t, 2 * pi - t),
                                    arc_set({1, 0}, r, turn, 2 * pi - turn)};
  const RegionEvaluator bite(described_solid(bitten, numbered(2)).region);
  EXPECT_FALSE(bite.contains(Point{0.985, 0}));
  EXPECT_TRUE(bite.contains(Point{0.975, 0}));
  const double h = 1e-3, angle = std::asin(h);
  const std::vector<ThinSet> slotted{
      arc_set({0, 0}, 1, angle, 2 * pi - angle), segment_set({std::cos(angle), h}, {0.2, h}),
      segment_set({0.2, h}, {0.2, -h}), segment_set({0.2, -h}, {std::cos(angle), -h})};
  const RegionEvaluator slot(described_solid(slotted, numbered(4)).region);
  EXPECT_FALSE(slot.contains(Point{0.5, 0}));
  EXPECT_FALSE(slot.contains(Point{0.2001, 0.0009}));
  EXPECT_TRUE(slot.contains(Point{0.5, 0.0011}));
  EXPECT_TRUE(slot.contains(Point{0.199, 0}));
}

TEST(Separators, PiecesThatBoundNothingAreRefusedByName) {
  // Two squares with a common side: inside by parity on both sides of it.
  std::vector<ThinSet> pieces;
  const std::vector<Point> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  for (const auto& [from, to] : std::vector<std::pair<int, int>>{
           {0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 2}, {2, 1}})
    pieces.push_back(segment_set(corners[from], corners[to]));
  try {
    described_solid(pieces, numbered(8));
    FAIL() << "accepted";
  } catch (const InvalidArgument& mistake) {
    EXPECT_THAT(mistake.what(), testing::HasSubstr("'p1' does not bound"));
  }
  // A hole of a ten-billionth is not seen, and not passed over.
  pieces = half_circles({0, 0}, 1);
  for (const ThinSet& half : half_circles({0.3, 0.2}, 1e-10)) pieces.push_back(half);
  EXPECT_THROW(described_solid(pieces, numbered(4)), InvalidArgument);
}

TEST(Separators, OfStraightPiecesAreAPolygonWithUnitSlope) {
  // A spiral whose lines meet each other often: by the signs of its lines a side is in several
  // products, and the slope of the R-function up to 3.4.
  const std::vector<Point> spiral{{0, 0}, {5, 0}, {5, 5}, {1, 5}, {1, 2}, {3, 2},
                                  {3, 3}, {2, 3}, {2, 4}, {4, 4}, {4, 1}, {0, 1}};
  std::vector<ThinSet> pieces;
  for (std::size_t i = 0; i < spiral.size(); ++i) {
    // Each turned as it likes, and not in order.
    const std::size_t k = (5 * i) % spiral.size();
    const Point &p = spiral[k], &q = spiral[(k + 1) % spiral.size()];
    pieces.push_back(i % 3 == 0 ? segment_set(q, p) : segment_set(p, q));
  }
  const DescribedSolid solid = described_solid(pieces, numbered(pieces.size()));
  EXPECT_EQ(solid.region.primitives().size(), pieces.size());
  const Field omega = implicit(solid.region);
  for (const ThinSet& piece : pieces)
    for (const double t : {0.1, 0.3, 0.5, 0.9}) {
      const Point &p = piece.points[0], &q = piece.points[1];
      const Point at{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
      const PointJet jet = evaluate(omega, at, 1, 2);
      EXPECT_NEAR(jet.derivative(0, 0), 0, 1e-14);
      EXPECT_NEAR(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 1, 1e-12);
    }
  // The primitive of a piece has its name.
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Primitive& primitive = *solid.region.primitives()[k];
    const ThinSet& piece = pieces[std::stoul(primitive.name.substr(1))];
    EXPECT_NEAR(value_at(primitive.function, piece.points[0]), 0, 1e-14);
    EXPECT_NEAR(value_at(primitive.function, piece.points[1]), 0, 1e-14);
  }
}

TEST(Separators, StraightPiecesMayBeManyAndHaveHoles) {
  std::vector<ThinSet> pieces;
  for (const double radius : {1.0, 0.5, 0.001})
    for (int k = 0; k < 150; ++k) {
      const double s = 2 * pi * k / 150, t = 2 * pi * ((k + 1) % 150) / 150;
      pieces.push_back(segment_set({radius * std::cos(s), radius * std::sin(s)},
                                   {radius * std::cos(t), radius * std::sin(t)}));
    }
  const RegionEvaluator region(described_solid(pieces, numbered(pieces.size())).region);
  EXPECT_TRUE(region.contains(Point{0.0005, 0.0003}));
  EXPECT_FALSE(region.contains(Point{0.3, 0.3}));
  EXPECT_TRUE(region.contains(Point{0.6, 0.3}));
  EXPECT_FALSE(region.contains(Point{0.8, 0.8}));
}

TEST(Separators, StraightPiecesThatTouchAreDescribedByTheirSigns) {
  // Two squares with a common corner are no simple polygon.
  std::vector<ThinSet> pieces;
  for (const double at : {-1.0, 0.0})
    for (const auto& [p, q] : std::vector<std::pair<Point, Point>>{
             {{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{0, 1}, {0, 0}}})
      pieces.push_back(segment_set({p[0] + at, p[1] + at}, {q[0] + at, q[1] + at}));
  const RegionEvaluator region(described_solid(pieces, numbered(8)).region);
  EXPECT_TRUE(region.contains(Point{0.4, 0.3}));
  EXPECT_TRUE(region.contains(Point{-0.4, -0.3}));
  EXPECT_FALSE(region.contains(Point{-0.4, 0.3}));
}

TEST(Separators, FullCirclesAreClosed) {
  const std::vector<ThinSet> ring{arc_set({0, 0}, 1, 0, 2 * pi),
                                  arc_set({0.2, 0}, 0.3, 1, 1 + 2 * pi)};
  const DescribedSolid solid = described_solid(ring, {"rim", "hole"});
  ASSERT_EQ(solid.region.primitives().size(), 2u);
  EXPECT_EQ(solid.region.primitives()[1]->name, "hole");
  EXPECT_TRUE(solid.sides.empty());
  expect_inside(solid, ring, 1.2);
  const RegionEvaluator region(solid.region);
  EXPECT_FALSE(region.contains(Point{0.2, 0.1}));
  EXPECT_TRUE(region.contains(Point{-0.5, 0.1}));
}

TEST(Separators, PiecesMustCloseAndHaveNames) {
  EXPECT_THROW(described_solid({segment_set({0, 0}, {1, 0})}, numbered(1)), InvalidArgument);
  EXPECT_THROW(
      described_solid({arc_set({0, 0}, 1, 0, 2), segment_set({1, 0}, {0, 1})}, numbered(1)),
      InvalidArgument);
}

}  // namespace
}  // namespace rfm
