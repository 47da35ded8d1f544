#include "core/expression.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/tape.hpp"

using namespace rfm;

namespace {

constexpr double at_x = 0.7, at_y = -1.3, value_a = 2.5;

ExpressionScope test_scope() {
  ExpressionScope scope = coordinate_scope(2);
  define_derivatives(scope, 2);
  scope.define("a", value_a);
  scope.define("radius", 0.25);
  scope.define("v", ExpressionValue(std::vector<Field>{3.0, x_coordinate()}));
  scope.define("plate.left", 7.0);
  scope.define("square", Expression("x^2 + y^2"));
  scope.define_function("f", {"p", "q"}, Expression("p - 2*q"));
  scope.define("wave", sin(x_coordinate() + y_coordinate()));
  scope.define_function("g", {"h"}, Expression("h(x + 1, y)"));
  scope.define_parameter("k", 4);
  scope.refuse("u", "is known after the solve only");
  return scope;
}

double value(const std::string& text) {
  return value_at(to_field(Expression(text), test_scope()), {at_x, at_y, 0}, 0.5);
}

/// Parses and evaluates a text that is wrong; the mistake as "offset+length: message".
std::string mistake(const std::string& text) {
  try {
    to_field(Expression(text), test_scope());
  } catch (const InputError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.what();
  }
  return "none";
}

struct Case {
  std::string text;
  double expected;
};
std::ostream& operator<<(std::ostream& stream, const Case& c) { return stream << c.text; }

}  // namespace

class ExpressionMeaning : public testing::TestWithParam<Case> {};

// The right column is the same formula in C++, with parentheses where the grammars differ.
INSTANTIATE_TEST_SUITE_P(
    Precedence, ExpressionMeaning,
    testing::Values(Case{"1 + 2*3", 7}, Case{"(1 + 2)*3", 9}, Case{"8/4/2", 1}, Case{"8/(4/2)", 4},
                    Case{"7 - 4 - 2", 1}, Case{"7 - (4 - 2)", 5}, Case{"2*3/4*2", 3},
                    Case{"-x^2", -(at_x* at_x)}, Case{"(-x)^2", at_x* at_x}, Case{"2^3^2", 512},
                    Case{"(2^3)^2", 64}, Case{"2^-1", 0.5}, Case{"2^-1*4", 2},
                    Case{"2^-x^2", std::pow(2, -(at_x* at_x))}, Case{"2*-x", -2 * at_x},
                    Case{"1 - -x", 1 + at_x}, Case{"--x", at_x}, Case{"-2^2", -4},
                    Case{"+x - +y", at_x - at_y}, Case{"-x*y", -at_x* at_y},
                    Case{"a*x^2/y", value_a* at_x* at_x / at_y}, Case{"x < y", 0}, Case{"x > y", 1},
                    Case{"x + 1 > y*2", 1}, Case{"1 <= 1", 1}, Case{"1 >= 1", 1}, Case{"1 < 1", 0},
                    Case{"2 == 2", 1}, Case{"2 != 2", 0}, Case{"2 != 3", 1},
                    Case{"(x > 0)*(y < 0)", 1}, Case{"1 + (2 < 3)", 2},
                    Case{"v[0] + v[1]", 3 + at_x}, Case{"v[1]^2", at_x* at_x}, Case{"-v[0]", -3},
                    Case{"v[3 - 2]", at_x}));
INSTANTIATE_TEST_SUITE_P(Numbers, ExpressionMeaning,
                         testing::Values(Case{"1e-3", 1e-3}, Case{".5", 0.5}, Case{"2.", 2},
                                         Case{"1.5E+2", 150}, Case{"08", 8}, Case{"1e-400", 0},
                                         Case{"pi", std::numbers::pi}, Case{"2.*x", 2 * at_x},
                                         Case{"\t 1\n+ 2 ", 3}));
