#include "core/contact.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

Factor plain(int primitive) {
  return {BooleanExpression::variable(primitive), {{primitive, false}}};
}
Factor negated(int primitive) {
  return {!BooleanExpression::variable(primitive), {{primitive, true}}};
}

// Each question with a tree of its own.
Contact contact_of(const Factor& a, const Factor& b, const RegionEvaluator& region,
                   const Box& bounds) {
  SignTree tree(region, bounds);
  return rfm::contact(a, b, tree);
}
bool meets(const Factor& factor, const RegionEvaluator& region, const Box& bounds) {
  SignTree tree(region, bounds);
  return rfm::meets_region(factor, tree);
}
bool extends(int primitive, const RegionEvaluator& region, const Box& bounds) {
  SignTree tree(region, bounds);
  return rfm::extends_beyond_piece(primitive, tree);
}
bool has_sign(int primitive, bool positive, const RegionEvaluator& region, const Box& bounds) {
  SignTree tree(region, bounds);
  return rfm::has_sign_within(primitive, positive, tree);
}

// Two half-planes that open by `degrees` around a corner at the origin, closed by a circle.
class Wedge : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Contact, Wedge,
                         testing::Values(20.0, 60.0, 89.9, 90.0, 90.1, 120.0, 175.0));

TEST_P(Wedge, IsAcuteUpToARightAngle) {
  const double angle = GetParam() * std::numbers::pi / 180;
  // The x-axis is the lower side; the upper one runs along (cos, sin).
  const Region region = half_plane({0, 0}, {0, 1}) &
                        half_plane({0, 0}, {std::sin(angle), -std::cos(angle)}) & circle({0, 0}, 1);
  const RegionEvaluator evaluator(region);
  EXPECT_EQ(contact_of(plain(0), plain(1), evaluator, bounding_box(evaluator)),
            GetParam() <= 90 ? Contact::acute : Contact::obtuse);
}

TEST(Contact, OfCurvesThatDoNotMeetIsNone) {
  const RegionEvaluator ring(circle({0, 0}, 1) - circle({0, 0}, 0.95));
  EXPECT_EQ(contact_of(plain(0), negated(1), ring, {2, {-1, -1}, {1, 1}}), Contact::none);
}

TEST(Contact, OutsideTheRegionDoesNotCount) {
  // The lines y = ±x/2 cross at the origin, but the region lies to the right of x = 1/2.
  const RegionEvaluator region(half_plane({0, 0}, {0.5, -1}) & half_plane({0, 0}, {0.5, 1}) &
                               box({0.5, -1}, {1, 1}));
  EXPECT_EQ(contact_of(plain(0), plain(1), region, {2, {0.5, -0.5}, {1, 0.5}}), Contact::none);
  // Also if they cross so close to it that no box separates them.
  const RegionEvaluator close(half_plane({0, 0}, {0.5, -1}) & half_plane({0, 0}, {0.5, 1}) &
                              box({1e-4, -1}, {1, 1}));
  EXPECT_EQ(contact_of(plain(0), plain(1), close, {2, {1e-4, -0.5}, {1, 0.5}}), Contact::none);
}

TEST(Contact, TurnsWithTheSignOfALiteral) {
  // At (0, 1) the circle and the line x = 0 cross at right angles; a tilted line does not.
  const Region disk = circle({0, 0}, 1);
  for (const double tilt : {0.3, -0.3}) {
    const Region line = half_plane({0, 1}, {1, tilt});
    const RegionEvaluator within(disk & line), without(disk - line);
    // The line also leaves the disk elsewhere, at the supplementary angle to the chord's other
    // side.
    const Box above{2, {-0.2, 0.8}, {0.2, 1}};
    EXPECT_EQ(contact_of(plain(0), plain(1), within, above),
              tilt < 0 ? Contact::obtuse : Contact::acute)
        << tilt;
    EXPECT_EQ(contact_of(plain(0), negated(1), without, above),
              tilt < 0 ? Contact::acute : Contact::obtuse)
        << tilt;
  }
}

TEST(Contact, FactorsThatMissTheRegionAreProvedTo) {
  const RegionEvaluator region(circle({0, 0}, 1) & circle({0.3, 0}, 1.5) & circle({0, 0}, 1.2));
  const Box bounds{2, {-1, -1}, {1, 1}};
  EXPECT_TRUE(meets(plain(0), region, bounds));
  EXPECT_FALSE(meets(plain(1), region, bounds));
  EXPECT_FALSE(meets(plain(2), region, bounds));
}

TEST(Contact, ZeroSetsThatGoOnIntoTheRegionAreFound) {
  const RegionEvaluator ring(circle({0, 0}, 1) - circle({0, 0}, 0.4));
  const Box unit{2, {-1, -1}, {1, 1}};
  EXPECT_FALSE(extends(0, ring, unit));
  EXPECT_FALSE(extends(1, ring, unit));
  const RegionEvaluator two(circle({0, 0}, 1) | circle({1, 0}, 1));
  EXPECT_TRUE(extends(0, two, {2, {-1, -1}, {2, 1}}));
  const RegionEvaluator apart(circle({0, 0}, 1) | circle({3, 0}, 1));
  EXPECT_FALSE(extends(0, apart, {2, {-1, -1}, {4, 1}}));
}

TEST(Contact, SignsThatAPrimitiveHasWithinAreFound) {
  const Box both{2, {-1, -1}, {4, 1}};
  const RegionEvaluator apart(circle({0, 0}, 1) | circle({3, 0}, 1));
  EXPECT_TRUE(has_sign(0, true, apart, both));
  EXPECT_TRUE(has_sign(0, false, apart, both));  // in the other disk
  const RegionEvaluator ring(circle({0, 0}, 1) - circle({0, 0}, 0.4));
  EXPECT_FALSE(has_sign(0, false, ring, {2, {-1, -1}, {1, 1}}));
  EXPECT_FALSE(has_sign(1, true, ring, {2, {-1, -1}, {1, 1}}));
}

}  // namespace
}  // namespace rfm
