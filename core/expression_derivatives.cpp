
#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/expression_tokens.hpp"
#include "core/graph_derivative.hpp"

namespace rfm {
namespace {

constexpr std::size_t most_letters = 8;

const Field& scalar_argument(const ExpressionArgument& argument, const std::string& function) {
  if (argument.value.is_vector)
    throw InputError(function + " takes a function, not a vector: choose a component with [0]",
                     argument.offset, argument.length);
  return argument.value.components[0];
}

// d(f, p).
ExpressionValue derivative(std::span<const ExpressionArgument> arguments) {
  const Field& f = scalar_argument(arguments[0], "d");
  const ExpressionArgument& by = arguments[1];
  const Field::Node& variable = by.value.components[0].node();
  if (!by.value.is_vector && variable.operation == Operation::coordinate)
    return partial(f, variable.index);
  if (by.value.is_vector || variable.operation != Operation::parameter)
    throw InputError("the second argument of d must be a parameter or a coordinate", by.offset,
                     by.length);
  return derivative_with_respect_to(f, by.value.components[0]);
}

}  // namespace

std::vector<int> derivative_axes(std::string_view name) {
  if (name.size() < 2 || name.size() > most_letters + 1 || name[0] != 'd') return {};
  std::vector<int> along;
  for (const char letter : name.substr(1)) {
    const std::size_t axis = std::string_view("xyzt").find(letter);
    if (axis == std::string_view::npos) return {};
    along.push_back(static_cast<int>(axis));
  }
  return along;
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
  scope.define_function("d", {2, 2, derivative});
  scope.define_partials(dimension);
}

bool is_reserved_in_expressions(std::string_view name) {
  for (const std::string_view word : {"pi", "grad", "laplacian", "omega", "table", "test"})
    if (name == word) return true;
  const bool along_space = !derivative_axes(name).empty() && name.find('t') == name.npos;
  return along_space || (find_operation(name) && is_name(name));
}

}  // namespace rfm
