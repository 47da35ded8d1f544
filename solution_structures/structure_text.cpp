#include "solution_structures/structure_text.hpp"

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/expression_text.hpp"
#include "solution_structures/structure_formula.hpp"
#include "solution_structures/transfinite.hpp"
#include "solution_structures/undetermined.hpp"

namespace rfm {
namespace {

constexpr int most_arguments = 300;  // 100 sets
constexpr int most_functions = 64;   // as of `Structure::undetermined`

std::string call_text(const Structure::Call& call, const ExpressionTextOptions& options) {
  std::string text = call.function + "(";
  for (std::size_t i = 0; i < call.arguments.size(); ++i)
    text += (i > 0 ? ", " : "") + to_text(call.arguments[i], options);
  return text + ")";
}

const Field& scalar(const ExpressionArgument& argument) {
  if (argument.value.is_vector)
    throw InputError("a number is needed here, not a vector: choose a component with [0]",
                     argument.offset, argument.length);
  return argument.value.components[0];
}

const Field& known(const ExpressionArgument& argument) {
  const Field& value = scalar(argument);
  if (has_undetermined(value))
    throw InputError("this must not depend on undetermined functions", argument.offset,
                     argument.length);
  return value;
}

Field call_transfinite(std::span<const ExpressionArgument> arguments) {
  if (arguments.size() % 3 != 0)
    throw InputError("transfinite takes three arguments for each set: value, omega, exponent",
                     arguments.back().offset, arguments.back().length);
  std::vector<TransfiniteDatum> data;
  for (std::size_t i = 0; i < arguments.size(); i += 3) {
    const Field& exponent = known(arguments[i + 2]);
    const double mu = exponent.is_constant() ? exponent.constant() : 0;
    if (!(mu >= 1 && mu <= 64 && mu == static_cast<int>(mu)))
      throw InputError("an exponent is a whole number from 1 to 64", arguments[i + 2].offset,
                       arguments[i + 2].length);
    data.push_back({scalar(arguments[i]), known(arguments[i + 1]), static_cast<int>(mu)});
  }
  return transfinite_interpolant(data);
}

}  // namespace

std::string to_text(const Structure& structure, const StructureNames& names) {
  ExpressionTextOptions options;
  options.names = names;
  // Also those whose terms cancel are in the formula.
  for (int k = 0; k < most_functions; ++k)
    options.names.emplace_back("psi" + std::to_string(k + 1), undetermined_function(k));
  for (const Structure::Call& call : structure.calls())
    options.names.emplace_back(call_text(call, options), call.value);
  return to_text(structure.formula(), options);
}

void define_structures(ExpressionScope& scope, int dimension, int unknowns) {
  define_derivatives(scope, dimension);
  if (unknowns == 1) scope.define("psi", undetermined_function(0));
  for (int k = 0; k < unknowns; ++k)
    scope.define("psi" + std::to_string(k + 1), undetermined_function(k));
  scope.define_function("D", {2, 2, [dimension](std::span<const ExpressionArgument> arguments) {
                                return ExpressionValue(inward_derivative(
                                    scalar(arguments[1]), known(arguments[0]), dimension));
                              }});
  scope.define_function(
      "normalizer",
      {2, 2, [dimension](std::span<const ExpressionArgument> arguments) {
         return ExpressionValue(normalizer(known(arguments[0]), known(arguments[1]), dimension));
       }});
  scope.define_function("transfinite",
                        {3, most_arguments, [](std::span<const ExpressionArgument> arguments) {
                           return ExpressionValue(call_transfinite(arguments));
                         }});
}

Structure to_structure(const Expression& text, const ExpressionScope& scope) {
  const Field formula = to_field(text, scope);
  try {
    return structure_of(formula);
  } catch (const InvalidArgument& mistake) {
    throw InputError(mistake.what(), 0, text.text().size());
  }
}

}  // namespace rfm
