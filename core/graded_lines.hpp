#pragma once

#include <vector>

namespace rfm {

/// Where grid lines of an axis lie closer: cells there are `finer` times smaller than those farther
/// away than `within`, and their size changes linearly in between, min(1, 1/finer + (1 −
/// 1/finer) · distance/within).
struct LineGrading {
  std::vector<double> toward;  ///< one place, or several
  double finer = 8;
  double within = 1;
};

/// cells + 1 lines from `low` to `high`, with cells whose sizes are in the ratio that `grading`
/// asks for: x(i / cells) with the inverse of ξ(x) = ∫ dx / size, which is known in closed form.
/// More cells divide the same ξ: orders of convergence are those of equal cells. Throws
/// `InvalidArgument` unless low < high, cells ≥ 1, finer ≥ 1 and within > 0.
std::vector<double> graded_lines(double low, double high, int cells, const LineGrading& grading);

/// Each interval between neighbouring lines divided into `parts` equal ones.
std::vector<double> divided_lines(const std::vector<double>& lines, int parts);

}  // namespace rfm
