#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/jet_shape.hpp"
#include "core/tape.hpp"
#include "core/tape_step.hpp"

namespace rfm {

/// One operation on jets, as single points and bounds see it: every register is a whole jet. Of a
/// partial derivative, `index` is the number of the jets' variable.
struct Instruction {
  Operation operation = Operation::constant;
  int order = 0;  ///< that its users need
  int index = 0;
  double number = 0;
  int variable = -1;  ///< which of the jets' variables a coordinate is; −1 if it is held
  std::array<int, 3> operands{-1, -1, -1};  ///< instructions whose results are the arguments
  std::shared_ptr<const FieldSource> source;
};

/// A compiled tape: instructions, one per operation, and the steps for blocks, which are made from
/// them when they are first needed: many tapes serve single points and bounds alone.
struct Tape::Program {
  Variables variables;
  std::vector<Instruction> instructions;
  std::vector<int> root_instructions;
  std::vector<std::string> parameter_names;  ///< by number, empty where one has none
  int highest_order = 0;

  mutable std::once_flag has_steps;
  std::vector<Step> steps;
  std::vector<double> step_constants;  ///< what `Step::constants` points into
  std::vector<int> root_offsets;       ///< of the dense results
  /// A workspace is: rows of the variables, `varying_size` numbers in all with the registers, then
  /// a copy of `constant_parts`. Other coordinates and parameters are written into it for each
  /// block: a row of numbers, or one that is the same for all points.
  int varying_size = 0;
  std::vector<double> constant_parts;
  struct Input {
    int instruction;
    int offset;
    bool is_row;
  };
  std::vector<Input> inputs;

  explicit Program(const Variables& variables) : variables(variables) {}
};

/// Highest order of derivatives with kernels of its own for each number of variables: these are
/// compiled for 1 to 3 variables and orders 0 to 3, in 2D also 4. All else, up to four variables
/// and order 16, is the work of one set of kernels with tables at run time.
constexpr int highest_compiled_order(int variables) {
  return variables > 3 ? -1 : variables == 2 ? 4 : 3;
}

/// The kernels of one shape are compiled in so many parts, by the number of the operation.
inline constexpr int kernel_parts = 4;
/// The kernel in N variables at order K of an operation of this part; null for others and for
/// leaves. Instantiated in units of their own (core/tape_kernels_*.cpp), each of which compiles in
/// less than 20 s.
template <int N, int K, int part>
Kernel find_compiled_kernel(Operation operation);
/// The kernel that knows number of variables and order from its step.
Kernel find_dynamic_kernel(Operation operation);
/// Chooses among all of these.
Kernel find_kernel(Operation operation, int variables, int order);

/// What is wrong where only the values of `given` parameters are known.
std::string missing_parameter(const Tape::Program& program, int number, std::size_t given);

/// Jets at single points and bounds over boxes, in N variables, or in any number at any order.
template <int N>
struct SinglePoint {
  /// The first coefficients of a root.
  static void jet(const Tape::Program& program, int root, const Point& point,
                  const OtherValues& others, std::span<double> coefficients);
  static FunctionBounds bounds(const Tape::Program& program, int root, const Box& box,
                               const OtherRanges& others);
  static Interval value_bounds(const Tape::Program& program, int root, const Box& box,
                               const OtherRanges& others);
  /// Bounds along a line, by derivatives in N variables; N = 1 means the derivative along the line
  /// itself, which serves programs of order 1 of any dimension.
  static LineBounds bounds(const Tape::Program& program, int root, const Line& line,
                           const Interval& range, const OtherRanges& others);
};

/// Jets of a source in the variables of a tape, up to `order`, coefficient by coefficient: the
/// source itself knows x, y, z only.
void evaluate_source(const FieldSource& source, const Variables& variables,
                     const std::array<const double*, 3>& coordinates, int count, int order,
                     double* jets, int stride);

/// The same of a source at the places that its arguments give, for `padded_count` points.
void evaluate_composed_source(const Instruction& instruction, const Step& step, double* memory,
                              int padded_count);

/// Hash-conses the graphs of `roots`, and finds the order that each node needs.
/// Throws `InvalidArgument` where a higher order than the highest is needed.
std::unique_ptr<const Tape::Program> compile(const std::vector<Field>& roots,
                                             const std::vector<int>& orders,
                                             const Variables& variables);

/// The same without the branches that are not taken over a box (Tape::specialised).
std::unique_ptr<const Tape::Program> specialised(const Tape::Program& original,
                                                 const std::vector<int>& orders, const Box& box);

/// Makes the steps for blocks from the instructions, whose orders are known (tape_lowering.cpp).
void lower(Tape::Program& program, const std::vector<int>& orders, int dimension);

}  // namespace rfm
