#include "core/boundary_piece.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/bounding_box.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

BoundaryPiece piece_of(const Region& region, const std::string& name) {
  const RegionEvaluator evaluator(region);
  for (int k = 0; k < evaluator.primitive_count(); ++k)
    if (region.primitives()[k]->name == name)
      return boundary_piece(k, evaluator, bounding_box(evaluator));
  ADD_FAILURE() << "no primitive " << name;
  return {};
}

void expect_positive_within(const Field& function, const Region& region) {
  const RegionEvaluator evaluator(region);
  const Box box = bounding_box(evaluator);
  for (double s = 0.017; s < 1; s += 0.047)
    for (double t = 0.013; t < 1; t += 0.047) {
      const Point at{box.low[0] + s * box.length(0), box.low[1] + t * box.length(1)};
      if (!evaluator.contains(at)) continue;
      EXPECT_GT(value_at(function, at), 0) << at[0] << ", " << at[1];
    }
}

// Zero at `at` with unit slope along the inward `normal`.
void expect_boundary(const Field& function, const Point& at, const Point& normal) {
  EXPECT_NEAR(value_at(function, at), 0, 2e-16);
  const double small = 1e-7;
  const Point inside{at[0] + small * normal[0], at[1] + small * normal[1]};
  const PointJet jet = evaluate(function, inside, 1);
  EXPECT_NEAR(jet.derivative(1, 0), normal[0], 1e-6);
  EXPECT_NEAR(jet.derivative(0, 1), normal[1], 1e-6);
}

TEST(BoundaryPiece, OfARingAreTheWholeCircles) {
  const Region ring = circle({0, 0}, 1).named("outer") - circle({0.1, 0}, 0.4).named("inner");
  for (const char* name : {"outer", "inner"}) {
    const BoundaryPiece piece = piece_of(ring, name);
    EXPECT_TRUE(piece.whole);
    EXPECT_EQ(piece.name, name);
    expect_positive_within(piece.function, ring);
  }
  expect_boundary(piece_of(ring, "outer").function, {1, 0}, {-1, 0});
  expect_boundary(piece_of(ring, "inner").function, {0.5, 0}, {1, 0});
}

const Region ell = box({0, 0}, {1, 1}).named("big") - box({0.5, 0.25}, {2, 2}).named("small");

TEST(BoundaryPiece, SidesThatGoOnIntoTheRegionAreTrimmed) {
  EXPECT_TRUE(piece_of(ell, "big.left").whole);
  const BoundaryPiece left = piece_of(ell, "small.left"), bottom = piece_of(ell, "small.bottom");
  EXPECT_FALSE(left.whole);
  EXPECT_FALSE(bottom.whole);
  for (const double t : {0.3, 0.5, 0.9}) expect_boundary(left.function, {0.5, t}, {-1, 0});
  for (const double t : {0.55, 0.7, 0.95}) expect_boundary(bottom.function, {t, 0.25}, {0, -1});
  // On the rest of their lines, within the region, they are not zero.
  EXPECT_GT(value_at(left.function, {0.5, 0.2}), 1e-3);
  EXPECT_GT(value_at(bottom.function, {0.4, 0.25}), 1e-3);
  expect_positive_within(left.function, ell);
  expect_positive_within(bottom.function, ell);
}

TEST(BoundaryPiece, OfOverlappingDisksAreTrimmedArcs) {
  const Region two = circle({0, 0}, 1).named("a") | circle({1, 0}, 1).named("b");
  const BoundaryPiece arc = piece_of(two, "a");
  EXPECT_FALSE(arc.whole);
  expect_boundary(arc.function, {-1, 0}, {1, 0});
  expect_boundary(arc.function, {-0.6, 0.8}, {0.6, -0.8});
  EXPECT_GT(value_at(arc.function, {1, 0}), 0.1);
  expect_positive_within(arc.function, two);
}

