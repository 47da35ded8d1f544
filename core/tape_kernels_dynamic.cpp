#include "core/composed_source.hpp"
#include "core/tape_kernels.hpp"

namespace rfm {
namespace {

using DynamicKernels = Kernels<run_time, run_time>;
using Shape = DynamicKernels::Shape;

}  // namespace

void evaluate_composed_source(const Instruction& instruction, const Step& step, double* memory,
                              int count) {
  const FieldSource& source = *instruction.source;
  const MultiIndex alpha = source_derivative(instruction.index);
  const Shape shape(step);
  const int axes = source.valid().dimension;
  const Shape outer_shape(JetShape::get(axes, shape.order() + degree(alpha)));
  std::array<double, 3 * Tape::block_size> places;
  std::array<const double*, 3> coordinates{};
  for (int axis = 0; axis < axes; ++axis) {
    const Part& value = step.arguments[axis].value;
    double* const row = places.data() + axis * Tape::block_size;
    for (int lane = 0; lane < count; ++lane)
      row[lane] = memory[value.offset() + lane * value.stride()];
    coordinates[axis] = row;
  }
  std::vector<double> jets(static_cast<std::size_t>(outer_shape.size()) * Tape::block_size);
  source.evaluate(coordinates, count, axes, outer_shape.order(), jets.data(), Tape::block_size);
  std::vector<DynamicJet<Batch>> place(axes);
  for (int lane = 0; lane < count; lane += DynamicKernels::width) {
    for (int axis = 0; axis < axes; ++axis)
      place[axis] = DynamicKernels::load(shape, step.arguments[axis], memory, lane);
    const Register outer = Register::dense(0, axes);
    DynamicKernels::store(
        shape,
        compose_outer<Batch>(
            shape.shape, DynamicKernels::load(outer_shape, outer, jets.data(), lane), alpha, place),
        memory + step.result + lane);
  }
}

Kernel find_dynamic_kernel(Operation operation) { return DynamicKernels::find<-1>(operation); }

}  // namespace rfm
