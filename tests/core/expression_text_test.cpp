#include "core/expression_text.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/expression.hpp"
#include "core/expression_evaluator.hpp"
#include "core/field_node.hpp"
#include "core/further_coordinate.hpp"
#include "core/spline_field.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), t = time_coordinate();

ExpressionScope scope() {
  ExpressionScope scope = coordinate_scope(3);
  define_derivatives(scope, 3);
  return scope;
}

Field read(const std::string& text) { return to_field(Expression(text), scope()); }

Field read(const DefinitionsText& text, ExpressionScope names = scope()) {
  for (const auto& [name, formula] : text.definitions)
    names.define(name, to_field(Expression(formula), names));
  return to_field(Expression(text.formula), names);
}

/// The same where the definitions stay formulas until they are used.
Field read_later(const DefinitionsText& text, ExpressionScope names = scope()) {
  for (const auto& [name, formula] : text.definitions) names.define(name, Expression(formula));
  return to_field(Expression(text.formula), names);
}

class EveryFormula : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(
    ToText, EveryFormula,
    testing::Values("x", "x + y*z", "(x + y)*z", "x - (y - z)", "x - y - z", "x/(y*z)", "x/y*z",
                    "x*(y/z)", "-x^2", "(-x)^2", "-(x + y)", "-(x*y)", "-x*y", "x - -2", "2^x^y",
                    "(2^x)^y", "x^-1", "x^0.5", "(x + 1)^-2.5", "x^-y", "sqrt(x + 1)",
                    "min(x, max(y, z))", "if(x < y, x, -y)", "(x < y)*(y <= z)", "1 - (x == y)",
                    "(x < y) < z", "rp_and(x, y, 4)", "ralpha_or(x, y, 0.5)", "dx(sin(x*y))",
                    "dxyz(x^2*y^3*z)", "1e-300*x + 1.7976931348623157e+308", "0.1*t", "x*-2",
                    "mod(x, 2*y)", "hypot(x, y)^3", "dzxxyy(exp(x*y*z))",
                    "dxxxxxxxx(dy(exp(x*y*z)))", "dxt(sin(x*t))"));

TEST_P(EveryFormula, IsWrittenAsItWasRead) { EXPECT_EQ(to_text(read(GetParam())), GetParam()); }

TEST(ToText, NumbersAreTheShortestThatAreReadBackAsTheSame) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(number_text(1e23), "1e+23");
  for (const double value :
       {M_PI, 5e-324, 2.2250738585072014e-308, 1e22, 0.1 + 0.2, -0.0, 123456789.0})
    for (const double number : {value, -value}) {
      const Field back = read(to_text(Field(number)));
      ASSERT_TRUE(back.is_constant());
      EXPECT_EQ(back.constant(), number);
      EXPECT_EQ(std::signbit(back.constant()), std::signbit(number));
    }
  EXPECT_EQ(value_at(read(to_text(Field(INFINITY))), {}), INFINITY);
  EXPECT_EQ(value_at(read(to_text(x + Field(-INFINITY))), {}), -INFINITY);
  EXPECT_TRUE(std::isnan(value_at(read(to_text(2 * Field(NAN))), {})));
}

const Grid plane({2, {-5, -5}, {5, 5}}, {4, 4, 1});
const Field sampled = field(std::make_shared<SplineField>(plane, 3, std::vector<double>(49, 0.5)));
const Field radius = parameter(0, "radius"), extra = further_coordinate(4);

/// Names of what has none of its own; each use of a further coordinate is a node of its own.
ExpressionTextOptions names() {
  ExpressionTextOptions options;
  options.names = {{"wall", sampled}, {"w", extra}};
  return options;
}

ExpressionScope named_scope() {
  ExpressionScope named = scope();
  named.define("wall", sampled);
  named.define("w", extra);
  named.define("radius", radius);
  return named;
}

