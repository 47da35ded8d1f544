#include "core/tape.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <random>
#include <thread>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/multi_index.hpp"
#include "core/table.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
using testing::Throws;
using testing::ThrowsMessage;

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

// Points of one block, as a tape wants them.
struct Points {
  std::array<std::vector<double>, 3> coordinates;
  PointBlock block(double time = 0) const {
    return {.coordinates = {coordinates[0].data(), coordinates[1].data(), coordinates[2].data()},
            .count = static_cast<int>(coordinates[0].size()),
            .time = time};
  }
  Point operator[](int i) const {
    return {coordinates[0][i], coordinates[1][i], coordinates[2][i]};
  }
};

Points random_points(int count, unsigned seed = 1) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-2, 2);
  Points points;
  for (auto& axis : points.coordinates)
    for (int i = 0; i < count; ++i) axis.push_back(uniform(generator));
  return points;
}

TEST(Tape, SharesEqualSubexpressions) {
  // Twice √(x² + y²), built separately: x, y, x², y², their sum, the root, and the product.
  const auto distance = [] { return sqrt(x_coordinate() * x_coordinate() + y * y); };
  EXPECT_EQ(Tape({distance()}, {0}, 2).instruction_count(), 6);
  EXPECT_EQ(Tape({distance(), distance()}, {0}, 2).instruction_count(), 6);
  EXPECT_EQ(Tape({distance() * sin(distance())}, {0}, 2).instruction_count(), 8);
  // Commuted arguments are the same, and so are a product with itself and a square.
  EXPECT_EQ(Tape({x * y + y * x}, {0}, 2).instruction_count(),
            Tape({x * y + x * y}, {0}, 2).instruction_count());
  EXPECT_EQ(Tape({x * x, pow(x, 2)}, {0}, 2).instruction_count(), 2);
}

TEST(Tape, KeepsNoInstructionThatNoRootNeeds) {
  EXPECT_EQ(Tape({2 * x + 1}, {0}, 2).instruction_count(), 3);               // x, 2·x, + 1
  EXPECT_EQ(Tape({partial(exp(z), 2) + x}, {0}, 2).instruction_count(), 1);  // x + 0
}

TEST(Tape, FoldsConstantsAndAppliesIdentitiesThatDoNotRound) {
  const auto same = [](const Field& a, const Field& b) { return same_expression(a, b); };
  EXPECT_TRUE(same(x + -y, x - y));
  EXPECT_TRUE(same(x - -y, y + x));
  EXPECT_TRUE(same(-(x - y), y - x));
  EXPECT_TRUE(same(-x * -y, x * y));
  EXPECT_TRUE(same(abs(-x), abs(abs(x))));
  EXPECT_TRUE(same(cos(-x), cos(x)));
  EXPECT_TRUE(same(pow(-x, 4), pow(x, 4)));
  EXPECT_TRUE(same(min(x, x), max(x, x)));
  EXPECT_TRUE(same(select(y, x, x), x));
  EXPECT_TRUE(same(x / 4, 0.25 * x));
  EXPECT_FALSE(same(x / 3, (1 / 3.0) * x));
  EXPECT_FALSE(same(pow(-x, 3), pow(x, 3)));
  EXPECT_FALSE(same(sin(-x), sin(x)));
  EXPECT_EQ(Tape({sin(z) + exp(z)}, {0}, 2).instruction_count(), 1);  // z = 0
  // What is not finite is left for the diagnosis.
  EXPECT_GT(Tape({1 / z}, {0}, 2).instruction_count(), 1);
}

TEST(Tape, SameExpressionMeansSameStructure) {
  EXPECT_TRUE(same_expression(sin(x) * y, y * sin(x)));
  EXPECT_FALSE(same_expression(x + x, 2 * x));
  EXPECT_FALSE(same_expression(sin(x), cos(x)));
}

class EveryDimension : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Tape, EveryDimension, testing::Values(1, 2, 3));

