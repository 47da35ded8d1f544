#pragma once

#include <string>
#include <vector>

namespace rfm {

struct CheckOptions {
  std::vector<std::string> overrides;  ///< path=value
  bool picture = false;                ///< draw the domain into `output`
  std::string output;                  ///< the folder of the picture, NAME.check.png
};

/// `rfm-solve check`: reads a file, and reports the domain, the pieces of its boundary with their
/// conditions, the structure, and how many unknowns a solve would have. Does not solve, and writes
/// nothing but the picture. Returns 0. Throws `ProblemFileErrors`.
int check_problem(const std::string& file, const CheckOptions& options);

}  // namespace rfm
