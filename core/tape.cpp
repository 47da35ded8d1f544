#include "core/tape.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "core/error.hpp"
#include "core/scalar.hpp"
#include "core/tape_program.hpp"
#include "core/tape_specialization.hpp"

namespace rfm {

namespace {

constexpr int batch_width = static_cast<int>(Batch::size());
static_assert(Tape::block_size % batch_width == 0);

template <class Function>
auto in_dimension(int variables, int order, const Function& function) {
  if (order > highest_compiled_order(variables)) return function.template operator()<run_time>();
  switch (variables) {
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

// NaN ends nothing either.
void check_box(const Box& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.low[axis] <= box.high[axis]))
      throw InvalidArgument("bounds are asked for over a box that ends before it begins");
}

template <int N, int K>
Kernel find_kernel_at(Operation operation) {
  static_assert(kernel_parts == 4);
  switch (static_cast<int>(operation) % kernel_parts) {
    case 0:
      return find_compiled_kernel<N, K, 0>(operation);
    case 1:
      return find_compiled_kernel<N, K, 1>(operation);
    case 2:
      return find_compiled_kernel<N, K, 2>(operation);
    default:
      return find_compiled_kernel<N, K, 3>(operation);
  }
}

template <int N>
Kernel find_kernel_in(Operation operation, int order) {
  Kernel kernel = nullptr;
  [&]<int... K>(std::integer_sequence<int, K...>) {
    ((order == K ? static_cast<void>(kernel = find_kernel_at<N, K>(operation)) : void()), ...);
  }
  (std::make_integer_sequence<int, highest_compiled_order(N) + 1>());
  return kernel;
}

}  // namespace

std::string missing_parameter(const Tape::Program& program, int number, std::size_t given) {
  const std::string& name = program.parameter_names[static_cast<std::size_t>(number)];
  return "the field needs parameter number " + std::to_string(number) +
         (name.empty() ? "" : " ('" + name + "')") + ", but only " + std::to_string(given) +
         " are given";
}

Kernel find_kernel(Operation operation, int variables, int order) {
  return in_dimension(variables, order, [&]<int N>() -> Kernel {
    if constexpr (N == run_time)
      return find_dynamic_kernel(operation);
    else
      return find_kernel_in<N>(operation, order);
  });
}

Tape::Tape(std::vector<Field> roots, std::vector<int> orders, const Variables& variables)
    : roots_(std::move(roots)), orders_(std::move(orders)), variables_(variables) {
  if (orders_.size() == 1) orders_.resize(roots_.size(), orders_[0]);
  if (orders_.size() != roots_.size())
    throw InvalidArgument("a tape needs one order, or one for each root");
  for (const int order : orders_)
    if (order < 0)
      throw InvalidArgument("orders of derivatives start at 0, got " + std::to_string(order));
  program_ = compile(roots_, orders_, variables_);
}

Tape::Tape(const Tape& general, const Box& box)
    : roots_(general.roots_), orders_(general.orders_), variables_(general.variables_) {
  program_ = rfm::specialised(*general.program_, orders_, box);
}

Tape Tape::specialised(const Box& box) const { return Tape(*this, box); }

Tape::~Tape() = default;
Tape::Tape(Tape&&) noexcept = default;
Tape& Tape::operator=(Tape&&) noexcept = default;

int Tape::instruction_count() const { return static_cast<int>(program_->instructions.size()); }

int Tape::branch_count() const {
  return static_cast<int>(std::ranges::count_if(
      program_->instructions, [](const Instruction& i) { return has_branches(i.operation); }));
}

const Tape::Program& Tape::with_steps() const {
  std::call_once(program_->has_steps, [this] {
    // Nobody reads the steps before this is done.
    lower(const_cast<Program&>(*program_), orders_, dimension());
  });
  return *program_;
}

int Tape::step_count() const { return static_cast<int>(with_steps().steps.size()); }

int Tape::checked(int root) const {
  if (static_cast<std::size_t>(root) >= roots_.size())
    throw InvalidArgument("the tape has " + std::to_string(roots_.size()) +
                          " roots, numbered from 0; there is no root " + std::to_string(root));
  return root;
}

const std::vector<std::string>& Tape::parameter_names() const { return program_->parameter_names; }

Tape::Workspace::Workspace(const Tape& tape)
    : program_(tape.program_),
      storage_(static_cast<std::size_t>(tape.with_steps().varying_size) +
               tape.program_->constant_parts.size() + 8),
      data_(aligned(storage_.data())),
      root_offset_(tape.program_->root_offsets) {
  for (const int order : tape.orders_) root_size_.push_back(jet_size(tape.dimension(), order));
  std::ranges::copy(tape.program_->constant_parts, data_ + tape.program_->varying_size);
}

void Tape::Workspace::refuse(int root, int coefficient) const {
  const std::size_t count = root_offset_.size();
  if (static_cast<std::size_t>(root) >= count)
    throw InvalidArgument("the tape has " + std::to_string(count) +
                          " roots, numbered from 0; there is no root " + std::to_string(root));
  throw InvalidArgument(
      "the jets of root " + std::to_string(root) + " have " + std::to_string(root_size_[root]) +
      " coefficients, numbered from 0; there is no coefficient " + std::to_string(coefficient));
}

void Tape::evaluate(const PointBlock& points, Workspace& workspace) const {
  if (workspace.program_ != program_)
    throw InvalidArgument("the workspace was made for another tape");
  if (points.count == 0) return;
  if (points.count < 0 || points.count > block_size)
    throw InvalidArgument("a block has 0 to " + std::to_string(block_size) + " points, got " +
                          std::to_string(points.count));
  double* const memory = workspace.data_;
  // Lanes beyond the last point repeat it, so that kernels always work on whole vectors.
  const int padded = (points.count + batch_width - 1) / batch_width * batch_width;
  const auto pad = [&](double* row) {
    std::fill(row + points.count, row + padded, row[points.count - 1]);
  };
  // The rows of a coordinate: given, or the same time everywhere.
  const auto fill_coordinate = [&](int index, double* row) {
    if (index == 3) return void(std::fill_n(row, padded, points.time));
    const std::size_t further = static_cast<std::size_t>(index) - 4;
    const double* const values = index < 3                         ? points.coordinates[index]
                                 : further < points.further.size() ? points.further[further]
                                                                   : nullptr;
    if (!values)
      throw InvalidArgument("the points of a block have no coordinate number " +
                            std::to_string(index) + ", which is needed");
    std::copy_n(values, points.count, row);
    pad(row);
  };
  for (int v = 0; v < dimension(); ++v)
    fill_coordinate(variables_.coordinates()[v], memory + v * block_size);
  for (const auto& [number, offset, is_row] : program_->inputs) {
    const Instruction& input = program_->instructions[number];
    if (is_row) {
      fill_coordinate(input.index, memory + offset);
      continue;
    }
    const bool is_time = input.operation == Operation::coordinate;
    if (!is_time && input.index >= static_cast<int>(points.parameters.size()))
      throw InvalidArgument(missing_parameter(*program_, input.index, points.parameters.size()));
    std::fill_n(memory + offset, batch_width,
                is_time ? points.time : points.parameters[input.index]);
  }
  for (const Step& step : program_->steps) {
    if (step.kernel) {
      step.kernel(step, memory, padded);
      continue;
    }
    double* const jets = memory + step.result;
    const Instruction& source = program_->instructions[step.index];
    if (source.operands[0] >= 0) {
      evaluate_composed_source(source, step, memory, padded);
      continue;
    }
    for (int axis = 0; axis < source.source->valid().dimension; ++axis)
      if (!points.coordinates[axis])
        throw InvalidArgument("the points of a block have no coordinate number " +
                              std::to_string(axis) + ", which a sampled field needs");
    evaluate_source(*source.source, variables_, points.coordinates, points.count, step.order, jets,
                    block_size);
    for (int k = 0; k < jet_size(dimension(), step.order); ++k) pad(jets + k * block_size);
  }
}

FunctionBounds Tape::bounds(const Box& box, int root, const OtherRanges& others) const {
  checked(root);
  check_box(box);
  return in_dimension(dimension(), program_->highest_order, [&]<int N>() {
    return SinglePoint<N>::bounds(*program_, root, box, others);
  });
}

Interval Tape::value_bounds(const Box& box, int root, const OtherRanges& others) const {
  checked(root);
  check_box(box);
  return in_dimension(dimension(), program_->highest_order, [&]<int N>() {
    return SinglePoint<N>::value_bounds(*program_, root, box, others);
  });
}

LineBounds Tape::bounds(const Line& line, const Interval& range, int root,
                        const OtherRanges& others) const {
  if (orders_[checked(root)] < 1 || !variables_.are_leading())
    throw InvalidArgument(
        "bounds along a line need a tape of first order for the root, in coordinates of space");
  // Without derivatives in the expression (they need a higher order) the line is the only variable.
  if (program_->highest_order == 1)
    return SinglePoint<1>::bounds(*program_, root, line, range, others);
  return in_dimension(dimension(), program_->highest_order, [&]<int N>() {
    return SinglePoint<N>::bounds(*program_, root, line, range, others);
  });
}

double Tape::value(const Point& point, int root, const OtherValues& others) const {
  double value;
  coefficients(point, checked(root), others, {&value, 1});
  return value;
}

double Tape::value_and_gradient(const Point& point, Point& gradient, int root,
                                const OtherValues& others) const {
  if (orders_[checked(root)] < 1 || dimension() > static_cast<int>(gradient.size()))
    throw InvalidArgument(
        "the gradient of a root needs a tape of first order for it, in up to three variables");
  std::array<double, 4> jet{};
  coefficients(point, root, others, std::span(jet).first(1 + dimension()));
  std::copy_n(jet.begin() + 1, gradient.size(), gradient.begin());
  return jet[0];
}

std::vector<double> Tape::jet(const Point& point, int root, const OtherValues& others) const {
  std::vector<double> jet(jet_size(dimension(), orders_[checked(root)]));
  coefficients(point, root, others, jet);
  return jet;
}

void Tape::coefficients(const Point& point, int root, const OtherValues& others,
                        std::span<double> first) const {
  in_dimension(dimension(), program_->highest_order,
               [&]<int N>() { SinglePoint<N>::jet(*program_, root, point, others, first); });
}

bool same_expression(const Field& a, const Field& b) {
  if (a.same_as(b)) return true;
  const auto program = compile({a, b}, {0, 0}, 3);
  return program->root_instructions[0] == program->root_instructions[1];
}

}  // namespace rfm
