#pragma once

#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace rfm {

/// Reads and checks a problem file, after setting `overrides` ("path=value", as of `--set`).
/// Throws `ProblemFileErrors` with every mistake found, in the file's order. What depends on the
/// shape of the domain remains to be checked: see boundary_coverage.hpp.
///
/// Problems that this one takes results from (`{from: other.yaml, field: u}`) are read and solved,
/// too; `files` are those that wait for this one, which is the last of them.
Problem read_problem(const std::string& path, const std::vector<std::string>& overrides = {},
                     const std::vector<std::string>& files = {});

/// The same for a text in memory.
Problem read_problem(std::shared_ptr<const SourceText> source,
                     const std::vector<std::string>& overrides = {},
                     const std::vector<std::string>& files = {});

}  // namespace rfm
