#pragma once

#include <span>

#include "solvers/linear_solver.hpp"

namespace rfm {

/// Solves a system block after block: the first as if there were no others, each further one with
/// those before it fixed. Block i holds the coefficients from `first[i]` to `first[i + 1]` − 1. So
/// what is fine is found where what is coarse is known already (one sweep of the method of Gauss
/// and Seidel); the energy falls with every block, not to its least. Reports what `solve` does for
/// the first block, and the largest residual of any block's own equations.
LinearSolution solve_in_turn(const LinearSystem& system, std::span<const Eigen::Index> first,
                             const LinearSolverOptions& options = {});

}  // namespace rfm
