#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "core/tape.hpp"
#include "core/tape_step.hpp"

namespace rfm {

/// One operation on jets, as single points and bounds see it: every register is a whole jet.
struct Instruction {
  Operation operation = Operation::constant;
  int order = 0;  ///< that its users need
  int index = 0;
  double number = 0;
  std::array<int, 3> operands{-1, -1, -1};  ///< instructions whose results are the arguments
  std::shared_ptr<const FieldSource> source;
};

/// A compiled tape: instructions, one per operation, and the steps for blocks, which are made from
/// them when they are first needed: many tapes serve single points and bounds alone.
struct Tape::Program {
  std::vector<Instruction> instructions;
  std::vector<int> root_instructions;
  int highest_order = 0;

  mutable std::once_flag has_steps;
  std::vector<Step> steps;
  std::vector<double> step_constants;  ///< what `Step::constants` points into
  std::vector<int> root_offsets;       ///< of the dense results
  /// A workspace is: rows of the coordinates, `varying_size` numbers in all with the registers,
  /// then a copy of `constant_parts`. Time and parameters are written into it for each block.
  int varying_size = 0;
  std::vector<double> constant_parts;
  struct Input {
    int instruction;
    int offset;
  };
  std::vector<Input> inputs;
};

/// Highest order of derivatives compiled for each number of variables.
constexpr int highest_compiled_order(int dimension) { return dimension == 2 ? 4 : 3; }

/// The kernel for an operation in N variables; null for leaves.
template <int N>
Kernel find_kernel_in(Operation operation, int order);
template <>
Kernel find_kernel_in<1>(Operation operation, int order);
template <>
Kernel find_kernel_in<2>(Operation operation, int order);
template <>
Kernel find_kernel_in<3>(Operation operation, int order);
/// The same with the number of variables known at run time.
Kernel find_kernel(Operation operation, int dimension, int order);

/// Values at single points and bounds over boxes, in N variables.
template <int N>
struct SinglePoint {
  static double value(const Tape::Program& program, int root, const Point& point, double time,
                      Point* gradient);
  static FunctionBounds bounds(const Tape::Program& program, int root, const Box& box, double time);
  static Interval value_bounds(const Tape::Program& program, int root, const Box& box, double time);
  /// Bounds along a line, by derivatives in N variables; N = 1 means the derivative along the line
  /// itself, which serves programs of order 1 of any dimension.
  static LineBounds bounds(const Tape::Program& program, int root, const Line& line,
                           const Interval& range, double time);
};

/// Hash-conses the graphs of `roots`, and finds the order that each node needs.
/// Throws `InvalidArgument` where a higher order than the compiled ones is needed.
std::unique_ptr<const Tape::Program> compile(const std::vector<Field>& roots,
                                             const std::vector<int>& orders, int dimension);

/// The same without the branches that are not taken over a box (Tape::specialised).
std::unique_ptr<const Tape::Program> specialised(const Tape::Program& original,
                                                 const std::vector<int>& orders, int dimension,
                                                 const Box& box);

/// Makes the steps for blocks from the instructions, whose orders are known (tape_lowering.cpp).
void lower(Tape::Program& program, const std::vector<int>& orders, int dimension);

}  // namespace rfm
