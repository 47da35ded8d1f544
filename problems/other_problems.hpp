#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "problems/document.hpp"

namespace rfm {

/// Results of other problem files, which are solved when first asked for: `{from: other.yaml,
/// field: u}`, the field being a formula of that problem's results. Files are named relative to the
/// folder of the file that asks, and lie in it.
class OtherProblems {
 public:
  /// `files` are being read, each asked for by the one before it; the last one asks here.
  OtherProblems(std::vector<std::string> files, int dimension);
  ~OtherProblems();

  /// The field that a map asks for. It exists in the domain of that problem only. Throws
  /// `ProblemFileErrors` where the file or the result is wrong, a file would need itself, or the
  /// dimensions differ, and `ComputationError` if that problem has no solution.
  Field result(const DocumentNode& map);

 private:
  struct Solved;
  const Solved& solved(const DocumentNode& from);

  std::vector<std::string> files_;
  int dimension_;
  std::map<std::string, std::unique_ptr<const Solved>> solved_;
};

}  // namespace rfm