TEST_P(EveryDimension, PartialDerivativesAreCoefficientsOfHigherJets) {
  const int dimension = GetParam();
  const Field f = exp(sin(x * y) + 0.3 * z * x) / (2 + cos(x + y - z));
  const int highest = dimension == 2 ? 4 : 3;
  const Tape jets({f}, {highest}, dimension);
  Tape::Workspace jet_workspace(jets);
  const Points points = random_points(50);
  jets.evaluate(points.block(), jet_workspace);
  std::vector<Field> roots;
  std::vector<MultiIndex> derivatives;
  for (int i = 0; i <= highest; ++i)
    for (int j = 0; i + j <= (dimension > 1 ? highest : i); ++j)
      for (int k = 0; i + j + k <= (dimension > 2 ? highest : i + j); ++k) {
        derivatives.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
                               static_cast<std::uint8_t>(k), 0});
        roots.push_back(partial(f, derivatives.back()));
      }
  const Tape tape(roots, {0}, dimension);
  Tape::Workspace workspace(tape);
  tape.evaluate(points.block(), workspace);
  ASSERT_EQ(static_cast<int>(roots.size()), jet_size(dimension, highest));
  for (std::size_t r = 0; r < roots.size(); ++r)
    for (int i = 0; i < 50; ++i) {
      const double expected = factorial(derivatives[r]) *
                              jet_workspace.coefficient(0, jet_index(dimension, derivatives[r]))[i];
      EXPECT_NEAR(workspace.coefficient(static_cast<int>(r))[i], expected,
                  1e-12 * (1 + std::fabs(expected)));
    }
}

TEST_P(EveryDimension, OrdersBeyondTheHighestAreRefused) {
  const int dimension = GetParam();
  EXPECT_NO_THROW(Tape({x}, {maximum_order}, dimension));
  EXPECT_THAT([&] { Tape({x}, {maximum_order + 1}, dimension); },
              ThrowsMessage<InvalidArgument>(HasSubstr("derivatives of order 17")));
  Field derivative = sin(x);
  for (int k = 0; k < maximum_order; ++k) derivative = partial(derivative, 0);
  EXPECT_NO_THROW(Tape({derivative}, {0}, dimension));
  EXPECT_THROW(Tape({derivative}, {1}, dimension), InvalidArgument);
}

TEST_P(EveryDimension, TablesAtRunTimeContinueTheCompiledOrders) {
  // One root of high order makes every node use tables; the other tape does not.
  const int dimension = GetParam(), compiled = dimension == 2 ? 4 : 3;
  const Field f = exp(sin(x * y) + 0.3 * z * x) / (2 + cos(x + y - z));
  const Tape low({f}, {compiled}, dimension), high({f}, {compiled + 2}, dimension);
  Tape::Workspace low_workspace(low), high_workspace(high);
  const Points points = random_points(30);
  low.evaluate(points.block(), low_workspace);
  high.evaluate(points.block(), high_workspace);
  for (int k = 0; k < jet_size(dimension, compiled); ++k)
    for (int i = 0; i < 30; ++i) {
      const double expected = low_workspace.coefficient(0, k)[i];
      EXPECT_NEAR(high_workspace.coefficient(0, k)[i], expected, 1e-12 * (1 + std::fabs(expected)));
      EXPECT_NEAR(high.jet(points[i])[k], expected, 1e-12 * (1 + std::fabs(expected)));
    }
}

TEST(Tape, NodesHaveTheOrderThatTheirUsersNeed) {
  // The same u twice: for its value alone, and below two derivatives.
  const Field u = sin(x) * cos(y);
  const Tape tape({u, laplacian(u, 2), partial(u, 0)}, {0, 0, 1}, 2);
  Tape::Workspace workspace(tape);
  const Points points = random_points(10);
  tape.evaluate(points.block(), workspace);
  for (int i = 0; i < 10; ++i) {
    const auto [a, b, c] = points[i];
    EXPECT_NEAR(workspace.coefficient(0)[i], std::sin(a) * std::cos(b), 1e-15);
    EXPECT_NEAR(workspace.coefficient(1)[i], -2 * std::sin(a) * std::cos(b), 4e-15);
    EXPECT_NEAR(workspace.coefficient(2)[i], std::cos(a) * std::cos(b), 1e-15);
    EXPECT_NEAR(workspace.coefficient(2, 1)[i], -std::sin(a) * std::cos(b), 2e-15);
    EXPECT_NEAR(workspace.coefficient(2, 2)[i], -std::cos(a) * std::sin(b), 2e-15);
  }
}

