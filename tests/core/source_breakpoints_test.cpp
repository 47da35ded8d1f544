#include "core/source_breakpoints.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>

#include "core/composition.hpp"
#include "core/field_node.hpp"
#include "core/spline_field.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;

const Field x = x_coordinate(), y = y_coordinate();
/// Lines at x = 1, 2, 3 and y = 1.
const Grid grid({2, {0, 0}, {4, 2}}, {4, 2, 1});

/// A piecewise linear function of a grid, of which each cell has another slope.
Field tent() {
  std::vector<double> coefficients;
  for (int i = 0; i < 15; ++i) coefficients.push_back(i % 5 == 2 ? 1.0 : 0.1 * i);
  return field(std::make_shared<SplineField>(grid, 1, coefficients));
}

TEST(SourceBreakpoints, AreThoseOfEverySampledFieldInAnExpression) {
  const auto breakpoints = source_breakpoints(sin(tent()) * x + tent(), 2);
  EXPECT_THAT(breakpoints[0], ElementsAre(1, 2, 3));
  EXPECT_THAT(breakpoints[1], ElementsAre(1));
  EXPECT_THAT(breakpoints[2], IsEmpty());
}

TEST(SourceBreakpoints, FollowMapsAlongTheAxes) {
  // Lines where 2 − 4 y = 1, 2, 3 and 0.5 (x + 3) = 1.
  const auto breakpoints = source_breakpoints(compose(tent(), {2 - 4 * y, (x + 3) / 2}), 2);
  EXPECT_THAT(breakpoints[0], ElementsAre(DoubleEq(-1)));
  EXPECT_THAT(breakpoints[1], ElementsAre(DoubleEq(-0.25), DoubleEq(0), DoubleEq(0.25)));
}

TEST(SourceBreakpoints, BetweenThemAMappedSplineIsOnePolynomial) {
  const Field mapped = compose(tent(), {3 * x - 0.5, 0.2 + y / 3});
  const Tape tape({mapped}, {1}, 2);
  std::vector<double> lines = source_breakpoints(mapped, 2)[0];
  ASSERT_EQ(lines.size(), 3u);
  const double last = lines.back();
  for (const double line : lines) {
    const auto slope = [&](double at) { return tape.jet({at, 0.1})[1]; };
    EXPECT_NEAR(slope(line - 0.3), slope(line - 1e-9), 1e-12);
    EXPECT_GT(std::fabs(slope(line - 1e-9) - slope(line + 1e-9)), 0.1);
    if (line == last) {
      EXPECT_NEAR(slope(line + 0.3), slope(line + 1e-9), 1e-12);
    }
  }
}

TEST(SourceBreakpoints, OfMapsThatTurnOrBendAreNotKnown) {
  for (const Field& component : {x + y, x * x, sin(x), Field(0.5)}) {
    const auto breakpoints = source_breakpoints(compose(tent(), {component, y}), 2);
    EXPECT_THAT(breakpoints[0], IsEmpty());
    EXPECT_THAT(breakpoints[1], ElementsAre(1));
  }
}

}  // namespace
}  // namespace rfm
