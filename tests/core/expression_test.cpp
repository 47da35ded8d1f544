#include "core/expression.hpp"

#include "tests/core/expression_cases.hpp"

namespace rfm {
namespace {

class Syntax : public WrongFormula {};
TEST_P(Syntax, IsReportedWithItsPlace) { expect_mistake(); }

INSTANTIATE_TEST_SUITE_P(
    Expression, Syntax,
    testing::Values(
        std::pair{"", "0+1: expected an expression but the text is empty"},
        std::pair{"   ", "0+1: expected an expression but the text is empty"},
        std::pair{"1 + )", "4+1: expected a number, a name or '(' but found ')'"},
        std::pair{"1 +", "3+1: expected a number, a name or '(' but found the end"},
        std::pair{"(1 + 2", "6+1: expected ')' but found the end"},
        std::pair{"sin(x", "5+1: expected ',' or ')' but found the end"},
        std::pair{"sin(x y)", "6+1: expected an operator, ',' or ')' but found 'y'"},
        std::pair{"(x y)", "3+1: expected an operator or ')' but found 'y'"},
        std::pair{"v[1", "3+1: expected ']' but found the end"},
        std::pair{"2x", "1+1: expected an operator or the end but found 'x'"},
        std::pair{"x y", "2+1: expected an operator or the end but found 'y'"},
        std::pair{"1 2", "2+1: expected an operator or the end but found '2'"},
        std::pair{"x ** 2",
                  "2+2: expected an operator or the end but found '**' (powers are "
                  "written with '^')"},
        std::pair{"x = 2", "2+1: unexpected character '=' (write '==' to compare)"},
        std::pair{"x && y",
                  "2+2: expected an operator or the end but found '&&' (multiply "
                  "conditions: (a < b) * (b < c))"},
        std::pair{"0 < x < 1",
                  "6+1: comparisons cannot be chained; multiply them: (a < b) * "
                  "(b < c)"},
        std::pair{"x # 1", "2+1: unexpected character '#'"},
        std::pair{"x \u2212 1",
                  "2+3: unexpected character '\u2212' (a minus sign that is not '-')"},
        std::pair{"x\u00B2", "1+2: unexpected character '\u00B2' (a superscript: write '^2')"},
        std::pair{"1e400", "0+5: the number 1e400 is too large: numbers go up to 1.797e308"},
        std::pair{"'abc", "0+1: the quotation that begins here does not end"},
        std::pair{"* 2", "0+1: expected a number, a name or '(' but found '*'"}));

TEST(Expression, HostileNestingIsAMistakeAndNotACrash) {
  const std::string deep(100'000, '(');
  EXPECT_THAT(mistake(deep), testing::HasSubstr("nested more than 250 levels"));
  EXPECT_THAT(mistake(std::string(100'000, '-') + "1"), testing::HasSubstr("nested more than"));
  std::string powers = "2", calls = "x";
  for (int i = 0; i < 300; ++i) {
    powers += "^2";
    calls = "sin(" + calls + ")";
  }
  EXPECT_THAT(mistake(powers), testing::HasSubstr("nested more than"));
  EXPECT_THAT(mistake(calls), testing::HasSubstr("nested more than"));
  const std::string allowed = std::string(200, '(') + "x" + std::string(200, ')');
  EXPECT_DOUBLE_EQ(value_of(allowed), at_x);
}

TEST(Expression, LongSumsCostNoStack) {
  std::string sum = "0";
  for (int i = 0; i < 100'000; ++i) sum += "+1";
  EXPECT_DOUBLE_EQ(to_number(Expression(sum), ExpressionScope()), 100'000);
}

TEST(Expression, ListsTheNamesItUses) {
  const Expression expression("a*sin(b) + omega(hole) + table(\"t.csv\", x + 1)");
  EXPECT_TRUE(expression.uses("a"));
  EXPECT_TRUE(expression.uses("sin"));
  EXPECT_TRUE(expression.uses("hole"));
  EXPECT_FALSE(expression.uses("t"));
  const std::vector<Expression::Use> uses = expression.uses();
  ASSERT_EQ(uses.back().name, "table");
  EXPECT_THAT(uses.back().arguments, testing::ElementsAre("\"t.csv\"", "x + 1"));
}

}  // namespace
}  // namespace rfm
