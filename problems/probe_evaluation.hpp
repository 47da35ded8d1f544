#pragma once

#include <string>
#include <vector>

#include "problems/scalar_problem.hpp"

namespace rfm {

/// A value of a probe: one number, or a vector.
struct ProbeValue {
  std::string name;  ///< the text as written, or the name given to it; empty for a single number
  std::vector<double> components;
  bool is_vector = false;
};

/// What a probe gave.
struct ProbeResult {
  const Probe* probe = nullptr;
  /// Values of point probes, one per expression; of integrals, averages and extremes, one number.
  std::vector<ProbeValue> values;
  /// Of line probes: the points, and for each the values.
  std::vector<Point> line_points;
  std::vector<std::vector<ProbeValue>> line_values;
  /// Where an extreme is attained.
  Point at{};
};

/// Evaluates all probes of a problem. Throws `ProblemFileErrors` for a point outside the domain
/// (within 10⁻⁹ of its size counts as inside), `ComputationError` where a value is not finite.
std::vector<ProbeResult> evaluate_probes(const ScalarProblem& problem,
                                         const ScalarSolution& solution);

}  // namespace rfm
