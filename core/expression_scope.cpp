#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/expression_tokens.hpp"

namespace rfm {
namespace {

constexpr int highest_derivative = 4;
constexpr std::string_view axes = "xyz";

/// `dxy` → {0, 1}; empty if the name is not one of a derivative.
std::vector<int> derivative_axes(std::string_view name) {
  if (name.size() < 2 || name.size() > highest_derivative + 1 || name[0] != 'd') return {};
  std::vector<int> along;
  for (const char letter : name.substr(1)) {
    const std::size_t axis = axes.find(letter);
    if (axis == std::string_view::npos) return {};
    along.push_back(static_cast<int>(axis));
  }
  return along;
}

Field scalar_argument(const ExpressionArgument& argument, const std::string& function) {
  if (argument.value.is_vector)
    throw InputError(function + " takes a function, not a vector: choose a component with [0]",
                     argument.offset, argument.length);
  return argument.value.components[0];
}

void define_partial(ExpressionScope& scope, const std::string& name) {
  scope.define_function(
      name, {1, 1, [name](std::span<const ExpressionArgument> arguments) -> ExpressionValue {
               Field derivative = scalar_argument(arguments[0], name);
               for (const int axis : derivative_axes(name)) derivative = partial(derivative, axis);
               return derivative;
             }});
}

void define_partials(ExpressionScope& scope, const std::string& prefix, int dimension) {
  for (int axis = 0; axis < dimension; ++axis) {
    const std::string name = prefix + axes[axis];
    define_partial(scope, name);
    if (name.size() <= highest_derivative) define_partials(scope, name, dimension);
  }
}

}  // namespace

void ExpressionScope::define(const std::string& name, ExpressionValue value) {
  refused_.erase(name);
  names_.insert_or_assign(name, Meaning{std::move(value), nullptr});
}

void ExpressionScope::define(const std::string& name, Expression formula) {
  refused_.erase(name);
  names_.insert_or_assign(name,
                          Meaning{0.0, std::make_shared<const Expression>(std::move(formula))});
}

void ExpressionScope::define_function(const std::string& name, ExpressionFunction function) {
  refused_.erase(name);
  functions_.insert_or_assign(name, std::move(function));
}

void ExpressionScope::define_function(const std::string& name, std::vector<std::string> parameters,
                                      Expression formula) {
  refused_.erase(name);
  user_functions_.insert_or_assign(
      name,
      UserFunction{std::move(parameters), std::make_shared<const Expression>(std::move(formula))});
}

void ExpressionScope::refuse(const std::string& name, std::string reason) {
  names_.erase(name);
  functions_.erase(name);
  user_functions_.erase(name);
  refused_.insert_or_assign(name, std::move(reason));
}

bool ExpressionScope::has_function(const std::string& name) const {
  const OperationRow* row = find_operation(std::string_view(name));
  return functions_.contains(name) || user_functions_.contains(name) || (row && is_name(name));
}

std::vector<std::string> ExpressionScope::names() const {
  std::vector<std::string> names = {"pi"};
  for (const auto& [name, meaning] : names_) names.push_back(name);
  return names;
}

std::vector<std::string> ExpressionScope::functions() const {
  std::vector<std::string> names;
  for (const OperationRow& row : operation_table)
    if (is_name(row.name)) names.emplace_back(row.name);
  for (const auto& [name, function] : functions_) names.push_back(name);
  for (const auto& [name, function] : user_functions_) names.push_back(name);
  return names;
}

ExpressionScope coordinate_scope(int dimension) {
  if (dimension < 1 || dimension > 3) throw InvalidArgument("the dimension is 1, 2 or 3");
  ExpressionScope scope;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, axes[axis]);
    if (axis < dimension)
      scope.define(name, coordinate(axis));
    else
      scope.refuse(name, "does not exist in dimension " + std::to_string(dimension));
  }
  scope.define("t", time_coordinate());
  return scope;
}

void define_derivatives(ExpressionScope& scope, int dimension) {
  scope.define_function(
      "grad", {1, 1, [dimension](std::span<const ExpressionArgument> arguments) {
                 return ExpressionValue(gradient(scalar_argument(arguments[0], "grad"), dimension));
               }});
  scope.define_function(
      "laplacian",
      {1, 1, [dimension](std::span<const ExpressionArgument> arguments) -> ExpressionValue {
         return laplacian(scalar_argument(arguments[0], "laplacian"), dimension);
       }});
  define_partials(scope, "d", dimension);
}

bool is_reserved_in_expressions(std::string_view name) {
  for (const std::string_view word : {"pi", "grad", "laplacian", "omega", "table", "test"})
    if (name == word) return true;
  return !derivative_axes(name).empty() || (find_operation(name) && is_name(name));
}

}  // namespace rfm
