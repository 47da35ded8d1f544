#include "tests/core/expression_cases.hpp"

namespace rfm {
namespace {

TEST(Expression, ADefinitionThatUsesItselfIsAMistakeThatNamesTheCycle) {
  ExpressionScope scope;
  scope.define("p", Expression("q + 1"));
  scope.define("q", Expression("p + 1"));
  scope.define_function("f", {"s"}, Expression("f(s)"));
  scope.define_function("g", {"s"}, Expression("s*r"));
  scope.define("r", Expression("g(2)"));
  EXPECT_EQ(mistake("2 + p", scope), "4+1: a definition that uses itself: p -> q -> p");
  EXPECT_EQ(mistake("f(1)", scope), "0+1: a definition that uses itself: f -> f");
  EXPECT_EQ(mistake("1 + g(1)", scope), "4+1: a definition that uses itself: g -> r -> g");
  // An argument hides the function that would be a cycle.
  scope.define("p", Expression("h(1)"));
  scope.define_function("h", {"p"}, Expression("p + 1"));
  EXPECT_EQ(to_number(Expression("p"), scope), 2);
}

TEST(Expression, ChainsOfDefinitionsMayBeLong) {
  constexpr int length = 100'000;
  ExpressionScope scope = coordinate_scope(1);
  scope.define("p0", Expression("x"));
  for (int i = 1; i <= length; ++i)
    scope.define("p" + std::to_string(i), Expression("p" + std::to_string(i - 1) + " + 1"));
  const Field sum = to_field(Expression("p" + std::to_string(length)), scope);
  EXPECT_EQ(value_at(sum, {0.5}), length + 0.5);
  scope.define("p0", Expression("x + missing"));
  EXPECT_EQ(mistake("1 + p" + std::to_string(length), scope),
            "4+7: in 'p0': unknown name 'missing'");
}

TEST(Expression, ADefinitionMayUseNamesThatAreDefinedLater) {
  ExpressionScope scope;
  scope.define("p", Expression("2*q"));
  scope.define("q", 3.0);
  EXPECT_EQ(to_number(Expression("p"), scope), 6);
  scope.define("q", 5.0);
  EXPECT_EQ(to_number(Expression("p"), scope), 10);
}

TEST(Expression, AMistakeInADefinitionIsReportedWhereItIsUsed) {
  ExpressionScope scope;
  scope.define("inner", Expression("1 + missing"));
  scope.define("outer", Expression("2 * inner"));
  try {
    to_field(Expression("3 + outer"), scope);
    FAIL() << "no mistake";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "in 'inner': unknown name 'missing'");
    EXPECT_EQ(error.offset, 4u);
    EXPECT_EQ(error.length, 5u);
  }
}

}  // namespace
}  // namespace rfm
