#include "core/composed_source.hpp"
#include "core/operation_rules.hpp"
#include "core/tape_program.hpp"

namespace rfm {
namespace {

// Kernels for any number of variables and any order, known from the step: the rules are
// those of the compiled kernels.

using BatchJet = DynamicJet<Batch>;
constexpr int width = static_cast<int>(Batch::size());
constexpr int block = Tape::block_size;

const JetShape& shape_of(const Step& step) { return JetShape::get(step.variables, step.order); }

BatchJet load(const JetShape& shape, const Register& from, const double* memory, int lane) {
  BatchJet jet(shape);
  const auto read = [&](int first, int last, const Part& part) {
    const double* const place = memory + part.offset() + lane * part.stride();
    for (int i = first; i < last; ++i)
      jet.c[i].copy_from(place + (i - first) * block, std::experimental::element_aligned);
  };
  const int first_order = 1 + shape.variables();
  read(0, 1, from.value);
  if (shape.order() >= 1) read(1, first_order, from.gradient);
  if (shape.order() >= 2) read(first_order, jet.size, from.rest);
  return jet;
}

void store(const BatchJet& jet, const JetShape& shape, double* to) {
  for (int i = 0; i < shape.size(); ++i)
    coefficient(jet, i).copy_to(to + i * block, std::experimental::element_aligned);
}

template <Operation operation, int arity>
void apply(const Step& step, double* memory, int count) {
  const JetShape& shape = shape_of(step);
  const BatchJet none;
  for (int lane = 0; lane < count; lane += width) {
    const BatchJet a = load(shape, step.arguments[0], memory, lane);
    const BatchJet b = arity > 1 ? load(shape, step.arguments[1], memory, lane) : none;
    const BatchJet c = arity > 2 ? load(shape, step.arguments[2], memory, lane) : none;
    store(apply_rule<operation>(a, b, c, *step.constants), shape, memory + step.result + lane);
  }
}

template <class Rule>
void apply_to_one(const Step& step, double* memory, int count, const Rule& rule) {
  const JetShape& shape = shape_of(step);
  for (int lane = 0; lane < count; lane += width)
    store(rule(load(shape, step.arguments[0], memory, lane)), shape, memory + step.result + lane);
}

void scale(const Step& step, double* memory, int count) {
  apply_to_one(step, memory, count,
               [&](const BatchJet& a) { return scaled(Batch(*step.constants), a); });
}

void offset(const Step& step, double* memory, int count) {
  apply_to_one(step, memory, count, [&](BatchJet a) {
    a.c[0] += Batch(*step.constants);
    return a;
  });
}

// The argument has one order more; its coefficients shift down: (∂ᵢf)_α = (αᵢ + 1) f_{α+eᵢ}.
void partial(const Step& step, double* memory, int count) {
  const JetShape& shape = shape_of(step);
  for (int i = 0; i < shape.size(); ++i) {
    const double factor = shape.exponent(i)[step.index] + 1.0;
    int index = shape.raised(step.index, i);
    const Part part = step.arguments[0].part_of(index, shape.variables());
    const double* const from = memory + part.offset() + index * block;
    double* const to = memory + step.result + i * block;
    for (int lane = 0; lane < count; ++lane) to[lane] = factor * from[lane * part.stride()];
  }
}

}  // namespace

void evaluate_composed_source(const Instruction& instruction, const Step& step, double* memory,
                              int count) {
  const FieldSource& source = *instruction.source;
  const MultiIndex alpha = source_derivative(instruction.index);
  const JetShape& shape = shape_of(step);
  const int axes = source.valid().dimension;
  const JetShape& outer_shape = JetShape::get(axes, shape.order() + degree(alpha));
  std::array<double, 3 * block> places;
  std::array<const double*, 3> coordinates{};
  for (int axis = 0; axis < axes; ++axis) {
    const Part& value = step.arguments[axis].value;
    double* const row = places.data() + axis * block;
    for (int lane = 0; lane < count; ++lane)
      row[lane] = memory[value.offset() + lane * value.stride()];
    coordinates[axis] = row;
  }
  std::vector<double> jets(static_cast<std::size_t>(outer_shape.size()) * block);
  source.evaluate(coordinates, count, axes, outer_shape.order(), jets.data(), block);
  std::vector<BatchJet> place(axes);
  for (int lane = 0; lane < count; lane += width) {
    for (int axis = 0; axis < axes; ++axis)
      place[axis] = load(shape, step.arguments[axis], memory, lane);
    const Register outer = Register::dense(0, axes);
    store(compose_outer<Batch>(shape, load(outer_shape, outer, jets.data(), lane), alpha, place),
          shape, memory + step.result + lane);
  }
}

Kernel find_dynamic_kernel(Operation operation) {
  switch (operation) {
    case Operation::scale:
      return scale;
    case Operation::offset:
      return offset;
    case Operation::partial:
      return partial;
#define RFM_KERNEL(id, name, arity, ...) \
  case Operation::id:                    \
    return apply<Operation::id, arity>;
      RFM_OPERATIONS(RFM_KERNEL)
#undef RFM_KERNEL
    default:
      return nullptr;
  }
}

}  // namespace rfm
