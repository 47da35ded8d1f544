#pragma once

#include "core/quadric_evaluator.hpp"
#include "core/taylor_bound.hpp"

namespace rfm {

/// A quadric and its slopes over a box as models of first order about its centre, in closed form:
/// what operation by operation gives, at a tenth of the cost, with the exact range (but for mixed
/// terms) beside it. The frame in force must be that of the box.
struct QuadricModel {
  QuadricModel(const QuadricEvaluator& quadric, const Box& box);

  TaylorBound value;
  std::array<TaylorBound, 3> slopes;
};

}  // namespace rfm
