#include "core/parameters.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/expression_text.hpp"
#include "core/graph_derivative.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const Field x = x_coordinate(), y = y_coordinate();

TEST(Parameters, ChangeWhatOneTapeGivesAtPointsInBlocksAndAsBounds) {
  Parameters parameters{{"r", 0.25}, {"k", 3}};
  const Field r = parameters["r"], k = parameters["k"];
  const Tape tape({k * (r * r - x * x - y * y)}, {1}, 2);
  EXPECT_THAT(tape.parameter_names(), ElementsAre("r", "k"));
  Tape::Workspace workspace(tape);
  for (const double radius : {0.25, 0.5, 2.0}) {
    parameters.set("r", radius);
    const double expected = 3 * (radius * radius - 0.25);
    EXPECT_DOUBLE_EQ(tape.value({0.5, 0}, 0, {0, parameters}), expected);
    const double coordinates[] = {0.5, 0.0};
    PointBlock block;
    block.coordinates = {&coordinates[0], &coordinates[1], nullptr};
    block.count = 1;
    block.parameters = parameters;
    tape.evaluate(block, workspace);
    EXPECT_DOUBLE_EQ(workspace.coefficient(0)[0], expected);
    EXPECT_DOUBLE_EQ(workspace.coefficient(0, 1)[0], -3);
    const Interval ranges[] = {radius, 3.0};
    EXPECT_TRUE(
        tape.value_bounds({2, {0.4, -0.1}, {0.6, 0.1}}, 0, {0.0, ranges}).contains(expected));
  }
}

TEST(Parameters, HaveDerivativesLikeCoordinates) {
  Parameters parameters{{"r", 0.75}};
  const Field r = parameters["r"];
  const Field slope = derivative_with_respect_to(sin(r * x) / r, r);
  const double u = 0.75 * 0.4;
  EXPECT_NEAR(Tape({slope}, {0}, 1).value({0.4}, 0, {0, parameters}),
              0.4 * std::cos(u) / 0.75 - std::sin(u) / (0.75 * 0.75), 1e-15);
}

TEST(Parameters, AreWrittenByNameAndReadBackAsTheSameExpression) {
  Parameters parameters{{"r", 0.25}, {"k", 45}};
  const Field f = parameters["k"] * (parameters["r"] - hypot(x, y));
  EXPECT_EQ(to_text(f), "k*(r - hypot(x, y))");
  ExpressionScope scope = coordinate_scope(2);
  for (const std::string& name : parameters.names()) scope.define(name, parameters[name]);
  EXPECT_TRUE(same_expression(to_field(Expression(to_text(f)), scope), f));
}

TEST(Parameters, ValuesPutInAreConstantsThatFold) {
  Parameters parameters{{"r", 3}, {"k", 2}};
  const Field r = parameters["r"], beyond = parameter(2, "s");
  const Field f = partial(pow(x, parameters["k"]), 0) + (r * r - 9) * y + beyond;
  EXPECT_EQ(to_text(with_values(f, parameters)), "dx(x^2) + s");
  parameters.set("k", 1);
  EXPECT_EQ(to_text(with_values(f, parameters)), "1 + s");
}

TEST(Parameters, WrongNamesAreRefusedWithTheNearest) {
  Parameters parameters{{"radius", 1}};
  EXPECT_THAT(
      [&] { parameters.set("raduis", 2); },
      ThrowsMessage<InvalidArgument>("there is no parameter 'raduis' (did you mean 'radius'?)"));
  EXPECT_THAT([&] { parameters.add("radius", 2); },
              ThrowsMessage<InvalidArgument>("there is a parameter 'radius' already"));
  EXPECT_THAT([&] { parameters.add("2r", 2); },
              ThrowsMessage<InvalidArgument>(HasSubstr("'2r' cannot name a parameter")));
}

TEST(Parameters, NamesWithAMeaningInFormulasAreRefused) {
  for (const char* name : {"x", "y", "z", "t", "pi", "sin", "dx"})
    EXPECT_THAT([&] { Parameters().add(name, 1); },
                ThrowsMessage<InvalidArgument>("'" + std::string(name) +
                                               "' cannot name a parameter: it has a meaning in "
                                               "formulas"));
  EXPECT_NO_THROW(Parameters().add("x1", 1));
}

TEST(Parameters, ThatAreMissingAreNamed) {
  const Tape tape({x * parameter(1, "k")}, {0}, 1);
  const double one[] = {1.0};
  EXPECT_THAT(
      [&] {
        tape.value({1}, 0, {0, one});
      },
      ThrowsMessage<InvalidArgument>(
          "the field needs parameter number 1 ('k'), but only 1 are given"));
}

TEST(Parameters, OfTwoSetsDoNotMeetInOneTape) {
  const Parameters first{{"r", 1}}, second{{"s", 2}};
  EXPECT_THAT([&] { Tape({first["r"] + second["s"]}, {0}, 1); },
              ThrowsMessage<InvalidArgument>(HasSubstr("is called 's' and 'r'")));
}

}  // namespace
}  // namespace rfm