TEST(Tape, WrongArgumentsAreRefused) {
  EXPECT_THROW(Tape({x}, {0}, 0), InvalidArgument);
  EXPECT_THROW(Tape({x}, {0}, 4), InvalidArgument);
  EXPECT_THROW(Tape({x, y}, {0, 0, 0}, 2), InvalidArgument);
  EXPECT_THROW(Tape({x}, {-1}, 2), InvalidArgument);
  const Tape tape({x}, {0}, 2);
  Tape::Workspace workspace(tape);
  const Points too_many = random_points(Tape::block_size + 1);
  EXPECT_THROW(tape.evaluate(too_many.block(), workspace), InvalidArgument);
  EXPECT_NO_THROW(tape.evaluate(Points().block(), workspace));
}

TEST(Tape, BoxesThatEndBeforeTheyBeginHaveNoBounds) {
  const Tape tape({x * x}, {1}, 1);
  for (const Box& box : {Box{1, {1, 0, 0}, {-1, 0, 0}}, Box{1, {NAN, 0, 0}, {1, 0, 0}}}) {
    EXPECT_THROW(tape.bounds(box), InvalidArgument);
    EXPECT_THROW(tape.value_bounds(box), InvalidArgument);
  }
  EXPECT_NO_THROW(tape.bounds({1, {1, 0, 0}, {1, 0, 0}}));
}

// Also where it is undefined whatever the point is: by a parameter or a number.
TEST(Tape, WhatIsUndefinedHasNoDerivativesAtAnyOrder) {
  const double below_zero[] = {-1};
  const Point at{0.5, 0.25};
  PointBlock block{{&at[0], &at[1], &at[2]}, 1};
  block.parameters = below_zero;
  for (const Field& f : {pow(x, 6.0) + log(parameter(0)), x * y + acos(Field(2)) * parameter(0),
                         select(apply(Operation::less, {x, 1.0}), NAN, x)})
    for (int variables = 1; variables <= 4; ++variables)
      for (int order = 1; order <= 6; ++order) {
        std::vector<int> coordinates(variables);
        std::iota(coordinates.begin(), coordinates.end(), 0);
        const Tape tape({f}, {order}, Variables(coordinates));
        Tape::Workspace workspace(tape);
        tape.evaluate(block, workspace);
        const auto jet = tape.jet(at, 0, {0, below_zero});
        for (int k = 0; k <= variables; ++k) {
          EXPECT_TRUE(std::isnan(jet[k])) << k << " of order " << order << " in " << variables;
          EXPECT_TRUE(std::isnan(workspace.coefficient(0, k)[0])) << k << " of order " << order;
        }
      }
  EXPECT_TRUE(std::isnan(partial(Field(NAN), 0).constant()));
}

TEST(Tape, BlocksWithoutTheRowThatASourceNeedsAreRefused) {
  const std::vector<double> ascending{0, 1, 2};
  const Tape tape({field(std::make_shared<Table>(ascending, ascending, 1))}, {0}, 1);
  Tape::Workspace workspace(tape);
  const double at = 0.5;
  EXPECT_THROW(tape.evaluate({{&at}, 1}, workspace), InvalidArgument);
}

TEST(Tape, AbsoluteValuesAreNeverNegativeZeros) {
  const Tape tape({abs(x)}, {1}, 1);
  EXPECT_FALSE(std::signbit(tape.value({-0.0})));
  EXPECT_FALSE(std::signbit(evaluate(abs(x), {-0.0}, 1, 1).value()));
}