INSTANTIATE_TEST_SUITE_P(
    Functions, ExpressionMeaning,
    testing::Values(Case{"sqrt(2)", std::sqrt(2.)}, Case{"cbrt(y)", std::cbrt(at_y)},
                    Case{"exp(x)", std::exp(at_x)}, Case{"log(x)", std::log(at_x)},
                    Case{"sin(x)", std::sin(at_x)}, Case{"cos(x)", std::cos(at_x)},
                    Case{"tan(x)", std::tan(at_x)}, Case{"asin(x)", std::asin(at_x)},
                    Case{"acos(x)", std::acos(at_x)}, Case{"atan(y)", std::atan(at_y)},
                    Case{"atan2(y, x)", std::atan2(at_y, at_x)}, Case{"sinh(x)", std::sinh(at_x)},
                    Case{"cosh(x)", std::cosh(at_x)}, Case{"tanh(x)", std::tanh(at_x)},
                    Case{"abs(y)", -at_y}, Case{"sign(y)", -1}, Case{"min(x, y)", at_y},
                    Case{"max(x, y)", at_x}, Case{"min(3, x, y, 1)", at_y},
                    Case{"max(-3, x, y)", at_x}, Case{"pow(x, 2)", at_x* at_x},
                    Case{"hypot(x, y)", std::hypot(at_x, at_y)}, Case{"erf(x)", std::erf(at_x)},
                    Case{"step(y)", 0}, Case{"step(0*x)", 1}, Case{"floor(y)", -2},
                    Case{"mod(y, 1)", at_y + 2}, Case{"if(x > 0, 1, 2)", 1},
                    Case{"if(x < 0, 1, 2)", 2}, Case{"if(1, x, 1/0)", at_x},
                    Case{"sqrt(if(x > 0, x, -1))", std::sqrt(at_x)}, Case{"t", 0.5},
                    Case{"f(x, y)", at_x - 2 * at_y}, Case{"f(f(1, 2), x)", -3 - 2 * at_x},
                    Case{"square", at_x* at_x + at_y* at_y}, Case{"plate.left + 1", 8}));
INSTANTIATE_TEST_SUITE_P(
    Derivatives, ExpressionMeaning,
    testing::Values(Case{"dx(x^2*y)", 2 * at_x* at_y}, Case{"dxy(x^2*y)", 2 * at_x},
                    Case{"grad(x^2*y)[1]", at_x* at_x},
                    Case{"laplacian(x^4 + y^2)", 12 * at_x* at_x + 2}, Case{"dxxy(x^2*y)", 2},
                    Case{"dyyy(y^4)", 24 * at_y}, Case{"dxxxxxxxx(x^9)", 362880 * at_x},
                    Case{"dxxxx(dxxxxx(x^10)) - 3628800*x", 0}, Case{"dt(x*t^2)", at_x},
                    Case{"dxt(x*t^2)", 1}, Case{"d(x*t^2, t)", at_x}, Case{"d(x^2, x)", 2 * at_x},
                    Case{"d(k*x^2 + k^3, k)", at_x* at_x + 48},
                    Case{"d(d(sin(k*x), k), x)", std::cos(4 * at_x) - 4 * at_x* std::sin(4 * at_x)},
                    Case{"d(x^k, x)", 4 * at_x* at_x* at_x}));
INSTANTIATE_TEST_SUITE_P(AtOtherPoints, ExpressionMeaning,
                         testing::Values(Case{"square(y, 2)", at_y* at_y + 4},
                                         Case{"wave(x + y, x)", std::sin(2 * at_x + at_y)},
                                         Case{"wave.dx(2*x, y) + wave.dxy(x, y)",
                                              std::cos(2 * at_x + at_y) - std::sin(at_x + at_y)},
                                         Case{"dx(wave(2*x, y))", 2 * std::cos(2 * at_x + at_y)},
                                         Case{"g(wave)", std::sin(at_x + 1 + at_y)}));
