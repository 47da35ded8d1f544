#include "core/expression_evaluator.hpp"

#include <numbers>

#include "tests/core/expression_cases.hpp"

namespace rfm {
namespace {

class Value : public FormulaWithValue {};
TEST_P(Value, IsThatOfTheSameFormulaInCpp) { expect_value(); }

// The right column is the same formula in C++, with parentheses where the grammars differ.
INSTANTIATE_TEST_SUITE_P(
    Precedence, Value,
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
INSTANTIATE_TEST_SUITE_P(Numbers, Value,
                         testing::Values(Case{"1e-3", 1e-3}, Case{".5", 0.5}, Case{"2.", 2},
                                         Case{"1.5E+2", 150}, Case{"08", 8}, Case{"5e-324", 5e-324},
                                         Case{"pi", std::numbers::pi}, Case{"2.*x", 2 * at_x},
                                         Case{"\t 1\n+ 2 ", 3}));
INSTANTIATE_TEST_SUITE_P(
    Parameters, Value,
    testing::Values(Case{"k + 1", 5}, Case{"k^0.5", 2}, Case{"grad(x*y)[k - 3]", at_x},
                    Case{"rp_and(0*x + 3, 4, k)", 7 - std::pow(81 + 256, 0.25)}));

class WrongName : public WrongFormula {};
TEST_P(WrongName, IsReportedWithItsPlace) { expect_mistake(); }

INSTANTIATE_TEST_SUITE_P(
    Names, WrongName,
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
                    std::pair{"1 + dxxxxxxxx(2*dxxxxxxxx(dx(sin(x))))",
                              "4+34: derivatives of a formula are at most of order 16, this one is "
                              "of order 17"},
                    std::pair{"1 + laplacian(dxxxxxxxx(2*dxxxxxxx(sin(x))))",
                              "4+40: derivatives of a formula are at most of order 16, this one is "
                              "of order 17"},
                    std::pair{"d(dxxxxxxxx(2*dxxxxxxxx(sin(x))), x)",
                              "0+36: derivatives of a formula are at most of order 16, this one is "
                              "of order 17"},
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
    Vectors, WrongName,
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

TEST(ToNumber, RefusesWhatIsNotAFiniteNumber) {
  EXPECT_THROW(to_number(Expression("1/0"), ExpressionScope()), InputError);
  EXPECT_THROW(to_number(Expression("sqrt(-1)"), ExpressionScope()), InputError);
  EXPECT_THROW(to_number(Expression("1e308*10"), ExpressionScope()), InputError);
  EXPECT_THROW(to_number(Expression("x"), coordinate_scope(2)), InputError);
  EXPECT_EQ(to_number(Expression("if(1, 2, 1/0)"), ExpressionScope()), 2);
}

}  // namespace
}  // namespace rfm
