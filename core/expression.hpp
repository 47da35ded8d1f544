#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "core/multi_index.hpp"
#include "core/parameters.hpp"

namespace rfm {

/// A formula as text, parsed but not yet given a meaning: which names it uses is known, what they
/// stand for is not. Stages are types: text → Expression → Field (or number).
///
///     const Expression source("100 * exp(-hypot(x - a, y)^2)");
///     ExpressionScope scope = coordinate_scope(2);
///     scope.define("a", 0.5);
///     const Field f = to_field(source, scope);
///
/// Grammar, loosest first: comparisons `< <= > >= == !=` (1 or 0, not chained); `+ -`; `* /`; unary
/// `-`; `^` (right associative, so −x^2 is −(x^2); its exponent may have a sign: 2^-1); an index
/// `v[0]` of a vector; numbers, names, calls and parentheses. Nesting is limited to 250 levels.
class Expression {
 public:
  /// Throws `InputError`, with the place in `text`.
  explicit Expression(std::string text);

  const std::string& text() const { return text_; }
  /// A name or call in the text. Arguments of a call are uses too.
  struct Use {
    std::string name;
    std::size_t offset;
    bool is_call;
    /// Arguments as text, of a call.
    std::vector<std::string> arguments;
  };
  std::vector<Use> uses() const;
  bool uses(std::string_view name) const;

  /// A node of the parsed formula. Its subtree is the nodes from `first` up to itself.
  struct Node {
    enum class Kind : std::uint8_t { number, name, text, operation, not_equal, call, index };
    Kind kind;
    Operation operation = Operation::constant;
    std::uint32_t first = 0;
    std::uint32_t argument_count = 0;
    double number = 0;
    /// The name, number or operator in the text.
    std::size_t offset = 0;
    std::size_t length = 0;
    /// Where the subtree begins and ends in the text.
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  /// Nodes in the order of evaluation: arguments before their users, the root last.
  std::span<const Node> nodes() const { return nodes_; }
  /// The arguments of node `i`, in order, as the roots of their subtrees.
  std::vector<std::size_t> arguments_of(std::size_t i) const;
  std::string_view text_of(const Node& node) const {
    return std::string_view(text_).substr(node.offset, node.length);
  }

 private:
  std::string text_;
  std::vector<Node> nodes_;
};

/// What a formula stands for: a number or function, or a vector of them (a gradient, a normal).
struct ExpressionValue {
  std::vector<Field> components;
  bool is_vector = false;

  ExpressionValue(Field scalar) : components{std::move(scalar)} {}    // NOLINT: fields are values
  ExpressionValue(double number) : ExpressionValue(Field(number)) {}  // NOLINT: numbers too
  explicit ExpressionValue(std::vector<Field> vector)
      : components(std::move(vector)), is_vector(true) {}
};

/// An argument of a call: its value, and the text it was written as.
struct ExpressionArgument {
  std::string text;
  std::size_t offset = 0;
  std::size_t length = 0;
  ExpressionValue value = 0.0;
};

/// A function that formulas may call. To refuse an argument, throw `InputError` with its offset.
struct ExpressionFunction {
  std::size_t least_arguments = 1;
  std::size_t most_arguments = 1;
  std::function<ExpressionValue(std::span<const ExpressionArgument>)> call;
  /// The arguments are not formulas but names of something else, as in `omega(hole)`: they have a
  /// text but no value.
  bool takes_names = false;
  /// So many arguments at the beginning are texts in quotes, which have no value either.
  std::size_t text_arguments = 0;
};

/// What names mean. A value: copy it and define more. `pi` and the functions of the operation table
/// (operations.hpp) always have a meaning, and `min`, `max` take two or more arguments. A name that
/// stands for a function f of the coordinates may be called: f(a, b) is f at the point (a, b), and
/// f.dx(a, b) its derivative ∂f/∂x there (core/composition.hpp).
class ExpressionScope {
 public:
  void define(const std::string& name, ExpressionValue value);
  /// A name that stands for a number which formulas may be differentiated by: d(f, name). What a
  /// formula comes to holds the number, or, in a scope that keeps its parameters, the parameter, so
  /// that the number may change after the formula was compiled.
  void define_parameter(const std::string& name, double value);
  const Parameters& parameters() const { return parameters_; }
  void keep_parameters(bool keep = true) { keeps_parameters_ = keep; }
  /// A name that stands for a formula, with whatever its own names mean where it is used: so it may
  /// contain names that are defined later. It must not use itself, however indirectly. Chains of
  /// definitions may be arbitrarily long.
  void define(const std::string& name, Expression formula);
  void define_function(const std::string& name, ExpressionFunction function);
  /// f(a, b) := formula; `arguments` hide other names inside it. Throws `InvalidArgument` if they
  /// are not different names.
  void define_function(const std::string& name, std::vector<std::string> arguments,
                       Expression formula);
  /// Makes dx(f), dxy(f), dt(f), … functions, in so many coordinates of space and the time.
  void define_partials(int dimension) { partials_ = dimension; }
  /// Derivatives of higher orders, those within derivatives counted, are refused where they are
  /// written. For formulas of which others take further derivatives: jets end at `maximum_order`.
  void limit_derivatives(int order) { highest_derivative_ = order; }
  /// A name that is known but cannot be used here, and why: "is known on boundaries only".
  void refuse(const std::string& name, std::string reason);

