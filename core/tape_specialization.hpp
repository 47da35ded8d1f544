#pragma once

#include <vector>

#include "core/instruction_table.hpp"

namespace rfm {

/// Intervals that enclose the value of each instruction over a box, whatever time and parameters
/// are. Of a derivative within an expression nothing is said.
std::vector<Interval> ranges_over(const std::vector<Instruction>& instructions, const Box& box);

/// Copies what `roots` need into `table`, without the branches that are not taken over the box, as
/// the ranges say; returns the number in the table of each instruction, −1 of those left out.
std::vector<int> pruned(const std::vector<Instruction>& instructions,
                        const std::vector<Interval>& ranges, const std::vector<int>& roots,
                        InstructionTable& table);

}  // namespace rfm
