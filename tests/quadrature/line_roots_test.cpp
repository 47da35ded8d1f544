#include "quadrature/line_roots.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

// The parts inside and the crossings of the line y = 0, −1 ≤ x ≤ 1.
struct Walk {
  std::vector<std::array<double, 2>> parts;
  std::vector<std::pair<double, int>> crossings;
};

Walk walk(const BooleanExpression& expression, const std::vector<Field>& fields,
          const std::vector<Field>& interface_fields = {}) {
  std::vector<LevelFunction> levels;
  for (const Field& f : fields) levels.emplace_back(f, 2);
  for (const Field& f : interface_fields) levels.emplace_back(f, 2);
  std::vector<Surface> surfaces;
  for (const LevelFunction& level : levels) surfaces.emplace_back(level);
  std::vector<int> numbers(fields.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  ActiveSet active;
  active.table = TruthTable(expression, numbers, std::vector<Truth>(fields.size(), Truth::unknown));
  for (std::size_t i = 0; i < surfaces.size(); ++i) active.add(surfaces[i], static_cast<int>(i));
  const LineSegment line{{}, 0, -1, 1};
  Walk result;
  walk_line(
      active, find_line_roots(active, 0, line), line,
      [&](const LineEnd& from, const LineEnd& to) {
        result.parts.push_back({from.position, to.position});
      },
      [&](const LineCrossing& crossing) {
        result.crossings.emplace_back(crossing.position, crossing.surface);
      });
  return result;
}

BooleanExpression v(int number) { return BooleanExpression::variable(number); }

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(FindEndSigns, AreThoseOfTheCrossing) {
  const LineSegment line{{}, 0, -1, 1};
  for (const double place : {-2.0, -1.0, -1 - 1e-13, -0.3, 1 - 1e-13, 1.0, 4.0})
    for (const double sign : {1.0, -1.0}) {
      const LevelFunction level(sign * (exp(x()) - std::exp(place)), 2);
      const Surface surface(level);
      for (const Truth low : {Truth::unknown, Truth::yes, Truth::no}) {
        const Crossing crossing = find_crossing(surface, line, low);
        const Crossing ends = find_end_signs(surface, line, low, Truth::unknown);
        EXPECT_EQ(ends.exists, crossing.exists);
        EXPECT_EQ(ends.starts_positive, crossing.starts_positive);
        EXPECT_EQ(ends.at_end, crossing.at_end);
        EXPECT_EQ(ends.position, place > 0 ? 1 : -1);
      }
    }
}

TEST(LineRoots, PartsLieBetweenCrossings) {
  const Walk w = walk(v(0) & v(1), {x() + 0.5, 0.25 - x()});
  EXPECT_THAT(w.parts, ElementsAre(std::array{-0.5, 0.25}));
  EXPECT_THAT(w.crossings, ElementsAre(Pair(-0.5, 0), Pair(0.25, 1)));
}

TEST(LineRoots, SurfacesInsideAnotherPartDoNotBreakIt) {
  const Walk w = walk(v(0) | v(1), {x() + 0.5, x() - 0.25});
  EXPECT_THAT(w.parts, ElementsAre(std::array{-0.5, 1.0}));
  EXPECT_THAT(w.crossings, ElementsAre(Pair(-0.5, 0)));
}

TEST(LineRoots, AFunctionAndItsNegativeLeaveNoCrack) {
  const Walk w = walk(v(0) | v(1), {x() - 0.1, 3 * (0.1 - x())});
  EXPECT_THAT(w.parts, ElementsAre(std::array{-1.0, 1.0}));
  EXPECT_THAT(w.crossings, IsEmpty());
}

TEST(LineRoots, CoincidentSurfacesAreOneCrossing) {
  const Walk w = walk(v(0) & v(1) & v(2), {0.3 - x(), 2 * (0.3 - x()), (0.3 - x()) / 7});
  EXPECT_THAT(w.parts.size(), 1u);
  EXPECT_THAT(w.crossings.size(), 1u);
}

TEST(LineRoots, AFaceAtAnEndBelongsToTheSideWhereItIsZero) {
  // sign(0) = +. Inside is x ≤ −1: the line meets the region in its low end alone.
  const Walk low = walk(v(0), {-1 - x()});
  EXPECT_THAT(low.parts, IsEmpty());
  EXPECT_THAT(low.crossings, ElementsAre(Pair(-1.0, 0)));
  // Inside is x ≤ 1: the whole line is inside, its high end is no crossing.
  const Walk high = walk(v(0), {1 - x()});
  EXPECT_THAT(high.parts, ElementsAre(std::array{-1.0, 1.0}));
  EXPECT_THAT(high.crossings, IsEmpty());
}

TEST(LineRoots, ACrossingThatValuesAtAnEndHideIsAtThatEnd) {
  // 1 − x touches zero at the end: by its value it is positive there, by what is known it is not.
  const LevelFunction level(1 - x(), 2);
  const Surface surface(level);
  const LineSegment line{{}, 0, -1, 1};
  EXPECT_FALSE(find_crossing(surface, line).exists);
  const Crossing known = find_crossing(surface, line, Truth::unknown, Truth::no);
  EXPECT_TRUE(known.exists);
  EXPECT_TRUE(known.starts_positive);
  EXPECT_EQ(known.position, 1);
  // And a crossing that is known not to be one is none.
  const Surface other(level);
  EXPECT_FALSE(find_crossing(other, {{}, 0, -1, 3}, Truth::unknown, Truth::yes).exists);
  EXPECT_EQ(find_crossing(other, {{}, 0, -1, 3}).position, 1);
}

TEST(LineRoots, SignsKnownAtEndsReachTheRootsOfALine) {
  const LevelFunction level(1 - x(), 2);
  const Surface surface(level);
  ActiveSet active;
  active.table = TruthTable(v(0), std::array{0}, std::array{Truth::unknown});
  active.add(surface, 0);
  LineSegment line{{}, 0, -1, 1};
  EXPECT_EQ(find_line_roots(active, 0, line).count, 0);
  line.ends[1].known = 1;
  EXPECT_EQ(find_line_roots(active, 0, line).count, 1);
  line.ends[1].positive = 1;
  EXPECT_EQ(find_line_roots(active, 0, line).count, 0);
}

TEST(LineRoots, WhereAPieceTouchesTheSideOfATurnedBoxThePieceIsTheBoundary) {
  // Surface 0 is the side of a box and no piece, 1 a piece of the boundary, with the same root: the
  // side would come first.
  const LevelFunction side_level(0.3 - x(), 2), piece_level(2 * (0.3 - x()), 2);
  const Surface side(side_level), piece(piece_level);
  ActiveSet active;
  active.table =
      TruthTable(v(0) & v(1), std::array{0, 1}, std::array{Truth::unknown, Truth::unknown});
  active.add(side, ActiveSet::no_piece);
  active.add(piece, 7);
  const LineSegment line{{}, 0, -1, 1};
  const LineRoots roots = find_line_roots(active, 0, line);
  ASSERT_EQ(roots.count, 2);
  EXPECT_EQ(bounding_piece(active, roots, 0, 2, 3, 0), 1);
  // A piece that does not bound the region there does not take the place of the side: inside is
  // where the side is positive, whatever the piece is.
  ActiveSet indifferent = active;
  indifferent.table = TruthTable(v(0) & (v(1) | !v(1)), std::array{0, 1},
                                 std::array{Truth::unknown, Truth::unknown});
  EXPECT_EQ(bounding_piece(indifferent, roots, 0, 2, 3, 0), 0);
  std::vector<int> crossed;
  walk_line(
      active, roots, line, [](const LineEnd&, const LineEnd&) {},
      [&](const LineCrossing& crossing) { crossed.push_back(crossing.surface); });
  EXPECT_THAT(crossed, ElementsAre(1));
}

// Answers that the surfaces of all pairs are apart by `height` times the difference of their
// numbers.
struct AtHeights : LineNeighbours {
  double height = 0;
  mutable bool lost = false;
  double height_over(int first, int second, const LineSegment&) const override {
    return height * (first - second);
  }
  void note_loss() const override { lost = true; }
};

// What lies between x = 0.25 and the same place, moved by `shift`, on the line y = 0.
std::vector<int> crossed(AtHeights& neighbours, double shift = 0) {
  const LevelFunction low(x() - 0.25, 2), high(0.25 + shift - x(), 2);
  const Surface first(low), second(high);
  ActiveSet active;
  active.table =
      TruthTable(v(0) & v(1), std::array{0, 1}, std::array{Truth::unknown, Truth::unknown});
  active.add(first, 0);
  active.add(second, 1);
  LineSegment line{{}, 0, -1, 1};
  line.neighbours = &neighbours;
  std::vector<int> surfaces;
  walk_line(
      active, find_line_roots(active, 0, line), line, [](const LineEnd&, const LineEnd&) {},
      [&](const LineCrossing& crossing) { surfaces.push_back(crossing.surface); });
  return surfaces;
}

TEST(LineRoots, SurfacesThatTouchComeInTheOrderOfNeighbouringLines) {
  AtHeights neighbours;
  neighbours.height = 1;  // the second is higher: something lies between
  EXPECT_THAT(crossed(neighbours), ElementsAre(0, 1));
  neighbours.height = -1;
  EXPECT_THAT(crossed(neighbours), IsEmpty());
  neighbours.height = 0;  // one surface
  EXPECT_THAT(crossed(neighbours), IsEmpty());
  EXPECT_FALSE(neighbours.lost);
}

TEST(LineRoots, ALengthThatRoundingDoesNotExplainIsNotLeftOutSilently) {
  AtHeights neighbours;
  EXPECT_THAT(crossed(neighbours, 1e-15), IsEmpty());
  EXPECT_FALSE(neighbours.lost);
  EXPECT_THAT(crossed(neighbours, 1e-14), IsEmpty());
  EXPECT_TRUE(neighbours.lost);
  EXPECT_THAT(crossed(neighbours, 1e-12), ElementsAre(0, 1));
}

TEST(LineRoots, InterfacesBreakPartsInsideOnly) {
  const Walk w = walk(v(0), {x()}, {x() - 0.5, x() + 0.5});
  EXPECT_THAT(w.parts, ElementsAre(std::array{0.0, 0.5}, std::array{0.5, 1.0}));
  EXPECT_THAT(w.crossings, ElementsAre(Pair(0.0, 0), Pair(0.5, 1)));
}

}  // namespace
