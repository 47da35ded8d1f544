#include "quadrature/vertices.hpp"

#include <gmock/gmock.h>

#include "core/point_algebra.hpp"
#include "core/primitives.hpp"
#include "core/profile_bodies.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

VertexSearch search(const Region& region, const Box& box) {
  const VertexSearch result = find_vertices(RegionEvaluator(region), box);
  EXPECT_EQ(result.crowded_boxes, 0);
  return result;
}

TEST(Vertices, ASquareHasFourRightAngles) {
  for (const double angle : {0.0, 0.3, pi / 4}) {
    const VertexSearch found = search(turned_square(0.8, angle, 0.1, -0.05), cube_box(1.7, 2));
    EXPECT_TRUE(found.unresolved.empty());
    ASSERT_EQ(found.vertices.size(), 4u);
    for (const Vertex& vertex : found.vertices) {
      EXPECT_NEAR(vertex.angle, pi / 2, 1e-14);
      EXPECT_EQ(vertex.edges, 2);
      EXPECT_EQ(vertex.primitives.size(), 2u);
      EXPECT_NEAR(std::hypot(vertex.point[0] - 0.1, vertex.point[1] + 0.05), 0.8 * std::sqrt(2),
                  1e-15);
    }
  }
}

TEST(Vertices, AStarHasFivePointsAndFiveNotches) {
  const VertexSearch found = search(star(0.45, 0.21), cube_box(1.7, 2));
  ASSERT_EQ(found.vertices.size(), 10u);
  int points = 0;
  for (const Vertex& vertex : found.vertices) {
    const bool is_point = vertex.angle < pi;
    points += is_point;
    EXPECT_NEAR(vertex.angle, is_point ? pi / 5 : 7 * pi / 5, 1e-13);
    EXPECT_EQ(vertex.primitives.size(), 2u);
  }
  EXPECT_EQ(points, 5);
}

TEST(Vertices, DisksMeetWhereTheirRadicalLineCrosses) {
  const VertexSearch found = search(disk(-0.5, 0, 1) | disk(0.5, 0, 1), cube_box(1.7, 2));
  ASSERT_EQ(found.vertices.size(), 2u);
  EXPECT_TRUE(found.unresolved.empty());
  for (const Vertex& vertex : found.vertices) {
    EXPECT_NEAR(vertex.point[0], 0, 1e-15);
    EXPECT_NEAR(std::fabs(vertex.point[1]), std::sqrt(0.75), 1e-15);
    // The radii to the point make 60°, so do the tangents; the union has all but that lens.
    EXPECT_NEAR(vertex.angle, 4 * pi / 3, 1e-14);
  }
  const VertexSearch lens = search(disk(-0.5, 0, 1) & disk(0.5, 0, 1), cube_box(1.7, 2));
  ASSERT_EQ(lens.vertices.size(), 2u);
  for (const Vertex& vertex : lens.vertices) EXPECT_NEAR(vertex.angle, 2 * pi / 3, 1e-14);
}

TEST(Vertices, CrossingsThatAreCoveredDoNotCount) {
  const Region covered = (disk(-0.5, 0, 1) | disk(0.5, 0, 1)) | half_plane(0, -1, 0.1);
  const VertexSearch found = search(covered & disk(0, 0, 1.6), cube_box(1.7, 2));
  // The upper crossing; the line with either circle; the line with the large circle.
  EXPECT_EQ(found.vertices.size(), 5u);
}

TEST(Vertices, ACheckerboardTouchesInOneCornerOfFourEdges) {
  const Region board = (half_plane(1, 0, 0.013) ^ half_plane(0, 1, -0.2)) & disk(0, 0, 1);
  const VertexSearch found = search(board, cube_box(1.7, 2));
  ASSERT_EQ(found.vertices.size(), 5u);
  int crosses = 0;
  for (const Vertex& vertex : found.vertices) {
    if (vertex.edges != 4) continue;
    ++crosses;
    EXPECT_NEAR(vertex.point[0], -0.013, 1e-15);
    EXPECT_NEAR(vertex.point[1], 0.2, 1e-15);
    EXPECT_NEAR(vertex.angle, pi, 1e-14);
  }
  EXPECT_EQ(crosses, 1);
}

