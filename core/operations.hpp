#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/multi_index.hpp"

namespace rfm {

/// The one table of operations. Everything that depends on the set of operations iterates over it:
/// the evaluators of tapes (jets, SIMD blocks, intervals, Taylor bounds), the expression parser and
/// printer, the conformance tests, docs/fields.md. A row is
///
///     X(enumerator, "name in text", arity, numbers, rule, reference, "formula", "domain",
///       "where it is not smooth")
///
/// `rule` is an expression in the arguments a, b, c, written once for every kind of number that the
/// evaluators use. An operation with one of the `numbers` also depends on the constant `number`,
/// which follows the arguments in text: rp_and(x, y, 4). `reference` is the plain value in real
/// numbers of any precision or in power series, by the definition rather than by the stable form:
/// what the rule is tested against. Names that are no words are operators. Adding an operation is
/// adding a row, the functions its rule calls, and its derivative in core/graph_derivative.cpp.
// clang-format off
#define RFM_OPERATIONS(X)                                                                          \
  X(add, "+", 2, 0, a + b, a + b, "a + b", "", "")                                                 \
  X(subtract, "-", 2, 0, a - b, a - b, "a - b", "", "")                                            \
  X(multiply, "*", 2, 0, a * b, a * b, "a b", "", "")                                              \
  X(divide, "/", 2, 0, a / b, a / b, "a / b", "b != 0", "b = 0")                                   \
  X(negate, "neg", 1, 0, -a, -a, "-a", "", "")                                                     \
  X(power, "pow", 2, 0, general_power(a, b),                                                       \
    a < 0 ? NAN : pow(fabs(a), b), "a^b = exp(b log a)",                                           \
    "a > 0; a = 0 where b >= 0", "a = 0")                                                          \
  X(integer_power, "^n", 1, 1, integer_power(a, static_cast<int>(number)), pow(a, number),         \
    "a^n, n a whole number", "a != 0 where n < 0", "a = 0 where n < 0")                            \
  X(real_power, "^r", 1, 1, real_power(a, number),                                                 \
    a < 0 && floor(number) < number ? NAN : pow(a, number), "a^r, r a number",                     \
    "a >= 0 unless r is whole; a != 0 where r < 0", "a = 0")                                       \
  X(sqrt, "sqrt", 1, 0, sqrt(a), sqrt(a), "square root", "a >= 0", "a = 0")                        \
  X(cbrt, "cbrt", 1, 0, cbrt(a), cbrt(a), "real cube root", "", "a = 0")                           \
  X(exp, "exp", 1, 0, exp(a), exp(a), "e^a", "", "")                                               \
  X(log, "log", 1, 0, log(a), log(a), "natural logarithm", "a > 0", "a = 0")                       \
  X(sin, "sin", 1, 0, sin(a), sin(a), "sine of radians", "", "")                                   \
  X(cos, "cos", 1, 0, cos(a), cos(a), "cosine of radians", "", "")                                 \
  X(tan, "tan", 1, 0, tan(a), tan(a), "tangent of radians", "a no odd multiple of pi/2",           \
    "odd multiples of pi/2")                                                                       \
  X(asin, "asin", 1, 0, asin(a), asin(a), "inverse sine, -pi/2 to pi/2", "|a| <= 1",               \
    "|a| = 1")                                                                                     \
  X(acos, "acos", 1, 0, acos(a), acos(a), "inverse cosine, 0 to pi", "|a| <= 1", "|a| = 1")        \
  X(atan, "atan", 1, 0, atan(a), atan(a), "inverse tangent, -pi/2 to pi/2", "", "")                \
  X(atan2, "atan2", 2, 0, atan2(a, b),                                                             \
    !(fabs(a) < INFINITY) && !(fabs(b) < INFINITY) ? NAN : atan2(a, b),                            \
    "angle of the point (b, a), -pi to pi", "", "b <= 0, a = 0")                                   \
  X(sinh, "sinh", 1, 0, sinh(a), sinh(a), "hyperbolic sine", "", "")                               \
  X(cosh, "cosh", 1, 0, cosh(a), cosh(a), "hyperbolic cosine", "", "")                             \
  X(tanh, "tanh", 1, 0, tanh(a), tanh(a), "hyperbolic tangent", "", "")                            \
  X(asinh, "asinh", 1, 0, asinh(a), asinh(a), "inverse hyperbolic sine", "", "")                   \
  X(erf, "erf", 1, 0, erf(a), erf(a), "error function", "", "")                                    \
  X(abs, "abs", 1, 0, abs(a), fabs(a), "|a|", "", "a = 0")                                         \
  X(sign, "sign", 1, 0, sign(a), (a > 0) - (a < 0), "-1, 0 or 1", "", "a = 0")                     \
  X(min, "min", 2, 0, min(a, b), b < a ? b : a, "the smaller (R1-conjunction)", "", "a = b")       \
  X(max, "max", 2, 0, max(a, b), a < b ? b : a, "the larger (R1-disjunction)", "", "a = b")        \
  X(hypot, "hypot", 2, 0, hypot(a, b), hypot(a, b), "sqrt(a^2 + b^2)", "", "a = b = 0")            \
  X(step, "step", 1, 0, step(a), a >= 0, "1 where a >= 0, else 0", "", "a = 0")                    \
  X(floor, "floor", 1, 0, floor(a), floor(a), "largest whole number <= a", "",                     \
    "whole numbers")                                                                               \
  X(mod, "mod", 2, 0, mod(a, b), floored_remainder(a, b), "a - b floor(a / b)", "b != 0",          \
    "a a multiple of b")                                                                           \
  X(less, "<", 2, 0, less_than(a, b), a < b, "1 where a < b, else 0", "", "a = b")                 \
  X(less_equal, "<=", 2, 0, at_most(a, b), a <= b, "1 where a <= b, else 0", "", "a = b")          \
  X(equal, "==", 2, 0, equals(a, b), a == b, "1 where a = b, else 0", "", "a = b")                 \
  X(select, "if", 3, 0, choose(a, b, c), a != 0 ? b : c, "b where a is not 0, else c", "",         \
    "a changes between 0 and not")                                                                 \
  X(r0_conjunction, "r0_and", 2, 0, r0_conjunction(a, b), a + b - hypot(a, b),                     \
    "a + b - sqrt(a^2 + b^2)", "", "a = b = 0")                                                    \
  X(r0_disjunction, "r0_or", 2, 0, r0_disjunction(a, b), a + b + hypot(a, b),                      \
    "a + b + sqrt(a^2 + b^2)", "", "a = b = 0")                                                    \
  X(r0_exclusive_or, "r0_xor", 2, 0, r0_exclusive_or(a, b),                                        \
    2 * sqrt((a * a + b * b) - a * b) - 2 * hypot(a, b),                                           \
    "2 sqrt(a^2 + b^2 - a b) - 2 sqrt(a^2 + b^2)", "", "a = b = 0")                                \
  X(ralpha_conjunction, "ralpha_and", 2, 1, ralpha_conjunction(a, b, number),                      \
    (a + b - sqrt(a * a + b * b - 2 * number * a * b)) / (1 + number),                             \
    "(a + b - sqrt(a^2 + b^2 - 2 n a b)) / (1 + n), -1 < n <= 1", "",                              \
    "a = b = 0; a = b where n = 1")                                                                \
  X(ralpha_disjunction, "ralpha_or", 2, 1, ralpha_disjunction(a, b, number),                       \
    (a + b + sqrt(a * a + b * b - 2 * number * a * b)) / (1 + number),                             \
    "(a + b + sqrt(a^2 + b^2 - 2 n a b)) / (1 + n), -1 < n <= 1", "",                              \
    "a = b = 0; a = b where n = 1")                                                                \
  X(rp_conjunction, "rp_and", 2, 1, rp_conjunction(a, b, static_cast<int>(number)),                \
    a + b - pow(pow(fabs(a), number) + pow(fabs(b), number), 1 / number),                          \
    "a + b - (a^n + b^n)^(1/n), n even", "", "a = b = 0")                                          \
  X(rp_disjunction, "rp_or", 2, 1, rp_disjunction(a, b, static_cast<int>(number)),                 \
    a + b + pow(pow(fabs(a), number) + pow(fabs(b), number), 1 / number),                          \
    "a + b + (a^n + b^n)^(1/n), n even", "", "a = b = 0")                                          \
  X(rp_equivalence, "rp_equivalence", 2, 1, rp_equivalence(a, b, static_cast<int>(number)),        \
    a == 0 && b == 0 ? 0 : a * b / pow(pow(fabs(a), number) + pow(fabs(b), number), 1 / number),   \
    "a b / (|a|^n + |b|^n)^(1/n), n whole; 0 at a = b = 0", "", "a = b = 0; a b = 0 where n is odd")
// clang-format on

/// What a node does: leaves and nodes with a payload first, then the rows of the table.
enum class Operation : std::uint8_t {
  constant,    ///< `number`
  coordinate,  ///< `index`: x, y, z, t
  parameter,   ///< `index`
  source,      ///< a `FieldSource`
  partial,     ///< ∂/∂(axis `index`)
  scale,       ///< `number` · a: made by tapes from products with a constant
  offset,      ///< a + `number`: made by tapes from sums with a constant
#define RFM_ENUMERATOR(id, ...) id,
  RFM_OPERATIONS(RFM_ENUMERATOR)
#undef RFM_ENUMERATOR
};

/// A row of the table as data.
struct OperationRow {
  Operation operation;
  std::string_view name;
  int arity;
  /// How many constants beside the arguments it depends on: 0 or 1.
  int numbers;
  std::string_view formula;
  /// Where it is defined; empty if everywhere. Elsewhere the result is not a finite number.
  std::string_view domain;
  /// Where the operation is not smooth; empty if it is analytic wherever it is defined.
  std::string_view not_smooth;
};

inline constexpr auto operation_table = std::to_array<OperationRow>({
#define RFM_ROW(id, name, arity, numbers, rule, reference, formula, domain, not_smooth) \
  {Operation::id, name, arity, numbers, formula, domain, not_smooth},
    RFM_OPERATIONS(RFM_ROW)
#undef RFM_ROW
});

/// The row of an operation, or null for leaves and nodes with a payload.
const OperationRow* find_operation(Operation operation);
/// The row with this name in text, or null.
const OperationRow* find_operation(std::string_view name);
/// Whether the operation is defined for all finite arguments (overflow apart), as by its row's
/// `domain` or because of its number: a^3 is, a^-1 is not.
bool is_defined_everywhere(const OperationRow& row, double number);
/// What an operation with a number asks of it, as "an even whole number from 2 to 64"; empty if
/// `number` is right, or the operation has none.
std::string objection_to_number(Operation operation, double number);

}  // namespace rfm