TEST(Tape, EveryNumberOfPointsOfABlockIsEvaluated) {
  const Field f = exp(x) * y - z / (2 + x * x);
  const Tape tape({f, partial(f, 0)}, {1, 0}, 3);
  for (int count = 1; count <= Tape::block_size; ++count) {
    Tape::Workspace workspace(tape);
    const Points points = random_points(count, count);
    tape.evaluate(points.block(), workspace);
    for (int i = 0; i < count; ++i) {
      const auto [a, b, c] = points[i];
      const double slope = std::exp(a) * b + 2 * a * c / ((2 + a * a) * (2 + a * a));
      EXPECT_NEAR(workspace.coefficient(0)[i], std::exp(a) * b - c / (2 + a * a), 1e-14);
      EXPECT_NEAR(workspace.coefficient(0, 1)[i], slope, 1e-14);
      EXPECT_NEAR(workspace.coefficient(1)[i], slope, 1e-14);
    }
  }
}

TEST(Tape, TimeIsAParameterOfAllPoints) {
  const Field t = time_coordinate();
  const Tape tape({x * t * t}, {1}, 2);
  Tape::Workspace workspace(tape);
  const Points points = random_points(3);
  tape.evaluate(points.block(1.5), workspace);
  EXPECT_EQ(workspace.coefficient(0)[2], points[2][0] * 2.25);
  EXPECT_EQ(workspace.coefficient(0, 1)[2], 2.25);
  EXPECT_EQ(tape.value(points[1], 0, 1.5), points[1][0] * 2.25);
  const Interval bounds = tape.value_bounds({2, {1, 0}, {2, 1}}, 0, 1.5);
  EXPECT_NEAR(bounds.low, 2.25, 1e-14);
  EXPECT_NEAR(bounds.high, 4.5, 1e-14);
}

TEST(Tape, ParametersAreReadFromTheBlock) {
  const Tape tape({parameter(1) * x + parameter(0)}, {1}, 1);
  Tape::Workspace workspace(tape);
  const Points points = random_points(2);
  PointBlock block = points.block();
  const double both[] = {3.0, 0.5}, one[] = {3.0};
  block.parameters = both;
  tape.evaluate(block, workspace);
  EXPECT_DOUBLE_EQ(workspace.coefficient(0)[1], 0.5 * points[1][0] + 3);
  EXPECT_EQ(workspace.coefficient(0, 1)[1], 0.5);
  block.parameters = one;
  EXPECT_THAT([&] { tape.evaluate(block, workspace); },
              ThrowsMessage<InvalidArgument>(HasSubstr("parameter number 1")));
}

TEST(Tape, DerivativesAlongTheTimeAreThoseOfTheExpression) {
  const Field t = time_coordinate(), f = sin(x * t) * exp(-t);
  const Tape tape({partial(f, 3), partial(partial(f, 0), 3)}, {1, 0}, 2);
  const double at = 0.7, time = 1.3, u = at * time, decay = std::exp(-time);
  const double rate = (at * std::cos(u) - std::sin(u)) * decay;
  const double mixed = (std::cos(u) - u * std::sin(u) - time * std::cos(u)) * decay;
  EXPECT_NEAR(tape.value({at, 0}, 0, time), rate, 1e-15);
  EXPECT_NEAR(tape.value({at, 0}, 1, time), mixed, 1e-15);
  EXPECT_NEAR(tape.jet({at, 0}, 0, time)[1], mixed, 1e-15);
  // The same where the time is a variable of the jets.
  const Tape moving({partial(f, 3)}, {0}, {0, 3});
  EXPECT_NEAR(moving.value({at, 0}, 0, time), rate, 1e-15);
}

