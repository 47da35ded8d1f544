#include "core/weight.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/polygon.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
using testing::Not;

Weight weight_of(const Region& region, const WeightOptions& options = {}) {
  const RegionEvaluator evaluator(region);
  return weight(evaluator, bounding_box(evaluator), options);
}

// The regular polygon with unit apothem, sides e0, e1, …
Region polygon(int sides) {
  const auto side = [&](int k) {
    const double t = 0.3 + 2 * std::numbers::pi * k / sides;
    return half_plane({std::cos(t), std::sin(t)}, {-std::cos(t), -std::sin(t)})
        .named("e" + std::to_string(k));
  };
  Region region = side(0);
  for (int k = 1; k < sides; ++k) region = region & side(k);
  return region;
}

void expect_weight(const Region& region) {
  // Positive inside.
  const RegionEvaluator evaluator(region);
  const Box box = bounding_box(evaluator);
  const Field omega = weight(evaluator, box).function;
  for (double s = 0.017; s < 1; s += 0.06)
    for (double t = 0.013; t < 1; t += 0.06) {
      const Point at{box.low[0] + s * box.length(0), box.low[1] + t * box.length(1)};
      if (!evaluator.contains(at)) continue;
      EXPECT_GT(value_at(omega, at), 0) << at[0] << ", " << at[1];
    }
}

TEST(Weight, AtRightAnglesIsAProduct) {
  const Region square = box({0, 0}, {1, 1}).named("s");
  EXPECT_EQ(weight_of(square).formula,
            "omega(s.left) * omega(s.right) * omega(s.bottom) * omega(s.top)");
  EXPECT_NEAR(value_at(weight_of(square).function, {0.25, 0.5}), 0.25 * 0.75 * 0.25, 1e-16);
  expect_weight(square);
}

TEST(Weight, OfDisjointHolesIsAProduct) {
  const Region plate = circle({0, 0}, 2).named("rim") - circle({-0.8, 0}, 0.5).named("a") -
                       circle({0.8, 0}, 0.5).named("b");
  EXPECT_EQ(weight_of(plate).formula, "omega(rim) * -omega(a) * -omega(b)");
  expect_weight(plate);
}

// Of many factors those that do not meet are joined: a product would vary by a power of their
// number from cell to cell.
TEST(Weight, OfManyDisjointHolesIsAnRFunction) {
  const auto plate = [](int holes) {
    Region region = circle({0, 0}, 1).named("rim");
    for (int k = 0; k < holes; ++k) {
      const double t = 2 * std::numbers::pi * k / holes;
      region = region -
               circle({0.6 * std::cos(t), 0.6 * std::sin(t)}, 0.1).named("h" + std::to_string(k));
    }
    return region;
  };
  EXPECT_EQ(weight_of(plate(5)).parts.size(), 7u);  // the product and its six factors
  const Weight joined = weight_of(plate(6));
  EXPECT_EQ(joined.parts.size(), 1u);
  EXPECT_THAT(joined.formula, testing::StartsWith("r0_and("));
  expect_weight(plate(6));
}

// The tips of a star are acute, and each meets two others: two or three factors without neighbours
// hold them all.
TEST(Weight, OfAStarOfManyTipsIsAProductOfFew) {
  for (const int tips : {12, 13, 60}) {
    std::vector<Point> points;
    for (int k = 0; k < 2 * tips; ++k) {
      const double size = k % 2 == 0 ? 1 : 0.7, t = std::numbers::pi * k / tips;
      points.push_back({size * std::cos(t), size * std::sin(t)});
    }
    const Region star = rfm::polygon(points);
    const Weight weight = weight_of(star);
    EXPECT_GE(weight.parts.size(), 3u);  // the product and two factors
    EXPECT_LE(weight.parts.size(), 4u);
    expect_weight(star);
    // Not the power of a distance that a product of all tips is (1e-6, 1e-6 and 1e-30).
    EXPECT_GT(value_at(weight.function, {0, 0}), 1e-5);
  }
}

