#include "core/smooth_joints.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/bounding_box.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::set<std::string> joints_of(const Region& shape) {
  const RegionEvaluator region(shape);
  std::set<std::string> names;
  for (const int k : smooth_joints(region, bounding_box(region)))
    names.insert(shape.primitives()[k]->name);
  return names;
}

TEST(SmoothJoints, OfACylinderAndTheBallsAtItsEnds) {
  for (const Point& axis : {Point{0, 0, 1}, Point{1, 2, -1}}) {
    const double size = std::hypot(axis[0], axis[1], axis[2]);
    const auto at = [&](double t) {
      return Point{t * axis[0] / size, t * axis[1] / size, t * axis[2] / size};
    };
    const Region rod = cylinder({0, 0, 0}, axis, 0.5, 2).named("rod");
    const Region ball = sphere(at(1), 0.5).named("ball"),
                 larger = sphere(at(1), 0.51).named("ball");
    EXPECT_THAT(joints_of(rod | ball), UnorderedElementsAre("rod.side", "ball"));
    EXPECT_THAT(joints_of(rod | larger), IsEmpty());
  }
}

TEST(SmoothJoints, OfAPlaneAndTheCylinderThatRoundsItsEdge) {
  const Region block = box({0, 0, 0}, {2, 1, 1}, 3).named("block");
  const Region round = cylinder({2, 0.5, 0.5}, {0, 0, 1}, 0.5, 1).named("round");
  EXPECT_THAT(joints_of(block | round),
              UnorderedElementsAre("block.bottom", "block.top", "round.side"));
}

TEST(SmoothJoints, OfAPlaneAndATorus) {
  // A plate with a round rim.
  const Region plate = cylinder({0, 0, 0}, {0, 0, 1}, 1, 0.4).named("plate");
  EXPECT_THAT(joints_of(plate | torus({0, 0, 0}, {0, 0, 1}, 1, 0.2).named("rim")),
              UnorderedElementsAre("plate.start", "plate.end", "rim"));
}

TEST(SmoothJoints, OfAStadiumInThePlane) {
  const Region middle = box({-1, -0.5}, {1, 0.5}).named("middle");
  EXPECT_THAT(joints_of(middle | circle({1, 0}, 0.5).named("end")),
              UnorderedElementsAre("middle.bottom", "middle.top", "end"));
}

TEST(SmoothJoints, AreNoneWhereSurfacesCrossOrTouchFromOutside) {
  EXPECT_THAT(joints_of(circle({0, 0}, 1).named("a") | circle({2, 0}, 1).named("b")), IsEmpty());
  EXPECT_THAT(joints_of(circle({0, 0}, 1).named("a") - circle({0.5, 0}, 0.5).named("b")),
              IsEmpty());
  // What touches from inside bounds nothing.
  EXPECT_THAT(joints_of(circle({0, 0}, 1).named("a") | circle({0.5, 0}, 0.5).named("b")),
              IsEmpty());
  EXPECT_THAT(joints_of(circle({0, 0}, 1).named("a") & box({-1, -1}, {1, 1}).named("b")),
              IsEmpty());
  // At an angle of two degrees.
  EXPECT_THAT(joints_of(circle({0, 0}, 1).named("a") & half_plane({0, 0.9994}, {0, -1}).named("b")),
              IsEmpty());
  EXPECT_THAT(joints_of(box({0, 0}, {1, 1}).named("a") - circle({0, 0}, 0.5).named("b")),
              IsEmpty());
}

TEST(SmoothJoints, AreNoneOfOneSurfaceThatTwoShapesShare) {
  const Region low = cylinder({0, 0, 0}, {0, 0, 1}, 0.5, 1).named("low");
  const Region high = cylinder({0, 0, 0.7}, {0, 0, 1}, 0.5, 1).named("high");
  EXPECT_THAT(joints_of(low | high), IsEmpty());
}

}  // namespace
}  // namespace rfm
