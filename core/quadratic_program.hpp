#pragma once

#include <vector>

#include "core/quadratic_bound.hpp"

namespace rfm {

/// A condition slope · d + value ≥ 0.
struct LinearCondition {
  QuadraticModel::Vector<double> slope{};
  double value = 0;
};

struct QuadraticMinimum {
  QuadraticModel::Vector<double> step{};
  std::vector<double> multipliers;  ///< ≥ 0, one for each condition; 0 where it does not bind
};

/// The minimum of ½ dᵀ M d + g·d, M = LLᵀ given by `cholesky`, under a few linear conditions: its
/// dual min ½ λᵀGλ − hᵀλ, λ ≥ 0 by the method of active sets (Lawson and Hanson 1974, chapter 23).
/// Conditions that contradict each other give what the method found last.
QuadraticMinimum constrained_minimum(const ShiftedCholesky& cholesky,
                                     const QuadraticModel::Vector<double>& gradient, int size,
                                     const std::vector<LinearCondition>& conditions);

}  // namespace rfm
