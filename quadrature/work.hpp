#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rfm {

/// What a thread has done for quadrature, in steps of about ten nanoseconds: crossings of lines
/// found and surfaces bounded, each weighted by the size of its expression, and points made.
/// Budgets are differences of this counter: unlike times they are the same in every run and on
/// every machine.
constinit inline thread_local std::int64_t work_done = 0;

/// Where searches give up that may go on for long: a value of `work_done`.
constinit inline thread_local std::int64_t last_work = std::numeric_limits<std::int64_t>::max();

/// Sets `last_work` as long as it lives.
class WorkLimit {
 public:
  explicit WorkLimit(std::int64_t work) : before_(last_work) {
    last_work = std::min(before_, work_done + work);
  }
  ~WorkLimit() { last_work = before_; }
  WorkLimit(const WorkLimit&) = delete;
  WorkLimit& operator=(const WorkLimit&) = delete;

 private:
  std::int64_t before_;
};

/// What a surface costs: one step for closed forms, else the operations of its expression.
struct WorkCost {
  int crossing = 3;
  int bounds = 8;

  static WorkCost of_operations(int count) { return {count, 6 * count}; }
};

}  // namespace rfm
