#pragma once

#include <vector>

#include "core/index_table.hpp"
#include "core/tape_program.hpp"

namespace rfm {

/// Instructions in the order in which they were added, each kept once: an instruction equal to an
/// earlier one is that one. What can be known without values is: operations on constants are
/// carried out (unless the result is not finite: evaluation then says where), and identities that
/// do not change a rounding or the domain are applied, a + (−b) = a − b, |−a| = |a|, min(a, a) = a,
/// a / 4 = 0.25 a.
class InstructionTable {
 public:
  /// The number of an instruction equal to this one, whose operands are numbers given before.
  int add(Instruction instruction);
  std::vector<Instruction> take() && { return std::move(instructions_); }
  /// Whether an instruction has a value wherever its coordinates have (Field::Node).
  bool is_defined_everywhere(int place) const { return defined_everywhere_[place]; }

 private:
  int simplified(Instruction& instruction) const;
  bool is(int operand, Operation operation) const {
    return instructions_[operand].operation == operation;
  }
  bool folded(Instruction& instruction) const;
  bool has_value_everywhere(const Instruction& instruction) const;

  std::vector<Instruction> instructions_;
  std::vector<char> defined_everywhere_;
  IndexTable known_;
};

}  // namespace rfm