TEST(Tape, ForeignWorkspacesAndRootsThatDoNotExistAreRefused) {
  Tape tape({x, x * y}, {0, 1}, 2);
  const Tape other({x + y}, {0}, 2);
  Tape::Workspace workspace(tape);
  const Points points = random_points(3);
  EXPECT_THAT([&] { other.evaluate(points.block(), workspace); },
              ThrowsMessage<InvalidArgument>("the workspace was made for another tape"));
  const Tape moved = std::move(tape);  // still the same tape
  moved.evaluate(points.block(), workspace);
  EXPECT_EQ(workspace.coefficient(1)[2], points[2][0] * points[2][1]);
  for (const int root : {-1, 2}) {
    const auto refused = ThrowsMessage<InvalidArgument>(
        HasSubstr("has 2 roots, numbered from 0; there is no root " + std::to_string(root)));
    const Box box{2, {0, 0}, {1, 1}};
    EXPECT_THAT([&] { moved.value({0, 0}, root); }, refused);
    EXPECT_THAT([&] { moved.jet({0, 0}, root); }, refused);
    EXPECT_THAT([&] { moved.bounds(box, root); }, refused);
    EXPECT_THAT([&] { moved.value_bounds(box, root); }, refused);
    EXPECT_THAT([&] { moved.bounds(Line{{0, 0}, {1, 0}}, {0, 1}, root); }, refused);
    EXPECT_THAT([&] { workspace.coefficient(root); }, refused);
    Point gradient;
    EXPECT_THAT([&] { moved.value_and_gradient({0, 0}, gradient, root); }, refused);
  }
  EXPECT_THAT([&] { workspace.coefficient(0, 1); },
              ThrowsMessage<InvalidArgument>(HasSubstr("there is no coefficient 1")));
  EXPECT_NO_THROW(workspace.coefficient(1, 2));
  PointBlock block = points.block();
  block.count = -1;
  EXPECT_THAT([&] { moved.evaluate(block, workspace); },
              ThrowsMessage<InvalidArgument>(HasSubstr("got -1")));
}

TEST(Tape, CoordinatesBeyondTheDimensionAreZero) {
  EXPECT_EQ(Tape({x + 3 * y + z}, {0}, 1).value({2, 5, 7}), 2);
  EXPECT_EQ(Tape({partial(x * z, 2)}, {0}, 2).value({2, 5, 7}), 0);
}

TEST(Tape, ChainsOf100000NodesAreBuiltEvaluatedAndDestroyed) {
  constexpr int length = 100000;
  Field sum = x, nested = x;
  for (int i = 0; i < length; ++i) {
    sum = sum + y * (1.0 / length);
    nested = sin(nested);
  }
  const Tape tape({sum, nested}, {1, 0}, 2);
  EXPECT_NEAR(tape.value({0.5, 2}), 2.5, 1e-9);
  // xₙ₊₁ = sin xₙ decays like √(3/n).
  EXPECT_NEAR(tape.value({0.5, 2}, 1), std::sqrt(3.0 / length), 1e-5);
  Tape::Workspace workspace(tape);
  const Points points = random_points(5);
  tape.evaluate(points.block(), workspace);
  EXPECT_NEAR(workspace.coefficient(0)[3], points[3][0] + points[3][1], 1e-9);
  EXPECT_NEAR(workspace.coefficient(0, 2)[3], 1, 1e-9);
}

TEST(Tape, DeepGraphsHaveBoundsCopiesAndSpecialTapes) {
  constexpr int length = 100000;
  Field deep = x;
  for (int i = 0; i < length; ++i) deep = i % 2 == 0 ? max(deep, y - (i + 1)) : sqrt(1 + deep) - 1;
  const Field copy = deep;
  deep = Field();
  const Tape tape({copy}, {1}, 2);
  const Box box{2, {0.25, 0}, {0.5, 1}};
  const Interval range = tape.value_bounds(box);
  EXPECT_TRUE(range.contains(tape.value({0.3, 0.5})));
  EXPECT_TRUE(tape.bounds(box).value.contains(tape.value({0.4, 0.1})));
  const Tape special = tape.specialised(box);
  EXPECT_LT(special.instruction_count(), tape.instruction_count());
  EXPECT_EQ(special.value({0.3, 0.5}), tape.value({0.3, 0.5}));
}

