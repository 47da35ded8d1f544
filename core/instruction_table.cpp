#include "core/instruction_table.hpp"

#include <bit>
#include <cmath>
#include <utility>

#include "core/operation_rules.hpp"

namespace rfm {
namespace {

std::uint64_t hash_of(const Instruction& instruction) {
  std::uint64_t hash = static_cast<std::uint64_t>(instruction.operation);
  const auto mix = [&hash](std::uint64_t value) {
    hash = (hash ^ value) * 0xff51afd7ed558ccdull;
    hash ^= hash >> 32;
  };
  mix(static_cast<std::uint64_t>(instruction.index));
  mix(std::bit_cast<std::uint64_t>(instruction.number));
  mix(reinterpret_cast<std::uintptr_t>(instruction.source.get()));
  for (const int operand : instruction.operands) mix(static_cast<std::uint64_t>(operand));
  return hash;
}

bool same(const Instruction& a, const Instruction& b) {
  return a.operation == b.operation && a.index == b.index && a.operands == b.operands &&
         std::bit_cast<std::uint64_t>(a.number) == std::bit_cast<std::uint64_t>(b.number) &&
         a.source == b.source;
}

bool is_power_of_two(double number) {
  int exponent = 0;
  return std::isnormal(number) && std::isnormal(1 / number) &&
         std::fabs(std::frexp(number, &exponent)) == 0.5;
}

}  // namespace

int InstructionTable::add(Instruction instruction) {
  if (!folded(instruction)) {
    const int other = simplified(instruction);
    if (other >= 0) return other;
  }
  const int next = static_cast<int>(instructions_.size());
  const int place = known_.find_or_insert(
      hash_of(instruction), next, [&](int i) { return same(instructions_[i], instruction); });
  if (place == next) {
    defined_everywhere_.push_back(has_value_everywhere(instruction));
    instructions_.push_back(std::move(instruction));
  }
  return place;
}

bool InstructionTable::has_value_everywhere(const Instruction& instruction) const {
  for (const int operand : instruction.operands)
    if (operand >= 0 && !defined_everywhere_[operand]) return false;
  if (instruction.operation == Operation::source) return false;
  if (instruction.operation == Operation::constant) return std::isfinite(instruction.number);
  if (instruction.operation == Operation::divide) {
    const Instruction& divisor = instructions_[instruction.operands[1]];
    return divisor.operation == Operation::constant && divisor.number != 0;
  }
  const OperationRow* row = find_operation(instruction.operation);
  return !row || rfm::is_defined_everywhere(*row, instruction.number);
}

bool InstructionTable::folded(Instruction& instruction) const {
  const auto& [a, b, c] = instruction.operands;
  for (const int operand : {a, b, c})
    if (operand >= 0 && !is(operand, Operation::constant)) return false;
  if (a < 0 || instruction.operation == Operation::source) return false;
  using Number = Jet<double, 1, 0>;
  const auto number = [&](int operand) {
    return Number(operand < 0 ? 0.0 : instructions_[operand].number);
  };
  Number result;
  switch (instruction.operation) {
    case Operation::partial:
      break;
    // Made by tapes, so without a row in the table of operations.
    case Operation::scale:
      result = number(a) * Number(instruction.number);
      break;
    case Operation::offset:
      result = number(a) + Number(instruction.number);
      break;
    default:
      result =
          apply_rule(instruction.operation, number(a), number(b), number(c), instruction.number);
  }
  if (!std::isfinite(result.value())) return false;
  instruction = Instruction();
  instruction.number = result.value();
  return true;
}

// Rewrites an instruction; returns the number of an earlier one if that is what it amounts to.
int InstructionTable::simplified(Instruction& instruction) const {
  auto& [a, b, c] = instruction.operands;
  const auto become = [&](Operation operation, int first, int second = -1, double number = 0) {
    instruction.operation = operation;
    instruction.number = number;
    instruction.index = 0;
    instruction.operands = {first, second, -1};
    return -1;
  };
  const auto constant = [&](int operand) { return is(operand, Operation::constant); };
  const auto negated = [&](int operand) { return is(operand, Operation::negate); };
  const auto number = [&](int operand) { return instructions_[operand].number; };
  const auto inner = [&](int operand) { return instructions_[operand].operands[0]; };
  // Sums and products with a constant need no jet for the constant.
  const auto scale = [&](double factor, int operand) {
    if (factor == 1) return operand;
    if (factor == 0 && defined_everywhere_[operand]) {
      instruction = Instruction();
      return -1;
    }
    return factor == -1 ? become(Operation::negate, operand)
                        : become(Operation::scale, operand, -1, factor);
  };
  const auto offset = [&](int operand, double sum) {
    return sum == 0 ? operand : become(Operation::offset, operand, -1, sum);
  };
  switch (instruction.operation) {
    case Operation::multiply:
      if (constant(b)) return scale(number(b), a);
      if (constant(a)) return scale(number(a), b);
      if (negated(a) && negated(b)) a = inner(a), b = inner(b);
      if (a == b) {
        const int base = a;
        become(Operation::integer_power, base, -1, 2);
        instruction.index = 2;
        return -1;
      }
      if (a > b) std::swap(a, b);
      return -1;
    case Operation::divide:
      if (constant(b) && is_power_of_two(number(b))) return scale(1 / number(b), a);
      return -1;
    case Operation::add:
      if (constant(b)) return offset(a, number(b));
      if (constant(a)) return offset(b, number(a));
      if (negated(b)) return become(Operation::subtract, a, inner(b));
      if (negated(a)) return become(Operation::subtract, b, inner(a));
      if (a > b) std::swap(a, b);
      return -1;
    case Operation::subtract:
      if (constant(b)) return offset(a, -number(b));
      if (negated(b) && !constant(a)) {
        become(Operation::add, a, inner(b));
        if (a > b) std::swap(a, b);
      }
      return -1;
    case Operation::negate:
      if (negated(a)) return inner(a);
      if (is(a, Operation::subtract)) {
        const auto [first, second, none] = instructions_[a].operands;
        return become(Operation::subtract, second, first);
      }
      return -1;
    case Operation::abs:
      if (is(a, Operation::abs)) return a;
      [[fallthrough]];
    case Operation::cos:
    case Operation::cosh:
      if (negated(a)) a = inner(a);
      return -1;
    case Operation::integer_power:
      if (instruction.index == 1) return a;
      if (instruction.index % 2 == 0 && negated(a)) a = inner(a);
      return -1;
    case Operation::min:
    case Operation::max:
      return a == b ? a : -1;
    case Operation::select:
      if (constant(a)) return number(a) != 0 ? b : c;
      return b == c && defined_everywhere_[a] ? b : -1;
    default:
      return -1;
  }
}

}  // namespace rfm
