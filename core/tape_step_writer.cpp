#include "core/tape_step_writer.hpp"

#include <algorithm>

namespace rfm {
namespace {

Part coordinate_rows(int axis) { return Part::varying(axis * Tape::block_size); }

}  // namespace

Step& StepWriter::push(Step step, std::initializer_list<double> constants) {
  first_constant_.push_back(static_cast<int>(program_.step_constants.size()));
  program_.steps.push_back(step);
  add_constants(constants);
  return program_.steps.back();
}

void StepWriter::add_constants(std::initializer_list<double> constants) {
  program_.step_constants.insert(program_.step_constants.end(), constants);
}

void StepWriter::finish() {
  for (std::size_t i = 0; i < program_.steps.size(); ++i)
    program_.steps[i].constants = program_.step_constants.data() + first_constant_[i];
}

void add_sum(StepWriter& steps, const Polynomial& p, int result, bool slopes, int dimension) {
  const Polynomial::Sum& sum = p.sum;
  Step& step = steps.push({}, {sum.scale, sum.first, sum.last});
  step.result = result;
  if (p.is_affine() || sum.count == 0) {
    step.kernel = affine_kernel(sum.count);
    for (int k = 0; k < sum.count; ++k) {
      step.arguments[k].value = coordinate_rows(sum.axis[k]);
      steps.add_constants({sum.factor[k], p.origin[sum.axis[k]]});
    }
    return;
  }
  step.kernel = quadratic_sum_kernel(dimension, slopes);
  std::array<int, 3> order = sum.axis;
  int count = sum.count;
  for (int axis = 0; axis < dimension; ++axis)
    if (std::find(order.begin(), order.begin() + count, axis) == order.begin() + count)
      order[count++] = axis;
  for (int k = 0; k < dimension; ++k) {
    const bool term = k < sum.count;
    const double factor = term ? sum.factor[k] : 0;
    const bool squared = term && sum.squared[k];
    step.arguments[k].value = coordinate_rows(order[k]);
    step.index |= order[k] << (2 * k);
    steps.add_constants({p.origin[order[k]], squared ? 0 : factor, squared ? factor : 0});
  }
}

void add_gradient(StepWriter& steps, const Polynomial& p, int result, int dimension) {
  Step& step = steps.push({}, {});
  step.kernel = quadric_gradient_kernel(dimension);
  step.result = result;
  for (int axis = 0; axis < dimension; ++axis) {
    step.arguments[axis].value = coordinate_rows(axis);
    steps.add_constants({p.origin[axis]});
  }
  for (int a = 0; a < dimension; ++a) {
    steps.add_constants({p.linear[a]});
    for (int b = 0; b < dimension; ++b)
      steps.add_constants({2 * p.square[Polynomial::square_index(a, b)]});
  }
}

}  // namespace rfm
