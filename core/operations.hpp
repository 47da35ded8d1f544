#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/multi_index.hpp"

namespace rfm {

/// The one table of operations. Everything that depends on the set of operations iterates over it:
/// the evaluators of tapes (jets, SIMD blocks, intervals, Taylor bounds), the expression parser,
/// the conformance tests. A row is
///
///     X(enumerator, "name in text", arity, rule, "formula", "where it is not smooth")
///
/// and `rule` is an expression in the arguments a, b, c, written once for every kind of number that
/// the evaluators use. Adding an operation is adding a row (and the functions its rule calls).
#define RFM_OPERATIONS(X)                                                                          \
  X(add, "+", 2, a + b, "a + b", "")                                                               \
  X(subtract, "-", 2, a - b, "a - b", "")                                                          \
  X(multiply, "*", 2, a* b, "a b", "")                                                             \
  X(divide, "/", 2, a / b, "a / b", "b = 0")                                                       \
  X(negate, "neg", 1, -a, "-a", "")                                                                \
  X(power, "pow", 2, general_power(a, b), "a^b = exp(b log a), a > 0", "a = 0")                    \
  X(sqrt, "sqrt", 1, sqrt(a), "square root, a >= 0", "a = 0")                                      \
  X(cbrt, "cbrt", 1, cbrt(a), "real cube root", "a = 0")                                           \
  X(exp, "exp", 1, exp(a), "e^a", "")                                                              \
  X(log, "log", 1, log(a), "natural logarithm, a > 0", "a = 0")                                    \
  X(sin, "sin", 1, sin(a), "sine of radians", "")                                                  \
  X(cos, "cos", 1, cos(a), "cosine of radians", "")                                                \
  X(tan, "tan", 1, tan(a), "tangent of radians", "odd multiples of pi/2")                          \
  X(asin, "asin", 1, asin(a), "inverse sine, |a| <= 1", "|a| = 1")                                 \
  X(acos, "acos", 1, acos(a), "inverse cosine, |a| <= 1", "|a| = 1")                               \
  X(atan, "atan", 1, atan(a), "inverse tangent", "")                                               \
  X(atan2, "atan2", 2, atan2(a, b), "angle of the point (b, a)", "b <= 0, a = 0")                  \
  X(sinh, "sinh", 1, sinh(a), "hyperbolic sine", "")                                               \
  X(cosh, "cosh", 1, cosh(a), "hyperbolic cosine", "")                                             \
  X(tanh, "tanh", 1, tanh(a), "hyperbolic tangent", "")                                            \
  X(asinh, "asinh", 1, asinh(a), "inverse hyperbolic sine", "")                                    \
  X(erf, "erf", 1, erf(a), "error function", "")                                                   \
  X(abs, "abs", 1, abs(a), "|a|", "a = 0")                                                         \
  X(sign, "sign", 1, sign(a), "-1, 0 or 1", "a = 0")                                               \
  X(min, "min", 2, min(a, b), "the smaller (R1-conjunction)", "a = b")                             \
  X(max, "max", 2, max(a, b), "the larger (R1-disjunction)", "a = b")                              \
  X(hypot, "hypot", 2, hypot(a, b), "sqrt(a^2 + b^2)", "a = b = 0")                                \
  X(step, "step", 1, step(a), "1 where a >= 0, else 0", "a = 0")                                   \
  X(floor, "floor", 1, floor(a), "largest integer <= a", "integers")                               \
  X(mod, "mod", 2, mod(a, b), "a - b floor(a / b)", "multiples of b")                              \
  X(less, "<", 2, less_than(a, b), "1 where a < b, else 0", "a = b")                               \
  X(less_equal, "<=", 2, at_most(a, b), "1 where a <= b, else 0", "a = b")                         \
  X(equal, "==", 2, equals(a, b), "1 where a = b, else 0", "a = b")                                \
  X(select, "if", 3, choose(a, b, c), "b where a is not 0, else c", "a changes between 0 and not") \
  X(r0_conjunction, "r0_and", 2, r0_conjunction(a, b), "a + b - sqrt(a^2 + b^2)", "a = b = 0")     \
  X(r0_disjunction, "r0_or", 2, r0_disjunction(a, b), "a + b + sqrt(a^2 + b^2)", "a = b = 0")

/// What a node does: leaves and nodes with a payload first, then the rows of the table.
enum class Operation : std::uint8_t {
  constant,       ///< `number`
  coordinate,     ///< `index`: x, y, z, t
  parameter,      ///< `index`
  source,         ///< a `FieldSource`
  partial,        ///< ∂/∂(axis `index`)
  integer_power,  ///< a^`index`
  real_power,     ///< a^`number`, a ≥ 0
  scale,          ///< `number` · a: made by tapes from products with a constant
  offset,         ///< a + `number`: made by tapes from sums with a constant
#define RFM_ENUMERATOR(id, ...) id,
  RFM_OPERATIONS(RFM_ENUMERATOR)
#undef RFM_ENUMERATOR
};

/// A row of the table as data.
struct OperationRow {
  Operation operation;
  std::string_view name;
  int arity;
  std::string_view formula;
  /// Where the operation is not smooth; empty if it is analytic wherever it is defined.
  std::string_view not_smooth;
};

inline constexpr auto operation_table = std::to_array<OperationRow>({
#define RFM_ROW(id, name, arity, rule, formula, not_smooth) \
  {Operation::id, name, arity, formula, not_smooth},
    RFM_OPERATIONS(RFM_ROW)
#undef RFM_ROW
});

/// The row of an operation, or null for leaves and nodes with a payload.
const OperationRow* find_operation(Operation operation);
/// The row with this name in text, or null.
const OperationRow* find_operation(std::string_view name);

}  // namespace rfm