// A random field of every operation of the table, derivatives along every coordinate, sampled
// fields and derivatives of them at mapped points, and constants.
Field random_field(std::mt19937& generator, int steps) {
  std::vector<Field> made = {x, y, z_coordinate(), t, sampled, radius, further_coordinate(4)};
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int i = 0; i < steps; ++i) {
    const auto any = [&]() -> const Field& { return made[generator() % made.size()]; };
    const auto kind = generator() % (operation_table.size() + 3);
    if (kind == operation_table.size()) {
      made.emplace_back(uniform(generator));
    } else if (kind == operation_table.size() + 1) {
      made.push_back(partial(any(), static_cast<int>(generator() % 5)));
    } else if (kind == operation_table.size() + 2) {
      const auto order = static_cast<std::uint8_t>(generator() % 3);
      made.push_back(field_at(sampled.node().source, {any(), any()}, {order, 1, 0, 0}));
    } else {
      const OperationRow& row = operation_table[kind];
      std::vector<Field> arguments;
      for (int k = 0; k < row.arity; ++k) arguments.push_back(any());
      std::optional<double> number;
      if (row.numbers > 0) number = row.operation == Operation::real_power ? 2.5 : 2;
      if (row.name.starts_with("ralpha")) number = 0.3;
      made.push_back(number ? apply(row.operation, arguments, number)
                            : apply_simplified(row.operation, arguments));
    }
  }
  return made.back();
}

// The highest order of derivatives on the way to the root.
int derivative_order(const Field& field) {
  std::map<const Field::Node*, int> needed{{&field.node(), 0}};
  int highest = 0;
  std::vector<const Field::Node*> pending{&field.node()};
  while (!pending.empty()) {
    const Field::Node* node = pending.back();
    pending.pop_back();
    const int order = needed[node] + (node->operation == Operation::partial);
    highest = std::max(highest, order);
    for (const Field& argument : node->arguments) {
      needed[&argument.node()] = std::max(needed[&argument.node()], order);
      pending.push_back(&argument.node());
    }
  }
  return highest;
}

TEST(ToText, RandomFieldsAreReadBackAsTheSameExpression) {
  std::mt19937 generator(17);
  int compared = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Field field = random_field(generator, 1 + trial % 12);
    if (derivative_order(field) > 3) continue;
    ++compared;
    const std::string text = to_text(field, names());
    EXPECT_TRUE(same_expression(to_field(Expression(text), named_scope()), field)) << text;
    const DefinitionsText definitions = to_definitions(field, "part", names());
    EXPECT_TRUE(same_expression(read(definitions, named_scope()), field)) << text;
    EXPECT_TRUE(same_expression(read_later(definitions, named_scope()), field)) << text;
  }
  EXPECT_GT(compared, 1000);
}