TEST(NormalizedFactors, OfAConvexPolygonOfManySidesAreOneFunction) {
  const RegionEvaluator region(polygon(500));
  const std::vector<Weight> factors =
      normalized_factors(region.region().expression(), region, bounding_box(region));
  ASSERT_EQ(factors.size(), 1u);
  EXPECT_GT(value_at(factors[0].function, {0, 0}), 1e-3);
  const PointJet jet =
      evaluate(factors[0].function, {std::cos(0.3), std::sin(0.3)}, 1, 2);  // middle of a side
  EXPECT_NEAR(jet.value(), 0, 1e-14);
  EXPECT_NEAR(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 1, 1e-9);
}

TEST(NormalizedFactors, OfASquareAreItsSides) {
  const RegionEvaluator square(box({0, 0}, {1, 1}));
  EXPECT_EQ(normalized_factors(square.region().expression(), square, {2, {0, 0}, {1, 1}}).size(),
            4u);
}

TEST(Weight, AtAcuteAnglesIsAProduct) {
  EXPECT_EQ(weight_of(polygon(3)).formula, "omega(e0) * omega(e1) * omega(e2)");
  expect_weight(polygon(3));
}

TEST(Weight, AtObtuseAnglesIsAnRFunction) {
  const Weight hexagon = weight_of(polygon(6));
  EXPECT_THAT(hexagon.formula, testing::StartsWith("r0_and("));
  EXPECT_THAT(hexagon.formula, Not(HasSubstr(" * ")));
  expect_weight(polygon(6));
}

TEST(Weight, OnlyThePairsAtObtuseAnglesAreJoined) {
  // A house: walls and floor at right angles, two slopes of the roof at 135° with the walls and at
  // 90° with each other.
  const Region house = box({-1, -1}, {1, 5}).named("w") & half_plane({0, 1}, {1, -1}).named("l") &
                       half_plane({0, 1}, {-1, -1}).named("r");
  const std::string formula = weight_of(house).formula;
  EXPECT_THAT(formula, HasSubstr("r0_and(omega(w.left), omega(l))"));
  EXPECT_THAT(formula, HasSubstr("r0_and(omega(w.right), omega(r))"));
  EXPECT_THAT(formula, HasSubstr("omega(w.bottom)"));
  EXPECT_THAT(formula, Not(HasSubstr("w.top")));  // above the roof
  expect_weight(house);
}

TEST(Weight, AtAReentrantCornerIsADisjunction) {
  const Region ell = box({0, 0}, {1, 1}).named("big") - box({0.5, 0.5}, {2, 2}).named("small");
  EXPECT_EQ(weight_of(ell).formula,
            "omega(big.left) * omega(big.right) * omega(big.bottom) * omega(big.top) * "
            "r0_or(-omega(small.left), -omega(small.bottom))");
  expect_weight(ell);
}

TEST(Weight, OverlappingDisksAreADisjunction) {
  const Region two = circle({0, 0}, 1).named("a") | circle({1, 0}, 1).named("b");
  EXPECT_EQ(weight_of(two).formula, "r0_or(omega(a), omega(b))");
  expect_weight(two);
}

TEST(Weight, TangencyFromTheSameSideIsObtuse) {
  // Inside both circles, which touch at (1, 0): the interior angle there is 180°.
  const Region region = circle({0, 0}, 1).named("a") & circle({0.5, 0}, 0.5).named("b");
  EXPECT_EQ(weight_of(region).formula, "r0_and(omega(a), omega(b))");
}

TEST(Weight, ConjunctsThatDoNotMeetTheRegionAreLeftOut) {
  const Region region = circle({0, 0}, 1).named("disk") & box({-9, -9}, {9, 9}).named("far") &
                        !circle({5, 0}, 1).named("away");
  EXPECT_EQ(weight_of(region).formula, "omega(disk)");
  // In a corner of the bounding box, but off the disk.
  EXPECT_EQ(
      weight_of(circle({0, 0}, 1).named("disk") - circle({0.9, 0.9}, 0.2).named("corner")).formula,
      "omega(disk)");
}

