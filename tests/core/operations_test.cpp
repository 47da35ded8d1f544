#include "core/operations.hpp"

#include <gmock/gmock.h>

#include <random>
#include <set>

#include "core/box.hpp"
#include "tests/core/operation_rows.hpp"

// Bounds of every row of the table: what they enclose and how tight they are. Values and
// derivatives are the matter of conformance_test.cpp.
namespace rfm {
namespace {

class EveryOperation : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(OperationTable, EveryOperation, testing::ValuesIn(all_rows()),
                         [](const auto& info) { return info.param.identifier; });

TEST(OperationTable, NamesAreUniqueAndFindTheirRows) {
  std::set<std::string_view> names;
  for (const OperationRow& row : operation_table) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(find_operation(row.name), &row);
    EXPECT_EQ(find_operation(row.operation), &row);
    EXPECT_THAT(row.arity, testing::AllOf(testing::Ge(1), testing::Le(3)));
    EXPECT_FALSE(row.formula.empty());
  }
  EXPECT_EQ(find_operation("sine"), nullptr);
  EXPECT_EQ(find_operation(Operation::coordinate), nullptr);
}

// Bounds. A place is a box with two functions of its coordinates that become the arguments.

Interval range_of(const Interval& a) { return a; }
Interval range_of(const TaylorBound& a) { return a.range; }

template <class T>
Jet<T, 2, 1> coordinate_over(const Box& box, int axis) {
  if constexpr (std::is_same_v<T, TaylorBound>)
    return Jet<T, 2, 1>::variable(axis, TaylorBound::coordinate(box.interval(axis), axis));
  else
    return Jet<T, 2, 1>::variable(axis, box.interval(axis));
}

std::array<double, maximum_variables> half_sides(const Box& box) {
  return {0.5 * box.length(0) * (1 + 1e-15), 0.5 * box.length(1) * (1 + 1e-15), 0};
}

Box random_box(std::mt19937& generator) {
  const double special[] = {0, 1, -1, std::numbers::pi / 2, -std::numbers::pi, 2};
  std::uniform_real_distribution<double> uniform(-3, 3), exponent(-9, 0.5);
  std::uniform_int_distribution<int> choice(0, 11);
  Box box;
  for (int axis = 0; axis < 2; ++axis) {
    const int chosen = choice(generator);
    const double center = chosen < 6 ? special[chosen] : uniform(generator);
    const double radius = std::pow(10, exponent(generator));
    box.low[axis] = center - radius * (chosen % 3 == 0 ? 0 : 1);  // the special point on the side
    box.high[axis] = center + radius;
  }
  return box;
}

std::vector<Point> samples_of(const Box& box, std::mt19937& generator) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Point> samples{box.center()};
  for (int i = 0; i < 16; ++i) {
    Point point{};
    for (int axis = 0; axis < 2; ++axis) {
      const double t = i < 4 ? (i >> axis & 1) : unit(generator);
      point[axis] =
          std::clamp((1 - t) * box.low[axis] + t * box.high[axis], box.low[axis], box.high[axis]);
    }
    samples.push_back(point);
  }
  return samples;
}

bool encloses(const Interval& bounds, long double value) {
  return std::isnan(value) || (bounds.low <= value && value <= bounds.high);
}

// Whether bounds of value and gradient hold at samples of the box, for a function written once for
// all kinds of numbers.
template <class T, class Function>
void expect_enclosure(const Function& function, const Box& box, std::mt19937& generator) {
  using Reference = Jet<long double, 2, 1>;
  const TaylorBound::Frame frame(half_sides(box));
  const auto bounds = function(coordinate_over<T>(box, 0), coordinate_over<T>(box, 1));
  for (const Point& point : samples_of(box, generator)) {
    if (testing::Test::HasFailure()) return;  // one miss is enough to look at
    const Reference exact =
        function(Reference::variable(0, point[0]), Reference::variable(1, point[1]));
    if (std::isnan(exact.value())) continue;
    for (int k = 0; k < 3; ++k) {
      const Interval range = range_of(bounds.c[k]);
      EXPECT_TRUE(encloses(range, exact.c[k]))
          << testing::PrintToString(double(exact.c[k])) << " is not in [" << range.low << ", "
          << range.high << "], coefficient " << k << " at " << point[0] << ", " << point[1]
          << " of the box [" << box.low[0] << ", " << box.high[0] << "] x [" << box.low[1] << ", "
          << box.high[1] << "]";
      if constexpr (std::is_same_v<T, TaylorBound>) {
        const TaylorBound& model = bounds.c[k];
        const Point center = box.center();
        long double linear = model.value;
        for (int axis = 0; axis < 2; ++axis)
          linear += static_cast<long double>(model.slope[axis]) * (point[axis] - center[axis]);
        EXPECT_TRUE(std::isnan(exact.c[k]) || std::fabs(exact.c[k] - linear) <= model.error)
            << "the model misses coefficient " << k << " by "
            << double(std::fabs(exact.c[k] - linear)) << " > " << model.error << " at " << point[0]
            << ", " << point[1] << " of the box [" << box.low[0] << ", " << box.high[0] << "] x ["
            << box.low[1] << ", " << box.high[1] << "]";
      }
    }
  }
}

