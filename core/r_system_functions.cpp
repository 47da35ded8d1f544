#include "core/r_system_functions.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/r_functions.hpp"

namespace rfm {
namespace {

using Arguments = std::span<const ExpressionArgument>;

const Field& function(const ExpressionArgument& argument) {
  if (argument.value.is_vector)
    throw InputError("an R-function takes functions, not a vector: choose a component with [0]",
                     argument.offset, argument.length);
  return argument.value.components[0];
}

int order(const ExpressionArgument& argument) {
  const Field& field = function(argument);
  const double m = field.is_constant() ? field.constant() : NAN;
  if (!(m >= 1 && m <= 16 && m == std::floor(m)))
    throw InputError("the order m must be a whole number from 1 to 16", argument.offset,
                     argument.length);
  return static_cast<int>(m);
}

double alpha(const ExpressionArgument& argument) {
  const Field& field = function(argument);
  const double value = field.is_constant() ? field.constant() : NAN;
  if (const std::string expected = objection_to_number(Operation::ralpha_conjunction, value);
      !expected.empty())
    throw InputError("alpha must be " + expected, argument.offset, argument.length);
  return value;
}

void define(ExpressionScope& scope, const std::string& name, std::size_t parameters,
            const std::function<RSystem(Arguments)>& system) {
  const auto define_one = [&](const std::string& suffix, auto operation) {
    scope.define_function(
        name + suffix,
        {2 + parameters, 2 + parameters, [system, operation](Arguments a) -> ExpressionValue {
           return operation(function(a[0]), function(a[1]), system(a.subspan(2)));
         }});
  };
  define_one("_and",
             [](const Field& x, const Field& y, const RSystem& s) { return conjunction(x, y, s); });
  define_one("_or",
             [](const Field& x, const Field& y, const RSystem& s) { return disjunction(x, y, s); });
}

}  // namespace

void define_r_functions(ExpressionScope& scope) {
  define(scope, "r0m", 1, [](Arguments a) { return RAlphaM{0, order(a[0])}; });
  define(scope, "ralpham", 2, [](Arguments a) { return RAlphaM{alpha(a[0]), order(a[1])}; });
  define(scope, "rcm", 1, [](Arguments a) { return RCm{order(a[0])}; });
  define(scope, "ralpha_field", 1, [](Arguments a) {
    if (function(a[0]).is_constant()) alpha(a[0]);
    return RAlphaField{function(a[0])};
  });
}

}  // namespace rfm