TEST(Weight, OfEveryRuleVanishesToFirstOrderOnTheBoundary) {
  // u − g = O(ω) needs a normal derivative that is not zero.
  const Region ring = circle({0, 0}, 1) - circle({0.2, 0.1}, 0.35);
  for (const CombineRule& rule :
       {CombineRule(AutomaticRule{}), CombineRule(RAlpha{0}), CombineRule(R1{}),
        CombineRule(ProductRule{}), CombineRule(RAlpha{0.5}), CombineRule(Rp{4}),
        CombineRule(PlateauRule{0.2, 3})}) {
    const Field omega = weight_of(ring, rule).function;
    for (const double t : {0.3, 2.0, 4.1})
      for (const Point& at : {Point{std::cos(t), std::sin(t)},
                              Point{0.2 + 0.35 * std::cos(t), 0.1 + 0.35 * std::sin(t)}}) {
        const PointJet jet = evaluate(omega, at, 1, 2);
        EXPECT_NEAR(jet.value(), 0, 1e-15);
        EXPECT_GT(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 0.1);
      }
    EXPECT_GT(value_at(omega, {0.7, 0}), 0);
  }
}

TEST(Weight, RulesOverrideTheChoice) {
  const Region square = box({0, 0}, {1, 1}).named("s"), hexagon = polygon(6);
  EXPECT_EQ(weight_of(square, CombineRule(RAlpha{0})).formula,
            "r0_and(r0_and(r0_and(omega(s.left), omega(s.right)), omega(s.bottom)), omega(s.top))");
  EXPECT_THAT(weight_of(square, CombineRule(R1{})).formula, testing::StartsWith("min(min(min("));
  EXPECT_NEAR(value_at(weight_of(square, CombineRule(R1{})).function, {0.3, 0.9}), 0.1, 1e-16);
  EXPECT_THAT(weight_of(hexagon, CombineRule(ProductRule{})).formula, Not(HasSubstr("r0")));
}

TEST(Weight, InSpaceABrickIsAProduct) {
  const Weight brick = weight_of(box({0, 0, 0}, {1, 2, 3}, 3).named("b"));
  EXPECT_THAT(brick.formula, Not(HasSubstr("r0")));
  EXPECT_NEAR(value_at(brick.function, {0.5, 1, 1.5}), 0.25 * 1 * 2.25, 1e-15);
}

TEST(Weight, OfAnySystemIsWrittenAndSaysHowSmoothItIs) {
  const Region square = box({0, 0}, {1, 1}).named("s") & half_plane({0, 0}, {1, 1}).named("h");
  const auto expect = [&](const RSystem& system, const char* formula, const char* smoothness) {
    const Weight omega = weight_of(square, CombineRule(system));
    EXPECT_THAT(omega.formula, testing::StartsWith(formula));
    ASSERT_EQ(omega.parts.size(), 1u);
    EXPECT_THAT(omega.parts[0].smoothness, HasSubstr(smoothness)) << formula;
    EXPECT_GT(value_at(omega.function, {0.3, 0.4}), 0);
    EXPECT_LT(value_at(omega.function, {1.3, 0.4}), 0);
  };
  expect(RAlpha{0.5}, "ralpha_and(ralpha_and(ralpha_and(", "Lipschitz");
  expect(Rp{4}, "rp_and(rp_and(rp_and(", "Lipschitz");
  expect(RAlphaM{0, 2}, "r0m_and(r0m_and(r0m_and(", "2 times differentiable");
  expect(R1{}, "min(min(min(", "kink");
  expect(UserSystem{"mine", [](const Field& x, const Field& y) { return min(x, y); }},
         "mine_and(mine_and(mine_and(", "as its author made it");
}

// Of operations of higher degree too: else the function of the cube of side 0.01 is 1e-300 of that
// of the unit cube, and its square no number at all.
TEST(Weight, OfAnySystemIsTheSameInEveryUnitOfLength) {
  for (const RSystem& system : {RSystem(RAlpha{0.5}), RSystem(Rp{4}), RSystem(RAlphaM{0, 1}),
                                RSystem(RAlphaM{0, 16}), RSystem(RCm{3}), RSystem(RCm{16})})
    for (const double size : {1e-3, 0.01, 100.0}) {
      const auto omega = [&](double length) {
        const Region cube = box({0, 0, 0}, {length, length, length}, 3).named("c");
        return weight_of(cube, CombineRule(system)).function;
      };
      const double expected = size * value_at(omega(1), {0.3, 0.6, 0.55});
      const double value = value_at(omega(size), {0.3 * size, 0.6 * size, 0.55 * size});
      EXPECT_NEAR(value / expected, 1, 1e-9) << system << ", " << size;
    }
}