template <class T>
void expect_enclosures(const Row& row, int boxes) {
  std::mt19937 generator(5);
  for (int i = 0; i < boxes && !testing::Test::HasFailure(); ++i) {
    const Box box = random_box(generator);
    expect_enclosure<T>([&](const auto& x, const auto& y) { return row(x, y, x * y); }, box,
                        generator);
    // Arguments that are themselves curved.
    expect_enclosure<T>(
        [&](const auto& x, const auto& y) { return row(x * y + x, y * y - x, x - y); }, box,
        generator);
  }
}

TEST_P(EveryOperation, IntervalsEncloseValuesAndGradients) {
  expect_enclosures<Interval>(GetParam(), 300);
}
TEST_P(EveryOperation, TaylorBoundsEncloseValuesAndGradients) {
  expect_enclosures<TaylorBound>(GetParam(), 300);
}
TEST_P(EveryOperation, TaylorBoundsAreOfSecondOrder) {
  // At a place where every operation is defined and smooth.
  const auto error_over = [&](double h) {
    Box box;
    box.low = {0.61 - h, 0.38 - h, 0};
    box.high = {0.61 + h, 0.38 + h, 0};
    const TaylorBound::Frame frame(half_sides(box));
    const auto x = coordinate_over<TaylorBound>(box, 0), y = coordinate_over<TaylorBound>(box, 1);
    const auto model = GetParam()(x, y, x * y).value();
    EXPECT_TRUE(model.smooth);
    return model.error;
  };
  const double coarse = error_over(0x1p-8), fine = error_over(0x1p-9);
  if (coarse < 1e-14) return;  // linear, up to rounding
  EXPECT_LT(coarse, 20 * 0x1p-16);
  EXPECT_GT(coarse / fine, 3.5);
  EXPECT_LT(coarse / fine, 4.5);
}

TEST_P(EveryOperation, BoundsOverAPointAreAsNarrowAsRounding) {
  Box box;
  box.low = box.high = {0.61, 0.38, 0};
  const TaylorBound::Frame frame(half_sides(box));
  const auto narrow = [&]<class T>(T) {
    const auto x = coordinate_over<T>(box, 0), y = coordinate_over<T>(box, 1);
    for (const T& coefficient : GetParam()(x, y, x * y).c) {
      const Interval range = range_of(coefficient);
      EXPECT_LE(range.width(), 1e-13) << range.low << ", " << range.high;
    }
  };
  narrow(Interval());
  narrow(TaylorBound());
}

TEST_P(EveryOperation, DerivativesAlongOtherAxesAreExactlyZero) {
  Box box;
  box.low = {-0.2, 0.3, 0};
  box.high = {1.5, 0.4, 0};
  const TaylorBound::Frame frame(half_sides(box));
  const auto independent = [&]<class T>(T) {
    const auto x = coordinate_over<T>(box, 0);
    const auto f = GetParam()(x, x + Jet<T, 2, 1>(0.25), x);
    EXPECT_TRUE(range_of(f.c[2]).is_zero());
  };
  independent(Interval());
  independent(TaylorBound());
}

// Random programs of many operations: arguments of every shape reach every rule.
struct RandomProgram {
  struct Step {
    Row row;
    std::array<int, 3> operands;
  };
  std::vector<Step> steps;

  RandomProgram(std::mt19937& generator, int length) {
    static const std::vector<Row> rows = all_rows();
    std::uniform_int_distribution<std::size_t> row(0, rows.size() - 1);
    for (int i = 0; i < length; ++i) {
      std::uniform_int_distribution<int> operand(0, i + 1);
      steps.push_back(
          {rows[row(generator)], {operand(generator), operand(generator), operand(generator)}});
    }
  }

  template <class Number>
  Number operator()(const Number& x, const Number& y) const {
    std::vector<Number> results{x, y};
    for (const Step& step : steps) {
      results.push_back(step.row(results[step.operands[0]], results[step.operands[1]],
                                 results[step.operands[2]]));
      // Bounds speak of points where all is defined; comparisons would hide that it is not.
      if constexpr (std::is_same_v<Number, Jet<long double, 2, 1>>)
        if (!std::isfinite(results.back().value())) return Number(std::nan(""));
    }
    return results.back();
  }
};

void expect_enclosed_programs(int count) {
  std::mt19937 generator(11);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const RandomProgram program(generator, 1 + i % 7);
    const Box box = random_box(generator);
    expect_enclosure<Interval>(program, box, generator);
    expect_enclosure<TaylorBound>(program, box, generator);
    if (!testing::Test::HasFailure()) continue;
    for (const auto& step : program.steps)
      ADD_FAILURE() << step.row.identifier << " of " << testing::PrintToString(step.operands);
  }
}

TEST(RandomPrograms, AreEnclosedByIntervalsAndTaylorBounds) { expect_enclosed_programs(3000); }

TEST(LongOperations, RandomProgramsAreEnclosed) { expect_enclosed_programs(1000000); }
TEST(LongOperations, EveryOperationIsEnclosed) {
  for (const Row& row : all_rows()) {
    expect_enclosures<Interval>(row, 30000);
    expect_enclosures<TaylorBound>(row, 30000);
  }
}

}  // namespace
}  // namespace rfm
