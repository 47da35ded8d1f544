#include "problems/solution_symbols.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "solvers/form_symbols.hpp"

namespace rfm {

void define_symbols(ExpressionScope& scope, const std::vector<std::string>& unknowns,
                    int dimension) {
  for (std::size_t c = 0; c < unknowns.size(); ++c)
    scope.define(unknowns[c], unknown_symbol(static_cast<int>(c), dimension));
}

void define_tests(ExpressionScope& scope, const std::vector<std::string>& unknowns, int dimension) {
  scope.define_function(
      "test", {.call =
                   [unknowns, dimension](std::span<const ExpressionArgument> arguments) {
                     const ExpressionArgument& name = arguments[0];
                     const auto found = std::ranges::find(unknowns, name.text);
                     if (found == unknowns.end())
                       throw InputError(
                           "test takes the name of an unknown" + did_you_mean(name.text, unknowns),
                           name.offset, name.length);
                     return ExpressionValue(
                         test_symbol(static_cast<int>(found - unknowns.begin()), dimension));
                   },
               .takes_names = true});
}

}  // namespace rfm