TEST(Vertices, ThreeLinesThroughAPointAreOneCorner) {
  const Region wedge = half_plane(0, 1, 0) & half_plane(std::sin(1), -std::cos(1), 0) &
                       half_plane(std::sin(0.5), std::cos(0.5), 0);
  const VertexSearch found = search(wedge & disk(0, 0, 1), cube_box(1.7, 2));
  ASSERT_EQ(found.vertices.size(), 3u);
  for (const Vertex& vertex : found.vertices) {
    if (std::hypot(vertex.point[0], vertex.point[1]) > 0.5) continue;
    EXPECT_EQ(vertex.primitives.size(), 3u);
    EXPECT_EQ(vertex.edges, 2);
    EXPECT_NEAR(vertex.angle, 1, 1e-14);
  }
}

TEST(Vertices, CoincidentSidesCountOnce) {
  // Two boxes that share a face, together one box: four corners, not eight.
  const Region whole = box({-1, -1, 0}, {0, 1, 0}) | box({0, -1, 0}, {1, 1, 0});
  const VertexSearch found = search(whole, cube_box(1, 2));
  EXPECT_TRUE(found.unresolved.empty());
  EXPECT_EQ(found.vertices.size(), 4u);
  // A step: at (0, 1/2) a notch of 270°.
  const Region step = box({-1, -1, 0}, {0, 1, 0}) | box({0, -1, 0}, {1, 0.5, 0});
  const VertexSearch steps = search(step, cube_box(1, 2));
  ASSERT_EQ(steps.vertices.size(), 6u);
  int notches = 0;
  for (const Vertex& vertex : steps.vertices)
    if (std::fabs(vertex.angle - 1.5 * pi) < 1e-12) ++notches;
  EXPECT_EQ(notches, 1);
}

TEST(Vertices, TangenciesAreListedApart) {
  const VertexSearch found = search(disk(0, 0, 1) - disk(0.6, 0, 0.4), cube_box(1.7, 2));
  EXPECT_TRUE(found.vertices.empty());
  ASSERT_EQ(found.unresolved.size(), 1u);
  EXPECT_NEAR(found.unresolved[0][0], 1, 0.01);
  EXPECT_NEAR(found.unresolved[0][1], 0, 0.01);
}

TEST(Vertices, ACubeHasEightOfThreeEdgesAndAnEighthOfTheSphere) {
  for (const Region& cube :
       {box({-0.85, -0.85, -0.85}, {0.85, 0.85, 0.85}, 3), rotated_cube(0.85)}) {
    const VertexSearch found = search(cube, cube_box(1.7, 3));
    EXPECT_TRUE(found.unresolved.empty());
    ASSERT_EQ(found.vertices.size(), 8u);
    for (const Vertex& vertex : found.vertices) {
      EXPECT_EQ(vertex.edges, 3);
      EXPECT_EQ(vertex.primitives.size(), 3u);
      EXPECT_NEAR(vertex.angle, pi / 2, 1e-13);
      EXPECT_NEAR(std::hypot(vertex.point[0], vertex.point[1], vertex.point[2]),
                  0.85 * std::sqrt(3), 2e-15);
    }
  }
}

TEST(Vertices, FourPlanesMeetInTheApexOfAPyramid) {
  // |x| ≤ (1 − z)/2, |y| ≤ (1 − z)/2, z ≥ 0.
  const auto side = [](double a, double b) { return solid(0.5 * (1 - z()) + a * x() + b * y()); };
  const Region pyramid = side(1, 0) & side(-1, 0) & side(0, 1) & side(0, -1) & solid(z());
  const VertexSearch found = search(pyramid, cube_box(1.3, 3));
  EXPECT_TRUE(found.unresolved.empty());
  ASSERT_EQ(found.vertices.size(), 5u);
  for (const Vertex& vertex : found.vertices) {
    if (vertex.point[2] < 0.5) {
      EXPECT_EQ(vertex.edges, 3);
      continue;
    }
    EXPECT_EQ(vertex.edges, 4);
    EXPECT_EQ(vertex.primitives.size(), 4u);
    EXPECT_NEAR(vertex.point[2], 1, 1e-15);
    // A pyramid of half base a and height h: 4 asin(a² / (a² + h²)).
    EXPECT_NEAR(vertex.angle, 4 * std::asin(0.2), 1e-13);
  }
}