TEST(Weight, PartsNameTheRuleOfEveryFactor) {
  const Weight ell =
      weight_of(box({0, 0}, {1, 1}).named("big") - box({0.5, 0.5}, {2, 2}).named("small"));
  ASSERT_EQ(ell.parts.size(), 6u);
  EXPECT_EQ(ell.parts[0].rule,
            "product of 5 factors, their boundaries do not meet, or at no more than 90 degrees");
  EXPECT_EQ(ell.parts[1].formula, "omega(big.left)");
  EXPECT_EQ(ell.parts[1].rule, "the shape alone");
  EXPECT_EQ(ell.parts[5].formula, "r0_or(-omega(small.left), -omega(small.bottom))");
  EXPECT_EQ(ell.parts[5].rule, "R0-functions, a union within the shape");
  const Weight hexagon = weight_of(polygon(6));
  ASSERT_EQ(hexagon.parts.size(), 1u);
  EXPECT_EQ(hexagon.parts[0].rule, "R0-functions, boundaries that meet at more than 90 degrees");
}

TEST(Weight, PlateausAreConstantBeyondTheirWidth) {
  const Region square = box({0, 0}, {1, 1}).named("s");
  const Field omega = weight_of(square, CombineRule(PlateauRule{0.2, 3})).function;
  for (const Point& at : {Point{0.5, 0.5}, Point{0.21, 0.4}, Point{0.7, 0.79}}) {
    const PointJet jet = evaluate(omega, at, 2, 2);
    EXPECT_EQ(jet.value(), 1);
    EXPECT_EQ(jet.derivative(1, 0), 0);
    EXPECT_EQ(jet.derivative(0, 2), 0);
  }
  EXPECT_NEAR(value_at(omega, {0.1, 0.5}), 1 - 0.125, 1e-15);
}

TEST(Weight, SaturationAndCapsBoundItAndKeepItsSlope) {
  const Region disk = circle({0, 0}, 2).named("disk");
  const auto slope = [](const Field& omega) {
    return evaluate(omega, {2, 0}, 1, 2).derivative(1, 0);
  };
  WeightOptions saturated;
  saturated.saturation = Saturation{1, 5};
  const Weight one = weight_of(disk, saturated);
  EXPECT_EQ(one.formula, "omega(disk)/(1 + abs(5*(omega(disk)))^1)");
  EXPECT_LT(value_at(one.function, {0, 0}), 0.2);  // 1/beta
  EXPECT_NEAR(slope(one.function), -1, 1e-15);
  WeightOptions capped;
  capped.cap = 0.1 + 0.01 * x_coordinate();
  const Weight two = weight_of(disk, capped);
  EXPECT_EQ(two.formula, "r0_and(omega(disk), 0.1 + 0.01*x)");
  EXPECT_LT(value_at(two.function, {0, 0}), 0.1);
  EXPECT_NEAR(slope(two.function), -1, 1e-15);
  capped.cap = x_coordinate();
  EXPECT_THROW(weight_of(disk, capped), InvalidArgument);
}

TEST(Weight, ScalesDivideTheSlopeOfPieces) {
  WeightOptions options(CombineRule(RAlpha{0}));
  options.piece_scales = {{"s.left", 4}};
  const Weight omega = weight_of(box({0, 0}, {1, 1}).named("s"), options);
  EXPECT_THAT(omega.formula, HasSubstr("omega(s.left)/4"));
  EXPECT_NEAR(evaluate(omega.function, {0, 0.4}, 1, 2).derivative(1, 0), 0.25, 1e-14);
  EXPECT_NEAR(evaluate(omega.function, {0.4, 0}, 1, 2).derivative(0, 1), 1, 1e-14);
  options.piece_scales = {{"missing", 4}};
  EXPECT_THROW(weight_of(box({0, 0}, {1, 1}).named("s"), options), InvalidArgument);
}

