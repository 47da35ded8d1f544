#include <algorithm>

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/expression_tokens.hpp"

namespace rfm {
namespace {

constexpr std::string_view axes = "xyz";

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

void ExpressionScope::define_parameter(const std::string& name, double value) {
  if (parameters_.contains(name))
    parameters_.set(name, value);
  else
    parameters_.add(name, value);
  define(name, parameters_[name]);
}

void ExpressionScope::define_function(const std::string& name, ExpressionFunction function) {
  refused_.erase(name);
  functions_.insert_or_assign(name, std::move(function));
}

void ExpressionScope::define_function(const std::string& name, std::vector<std::string> arguments,
                                      Expression formula) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool again = std::find(arguments.begin(), arguments.begin() + static_cast<long>(i),
                                 arguments[i]) != arguments.begin() + static_cast<long>(i);
    if (again || !is_name(arguments[i]))
      throw InvalidArgument("the arguments of " + name + " must be different names, got '" +
                            arguments[i] + (again ? "' twice" : "'"));
  }
  refused_.erase(name);
  user_functions_.insert_or_assign(
      name,
      UserFunction{std::move(arguments), std::make_shared<const Expression>(std::move(formula))});
}

void ExpressionScope::refuse(const std::string& name, std::string reason) {
  names_.erase(name);
  functions_.erase(name);
  user_functions_.erase(name);
  refused_.insert_or_assign(name, std::move(reason));
}

bool ExpressionScope::has_function(const std::string& name) const {
  const OperationRow* row = find_operation(std::string_view(name));
  return functions_.contains(name) || user_functions_.contains(name) || (row && is_name(name)) ||
         is_partial(name);
}

bool ExpressionScope::is_partial(std::string_view name) const {
  const std::vector<int> along = derivative_axes(name);
  return partials_ > 0 && !along.empty() &&
         std::ranges::all_of(along, [&](int axis) { return axis < partials_ || axis == 3; });
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
  for (int first = 0; first < partials_; ++first) {
    names.push_back(std::string("d") + axes[static_cast<std::size_t>(first)]);
    for (int second = 0; second < partials_; ++second)
      names.push_back(names.back().substr(0, 2) + axes[static_cast<std::size_t>(second)]);
  }
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

}  // namespace rfm
