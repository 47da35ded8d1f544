#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/core/operation_truth.hpp"

namespace rfm {

using Arguments = std::array<double, 3>;

/// A way to compute the Taylor coefficients of an operation, the arguments of which are functions
/// of some variables as an `ArgumentShape` says, at points where they have given values.
struct Evaluator {
  std::string name;
  /// Whether it computes the operation for such arguments.
  std::function<bool(const Row&, const ArgumentShape&)> serves;
  /// The coefficients for each point.
  std::function<std::vector<std::vector<double>>(const Row&, const ArgumentShape&,
                                                 const std::vector<Arguments>&)>
      jets;
  /// Whether coefficients are accurate with respect to the largest of their degree only.
  bool shares_rounding = false;
};

/// All that the engine has: tapes at single points and in blocks, by compiled kernels and by those
/// of run-time order, tapes specialised to a box, the program for single points, and the node by
/// node derivatives of slots.
const std::vector<Evaluator>& all_evaluators();

}  // namespace rfm