TEST(Weight, ShapingIsPartOfTheSmoothnessThatIsTold) {
  const Region plate = box({0, 0}, {2, 1}).named("plate") - circle({1, 0.5}, 0.2).named("hole");
  const RegionEvaluator evaluator(plate);
  const auto told = [&](const WeightOptions& options) {
    return weight(evaluator, bounding_box(evaluator), options).parts.back().smoothness;
  };
  WeightOptions saturated, capped;
  saturated.saturation = Saturation{1.5, 1};
  EXPECT_THAT(told(saturated), HasSubstr("zero 2 times differentiable"));  // w |w|^1.5
  saturated.saturation = Saturation{2, 1};
  EXPECT_EQ(told(saturated), told({}));
  capped.cap = 0.1 + abs(x_coordinate() - 0.7);
  EXPECT_THAT(told(capped), HasSubstr("no smoother than the cap"));
}

TEST(Weight, CornerScalesBoundItNearTheirCorner) {
  // At a reentrant corner of 270 degrees R0 grows as 2 + sqrt 2 times the distance along the
  // bisector; with a scale m no direction exceeds distance / m.
  const Region ell = box({-1, -1}, {1, 1}).named("big") - box({0, 0}, {2, 2}).named("small");
  WeightOptions options(CombineRule(RAlpha{0}));
  const Field plain = weight_of(ell, options).function;
  options.corner_scales = {{"small.left", "small.bottom", 2}};
  const Weight scaled = weight_of(ell, options);
  EXPECT_THAT(scaled.formula,
              testing::EndsWith("hypot(omega(small.left), omega(small.bottom))/2, 2)"));
  const double r = 1e-4, s = std::sqrt(0.5);
  EXPECT_NEAR(value_at(plain, {-r * s, -r * s}) / r, std::sqrt(2.0) + 1, 1e-3);
  const double near = std::sqrt(2.0) + 1;
  EXPECT_NEAR(value_at(scaled.function, {-r * s, -r * s}) / r, 0.5 * near / std::hypot(0.5, near),
              1e-3);
  EXPECT_NEAR(evaluate(scaled.function, {0, 0.4}, 1, 2).derivative(1, 0), -1, 1e-13);
  // Opposite sides have no corner.
  const Region square = box({0, 0}, {1, 1}).named("box");
  options.corner_scales = {{"box.left", "box.right", 0.2}};
  EXPECT_THROW(weight_of(square, options), InvalidArgument);
  options.corner_scales = {{"box.left", "box.top", 0.2}};
  EXPECT_NO_THROW(weight_of(square, options));
  // Two circles that cross inside their union have no corner there.
  const Region three = circle({0, 0}, 1).named("a") | circle({1, 0}, 1).named("b") |
                       circle({0.5, 0.8}, 1).named("c");
  options.corner_scales = {{"a", "b", 1}};
  EXPECT_THROW(weight_of(three, options), InvalidArgument);
}

TEST(Weight, WithAScaledCornerIsTheSameInAnyUnitOfLength) {
  const auto scaled = [](double unit, const CombineRule& rule) {
    const Region plate = box({-unit, -unit}, {unit, unit}).named("b") -
                         circle({0.3 * unit, 0.2 * unit}, 0.3 * unit).named("h");
    WeightOptions options(rule);
    options.corner_scales = {{"b.left", "b.top", 3}};
    return weight_of(plate, options).function;
  };
  const std::vector<Point> places = {{-0.5, -0.3}, {-0.9, 0.95}, {0.9, 0}, {0.2, 0.8}};
  for (const CombineRule& rule :
       {CombineRule(AutomaticRule{}), CombineRule(ProductRule{}), CombineRule(RAlpha{0})}) {
    const Field metres = scaled(1, rule), millimetres = scaled(1000, rule);
    const auto ratio = [&](const Point& p) {
      return value_at(millimetres, {1000 * p[0], 1000 * p[1]}) / value_at(metres, p);
    };
    for (const Point& place : places) EXPECT_NEAR(ratio(place) / ratio({0, -0.5}), 1, 1e-12);
  }
}

TEST(Weight, ConjunctsAreTheOperandsOfTheOutermostConjunction) {
  const auto a = BooleanExpression::variable(0), b = BooleanExpression::variable(1),
             c = BooleanExpression::variable(2);
  EXPECT_EQ(conjuncts((a & (b | c)) & !c).size(), 3u);
  EXPECT_EQ(conjuncts(a | b).size(), 1u);
  EXPECT_EQ(conjuncts(a).size(), 1u);
}

}  // namespace
}  // namespace rfm
