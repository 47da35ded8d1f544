#pragma once

#include <string>
#include <vector>

#include "problems/reader.hpp"
#include "problems/scalar_problem.hpp"
#include "solvers/integrate.hpp"

namespace rfm::test {

/// The solution of a problem file given as text, on its own grid.
inline ScalarSolution solved(const std::string& text,
                             const std::vector<std::string>& overrides = {}) {
  const Problem file = read_problem(make_source("case.yaml", text), overrides);
  const ScalarProblem problem(file);
  return problem.solve(problem.grid());
}

/// How far two solutions of one unknown are apart at most, relative to the second.
inline double difference(const ScalarSolution& a, const ScalarSolution& b) {
  const Field& own = a.results.unknowns[0].field;
  const Field& other = b.results.unknowns[0].field;
  return norms(own - other, a.rule).maximum / norms(other, a.rule).maximum;
}

}  // namespace rfm::test
