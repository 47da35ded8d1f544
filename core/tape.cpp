#include "core/tape.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/error.hpp"
#include "core/scalar.hpp"
#include "core/tape_program.hpp"

namespace rfm {

namespace {

constexpr int batch_width = static_cast<int>(Batch::size());
static_assert(Tape::block_size % batch_width == 0);

template <class Function>
auto in_dimension(int dimension, const Function& function) {
  switch (dimension) {
    case 1:
      return function.template operator()<1>();
    case 2:
      return function.template operator()<2>();
    default:
      return function.template operator()<3>();
  }
}

// Rounds a pointer up to the width of a vector register.
double* aligned(double* pointer) {
  constexpr std::uintptr_t alignment = 64;
  const auto address = reinterpret_cast<std::uintptr_t>(pointer);
  return reinterpret_cast<double*>((address + alignment - 1) / alignment * alignment);
}

}  // namespace

Kernel find_kernel(Operation operation, int dimension, int order) {
  return in_dimension(dimension, [&]<int N>() { return find_kernel_in<N>(operation, order); });
}

Tape::Tape(std::vector<Field> roots, std::vector<int> orders, int dimension)
    : roots_(std::move(roots)), orders_(std::move(orders)), dimension_(dimension) {
  if (dimension < 1 || dimension > 3)
    throw InvalidArgument("tapes have 1 to 3 variables, got " + std::to_string(dimension));
  if (orders_.size() == 1) orders_.resize(roots_.size(), orders_[0]);
  if (orders_.size() != roots_.size())
    throw InvalidArgument("a tape needs one order, or one for each root");
  for (const int order : orders_)
    if (order < 0)
      throw InvalidArgument("orders of derivatives start at 0, got " + std::to_string(order));
  program_ = compile(roots_, orders_, dimension_);
}

Tape::Tape(const Tape& general, const Box& box)
    : roots_(general.roots_), orders_(general.orders_), dimension_(general.dimension_) {
  program_ = rfm::specialised(*general.program_, orders_, dimension_, box);
}

Tape Tape::specialised(const Box& box) const { return Tape(*this, box); }

Tape::~Tape() = default;
Tape::Tape(Tape&&) noexcept = default;
Tape& Tape::operator=(Tape&&) noexcept = default;

int Tape::instruction_count() const { return static_cast<int>(program_->instructions.size()); }

const Tape::Program& Tape::with_steps() const {
  std::call_once(program_->has_steps, [this] {
    // Nobody reads the steps before this is done.
    lower(const_cast<Program&>(*program_), orders_, dimension_);
  });
  return *program_;
}

int Tape::step_count() const { return static_cast<int>(with_steps().steps.size()); }

Tape::Workspace::Workspace(const Tape& tape)
    : storage_(static_cast<std::size_t>(tape.with_steps().varying_size) +
               tape.program_->constant_parts.size() + 8),
      data_(aligned(storage_.data())),
      root_offset_(tape.program_->root_offsets) {
  std::ranges::copy(tape.program_->constant_parts, data_ + tape.program_->varying_size);
}

void Tape::evaluate(const PointBlock& points, Workspace& workspace) const {
  if (points.count <= 0) return;
  if (points.count > block_size)
    throw InvalidArgument("a block has at most " + std::to_string(block_size) + " points, got " +
                          std::to_string(points.count));
  double* const memory = workspace.data_;
  // Lanes beyond the last point repeat it, so that kernels always work on whole vectors.
  const int padded = (points.count + batch_width - 1) / batch_width * batch_width;
  const auto pad = [&](double* row) {
    std::fill(row + points.count, row + padded, row[points.count - 1]);
  };
  for (int axis = 0; axis < dimension_; ++axis) {
    double* const row = memory + axis * block_size;
    if (!points.coordinates[axis])
      throw InvalidArgument("a block in " + std::to_string(dimension_) + "D needs coordinate " +
                            std::to_string(axis));
    std::copy_n(points.coordinates[axis], points.count, row);
    pad(row);
  }
  for (const auto& [number, offset] : program_->inputs) {
    const Instruction& input = program_->instructions[number];
    const bool is_time = input.operation == Operation::coordinate;
    if (!is_time && input.index >= static_cast<int>(points.parameters.size()))
      throw InvalidArgument("the field needs parameter number " + std::to_string(input.index) +
                            ", but only " + std::to_string(points.parameters.size()) +
                            " are given");
    std::fill_n(memory + offset, batch_width,
                is_time ? points.time : points.parameters[input.index]);
  }
  for (const Step& step : program_->steps) {
    if (step.kernel) {
      step.kernel(step, memory, padded);
      continue;
    }
    double* const jets = memory + step.result;
    program_->instructions[step.index].source->evaluate(points.coordinates, points.count,
                                                        dimension_, step.order, jets, block_size);
    for (int k = 0; k < jet_size(dimension_, step.order); ++k) pad(jets + k * block_size);
  }
}

FunctionBounds Tape::bounds(const Box& box, int root, double time) const {
  return in_dimension(dimension_,
                      [&]<int N>() { return SinglePoint<N>::bounds(*program_, root, box, time); });
}

Interval Tape::value_bounds(const Box& box, int root, double time) const {
  return in_dimension(dimension_, [&]<int N>() {
    return SinglePoint<N>::value_bounds(*program_, root, box, time);
  });
}

LineBounds Tape::bounds(const Line& line, const Interval& range, int root, double time) const {
  if (orders_[root] < 1)
    throw InvalidArgument("bounds along a line need a tape of first order for the root");
  // Without derivatives in the expression (they need a higher order) the line is the only variable.
  if (program_->highest_order == 1)
    return SinglePoint<1>::bounds(*program_, root, line, range, time);
  return in_dimension(dimension_, [&]<int N>() {
    return SinglePoint<N>::bounds(*program_, root, line, range, time);
  });
}

double Tape::value(const Point& point, int root, double time) const {
  return in_dimension(dimension_, [&]<int N>() {
    return SinglePoint<N>::value(*program_, root, point, time, nullptr);
  });
}

double Tape::value_and_gradient(const Point& point, Point& gradient, int root, double time) const {
  if (orders_[root] < 1)
    throw InvalidArgument("the gradient of a root needs a tape of first order for it");
  gradient = {};
  return in_dimension(dimension_, [&]<int N>() {
    return SinglePoint<N>::value(*program_, root, point, time, &gradient);
  });
}

bool same_expression(const Field& a, const Field& b) {
  if (a.same_as(b)) return true;
  const auto program = compile({a, b}, {0, 0}, 3);
  return program->root_instructions[0] == program->root_instructions[1];
}

}  // namespace rfm
