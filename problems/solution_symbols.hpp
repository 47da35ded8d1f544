#pragma once

#include <string>
#include <vector>

#include "core/expression.hpp"

namespace rfm {

/// Adds the unknowns as symbols of forms (solvers/form_symbols.hpp), for formulas that are part of
/// the equations: coefficients that depend on the solution, energies, residuals and weak forms.
/// Symbols of one component are the same field wherever they are defined, so that formulas agree.
void define_symbols(ExpressionScope& scope, const std::vector<std::string>& unknowns,
                    int dimension);
/// Adds test(u), the test function of an unknown.
void define_tests(ExpressionScope& scope, const std::vector<std::string>& unknowns, int dimension);

}  // namespace rfm
