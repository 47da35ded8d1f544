#pragma once

#include <initializer_list>
#include <vector>

#include "core/tape_polynomial.hpp"
#include "core/tape_program.hpp"

namespace rfm {

/// Appends steps to a program, each with the constants that its kernel reads. The constants of all
/// steps lie in one list that grows: steps point into it when the last one is made.
class StepWriter {
 public:
  explicit StepWriter(Tape::Program& program) : program_(program) {}

  Step& push(Step step, std::initializer_list<double> constants);
  /// Further constants of the last step.
  void add_constants(std::initializer_list<double> constants);
  void finish();

 private:
  Tape::Program& program_;
  std::vector<int> first_constant_;  // of each step
};

/// The step that computes a sum of terms of one coordinate each, and with `slopes` its gradient, in
/// the rows from `result` on.
void add_sum(StepWriter& steps, const Polynomial& p, int result, bool slopes, int dimension);
/// The step that computes the gradient of a polynomial.
void add_gradient(StepWriter& steps, const Polynomial& p, int result, int dimension);

}  // namespace rfm