INSTANTIATE_TEST_SUITE_P(
    Parameters, ExpressionMeaning,
    testing::Values(Case{"k + 1", 5}, Case{"k^0.5", 2}, Case{"grad(x*y)[k - 3]", at_x},
                    Case{"rp_and(0*x + 3, 4, k)", 7 - std::pow(81 + 256, 0.25)}));

TEST_P(ExpressionMeaning, IsThatOfTheSameFormulaInCpp) {
  EXPECT_NEAR(value(GetParam().text), GetParam().expected,
              2e-15 * (1 + std::abs(GetParam().expected)));
}

class ExpressionMistake : public testing::TestWithParam<std::pair<std::string, std::string>> {};

INSTANTIATE_TEST_SUITE_P(
    Syntax, ExpressionMistake,
    testing::Values(std::pair{"", "0+1: expected an expression but the text is empty"},
                    std::pair{"   ", "0+1: expected an expression but the text is empty"},
                    std::pair{"1 + )", "4+1: expected a number, a name or '(' but found ')'"},
                    std::pair{"1 +", "3+1: expected a number, a name or '(' but found the end"},
                    std::pair{"(1 + 2", "6+1: expected ')' but found the end"},
                    std::pair{"sin(x", "5+1: expected ',' or ')' but found the end"},
                    std::pair{"sin(x y)", "6+1: expected ',' or ')' but found 'y'"},
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
                    std::pair{"x\u00B2",
                              "1+2: unexpected character '\u00B2' (a superscript: write '^2')"},
                    std::pair{"1e400", "0+5: the number 1e400 is too large"},
                    std::pair{"'abc", "0+1: the quotation that begins here does not end"},
                    std::pair{"* 2", "0+1: expected a number, a name or '(' but found '*'"}));
INSTANTIATE_TEST_SUITE_P(
    Names, ExpressionMistake,
    testing::Values(std::pair{"2*radus", "2+5: unknown name 'radus' (did you mean 'radius'?)"},
                    std::pair{"1 + foo", "4+3: unknown name 'foo'"},
                    std::pair{"sine(x)", "0+4: unknown function 'sine' (did you mean 'sin'?)"},
                    std::pair{"a(2)", "0+1: 'a' is not a function (a product is written with '*')"},
                    std::pair{"2*sin", "2+3: 'sin' is a function: write sin(...)"},
                    std::pair{"z", "0+1: 'z' does not exist in dimension 2"},
                    std::pair{"x + u", "4+1: 'u' is known after the solve only"},
                    std::pair{"sin(x, y)", "0+3: sin takes 1 argument, got 2"},
                    std::pair{"1 + atan2(x)", "4+5: atan2 takes 2 arguments, got 1"},
                    std::pair{"sin()", "0+3: sin takes 1 argument, got 0"},
                    std::pair{"max(1)", "0+3: max takes 2 or more arguments, got 1"},
                    std::pair{"if(x, 1)", "0+2: if takes 3 arguments, got 2"},
                    std::pair{"f(x)", "0+1: f takes 2 arguments, got 1"},
                    std::pair{"dz(x)", "0+2: unknown function 'dz' (did you mean 'dx'?)"},
                    std::pair{"1 + dxxxxxxxxx(x)",
                              "4+10: derivatives have at most 8 letters: nest two of them"},
                    std::pair{"d(x, a)",
                              "5+1: the second argument of d must be a parameter or a coordinate"},
                    std::pair{"d(x, x + y)",
                              "5+5: the second argument of d must be a parameter or a coordinate"},
                    std::pair{"wave(x)", "0+4: wave takes 2 arguments, got 1"},
                    std::pair{"wave.du(x, y)", "0+7: unknown function 'wave.du'"},
                    std::pair{"k(2)", "0+1: 'k' is not a function (a product is written with '*')"},
                    std::pair{"x(2)", "0+1: 'x' is not a function (a product is written with '*')"},
                    std::pair{"'abc'", "0+5: a quoted text is not a number"}));
