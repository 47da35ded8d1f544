#include "core/winding_sign.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;

// A half disk with a square hole, its pieces in no order and turned at will.
std::vector<ThinSet> half_disk_with_hole() {
  return {segment_set({1, 0}, {-1, 0}),        arc_set({0, 0}, 1, 0, pi),
          segment_set({0.2, 0.2}, {0.2, 0.4}), segment_set({0.4, 0.4}, {0.4, 0.2}),
          segment_set({0.2, 0.4}, {0.4, 0.4}), segment_set({0.2, 0.2}, {0.4, 0.2})};
}
bool in_half_disk(double x, double y) {
  const bool hole = std::fabs(x - 0.3) < 0.1 && std::fabs(y - 0.3) < 0.1;
  return y > 0 && x * x + y * y < 1 && !hole;
}

TEST(WindingSign, OfPiecesOfThePlaneIsThatOfTheShape) {
  const Field omega = signed_function(half_disk_with_hole());
  std::mt19937 generator(8);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = -1.5 + 3 * 0x1p-32 * generator(), y = -1.5 + 3 * 0x1p-32 * generator();
    EXPECT_EQ(value_at(omega, {x, y}) > 0, in_half_disk(x, y)) << x << ", " << y;
    inside += in_half_disk(x, y);
  }
  EXPECT_GT(inside, 100);
}

// Arcs of every size, to the left and to the right of their chords, against the circles themselves.
TEST(WindingSign, OfArcsCountsThePartBetweenArcAndChord) {
  for (const double angle : {0.5, 2.0, 3.0, 4.0, 5.5}) {
    const Point from{std::cos(0.3), std::sin(0.3)};
    const Point to{std::cos(0.3 + angle), std::sin(0.3 + angle)};
    const WindingSign sign({arc_set({0, 0}, 1, 0.3, 0.3 + angle), segment_set(from, to)});
    for (double x = -1.21; x < 1.3; x += 0.1)
      for (double y = -1.23; y < 1.3; y += 0.1) {
        const double beyond = x * std::cos(0.3 + angle / 2) + y * std::sin(0.3 + angle / 2);
        const bool expected = x * x + y * y < 1 && beyond > std::cos(angle / 2);
        EXPECT_EQ(sign.is_inside({x, y}), expected) << angle << ": " << x << ", " << y;
      }
  }
}

// Where the angle of the chord jumps, the part between arc and chord takes over: at no point both
// or neither of them, however rounding places it.
TEST(WindingSign, OnTheChordOfAnArcIsThatOfItsNeighbourhood) {
  std::mt19937 generator(3);
  const auto uniform = [&] { return 0x1p-32 * generator(); };
  for (int trial = 0; trial < 300; ++trial) {
    const Point a{uniform(), uniform()}, b{2 + uniform(), uniform()};
    const Point middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    const double radius = 0.5 * std::hypot(b[0] - a[0], b[1] - a[1]);
    const double angle = std::atan2(b[1] - a[1], b[0] - a[0]);
    // Semicircles on the same chord: a disk; and with a segment for one of them: half of it.
    const WindingSign disk(
        {arc_set(middle, radius, angle, angle + pi), arc_set(middle, radius, angle - pi, angle)});
    for (int i = 0; i < 10; ++i) {
      const double t = 0.01 + 0.98 * uniform();
      EXPECT_TRUE(disk.is_inside({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}));
      EXPECT_FALSE(disk.is_inside({a[0] - t * (b[0] - a[0]), a[1] - t * (b[1] - a[1])}));
    }
  }
}

TEST(WindingSign, SignedFunctionsAreNormalisedAndSmoothAcrossTheirPieces) {
  const Field omega = signed_function(half_disk_with_hole());
  for (const double side : {-1e-7, 1e-7}) {
    const PointJet arc = evaluate(omega, {0.6 * (1 + side), 0.8 * (1 + side)}, 2, 2);
    EXPECT_NEAR(arc.derivative(1, 0), -0.6, 1e-5);
    EXPECT_NEAR(arc.derivative(0, 1), -0.8, 1e-5);
    const PointJet floor = evaluate(omega, {-0.5, side}, 2, 2);
    EXPECT_NEAR(floor.derivative(1, 0), 0, 1e-5);
    EXPECT_NEAR(floor.derivative(0, 1), 1, 1e-5);
  }
}

std::vector<ThinSet> tetrahedron() {
  const Point o{0, 0, 0}, a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1};
  return {triangle_set(o, b, a), triangle_set(o, a, c), triangle_set(o, c, b),
          triangle_set(a, b, c)};
}

TEST(WindingSign, OfATriangleMeshIsThatOfTheBody) {
  const Field omega = signed_function(tetrahedron());
  std::mt19937 generator(9);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point at{-0.2 + 1.0 * 0x1p-32 * generator(), -0.2 + 1.0 * 0x1p-32 * generator(),
                   -0.2 + 1.0 * 0x1p-32 * generator()};
    const bool expected = at[0] > 0 && at[1] > 0 && at[2] > 0 && at[0] + at[1] + at[2] < 1;
    EXPECT_EQ(value_at(omega, at) > 0, expected);
    inside += expected;
  }
  EXPECT_GT(inside, 50);
  for (const Point& on : {Point{0.2, 0.3, 0}, Point{0.2, 0.3, 0.5}})
    EXPECT_NEAR(value_at(omega, on), 0, 1e-15);
}

TEST(WindingSign, BoundsHoldAndAreSharpAwayFromTheBoundary) {
  const WindingSign sign(half_disk_with_hole());
  EXPECT_EQ(sign.bounds({2, {-0.4, 0.4}, {-0.3, 0.5}}).value.low, 1);
  EXPECT_EQ(sign.bounds({2, {1.2, 1}, {1.3, 1.1}}).value.high, -1);
  EXPECT_EQ(sign.bounds({2, {-0.1, -0.1}, {0.1, 0.1}}).value.width(), 2);
}

TEST(WindingSign, PiecesThatDoNotCloseAreRefused) {
  EXPECT_THROW(WindingSign({segment_set({0, 0}, {1, 0}), segment_set({1, 0}, {1, 1})}),
               InvalidArgument);
  EXPECT_THROW(WindingSign({point_set({0, 0})}), InvalidArgument);
  std::vector<ThinSet> open = tetrahedron();
  open.pop_back();
  EXPECT_THROW(WindingSign{open}, InvalidArgument);
}

}  // namespace
}  // namespace rfm