TEST(Vertices, AnOctantTakenFromACubeLeavesANotch) {
  const Region notched = box({-1, -1, -1}, {1, 1, 1}, 3) - box({0, 0, 0}, {1, 1, 1}, 3);
  const VertexSearch found = search(notched, cube_box(1, 3));
  EXPECT_TRUE(found.unresolved.empty());
  // 7 of the cube, 3 at the ends of the notch on edges, 3 in faces, 1 inside.
  ASSERT_EQ(found.vertices.size(), 14u);
  int inner = 0;
  for (const Vertex& vertex : found.vertices)
    if (norm(vertex.point) < 1e-12) {
      ++inner;
      EXPECT_NEAR(vertex.angle, 4 * pi - pi / 2, 1e-13);
      EXPECT_EQ(vertex.edges, 3);
    }
  EXPECT_EQ(inner, 1);
}

TEST(Vertices, ANapkinRingAndALineHaveNone) {
  const Region ring = sphere({0, 0, 0}, 1) - cylinder({0, 0, 0}, {0, 0, 1}, 0.5);
  EXPECT_TRUE(search(ring, cube_box(1.1, 3)).vertices.empty());
  EXPECT_TRUE(search(box({0, 0, 0}, {1, 0, 0}, 1), {1, {0, 0, 0}, {1, 0, 0}}).vertices.empty());
}

// Where two primitives have a piece in common, but not their whole zero sets, they form no corners.
TEST(Vertices, OfSidesThatCoincideWithACurveAreThoseOfTheOthers) {
  const Region strips = level_set(sin(pi * x_coordinate()));
  const VertexSearch found = search(box({0, 0}, {1, 1}) & strips, {2, {0, 0}, {1, 1}});
  EXPECT_EQ(found.vertices.size(), 4u);
  EXPECT_TRUE(found.unresolved.empty());
}

TEST(Vertices, WhereTwoSurfacesTouchInAPointThereIsNoProofAndThePointIsTold) {
  // Steinmetz: the two ellipses in which the cylinders meet cross at (0, ±1, 0).
  const Region two =
      region_of(1 - square(x()) - square(y()), 3) & region_of(1 - square(y()) - square(z()), 3);
  const Box box{3, {-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}};
  const VertexSearch found = find_vertices(RegionEvaluator(two), box);
  EXPECT_TRUE(found.vertices.empty());
  ASSERT_EQ(found.unresolved.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(found.unresolved[k][0], 0, 1e-3);
    EXPECT_NEAR(found.unresolved[k][1], k == 0 ? -1 : 1, 1e-3);
    EXPECT_NEAR(found.unresolved[k][2], 0, 1e-3);
  }
  // Of three cylinders eight vertices are corners of a cube; in six points two of them touch.
  const Region three = two & region_of(1 - square(z()) - square(x()), 3);
  const VertexSearch all = find_vertices(RegionEvaluator(three), box);
  EXPECT_EQ(all.vertices.size(), 8u);
  EXPECT_EQ(all.unresolved.size(), 6u);
}

TEST(Vertices, ContactsAlongCurvesAreNoPoints) {
  // A plane that touches a torus along a circle.
  const Region torus =
      region_of(0.0625 - square(sqrt(square(x()) + square(y())) - 0.7) - square(z()), 3);
  const Region body = torus & region_of(0.25 - z(), 3);
  const VertexSearch found = find_vertices(RegionEvaluator(body), {3, {-1, -1, -0.3}, {1, 1, 0.3}});
  EXPECT_TRUE(found.vertices.empty());
  EXPECT_TRUE(found.unresolved.empty());
}

// A turned can with a rounded corner: plane, torus and cylinder touch along circles, through which
// the cone passes that tells one from the other. Nothing is a point there, nor on the axis.
TEST(Vertices, ARoundedEdgeHasNone) {
  const Region profile = box({-5, 0}, {5, 6}) & (circle({4, 1}, 1) | half_plane({4, 0}, {-1, 1}));
  const Region can = revolution(profile, {0, 0, 0}, {0, 0, 1});
  const VertexSearch found = find_vertices(RegionEvaluator(can), {3, {-5, -5, 0}, {5, 5, 6}});
  EXPECT_TRUE(found.vertices.empty());
  EXPECT_TRUE(found.unresolved.empty());
}

}  // namespace