// Random graphs. Values stay moderate: every step is bounded.
std::vector<Field> random_graph(std::mt19937& generator, int size) {
  std::vector<Field> nodes{x, y, z, 0.7};
  std::uniform_int_distribution<int> kind(0, 7);
  for (int i = 0; i < size; ++i) {
    std::uniform_int_distribution<std::size_t> any(0, nodes.size() - 1);
    const Field a = nodes[any(generator)], b = nodes[any(generator)], c = nodes[any(generator)];
    switch (kind(generator)) {
      case 0:
        nodes.push_back(0.5 * a + b);
        break;
      case 1:
        nodes.push_back(sin(a) * b);
        break;
      case 2:
        nodes.push_back(a / (2 + b * b));
        break;
      case 3:
        nodes.push_back(tanh(a - b));
        break;
      case 4:
        nodes.push_back(sqrt(1 + a * a));
        break;
      case 5:
        nodes.push_back(select(tanh(a), sin(b), cos(c)));
        break;
      case 6:
        nodes.push_back(partial(sin(a), 1) + cos(b));
        break;
      default:
        nodes.push_back(apply(Operation::r0_conjunction, {tanh(a), cos(b)}));
    }
  }
  return nodes;
}

TEST(Tape, RegistersAreReusedWithoutOverwritingWhatIsStillNeeded) {
  // Each root evaluated alone at single points keeps all its registers.
  std::mt19937 generator(2);
  for (int graph = 0; graph < 60; ++graph) {
    std::vector<Field> nodes = random_graph(generator, 5 + graph);
    std::vector<Field> roots;
    for (const Field& node : nodes)
      if (generator() % 3 == 0) roots.push_back(node);
    roots.push_back(nodes.back());
    std::optional<Tape> tape;
    try {
      tape.emplace(roots, std::vector{1}, 3);
    } catch (const InvalidArgument&) {
      continue;  // nested derivatives beyond the third
    }
    Tape::Workspace workspace(*tape);
    const Points points = random_points(7, graph);
    tape->evaluate(points.block(), workspace);
    for (std::size_t r = 0; r < roots.size(); ++r) {
      const Tape alone({roots[r]}, {1}, 3);
      for (int i = 0; i < 7; ++i) {
        Point gradient;
        const double value = alone.value_and_gradient(points[i], gradient);
        const double tolerance = 1e-11 * (1 + std::fabs(value));
        EXPECT_NEAR(workspace.coefficient(static_cast<int>(r))[i], value, tolerance);
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_NEAR(workspace.coefficient(static_cast<int>(r), 1 + axis)[i], gradient[axis],
                      1e-10 * (1 + std::fabs(gradient[axis])))
              << "graph " << graph << " root " << r;
      }
    }
  }
}

TEST(Tape, ThreadsShareIt) {
  std::mt19937 generator(8);
  const Tape tape(random_graph(generator, 6), {1}, 3);
  const auto checksum = [&](unsigned seed) {
    Tape::Workspace workspace(tape);
    double sum = 0;
    for (unsigned repeat = 0; repeat < 300; ++repeat) {
      const Points points = random_points(33, seed + repeat);
      tape.evaluate(points.block(), workspace);
      for (int root = 0; root < tape.root_count(); ++root)
        for (int i = 0; i < 33; ++i) sum += workspace.coefficient(root)[i];
      sum += tape.value(points[0]) + tape.bounds({3, {0, 0, 0}, {1, 1, 1}}).value.high;
    }
    return sum;
  };
  const double expected[] = {checksum(1), checksum(1000)};
  double found[2];
  {
    std::jthread first([&] { found[0] = checksum(1); });
    std::jthread second([&] { found[1] = checksum(1000); });
  }
  EXPECT_EQ(found[0], expected[0]);
  EXPECT_EQ(found[1], expected[1]);
}

