#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/box.hpp"
#include "core/operations.hpp"

namespace rfm {

class FieldSource;

/// A function of the coordinates x, y, z, the time t and parameters: a cheap handle to an immutable
/// node of an expression graph. Sums, products and functions of fields are fields, so that C++
/// reads like the paper:
///
///     const Field x = x_coordinate(), y = y_coordinate();
///     Field rectangle = conjunction(a * a - x * x, b * b - y * y);         // R₀, eq. (1.2)
///     Field slope = partial(rectangle, 0);                                 // ∂/∂x, exact
///
/// A field knows nothing of how it is evaluated: a `Tape` (core/tape.hpp) compiles fields for many
/// points at once; `value_at` and `evaluate` (core/evaluate.hpp) serve single points and tests.
/// Constants fold and x + 0, 1 · x, 0 · x simplify when a field is built, but 0 · f and 0 / f only
/// if f is defined everywhere: 0 · log(x) stays, so that it fails where log(x) does. f⁰ is 1 for
/// every f, as in C. Equal sub-expressions are shared when a tape is compiled. Graphs may be
/// arbitrarily deep: nothing here recurses.
class Field {
 public:
  struct Node;

  Field() : Field(0.0) {}
  Field(double value);  // NOLINT: numbers are fields
  explicit Field(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

  const Node& node() const { return *node_; }
  const std::shared_ptr<const Node>& handle() const { return node_; }

  bool is_constant() const;
  bool is_constant(double value) const;
  /// The value of a constant field. Throws `InvalidArgument` if the field is not a constant.
  double constant() const;
  /// Whether both are the same node (not merely equal functions).
  bool same_as(const Field& other) const { return node_ == other.node_; }

 private:
  std::shared_ptr<const Node> node_;
};

/// A node of the graph. `arguments` holds as many fields as the operation has arguments.
struct Field::Node {
  Operation operation = Operation::constant;
  /// Value of a constant, exponent of an integer or real power.
  double number = 0;
  /// Axis of a coordinate or a partial derivative; index of a parameter.
  int index = 0;
  /// Whether it has a value at all finite coordinates, as far as its operations tell (overflow
  /// apart): no root, logarithm, quotient by something that varies, or sampled field.
  bool defined_everywhere = true;
  /// Of a parameter that has a name.
  std::shared_ptr<const std::string> name;
  std::shared_ptr<const FieldSource> source;
  std::vector<Field> arguments;

  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  ~Node();  // iterative: a chain of 100,000 nodes must not overflow the stack
};

/// Coordinate `axis`: 0, 1, 2 for x, y, z, and 3 for the time t.
Field coordinate(int axis);
inline Field x_coordinate() { return coordinate(0); }
inline Field y_coordinate() { return coordinate(1); }
inline Field z_coordinate() { return coordinate(2); }
inline Field time_coordinate() { return coordinate(3); }
/// Parameter number `index`: its value is given when a tape is evaluated, its name is how it is
/// written. A set of parameters numbers them by itself: core/parameters.hpp.
Field parameter(int index, const std::string& name = {});
/// A function that is not an expression: a solved field, a sampled distance (field_source.hpp).
Field field(std::shared_ptr<const FieldSource> source);
/// `operation` applied to its arguments, and to a number if the table says that it has one. Throws
/// `InvalidArgument` on a wrong number of arguments, a number that is missing, superfluous or out
/// of range, or when the operation is not in the table (leaves and partial have their own
/// builders).
Field apply(Operation operation, std::vector<Field> arguments, std::optional<double> number = {});

Field operator+(const Field& a, const Field& b);
Field operator-(const Field& a, const Field& b);
Field operator*(const Field& a, const Field& b);
Field operator/(const Field& a, const Field& b);
Field operator-(const Field& a);
/// a · b as a term of a sum over components: none, 0, if one of them is zero everywhere, also where
/// the other is not defined. Sums over axes and entries of matrices do not grow by such terms.
Field product_or_nothing(const Field& a, const Field& b);
/// aᵇ: exact repeated multiplication for a constant integer exponent up to 64, aᵉ for another
/// constant (a ≥ 0), exp(b log a) otherwise.
Field pow(const Field& a, const Field& b);

Field sqrt(const Field& a);
Field cbrt(const Field& a);
Field exp(const Field& a);
Field log(const Field& a);
Field sin(const Field& a);
Field cos(const Field& a);
Field tan(const Field& a);
Field asin(const Field& a);
Field acos(const Field& a);
Field atan(const Field& a);
Field atan2(const Field& y, const Field& x);
Field sinh(const Field& a);
Field cosh(const Field& a);
Field tanh(const Field& a);
Field asinh(const Field& a);
Field erf(const Field& a);
Field abs(const Field& a);
Field sign(const Field& a);
Field min(const Field& a, const Field& b);
Field max(const Field& a, const Field& b);
Field hypot(const Field& a, const Field& b);
/// 1 where a ≥ 0, else 0.
Field step(const Field& a);
Field floor(const Field& a);
/// a − b floor(a / b): the sign of b, as in Python.
Field mod(const Field& a, const Field& b);
/// `yes` where `condition` ≠ 0, else `no`; the other branch is not looked at, not even its NaN.
Field select(const Field& condition, const Field& yes, const Field& no);

/// ∂f/∂(coordinate `axis`): exact, from jets of one order more, or, along the time and what else a
/// tape takes no jets in, by derivation of the expression (core/graph_derivative.hpp).
Field partial(const Field& f, int axis);
/// ∂^α f.
Field partial(const Field& f, const MultiIndex& alpha);
/// ∇f in `dimension` coordinates.
std::vector<Field> gradient(const Field& f, int dimension);
/// ∇ω · ∇f: where ω is normalised, the derivative along the *inward* normal (D of the literature).
Field inward_derivative(const Field& f, const Field& omega, int dimension);
Field laplacian(const Field& f, int dimension);
/// First-order normalisation f / √(f² + |∇f|²), eq. (4.9) of Shapiro (2007): on {f = 0, ∇f ≠ 0} its
/// normal derivative is 1.
Field normalize(const Field& f, int dimension);

/// A generic lambda is a field: `field([](auto x, auto y) { return sin(x) * exp(y); })`.
template <class Function>
requires std::invocable<Function, Field> || std::invocable<Function, Field, Field> ||
    std::invocable<Function, Field, Field, Field>
        Field field(Function&& function) {
  if constexpr (std::invocable<Function, Field>)
    return function(x_coordinate());
  else if constexpr (std::invocable<Function, Field, Field>)
    return function(x_coordinate(), y_coordinate());
  else
    return function(x_coordinate(), y_coordinate(), z_coordinate());
}

}  // namespace rfm
