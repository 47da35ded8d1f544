#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/tape.hpp"

namespace rfm {

/// One operation on jets. Memory of blocks is counted in rows of `Tape::block_size` numbers: the
/// jet of a register of order k takes jet_size(dimension, k) rows from its offset on.
struct Instruction {
  Operation operation = Operation::constant;
  int order = 0;
  int index = 0;
  double number = 0;
  /// Instructions whose results are the arguments (single-point evaluation), and their rows.
  std::array<int, 3> operands{-1, -1, -1};
  std::array<int, 3> operand_rows{};
  int result_row = 0;
  std::shared_ptr<const FieldSource> source;
};

/// The SIMD kernel of one operation, number of variables and order.
using Kernel = void (*)(const Instruction& instruction, double* memory, int padded_count);

struct Tape::Program {
  std::vector<Instruction> instructions;
  std::vector<Kernel> kernels;  ///< null for leaves, which the tape fills itself
  std::vector<int> root_instructions;
  std::vector<int> root_rows;
  int rows = 0;
  int highest_order = 0;
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

/// Hash-conses the graphs of `roots`, finds the order that each node needs, and assigns registers.
/// Throws `InvalidArgument` where a higher order than the compiled ones is needed.
std::unique_ptr<const Tape::Program> compile(const std::vector<Field>& roots,
                                             const std::vector<int>& orders, int dimension);

}  // namespace rfm
