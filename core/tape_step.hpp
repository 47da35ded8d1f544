#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "core/tape.hpp"

namespace rfm {

/// Where some coefficients of a register lie in a workspace, counted in numbers from its start:
/// coefficient i of lane l is at `offset() + i · block_size + l · stride()`. A coefficient that
/// varies from point to point has a row of `block_size` numbers; a constant one is a single vector
/// read by every group of lanes (stride 0), so that what is known to be constant (the gradient of a
/// plane, the Hessian of a sphere, zeros) is never stored while blocks are evaluated.
class Part {
 public:
  Part() = default;
  static Part varying(int offset) { return Part(static_cast<std::uint32_t>(offset) << 1 | 1); }
  static Part constant(int offset) { return Part(static_cast<std::uint32_t>(offset) << 1); }
  int offset() const { return static_cast<int>(bits_ >> 1); }
  int stride() const { return static_cast<int>(bits_ & 1); }

 private:
  explicit Part(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = 0;
};

/// A register of a block: value, first derivatives, derivatives of order two and more.
struct Register {
  Part value, gradient, rest;

  /// All coefficients one after the other from `offset` on.
  static Register dense(int offset, int dimension) {
    constexpr int row = Tape::block_size;
    return {Part::varying(offset), Part::varying(offset + row),
            Part::varying(offset + (1 + dimension) * row)};
  }
  /// The part that holds coefficient `index` of the jet, which becomes the index within the part.
  Part part_of(int& index, int dimension) const {
    if (index == 0) return value;
    --index;
    if (index < dimension) return gradient;
    index -= dimension;
    return rest;
  }
};

struct Step;
/// Carries out a step at `padded_count` points, a multiple of the width of `Batch`.
using Kernel = void (*)(const Step& step, double* memory, int padded_count);

/// One step of the evaluation of a block. The result shares no row with the arguments.
struct Step {
  Kernel kernel = nullptr;            ///< null for sources, which the tape calls itself
  const double* constants = nullptr;  ///< numbers of the step, kept by the program
  std::array<Register, 3> arguments;
  int result = 0;              ///< offset of the first row
  int index = 0;               ///< exponent, axis, or the instruction of a source
  std::int16_t order = 0;      ///< of the result
  std::int16_t variables = 0;  ///< of the jets
};
static_assert(sizeof(Step) <= 64 && std::is_trivially_copyable_v<Step>,
              "a step is one cache line: a long tape is read through for every block");

}  // namespace rfm