TEST(BoundaryPiece, OfFlushShapesEndsWhereTheNextOneBegins) {
  // Both bottoms lie on y = 0. Where one is the boundary the function of the other is positive, and
  // data of both can be joined.
  const Region two = box({0, 0}, {1, 1}).named("a") | box({1, 0}, {2, 1}).named("b");
  const BoundaryPiece west = piece_of(two, "a.bottom"), east = piece_of(two, "b.bottom");
  for (const double t : {0.006, 0.3, 0.8}) {
    expect_boundary(west.function, {t, 0}, {0, 1});
    expect_boundary(east.function, {2 - t, 0}, {0, 1});
    EXPECT_GT(value_at(east.function, {t, 0}), 0.1 * (1 - t));
    EXPECT_GT(value_at(west.function, {2 - t, 0}), 0.1 * (1 - t));
  }
}

TEST(BoundaryPiece, IsPositiveAlsoInPartsOfAUnionThatDoNotMeet) {
  const Region apart = circle({0, 0}, 1).named("a") | circle({3, 0}, 1).named("b");
  EXPECT_TRUE(piece_of(apart, "a").whole);
  expect_positive_within(piece_of(apart, "a").function, apart);
  expect_boundary(piece_of(apart, "a").function, {1, 0}, {-1, 0});
  const Region pierced =
      (circle({0, 0}, 1) - circle({0, 0}, 0.5).named("hole")) | circle({3, 0}, 1).named("b");
  expect_positive_within(piece_of(pierced, "hole").function, pierced);
  expect_boundary(piece_of(pierced, "hole").function, {0.5, 0}, {1, 0});
}

TEST(BoundaryPiece, SidesFollowFromHowAPrimitiveOccurs) {
  const Region a = circle({0, 0}, 1), b = circle({1, 0}, 1);
  EXPECT_EQ(side_of(0, RegionEvaluator(a - b)), Side::positive);
  EXPECT_EQ(side_of(1, RegionEvaluator(a - b)), Side::negative);
  EXPECT_EQ(side_of(1, RegionEvaluator(a - !b)), Side::positive);
  EXPECT_EQ(side_of(0, RegionEvaluator(a ^ b)), Side::both);
}

TEST(BoundaryPiece, NormalsAreUnitVectorsOutOfTheRegion) {
  const auto normal_at = [](const Region& region, int primitive, const Point& at) {
    const std::vector<Field> normal = outward_normal(primitive, RegionEvaluator(region));
    return std::pair(value_at(normal[0], at), value_at(normal[1], at));
  };
  const Region a = circle({0, 0}, 1), b = circle({1, 0}, 1);
  const auto expect = [](const std::pair<double, double>& normal, double nx, double ny) {
    EXPECT_NEAR(normal.first, nx, 1e-15);
    EXPECT_NEAR(normal.second, ny, 1e-15);
  };
  expect(normal_at(a - b, 0, {-0.6, 0.8}), -0.6, 0.8);
  expect(normal_at(a - b, 1, {0, 0}), 1, 0);
  expect(normal_at(a ^ b, 0, {-1, 0}), -1, 0);  // the region lies inside of a here
  expect(normal_at(a ^ b, 0, {1, 0}), -1, 0);   // and outside of it within b
}

TEST(BoundaryPiece, SeenFromInsideIsSmoothAcrossThePieceAndTheSameWithin) {
  // A side that goes on into the region, one of a union whose parts do not meet, and a hole.
  const Region apart = (circle({0, 0}, 1) - circle({0, 0}, 0.3).named("hole")) |
                       (half_plane({3, 0}, {1, 0}).named("left") & circle({3, 0}, 1).named("cap"));
  for (const auto& [region, name, at, inward] :
       {std::tuple(ell, "small.left", Point{0.5, 0.6}, Point{-1, 0}),
        std::tuple(apart, "left", Point{3, 0.2}, Point{1, 0}),
        std::tuple(apart, "hole", Point{0, 0.3}, Point{0, 1})}) {
    const BoundaryPiece piece = piece_of(region, name);
    // As far outside as rounding may put a point, and more.
    const Point outside{at[0] - 1e-10 * inward[0], at[1] - 1e-10 * inward[1]};
    const Point inside{at[0] + 1e-3 * inward[0], at[1] + 1e-3 * inward[1]};
    EXPECT_LT(value_at(piece.from_inside, outside), 0) << name;
    EXPECT_NEAR(value_at(piece.from_inside, inside), value_at(piece.function, inside), 1e-15);
    expect_boundary(piece.from_inside, at, inward);
    expect_positive_within(piece.from_inside, region);
  }
}

}  // namespace
}  // namespace rfm
