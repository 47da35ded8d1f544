#pragma once

#include <cstdint>

namespace rfm {

/// What a thread has done for quadrature, in steps of about ten nanoseconds: crossings of lines
/// found and surfaces bounded, each weighted by the size of its expression. Budgets are differences
/// of this counter: unlike times they are the same in every run and on every machine.
constinit inline thread_local std::int64_t work_done = 0;

/// What a surface costs: one step for closed forms, else the operations of its expression.
struct WorkCost {
  int crossing = 3;
  int bounds = 5;

  static WorkCost of_operations(int count) { return {count, 10 * count}; }
};

}  // namespace rfm
