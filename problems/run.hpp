#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/run_log.hpp"

namespace rfm {

struct RunOptions {
  std::vector<std::string> overrides;  ///< path=value
  std::string output;                  ///< the folder of the result
  bool verify = true;
  /// Grids in all, each with twice the cells of the one before; 1 is the file's own.
  int converge = 1;
  bool picture = false;  ///< draw what outputs.picture asks for, or u
  bool json = false;     ///< print summary.json instead of the log
  bool quiet = false;
};

/// Solves one problem file and writes its result folder. Returns the exit status: 0, or 1 where an
/// expectation or an order is missed. Throws `ProblemFileErrors` (exit status 2, nothing written)
/// and `ComputationError` (3, nothing written).
int run_problem(const std::string& file, const RunOptions& options);

}  // namespace rfm
