#pragma once

#include <vector>

#include "core/instruction_table.hpp"

namespace rfm {

/// Whether bounds may decide which argument an operation comes to, or which number.
bool has_branches(Operation operation);

/// What is known of an instruction over a box.
struct RangeOver {
  Interval range;         ///< encloses its value where that is defined
  bool defined = false;   ///< whether it is known to have a finite value everywhere in the box
  bool vanishes = false;  ///< whether it is zero with all derivatives, where it is defined
};

/// What is known of each instruction over a box, whatever time and parameters are. Of a derivative
/// within an expression nothing is said.
std::vector<RangeOver> ranges_over(const std::vector<Instruction>& instructions, const Box& box);

/// Copies what `roots` need into `table`, without the branches that are not taken over the box, as
/// the ranges say; nothing is decided by comparisons with what may not be defined. Returns the
/// number in the table of each instruction, −1 of those left out.
std::vector<int> pruned(const std::vector<Instruction>& instructions,
                        const std::vector<RangeOver>& ranges, const std::vector<int>& roots,
                        InstructionTable& table);

}  // namespace rfm
