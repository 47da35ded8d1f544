#include "core/set_description.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/r_functions.hpp"
#include "core/regularity.hpp"

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;

std::vector<Field> functions(const Region& region) {
  std::vector<Field> list;
  for (const auto& primitive : region.primitives()) list.push_back(primitive->function);
  return list;
}

int literals(const BooleanExpression& expression) {
  int count = 0;
  for (const auto& node : expression.nodes()) count += node.kind == Kind::variable ? 1 : 0;
  return count;
}

// The R-function of an expression is positive where the region is and negative where it is not.
void expect_same_set(const BooleanExpression& expression, const std::vector<Field>& primitives,
                     const RegionEvaluator& region, const Box& bounds) {
  const Field f = r_function(expression, primitives);
  for (double s = -0.3117; s < 1.3; s += 0.0371)
    for (double t = -0.2911; t < 1.3; t += 0.0367) {
      const Point at{bounds.low[0] + s * bounds.length(0), bounds.low[1] + t * bounds.length(1)};
      EXPECT_EQ(value_at(f, at) >= 0, region.contains(at)) << at[0] << ", " << at[1];
    }
}

struct Disks {
  Disks() {
    for (int k = 0; k < 3; ++k) {
      const double t = 0.4 + 2 * std::numbers::pi * k / 3, c = std::cos(t), s = std::sin(t);
      const Region disk = circle({c, s}, 1).named("d" + std::to_string(k));
      parts.push_back(disk);
      // The chord of its outer arc.
      chords.push_back(half_plane({0.5 * c, 0.5 * s}, {c, s}).primitives()[0]->function);
    }
  }
  Region whole() const { return parts[0] | parts[1] | parts[2]; }
  std::vector<Region> parts;
  std::vector<Field> chords;
};

TEST(SetDescription, OfFigure59NeedsNoChords) {
  // V. Shapiro (2007), figure 5.9: a solid with three circular edges. The chords suffice, and are
  // not needed, since it is the union of its disks; for its complement they are.
  const Disks disks;
  const RegionEvaluator region(disks.whole());
  const Box bounds = bounding_box(region);
  std::vector<Field> primitives = functions(disks.whole());
  primitives.insert(primitives.end(), disks.chords.begin(), disks.chords.end());
  const SetDescription description(primitives, solid_membership(region), bounds);
  EXPECT_FALSE(description.conflict());
  const std::vector<bool> used = without_needless_separators(description, 3);
  EXPECT_EQ(used, (std::vector<bool>{true, true, true, false, false, false}));
  const BooleanExpression minimal = description.restricted(used).minimal_form();
  EXPECT_EQ(literals(minimal), 3);
  expect_same_set(minimal, primitives, region, bounds);

  const SetDescription outside = description.complement();
  EXPECT_FALSE(outside.conflict());
  EXPECT_EQ(without_needless_separators(outside, 3),
            (std::vector<bool>{true, true, true, true, true, true}));
  const auto points = outside.restricted(used).conflict();
  ASSERT_TRUE(points);  // the origin, where all circles meet
  EXPECT_NEAR(std::hypot(points->second[0], points->second[1]), 0, 1e-9);

  // With them the signed function has no zero inside, and vanishes on the boundary.
  const Field f = 0.5 * (implicit(disks.whole()) - r_function(outside.minimal_form(), primitives));
  EXPECT_GT(value_at(f, {0, 0}), 0.05);
  EXPECT_NEAR(value_at(f, {2 * std::cos(0.4), 2 * std::sin(0.4)}), 0, 1e-14);
}

