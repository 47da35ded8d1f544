#include "core/curve_division.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

/// A thin lens between two arcs through (−1, 0) and (1, 0).
std::vector<CurvePiece> lens(double lower, double upper) {
  return {CurvePiece::arc({-1, 0}, {1, 0}, lower, 0), CurvePiece::arc({1, 0}, {-1, 0}, upper, 1)};
}

const std::vector<std::string> names{"edge1", "edge2", "edge3", "edge4", "edge5"};

TEST(CurveDivision, PartsHullsOfPiecesThatDoNotFollowEachOther) {
  const auto contours = divided({lens(0.3, -0.25)}, names);
  ASSERT_EQ(contours.size(), 1u);
  const auto& links = contours[0];
  ASSERT_GT(links.size(), 2u);
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const bool follows = i - j == 1 || i - j == links.size() - 1;
      if (!follows) {
        EXPECT_FALSE(hulls_meet(links[i].piece.hull(), links[j].piece.hull())) << i << " " << j;
      }
    }
}

TEST(CurveDivision, PiecesAreTheCurveInOrder) {
  const auto contours = divided({lens(0.3, -0.25)}, names);
  const auto& links = contours[0];
  // The lower arc lies on a circle through (±1, 0) of radius (1 + b²)/(2 b).
  const double b = 0.3, radius = (1 + b * b) / (2 * b), height = radius - b;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const CurvePiece& piece = links[i].piece;
    EXPECT_EQ(piece.to, links[(i + 1) % links.size()].piece.from);
    EXPECT_FALSE(links[i].is_tangent);
    if (piece.edge != 0) continue;
    EXPECT_NEAR(std::hypot(piece.middle()[0], piece.middle()[1] - height), radius, 1e-14);
  }
}

TEST(CurveDivision, PutsATangentWhereTheCurvatureChangesItsSign) {
  // An S of two quarter circles on a box: they touch in (1, 1).
  const double quarter = std::tan(std::atan(1.0) / 2);
  const std::vector<CurvePiece> contour{
      CurvePiece::straight({0, -1}, {2, -1}, 0), CurvePiece::straight({2, -1}, {2, 2}, 1),
      CurvePiece::arc({2, 2}, {1, 1}, quarter, 2), CurvePiece::arc({1, 1}, {0, 0}, -quarter, 3),
      CurvePiece::straight({0, 0}, {0, -1}, 4)};
  int tangents = 0;
  const auto contours = divided({contour}, names);
  for (const ContourLink& link : contours[0])
    if (link.is_tangent) {
      ++tangents;
      EXPECT_NEAR(link.piece.from[0], 1, 1e-12);
      EXPECT_NEAR(link.piece.from[1], 1, 1e-12);
      EXPECT_TRUE(link.piece.is_straight());
    }
  EXPECT_EQ(tangents, 1);
}

TEST(CurveDivision, RefusesCurvesThatTouch) {
  // Both arcs bulge to the same side by the same amount.
  EXPECT_THROW(divided({lens(0.3, -0.3)}, names), InvalidArgument);
}

}  // namespace
}  // namespace rfm
