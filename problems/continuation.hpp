#pragma once

#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace rfm {

/// The problem of a file with another value of one of its parameters, on the way to the file's own
/// (`discretization.solver.continuation`).
struct ContinuationStop {
  std::string name;  ///< "load = 0.5"
  Problem problem;
};

/// The stops of a problem in their order; none where it has no continuation.
std::vector<ContinuationStop> continuation_stops(const Problem& problem);

}  // namespace rfm
