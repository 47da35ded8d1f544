#include "core/tape_specialization.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/expression_text.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

Box box_of(double x_low, double x_high, double y_low, double y_high) {
  return {2, {x_low, y_low}, {x_high, y_high}};
}

int length_over(const Field& field, const Box& box) {
  return Tape({field}, {1}, 2).specialised(box).instruction_count();
}

TEST(Specialization, LeavesOutBranchesThatAreNotTaken) {
  const Box right = box_of(0.5, 1, -1, 1), left = box_of(-1, -0.5, -1, 1);
  EXPECT_EQ(length_over(min(x, sin(y)), right), 4);
  EXPECT_EQ(length_over(min(x + 2, sin(y)), right), 2);  // sin y
  EXPECT_EQ(length_over(max(x + 2, sin(y)), right), 2);  // x + 2
  EXPECT_EQ(length_over(abs(x), right), 1);
  EXPECT_EQ(length_over(abs(x), left), 2);  // −x
  EXPECT_EQ(length_over(abs(y), right), 2);
  EXPECT_EQ(length_over(sign(x) * sin(y), right), 2);
  EXPECT_EQ(length_over(sign(x) * sin(y), left), 3);
  EXPECT_EQ(length_over(step(x) * sin(y), right), 2);
  EXPECT_EQ(length_over(step(x) * sin(y), left), 1);  // 0
  EXPECT_EQ(length_over(select(x, sin(y), cos(y)), right), 2);
  EXPECT_EQ(length_over(select(apply(Operation::less, {x, -2}), sin(y), y), right), 1);
  EXPECT_EQ(length_over(apply(Operation::less_equal, {x, 1.5}) + y, right), 2);
  EXPECT_EQ(length_over(floor(x / 2 + 0.2) + y, right), 1);
}

TEST(Specialization, DecidedNumbersAreAddedAndMultipliedLikeOthers) {
  const Box box = box_of(-2.5, -2.4, 2.2, 2.8);
  const auto specialised = [&](const Field& field) {
    return Tape({field}, {0}, 2).specialised(box).value({-2.45, 2.5});
  };
  EXPECT_EQ(specialised(floor(y) + 0.1), 2.1);
  EXPECT_EQ(specialised(2 * floor(y)), 4);
  EXPECT_EQ(specialised(apply(Operation::less, {x, 0}) + 1), 2);
  EXPECT_EQ(specialised(y * (apply(Operation::less, {x, 0}) + 1)), 5);
  EXPECT_EQ(specialised(3 - sign(x)), 4);
}

TEST(Specialization, DecidesNothingAboutTimeParametersDerivativesAndRFunctions) {
  const Box box = box_of(1, 2, 1, 2);
  const auto kept = [&](const Field& field) {
    EXPECT_EQ(length_over(field, box), Tape({field}, {1}, 2).instruction_count());
  };
  kept(abs(time_coordinate()) * x);
  kept(abs(parameter(0)) * x);
  kept(max(partial(sin(x * y), 0), y));
  kept(apply(Operation::r0_disjunction, {x, y - 100}));
}

TEST(Specialization, TellsTheSidesOfACutAtZerosOfBothSigns) {
  // A side of −0 is one of 0: what is decided there holds in the whole box.
  for (const double side : {0.0, -0.0}) {
    const Box box = box_of(side, 0.5, side, 0.5);
    for (const Field& f :
         {atan2(floor(y), -1), atan(1 / floor(y)), atan2(floor(y) * step(x), -2),
          atan2(mod(floor(y), 2), -1), atan2(sign(floor(y)), -1), atan2(min(floor(y), step(y)), -1),
          atan2(max(-floor(y), floor(y)), -1), atan2(abs(floor(y)), -1)}) {
      const Tape general({f}, {0}, 2), special = general.specialised(box);
      for (const double at : {0.0, -0.0, 0.25, 0.5})
        EXPECT_EQ(special.value({at, at}), general.value({at, at})) << to_text(f) << " at " << at;
    }
  }
}

TEST(Specialization, HidesNothingThatIsNotDefined) {
  // Over a box that reaches beyond the domain of a function nothing is decided by it.
  const Box box = box_of(-3, -0.5, 0.5, 2);
  const Field root = sqrt(x + 1), angle = asin(x);
  const Field here = apply(Operation::less, {angle, 5.0});
  for (const Field& f :
       {step(log(y / x)), step(root + 1), sign(angle + 3), floor(0.1 * angle + 0.5), min(root, -1),
        max(-1, root), select(here, y, x), apply(Operation::equal, {root, -1.0}), 0 * root,
        step(x - 10) * root, max(pow(x, -0.5), -5), step(1 + pow(root, 0.5)), min(mod(y, x + 1), 9),
        select(select(here, 1, 1), x, y), 0 / (x + 1)}) {
    const Tape general({f}, {1}, 2), special = general.specialised(box);
    for (const Point& point : {Point{-2, 1.5}, Point{-1, 1}, Point{-0.75, 0.6}})
      EXPECT_EQ(std::isfinite(special.value(point)), std::isfinite(general.value(point)));
  }
  // Inside of it all is decided.
  const Box inside = box_of(-0.9, -0.5, 0.5, 2);
  for (const Field& f : {step(root + 1), step(angle + 3), min(root, -1), step(x - 10) * root})
    EXPECT_EQ(length_over(f, inside), 1);
}

