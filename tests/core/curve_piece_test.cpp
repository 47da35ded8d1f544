#include "core/curve_piece.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace rfm {
namespace {

/// The counter-clockwise arc of the unit circle between two angles.
CurvePiece arc(double from, double to) {
  return CurvePiece::arc({std::cos(from), std::sin(from)}, {std::cos(to), std::sin(to)},
                         std::tan((to - from) / 4), 3);
}
double radius(const Point& p) { return std::hypot(p[0], p[1]); }
double angle_between(const Point& a, const Point& b) {
  return std::atan2(cross(a, b), a[0] * b[0] + a[1] * b[1]);
}

TEST(CurvePiece, HalvesOfAnArcAreArcsOfTheSameCircle) {
  const double pi = std::numbers::pi;
  for (const auto& [from, to] : {std::pair(0.0, pi), std::pair(-0.4, 0.3), std::pair(1.0, 3.5)}) {
    CurvePiece piece = arc(from, to);
    double expected = to - from;
    for (int i = 0; i < 6; ++i, expected /= 2) {
      EXPECT_NEAR(radius(piece.middle()), 1, 4e-16);
      EXPECT_NEAR(angle_between(piece.from, piece.to), expected, 1e-15);
      const auto [first, second] = piece.halves();
      EXPECT_EQ(first.to, second.from);
      EXPECT_EQ(first.from, piece.from);
      EXPECT_EQ(second.to, piece.to);
      EXPECT_EQ(second.edge, 3);
      piece = i % 2 == 0 ? second : first;
    }
  }
}

TEST(CurvePiece, DirectionsOfAnArcAreTangentsAndTheChordLiesBetween) {
  const CurvePiece piece = arc(0.2, 2.4);
  EXPECT_EQ(piece.turn, 1);
  EXPECT_NEAR(angle_between(piece.from, piece.start_direction()), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(angle_between(piece.to, piece.end_direction()), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(angle_between(piece.start_direction(), piece.chord()), 1.1, 1e-15);
  const CurvePiece back = piece.reversed();
  EXPECT_EQ(back.turn, -1);
  EXPECT_NEAR(angle_between(back.start_direction(), piece.end_direction()), std::numbers::pi,
              1e-15);
}

TEST(CurvePiece, HullsHoldTheCurve) {
  for (const CurvePiece& piece :
       {arc(0, 3.1), arc(2, 2.2), CurvePiece::conic({0, 0}, {1, 2}, 3, {3, 0.5}, 0)}) {
    const auto hull = piece.hull();
    std::vector<CurvePiece> parts{piece};
    for (int level = 0; level < 5; ++level) {
      std::vector<CurvePiece> halves;
      for (const CurvePiece& part : parts)
        for (const CurvePiece& half : part.halves()) halves.push_back(half);
      parts = halves;
    }
    for (const CurvePiece& part : parts)
      for (int i = 0; i < 4; ++i) {
        const Point &a = hull[i], &b = hull[(i + 1) % 4], &p = part.from;
        const double side = cross({b[0] - a[0], b[1] - a[1]}, {p[0] - a[0], p[1] - a[1]});
        EXPECT_GE(side * piece.turn, -1e-12);
      }
  }
}

TEST(CurvePiece, HullsMeetOnlyWhereTheyHaveAPointInCommon) {
  const auto hull = arc(0, 1.5).hull();
  EXPECT_TRUE(hulls_meet(hull, arc(1.5, 3).hull()));  // a common end
  EXPECT_FALSE(hulls_meet(hull, arc(1.6, 3).hull()));
  EXPECT_TRUE(hulls_meet(hull, {{{0, 0}, {2, 2}, {2, 2}, {0, 0}}}));
  EXPECT_FALSE(hulls_meet(hull, {{{0, 0}, {0.5, 0.4}, {0.5, 0.4}, {0, 0}}}));  // inside the circle
}

TEST(CurvePiece, ConesMeetAtSharpTurnsOnly) {
  const auto to = [](double angle) {
    return CurvePiece::straight({0, 0}, {std::cos(angle), std::sin(angle)}, 1);
  };
  const CurvePiece arriving = CurvePiece::straight({-1, 0}, {0, 0}, 0);
  EXPECT_FALSE(cones_meet(arriving, to(0)));
  EXPECT_FALSE(cones_meet(arriving, to(3.0)));
  EXPECT_TRUE(cones_meet(arriving, to(std::numbers::pi)));  // straight back
  // An arc that arrives from above sweeps a cone.
  const CurvePiece bent = CurvePiece::arc({-1, 0}, {0, 0}, -0.5, 0);
  EXPECT_TRUE(cones_meet(bent, to(3.0)));
  EXPECT_FALSE(cones_meet(bent, to(-2.0)));
}

}  // namespace
}  // namespace rfm