TEST(SetDescription, OfFigure58NeedsASeparator) {
  // As there, one cell of the boundary's primitives is inside in one part and outside in another:
  // the half of a ring that a line cuts off, described by its circles only.
  const Region ring = circle({0, 0}, 2).named("outer") - circle({0, 0}, 1).named("inner");
  const Region half = ring & half_plane({0, 0}, {0, 1}).named("line");
  const RegionEvaluator region(half);
  const Box bounds = bounding_box(region);
  const SetDescription by_circles(functions(ring), solid_membership(region), bounds);
  const auto points = by_circles.conflict();
  ASSERT_TRUE(points);
  EXPECT_GT(points->first[1], 0);
  EXPECT_LE(points->second[1], 0);
  EXPECT_THROW(by_circles.canonical_form(), InvalidArgument);
  const SetDescription complete(functions(half), solid_membership(region), bounds);
  EXPECT_FALSE(complete.conflict());
  EXPECT_EQ(without_needless_separators(complete, 2), (std::vector<bool>{true, true, true}));
  EXPECT_EQ(literals(complete.minimal_form()), 3);
}

TEST(SetDescription, CanonicalFormOfAnLIsTheSumOfItsCells) {
  const Region ell = box({0, 0}, {1, 1}).named("big") - box({0.5, 0.5}, {2, 2}).named("small");
  const RegionEvaluator region(ell);
  const Box bounds = bounding_box(region);
  const SetDescription description(functions(ell), solid_membership(region), bounds);
  // Six lines that matter cut the L into three squares, none farther away.
  const BooleanExpression canonical = description.canonical_form();
  EXPECT_EQ(literals(canonical), 3 * 8);
  expect_same_set(canonical, functions(ell), region, bounds);
  // Minimal: left, right, bottom and top, and not beyond both of small's sides.
  const BooleanExpression minimal = description.minimal_form();
  EXPECT_LE(literals(minimal), 8);
  expect_same_set(minimal, functions(ell), region, bounds);
}

TEST(SetDescription, OfSquaresThatShareASideDropsIt) {
  const Region two = box({0, 0}, {1, 1}).named("west") | box({1, 0}, {2, 1}).named("east");
  const RegionEvaluator region(two);
  const Box bounds = bounding_box(region);
  EXPECT_EQ(irregularities(region, bounds).size(), 1u);
  const SetDescription description(functions(two), solid_membership(region), bounds);
  const BooleanExpression minimal = description.minimal_form();
  EXPECT_EQ(literals(minimal), 4);
  const Field f = r_function(minimal, functions(two));
  EXPECT_GT(value_at(f, {1, 0.5}), 0.1);
  EXPECT_NEAR(value_at(f, {2, 0.5}), 0, 1e-15);
  EXPECT_NEAR(value_at(f, {1.7, 1}), 0, 1e-15);
  EXPECT_LT(value_at(f, {30, 0.5}), 0);
}

TEST(SetDescription, OfRandomCombinationsIsTheSameSet) {
  std::mt19937 generator(8);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(generator);
  };
  for (int trial = 0; trial < 12; ++trial) {
    Region region = circle({0, 0}, 1).named("c");
    for (int k = 0; k < 4; ++k) {
      const Region next =
          generator() % 2 == 0
              ? circle({number(-1, 1), number(-1, 1)}, number(0.4, 0.9)).named("d")
              : half_plane({number(-0.5, 0.5), number(-0.5, 0.5)}, {number(-1, 1), number(-1, 1)})
                    .named("h");
      region = generator() % 2 == 0 ? (region & next) | (region - next) : region - next;
      if (k % 2 == 1) region = region | circle({number(-1, 1), number(-1, 1)}, 0.5).named("e");
    }
    const RegionEvaluator evaluator(region);
    const Box bounds{2, {-2, -2}, {2, 2}};
    const SetDescription description(functions(region), solid_membership(evaluator), bounds);
    ASSERT_FALSE(description.conflict()) << trial;
    const BooleanExpression minimal = description.minimal_form();
    EXPECT_LE(literals(minimal), literals(description.canonical_form()));
    const Field f = r_function(minimal, functions(region));
    for (double x = -1.97; x < 2; x += 0.083)
      for (double y = -1.96; y < 2; y += 0.079)
        EXPECT_EQ(value_at(f, {x, y}) >= 0, evaluator.contains(Point{x, y}))
            << trial << ": " << x << ", " << y;
  }
}

}  // namespace
}  // namespace rfm