TEST(ToText, SharedNodesDoNotExplode) {
  // A graph of 10,000 nodes whose tree has 2^10000 leaves.
  Field field = x;
  for (int i = 0; i < 10'000; ++i) field = sin(field) * field + 1;
  EXPECT_THROW(to_text(field), InvalidArgument);
  const DefinitionsText text = to_definitions(field);
  EXPECT_GE(text.definitions.size(), 9'999u);
  std::size_t length = text.formula.size();
  for (const auto& [name, formula] : text.definitions) length += name.size() + formula.size();
  EXPECT_LT(length, 1'000'000u);
  EXPECT_TRUE(same_expression(read(text), field));
}

TEST(ToText, DeepGraphsCostNoStackAndAreCutIntoPieces) {
  Field nested = x, chain = x;
  for (int i = 0; i < 30'000; ++i) {
    nested = exp(-nested) / y;
    chain = chain + sin(Field(i) * y);
  }
  EXPECT_THROW(to_text(nested), InvalidArgument);
  EXPECT_TRUE(same_expression(read(to_definitions(nested)), nested));
  EXPECT_TRUE(same_expression(read(to_text(chain)), chain));
}

TEST(ToText, ChainsOf100000NodesAreReadBackFromDefinitionsThatAreFormulas) {
  Field nested = x;
  for (int i = 0; i < 100'000; ++i) nested = i % 2 == 0 ? sin(nested) : nested / (2 + y);
  const DefinitionsText text = to_definitions(nested);
  EXPECT_GT(text.definitions.size(), 900u);
  EXPECT_TRUE(same_expression(read_later(text), nested));
}

TEST(ToText, SampledFieldsAtMappedPointsAreWrittenAsCalls) {
  const auto source = sampled.node().source;
  const Field moved = field_at(source, {x + 1, 2 * y}), slope = field_at(source, {y, x}, {2, 1});
  EXPECT_EQ(to_text(moved - slope, names()), "wall(x + 1, 2*y) - wall.dxxy(y, x)");
  EXPECT_THAT([&] { to_text(moved); },
              testing::ThrowsMessage<InvalidArgument>("a sampled field has no name in the text"));
}

TEST(ToText, FurtherCoordinatesAreNamedByWhatTheyAre) {
  EXPECT_EQ(to_text(partial(x * further_coordinate(4), 4) + further_coordinate(4), names()),
            "d(x*w, w) + w");
  EXPECT_THAT([] { to_text(further_coordinate(6)); },
              testing::ThrowsMessage<InvalidArgument>("a coordinate 6 has no name in the text"));
}

TEST(ToText, SourcesAndParametersAppearByName) {
  const Grid grid({1, {0}, {1}}, {2, 1, 1});
  const Field wall =
      field(std::make_shared<SplineField>(grid, 1, std::vector<double>{0.0, 1.0, 4.0}));
  const Field whole = 2 * wall + parameter(1) * partial(wall, 0);
  EXPECT_THROW(to_text(whole), InvalidArgument);
  ExpressionTextOptions options;
  options.parameters = {"r", "k"};
  EXPECT_THROW(to_text(whole, options), InvalidArgument);
  options.names = {{"wall", wall}};
  EXPECT_EQ(to_text(whole, options), "2*wall + k*dx(wall)");
  ExpressionScope named = scope();
  named.define("wall", wall);
  named.define("k", parameter(1));
  EXPECT_TRUE(same_expression(to_field(Expression(to_text(whole, options)), named), whole));
}

TEST(ToText, NamedFieldsAppearByNameAndPartsAvoidNamesThatAreTaken) {
  const Field omega = x * x + y * y;
  ExpressionTextOptions options;
  options.names = {{"part1", omega}};
  EXPECT_EQ(to_text(1 - omega, options), "1 - part1");
  const Field twice = sin(x + y);
  const DefinitionsText text = to_definitions(twice * twice + omega, "part", options);
  ASSERT_EQ(text.definitions.size(), 1u);
  EXPECT_EQ(text.definitions[0], std::pair(std::string("part2"), std::string("sin(x + y)")));
  EXPECT_EQ(text.formula, "part2*part2 + part1");
}

TEST(ToText, PartsAvoidTheNamesOfParametersAndNeedAName) {
  const Field twice = sin(x + y), f = twice * twice + parameter(0, "part1");
  const DefinitionsText text = to_definitions(f);
  ASSERT_EQ(text.definitions.size(), 1u);
  EXPECT_EQ(text.definitions[0].first, "part2");
  EXPECT_EQ(text.formula, "part2*part2 + part1");
  EXPECT_THROW(to_definitions(f, "2part"), InvalidArgument);
}

TEST(ToText, MessagesAreCutOffAndDescribeWhatHasNoName) {
  ExpressionTextOptions options;
  options.abbreviated = true;
  options.longest = 12;
  EXPECT_EQ(to_text(parameter(3) + 1, options), "[parameter 3…");
  EXPECT_EQ(to_text(x + 1, options), "x + 1");
}

}  // namespace
}  // namespace rfm