INSTANTIATE_TEST_SUITE_P(
    Vectors, ExpressionMistake,
    testing::Values(
        std::pair{"v",
                  "0+1: a number is needed here, not a vector of 2 components: choose one "
                  "with [0]"},
        std::pair{"1 + grad(x)",
                  "4+7: a number is needed here, not a vector of 2 components: "
                  "choose one with [0]"},
        std::pair{"v[2]", "2+1: the index must be a whole number from 0 to 1"},
        std::pair{"v[0.5]", "2+3: the index must be a whole number from 0 to 1"},
        std::pair{"v[-1]", "2+2: the index must be a whole number from 0 to 1"},
        std::pair{"v[x]", "2+1: the index must be a whole number from 0 to 1"},
        std::pair{"x[0]", "1+1: only a vector has components, and this is a number"},
        std::pair{"dx(v)", "3+1: dx takes a function, not a vector: choose a component with [0]"}));

TEST_P(ExpressionMistake, IsReportedWithItsPlace) {
  EXPECT_EQ(mistake(GetParam().first), GetParam().second);
}

TEST(Expression, EveryNamedOperationOfTheTableIsAFunction) {
  for (const OperationRow& row : operation_table) {
    if (!std::isalpha(static_cast<unsigned char>(row.name[0]))) continue;
    std::string call = std::string(row.name) + "(";
    std::vector<Field> arguments;
    for (int i = 0; i < row.arity; ++i) {
      call += std::string(i ? ", " : "") + (i ? "y" : "x");
      arguments.push_back(i ? y_coordinate() : x_coordinate());
    }
    if (row.numbers > 0) call += ", 1";
    const double number = row.name.starts_with("rp_") && row.name != "rp_equivalence" ? 4 : 1;
    if (row.numbers > 0) call.back() = static_cast<char>('0' + static_cast<int>(number));
    const Field expected = apply(row.operation, arguments,
                                 row.numbers > 0 ? std::optional<double>(number) : std::nullopt);
    const Field actual = to_field(Expression(call + ")"), test_scope());
    const Point point = {0.4, 0.3, 0};
    EXPECT_DOUBLE_EQ(value_at(actual, point), value_at(expected, point)) << call;
  }
}

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
  EXPECT_DOUBLE_EQ(value(allowed), at_x);
}

