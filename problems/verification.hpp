#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "problems/scalar_problem.hpp"

namespace rfm {

/// Errors of a solution against an exact one, by a rule with more points than the solve's.
struct SolutionErrors {
  double l2 = 0, l2_relative = 0;
  double h1 = 0, h1_relative = 0;  ///< of the gradient
  double maximum = 0;              ///< over all volume and boundary points
  /// Of the norm called L2, H1 or max in problem files. Throws `InvalidArgument` for other names.
  double by_name(const std::string& norm) const;
};

/// The errors of the unknowns whose exact solution is known, by name, and those of all of them as
/// one vector, by Euclidean sum (the largest, for `maximum`).
struct ErrorReport {
  std::vector<std::pair<std::string, SolutionErrors>> by_unknown;
  SolutionErrors all;
};

/// Nothing where no exact solution is known. Relative errors of a solution that vanishes are
/// absolute.
std::optional<ErrorReport> solution_errors(const ScalarProblem& problem, const Grid& grid,
                                           const ScalarSolution& solution);

/// A solve of a convergence study.
struct ConvergenceRow {
  int cells = 0;
  int unknowns = 0;
  std::optional<SolutionErrors> errors;
  /// Change of u from the grid before, in L2 relative to u, where there is no exact solution.
  std::optional<double> change;
  /// The largest relative error of the eigenvalues where the exact ones are known.
  std::optional<double> eigenvalue_error{};

  /// The error called L2, H1, max or eigenvalues in problem files, if it is known.
  std::optional<double> error(const std::string& norm) const;
};

/// The observed order between two rows: log(e₁/e₂) / log(cells₂/cells₁).
double observed_order(double coarse_error, double fine_error, int coarse_cells, int fine_cells);

/// What an expectation came to.
struct ExpectationResult {
  std::string quantity;
  double value = 0;
  double expected = 0;
  double relative_error = 0;  ///< absolute where 0 is expected
  bool ok = false;
};

/// Looks a quantity up in a summary: `probes.centre.grad(u)[1]`. Paths match the longest key. Empty
/// if there is no such number.
std::optional<double> find_quantity(const nlohmann::ordered_json& summary, const std::string& path);

/// Holds an expectation against a value. With both tolerances either suffices. NaN never satisfies.
ExpectationResult check(const Expectation& expectation, double value);

}  // namespace rfm
