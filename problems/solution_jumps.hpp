#pragma once

#include <string>

#include "problems/scalar_problem.hpp"

namespace rfm {

/// Whether a formula has operations of the solution, as symbols, that jump or have corners.
bool jumps_with_symbols(const Field& formula);

/// Where equations have operations of the solution that jump or have corners, as `if(u > 1, 2, 3)`
/// and |u|: "source (plate.yaml:7:20), energy (plate.yaml:8:11)", or nothing. Where the solution
/// takes the very value over a part of the domain, the equations need not hold anywhere, and
/// Newton's method finds none.
std::string jumps_with_solution(const ScalarProblem& problem);

}  // namespace rfm
