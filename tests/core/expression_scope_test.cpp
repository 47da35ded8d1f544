#include "core/expression.hpp"

#include "core/tape.hpp"
#include "tests/core/expression_cases.hpp"

namespace rfm {
namespace {

TEST(ExpressionScope, ArgumentsOfAFunctionAreDifferentNames) {
  ExpressionScope scope;
  EXPECT_THROW(scope.define_function("h", {"a", "a"}, Expression("a")), InvalidArgument);
  EXPECT_THROW(scope.define_function("h", {"a", "2b"}, Expression("a")), InvalidArgument);
}

TEST(ExpressionScope, AScopeThatKeepsItsParametersGivesFieldsInWhichTheyMayChange) {
  ExpressionScope scope = coordinate_scope(1);
  scope.define_parameter("k", 4);
  const Expression formula("k*x");
  EXPECT_EQ(to_field(formula, scope).node().arguments[0].constant(), 4);
  scope.keep_parameters();
  const Tape tape({to_field(formula, scope)}, {0}, 1);
  Parameters parameters = scope.parameters();
  EXPECT_EQ(tape.value({3}, 0, {0, parameters}), 12);
  parameters.set("k", 5);
  EXPECT_EQ(tape.value({3}, 0, {0, parameters}), 15);
}

TEST(ExpressionScope, TheLatestMeaningOfANameCounts) {
  ExpressionScope scope = coordinate_scope(2);
  scope.define("a", 1.0);
  scope.refuse("a", "is not known yet");
  EXPECT_EQ(mistake("a", scope), "0+1: 'a' is not known yet");
  EXPECT_FALSE(scope.has_name("a"));
  scope.define("a", Expression("x + 1"));
  EXPECT_EQ(value_at(to_field(Expression("2*a"), scope), {3}), 8);
  scope.define_parameter("a", 5);
  scope.define_parameter("a", 6);
  EXPECT_EQ(to_number(Expression("a"), scope), 6);
  EXPECT_EQ(scope.parameters().size(), 1u);
}

TEST(ExpressionScope, CoordinatesBeyondTheDimensionAreRefusedByName) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    const ExpressionScope scope = coordinate_scope(dimension);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name(1, "xyz"[axis]);
      EXPECT_EQ(scope.has_name(name), axis < dimension);
      if (axis < dimension) continue;
      EXPECT_EQ(mistake(name, scope),
                "0+1: '" + name + "' does not exist in dimension " + std::to_string(dimension));
    }
    EXPECT_TRUE(scope.has_name("t"));
  }
  EXPECT_THROW(coordinate_scope(0), InvalidArgument);
  EXPECT_THROW(coordinate_scope(4), InvalidArgument);
}

TEST(ExpressionScope, KnowsTheFunctionsThatFormulasMayCall) {
  ExpressionScope scope = coordinate_scope(2);
  EXPECT_FALSE(scope.has_function("dx"));
  define_derivatives(scope, 2);
  for (const char* name : {"sin", "if", "grad", "d", "dx", "dxyxyxyxt"})
    EXPECT_TRUE(scope.has_function(name)) << name;
  for (const char* name : {"dz", "dxz", "dxyxyxyxyx", "dxu", "x", "+"})
    EXPECT_FALSE(scope.has_function(name)) << name;
  EXPECT_THAT(scope.functions(), testing::IsSupersetOf({"dx", "dyx", "laplacian", "hypot"}));
  EXPECT_THAT(scope.names(), testing::UnorderedElementsAre("pi", "x", "y", "t"));
}

}  // namespace
}  // namespace rfm
