#include "tests/core/expression_cases.hpp"

namespace rfm {
namespace {

class Call : public FormulaWithValue {};
TEST_P(Call, IsThatOfTheSameFormulaInCpp) { expect_value(); }

INSTANTIATE_TEST_SUITE_P(
    Functions, Call,
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
INSTANTIATE_TEST_SUITE_P(AtOtherPoints, Call,
                         testing::Values(Case{"square(y, 2)", at_y* at_y + 4},
                                         Case{"wave(x + y, x)", std::sin(2 * at_x + at_y)},
                                         Case{"wave.dx(2*x, y) + wave.dxy(x, y)",
                                              std::cos(2 * at_x + at_y) - std::sin(at_x + at_y)},
                                         Case{"dx(wave(2*x, y))", 2 * std::cos(2 * at_x + at_y)},
                                         Case{"g(wave)", std::sin(at_x + 1 + at_y)}));

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

TEST(Expression, FunctionsThatCallOneAnotherTooDeeplyAreAMistakeAndNotACrash) {
  ExpressionScope scope = coordinate_scope(1);
  scope.define_function("f0", {"p"}, Expression("p + 1"));
  for (int i = 1; i < 1000; ++i)
    scope.define_function("f" + std::to_string(i), {"p"},
                          Expression("f" + std::to_string(i - 1) + "(p) + 1"));
  EXPECT_EQ(to_number(Expression("f199(0)"), scope), 200);
  EXPECT_THAT(mistake("2*f999(x)", scope),
              testing::HasSubstr("2+4: functions call one another more than 200 deep here"));
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

TEST(Expression, ArgumentsHideOtherNames) {
  ExpressionScope scope;
  scope.define("p", 100.0);
  scope.define_function("f", {"p"}, Expression("p + 1"));
  EXPECT_EQ(to_number(Expression("f(1) + p"), scope), 102);
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

}  // namespace
}  // namespace rfm