TEST(Tape, GradientsNeedATapeOfFirstOrder) {
  // The register of ∂f/∂x has one order less than f: its own slope is not computed.
  const Tape tape({partial(sin(x), 0), sin(x)}, {0, 1}, 1);
  const Box box{1, {0.1}, {0.2}};
  EXPECT_TRUE(tape.bounds(box, 0).value.contains(std::cos(0.15)));
  EXPECT_TRUE(tape.bounds(box, 0).gradient[0].contains(-std::sin(0.15)));
  EXPECT_TRUE(tape.bounds(box, 1).gradient[0].contains(std::cos(0.15)));
  Point gradient;
  EXPECT_THROW(tape.value_and_gradient({0.1}, gradient, 0), InvalidArgument);
  EXPECT_NEAR(tape.value_and_gradient({0.1}, gradient, 1), std::sin(0.1), 1e-16);
  EXPECT_NEAR(gradient[0], std::cos(0.1), 1e-15);
}

TEST(Tape, BoundsEncloseRootsThatAreDerivatives) {
  const Field f = normalize(x * x / 4 + y * y - 1, 2);
  const Tape tape({f}, {1}, 2);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-2, 2), unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    Box box;
    for (int axis = 0; axis < 2; ++axis) {
      box.low[axis] = uniform(generator);
      box.high[axis] = box.low[axis] + 0.3 * unit(generator);
    }
    const FunctionBounds bounds = tape.bounds(box);
    const Interval plain = tape.value_bounds(box);
    for (int sample = 0; sample < 10; ++sample) {
      Point point{}, gradient;
      for (int axis = 0; axis < 2; ++axis)
        point[axis] = std::lerp(box.low[axis], box.high[axis], unit(generator));
      const double value = tape.value_and_gradient(point, gradient);
      EXPECT_TRUE(bounds.value.contains(value));
      EXPECT_TRUE(plain.contains(value));
      for (int axis = 0; axis < 2; ++axis)
        EXPECT_TRUE(bounds.gradient[axis].contains(gradient[axis]));
    }
  }
}

// A source that is a known function: f = x² y, valid in the unit square.
class Cubic : public FieldSource {
 public:
  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override {
    for (int i = 0; i < count; ++i) {
      const double a = coordinates[0][i], b = variables > 1 ? coordinates[1][i] : 0;
      const auto set = [&](MultiIndex index, double coefficient) {
        if (degree(index) <= order) jets[jet_index(variables, index) * stride + i] = coefficient;
      };
      for (int k = 0; k < jet_size(variables, order); ++k) jets[k * stride + i] = 0;
      set({}, a * a * b);
      set({1}, 2 * a * b);
      set({2}, b);
      if (variables < 2) continue;
      set({0, 1}, a * a);
      set({1, 1}, 2 * a);
      set({2, 1}, 1);
    }
  }
  FunctionBounds bounds(const Box& box) const override {
    const Interval a = box.interval(0), b = box.interval(1);
    return {square(a) * b, {Interval(2) * a * b, square(a), 0.0}, true};
  }
  std::vector<double> breakpoints(int axis) const override {
    return axis == 0 ? std::vector{0.5, 0.25} : std::vector<double>{};
  }
  Box valid() const override { return {2, {0, 0}, {1, 1}}; }
};

TEST(Tape, SourcesTakePartLikeAnyFunction) {
  const Field source = field(std::make_shared<Cubic>()), formula = x * x * y;
  const auto expression = [](const Field& f) { return sin(partial(f, 0)) + f * f; };
  const Tape tape({expression(source), expression(formula)}, {2}, 2);
  Tape::Workspace workspace(tape);
  const Points points = random_points(13);
  tape.evaluate(points.block(), workspace);
  for (int k = 0; k < jet_size(2, 2); ++k)
    for (int i = 0; i < 13; ++i)
      EXPECT_NEAR(workspace.coefficient(0, k)[i], workspace.coefficient(1, k)[i], 1e-12);
  EXPECT_NEAR(tape.value(points[3], 0), tape.value(points[3], 1), 1e-13);
  const Box box{2, {0.2, 0.1}, {0.4, 0.5}};
  const Interval bounds = Tape({source + x}, {1}, 2).bounds(box).value;
  EXPECT_TRUE(bounds.contains(0.2 * 0.2 * 0.1 + 0.2) && bounds.contains(0.4 * 0.4 * 0.5 + 0.4));
  EXPECT_LT(bounds.width(), 0.29);
}

}  // namespace
}  // namespace rfm