TEST(Expression, LongSumsCostNoStack) {
  std::string sum = "0";
  for (int i = 0; i < 100'000; ++i) sum += "+1";
  EXPECT_DOUBLE_EQ(to_number(Expression(sum), ExpressionScope()), 100'000);
}

TEST(Expression, DefinitionsThatMultiplyAreLimited) {
  ExpressionScope scope = coordinate_scope(1);
  scope.define_function("f0", {"p"}, Expression("p + p"));
  for (int i = 1; i < 40; ++i) {
    const std::string inner = "f" + std::to_string(i - 1) + "(p)";
    scope.define_function("f" + std::to_string(i), {"p"}, Expression(inner + " + " + inner));
  }
  EXPECT_THROW(to_field(Expression("f39(x)"), scope), InputError);
}

/// The mistake in a formula, as "offset: message".
std::string mistake_in(const std::string& text, const ExpressionScope& scope) {
  try {
    to_field(Expression(text), scope);
  } catch (const InputError& error) {
    return std::to_string(error.offset) + ": " + error.what();
  }
  return "none";
}

TEST(Expression, ADefinitionThatUsesItselfIsAMistakeThatNamesTheCycle) {
  ExpressionScope scope;
  scope.define("p", Expression("q + 1"));
  scope.define("q", Expression("p + 1"));
  scope.define_function("f", {"s"}, Expression("f(s)"));
  scope.define_function("g", {"s"}, Expression("s*r"));
  scope.define("r", Expression("g(2)"));
  EXPECT_EQ(mistake_in("2 + p", scope), "4: a definition that uses itself: p -> q -> p");
  EXPECT_EQ(mistake_in("f(1)", scope), "0: a definition that uses itself: f -> f");
  EXPECT_EQ(mistake_in("1 + g(1)", scope), "4: a definition that uses itself: g -> r -> g");
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
  EXPECT_EQ(mistake_in("1 + p" + std::to_string(length), scope),
            "4: in 'p0': unknown name 'missing'");
}

TEST(Expression, FunctionsThatCallOneAnotherTooDeeplyAreAMistakeAndNotACrash) {
  ExpressionScope scope = coordinate_scope(1);
  scope.define_function("f0", {"p"}, Expression("p + 1"));
  for (int i = 1; i < 1000; ++i)
    scope.define_function("f" + std::to_string(i), {"p"},
                          Expression("f" + std::to_string(i - 1) + "(p) + 1"));
  EXPECT_EQ(to_number(Expression("f199(0)"), scope), 200);
  EXPECT_THAT(mistake_in("2*f999(x)", scope),
              testing::HasSubstr("2: functions call one another more than 200 deep here"));
}

TEST(Expression, ArgumentsOfAFunctionAreDifferentNames) {
  ExpressionScope scope;
  EXPECT_THROW(scope.define_function("h", {"a", "a"}, Expression("a")), InvalidArgument);
  EXPECT_THROW(scope.define_function("h", {"a", "2b"}, Expression("a")), InvalidArgument);
}

TEST(Expression, AScopeThatKeepsItsParametersGivesFieldsInWhichTheyMayChange) {
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

TEST(Expression, ADefinitionMayUseNamesThatAreDefinedLater) {
  ExpressionScope scope;
  scope.define("p", Expression("2*q"));
  scope.define("q", 3.0);
  EXPECT_EQ(to_number(Expression("p"), scope), 6);
  scope.define("q", 5.0);
  EXPECT_EQ(to_number(Expression("p"), scope), 10);
}

TEST(Expression, ArgumentsHideOtherNames) {
  ExpressionScope scope;
  scope.define("p", 100.0);
  scope.define_function("f", {"p"}, Expression("p + 1"));
  EXPECT_EQ(to_number(Expression("f(1) + p"), scope), 102);
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

TEST(Expression, AFunctionMayTakeNames) {
  ExpressionScope scope;
  std::string received;
  scope.define_function("omega", {1, 1,
                                  [&](std::span<const ExpressionArgument> arguments) {
                                    received = arguments[0].text;
                                    return ExpressionValue(2.0);
                                  },
                                  true});
  EXPECT_EQ(to_number(Expression("1 + omega(hole)*3"), scope), 7);
  EXPECT_EQ(received, "hole");
  EXPECT_EQ(to_number(Expression("omega( plate.left )"), scope), 2);
  EXPECT_EQ(received, "plate.left");
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

TEST(ToNumber, RefusesWhatIsNotAFiniteNumber) {
  EXPECT_THROW(to_number(Expression("1/0"), ExpressionScope()), InputError);
  EXPECT_THROW(to_number(Expression("sqrt(-1)"), ExpressionScope()), InputError);
  EXPECT_THROW(to_number(Expression("1e308*10"), ExpressionScope()), InputError);
  EXPECT_THROW(to_number(Expression("x"), coordinate_scope(2)), InputError);
  EXPECT_EQ(to_number(Expression("if(1, 2, 1/0)"), ExpressionScope()), 2);
}

TEST(ReservedNames, AreFunctionsDerivativesAndPi) {
  for (const char* name :
       {"pi", "sin", "if", "max", "dx", "dxyz", "dxyzxyzx", "grad", "omega", "laplacian"})
    EXPECT_TRUE(is_reserved_in_expressions(name)) << name;
  for (const char* name : {"r", "d", "dt", "dxt", "dxyzxyzxyz", "k1", "radius"})
    EXPECT_FALSE(is_reserved_in_expressions(name)) << name;
}
