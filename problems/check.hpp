#pragma once

#include <string>
#include <vector>

namespace rfm {

/// `rfm-solve check`: reads a file, and reports the domain, the pieces of its boundary with their
/// conditions, the structure, and how many unknowns a solve would have. Solves and writes nothing.
/// Returns 0. Throws `ProblemFileErrors`.
int check_problem(const std::string& file, const std::vector<std::string>& overrides);

}  // namespace rfm
