#pragma once

#include <optional>
#include <vector>

#include "problems/scalar_problem.hpp"
#include "solvers/form.hpp"

namespace rfm {

/// Whether a problem is solved by forms (solvers/form.hpp): custom physics, coefficients that
/// contain the solution, advection, and every method but Ritz's. The others have quadratic
/// energies, whose data need no derivation.
bool uses_forms(const ScalarProblem& problem);

/// The degree of the splines of an undetermined function: that of its unknown or window, of further
/// functions that of the file.
int function_degree(const ScalarProblem& problem, int function);

/// Throws `ProblemFileErrors` where splines have fewer derivatives than equations with those of the
/// unknowns up to `orders` take through the structures on a grid, which contain derivatives, too.
void require_degrees(const ScalarProblem& problem, const Grid& grid,
                     const std::vector<int>& orders);

/// The equations of such a problem on a grid, that of the volume first; values that are enforced
/// weakly are among them. Throws `ProblemFileErrors` where an equation cannot have such values or
/// splines have too few derivatives.
std::vector<Form> problem_forms(const ScalarProblem& problem, const Grid& grid);

/// The user's energy without its loads; of a scalar equation ½ ∫ (∇u·K∇u + reaction u²); nothing
/// where there is none.
std::optional<double> energy_of_forms(const ScalarProblem& problem, const ScalarSolution& solution);

/// Throws `ProblemFileErrors` for a method that custom physics do not have.
void check_method(const Problem& problem);

}  // namespace rfm