// A random tree of min, max, |·|, select and smooth functions.
Field random_field(std::mt19937& generator, int depth) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  if (depth == 0) return uniform(generator) * x + uniform(generator) * y + uniform(generator);
  const Field a = random_field(generator, depth - 1), b = random_field(generator, depth - 1);
  switch (generator() % 8) {
    case 0:
      return abs(a) - b;
    case 1:
      return select(apply(Operation::less, {a, 0.1}), a, b);
    case 2:
      return sin(a) + step(b - 0.3);
    case 3:
      return a * sign(b);
    case 4:
    case 5:
      return max(a, b);
    default:
      return min(a, b);
  }
}

TEST(Specialization, GivesTheSameJetsAndNoWiderBounds) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1), unit(0, 1);
  int shortened = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    const Tape general({random_field(generator, 5)}, {1}, 2);
    Box box = box_of(uniform(generator), 0, uniform(generator), 0);
    for (int axis = 0; axis < 2; ++axis) box.high[axis] = box.low[axis] + 0.5 * unit(generator);
    const Tape special = general.specialised(box);
    shortened += special.instruction_count() < general.instruction_count();
    const Interval range = general.value_bounds(box), better = special.value_bounds(box);
    EXPECT_LE(range.low, better.low);
    EXPECT_LE(better.high, range.high);
    std::array<std::array<double, 64>, 2> points;
    for (int i = 0; i < 64; ++i)
      for (int axis = 0; axis < 2; ++axis)
        points[axis][i] = std::lerp(box.low[axis], box.high[axis], unit(generator));
    Tape::Workspace of_general(general), of_special(special);
    const PointBlock block{{points[0].data(), points[1].data()}, 64};
    general.evaluate(block, of_general);
    special.evaluate(block, of_special);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 64; ++i)
        EXPECT_NEAR(of_special.coefficient(0, k)[i], of_general.coefficient(0, k)[i], 1e-14);
  }
  EXPECT_GT(shortened, 200);
}

Field circles(int count) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Field> level;
  for (int k = 0; k < count; ++k) {
    const Field u = x - unit(generator), v = y - unit(generator);
    level.push_back(1e-4 - u * u - v * v);
  }
  Field all = level[0];
  for (std::size_t k = 1; k < level.size(); ++k) all = max(all, level[k]);
  return all;
}

// The signs of all cells of a grid of 2ⁿ × 2ⁿ: general bounds, or tapes specialised on the way
// down.
std::vector<int> signs_of_cells(const Tape& tape, int levels, bool specialise) {
  const int n = 1 << levels;
  std::vector<int> signs(static_cast<std::size_t>(n) * n);
  const auto visit = [&](const auto& self, const Tape& here, int i, int j, int size) -> void {
    const double h = 1.0 / n;
    const Box box = box_of(i * h, (i + size) * h, j * h, (j + size) * h);
    if (size == 1) {
      const Interval range = here.value_bounds(box);
      signs[static_cast<std::size_t>(j) * n + i] = range.low > 0 ? 1 : range.high < 0 ? -1 : 0;
      return;
    }
    const int half = size / 2;
    const auto descend = [&](const Tape& below) {
      for (const int p : {i, i + half})
        for (const int q : {j, j + half}) self(self, below, p, q, half);
    };
    if (specialise)
      descend(here.specialised(box));
    else
      descend(here);
  };
  visit(visit, tape, 0, 0, n);
  return signs;
}

TEST(Specialization, OfAQuadtreeClassifiesCellsAsTheGeneralTapeDoes) {
  const Tape tape({circles(200)}, {0}, 2);
  EXPECT_EQ(signs_of_cells(tape, 5, true), signs_of_cells(tape, 5, false));
}

TEST(Specialization, OfACellKeepsAFewOfAThousandCircles) {
  const Tape tape({circles(1000)}, {0}, 2);
  const Tape cell = tape.specialised(box_of(0.5, 0.5 + 1.0 / 256, 0.5, 0.5 + 1.0 / 256));
  EXPECT_LT(cell.instruction_count(), tape.instruction_count() / 100);
}

}  // namespace
}  // namespace rfm
