#include "tests/core/expression_cases.hpp"

namespace rfm {
namespace {

class Derivative : public FormulaWithValue {};
TEST_P(Derivative, IsThatOfTheSameFormulaInCpp) { expect_value(); }

INSTANTIATE_TEST_SUITE_P(
    Derivatives, Derivative,
    testing::Values(Case{"dx(x^2*y)", 2 * at_x* at_y}, Case{"dxy(x^2*y)", 2 * at_x},
                    Case{"grad(x^2*y)[1]", at_x* at_x},
                    Case{"laplacian(x^4 + y^2)", 12 * at_x* at_x + 2}, Case{"dxxy(x^2*y)", 2},
                    Case{"dyyy(y^4)", 24 * at_y}, Case{"dxxxxxxxx(x^9)", 362880 * at_x},
                    Case{"dxxxx(dxxxxx(x^10)) - 3628800*x", 0}, Case{"dt(x*t^2)", at_x},
                    Case{"dxt(x*t^2)", 1}, Case{"d(x*t^2, t)", at_x}, Case{"d(x^2, x)", 2 * at_x},
                    Case{"d(k*x^2 + k^3, k)", at_x* at_x + 48},
                    Case{"d(d(sin(k*x), k), x)", std::cos(4 * at_x) - 4 * at_x* std::sin(4 * at_x)},
                    Case{"d(x^k, x)", 4 * at_x* at_x* at_x}));

TEST(ReservedNames, AreFunctionsDerivativesAndPi) {
  for (const char* name :
       {"pi", "sin", "if", "max", "dx", "dxyz", "dxyzxyzx", "grad", "omega", "laplacian"})
    EXPECT_TRUE(is_reserved_in_expressions(name)) << name;
  for (const char* name : {"r", "d", "dt", "dxt", "dxyzxyzxyz", "k1", "radius"})
    EXPECT_FALSE(is_reserved_in_expressions(name)) << name;
}

}  // namespace
}  // namespace rfm