  bool has_name(const std::string& name) const { return names_.contains(name); }
  bool has_function(const std::string& name) const;
  /// A function that was defined by what it calls, or null.
  const ExpressionFunction* find_function(const std::string& name) const {
    const auto found = functions_.find(name);
    return found == functions_.end() ? nullptr : &found->second;
  }
  /// Whether the name is that of a partial derivative here: dxt, but not dz in the plane.
  bool is_partial(std::string_view name) const;
  /// All names, or all functions, that formulas may use; for suggestions.
  std::vector<std::string> names() const;
  std::vector<std::string> functions() const;

 private:
  friend class ExpressionEvaluator;
  struct Meaning {
    ExpressionValue value = 0.0;
    std::shared_ptr<const Expression> formula;
  };
  struct UserFunction {
    std::vector<std::string> arguments;
    std::shared_ptr<const Expression> formula;
  };
  std::map<std::string, Meaning> names_;
  std::map<std::string, std::string> refused_;
  std::map<std::string, ExpressionFunction> functions_;
  std::map<std::string, UserFunction> user_functions_;
  Parameters parameters_;
  bool keeps_parameters_ = false;
  int partials_ = 0;
  int highest_derivative_ = maximum_order;
};

/// `x`, `y`, `z` as far as `dimension` goes, and `t`.
ExpressionScope coordinate_scope(int dimension);
/// Adds `grad(f)`, `laplacian(f)`, `dx(f)`, `dxy(f)`, `dt(f)`, … (up to 8 letters, which may be
/// nested as far as tapes have orders), and d(f, p), the derivative with respect to a parameter or
/// a coordinate.
void define_derivatives(ExpressionScope& scope, int dimension);
/// `dxy` → {0, 1}: the axes of a derivative as its name spells them, t being 3; empty if the name
/// is not one.
std::vector<int> derivative_axes(std::string_view name);

/// The value of a formula. Throws `InputError` with a place in its text: a name without a meaning
/// (with a suggestion), a wrong number of arguments, a vector where a number is needed, definitions
/// that use themselves, more than a million operations after definitions are inserted.
ExpressionValue evaluate(const Expression& expression, const ExpressionScope& scope);
/// The value of a formula that must not be a vector.
Field to_field(const Expression& expression, const ExpressionScope& scope);
/// The value of a formula that must be a finite number.
double to_number(const Expression& expression, const ExpressionScope& scope);

/// Whether `name` has a meaning of its own in every formula: `pi` or a function of the operation
/// table, `if` or an operator such as `dx`. `d` and derivatives along the time are not reserved: a
/// function of that name hides them.
bool is_reserved_in_expressions(std::string_view name);

}  // namespace rfm
