#include "core/tape_specialization.hpp"

#include <cmath>

#include "core/operation_rules.hpp"

namespace rfm {
namespace {

using Bounds = Jet<Interval, 1, 0>;

Interval range_of(const Instruction& instruction, const std::vector<RangeOver>& known,
                  const Box& box) {
  const auto operand = [&](int k) {
    return Bounds::constant(instruction.operands[k] < 0 ? Interval()
                                                        : known[instruction.operands[k]].range);
  };
  const Bounds a = operand(0);
  switch (instruction.operation) {
    case Operation::constant:
      return instruction.number;
    case Operation::coordinate:
      return instruction.index < box.dimension ? box.interval(instruction.index)
                                               : Interval::entire();
    case Operation::parameter:
    case Operation::partial:
      return Interval::entire();
    case Operation::source:
      return instruction.operands[0] < 0 ? instruction.source->bounds(box).value
                                         : Interval::entire();
    case Operation::scale:
      return Interval(instruction.number) * a.value();
    case Operation::offset:
      return a.value() + Interval(instruction.number);
    default:
      return apply_rule(instruction.operation, a, operand(1), operand(2), instruction.number)
          .value();
  }
}

// Whether an operation is defined for all arguments in their ranges, as far as its own range does
// not tell: quotients, logarithms, negative powers and the tangent are unbounded where they are
// not.
bool is_defined_over(const Instruction& instruction, const std::vector<RangeOver>& known,
                     const Box& box) {
  const OperationRow* row = find_operation(instruction.operation);
  if (row && is_defined_everywhere(*row, instruction.number)) return true;
  const auto operand = [&](int k) { return known[instruction.operands[k]].range; };
  switch (instruction.operation) {
    case Operation::divide:
    case Operation::mod:
      return operand(1).excludes_zero();
    case Operation::power:
      return operand(0).low > 0 || (operand(0).low >= 0 && operand(1).low >= 0);
    case Operation::integer_power:
      return operand(0).excludes_zero();
    case Operation::real_power:
      return operand(0).low > 0 || (operand(0).low >= 0 && instruction.number > 0);
    case Operation::sqrt:
      return operand(0).low >= 0;
    case Operation::log:
      return operand(0).low > 0;
    case Operation::tan:
      return true;  // where its range is bounded
    case Operation::asin:
    case Operation::acos:
      return operand(0).low >= -1 && operand(0).high <= 1;
    case Operation::source: {
      if (instruction.operands[0] >= 0) return false;
      const Box valid = instruction.source->valid();
      for (int axis = 0; axis < valid.dimension; ++axis)
        if (axis >= box.dimension || box.low[axis] < valid.low[axis] ||
            box.high[axis] > valid.high[axis])
          return false;
      return true;
    }
    default:
      return !row && instruction.operation != Operation::partial;
  }
}

RangeOver known_of(const Instruction& instruction, const std::vector<RangeOver>& known,
                   const Box& box) {
  RangeOver result{range_of(instruction, known, box), true};
  result.vanishes = result.range.is_zero();  // in a box that is more than a point or a face
  for (int axis = 0; axis < box.dimension; ++axis)
    result.vanishes = result.vanishes && box.low[axis] < box.high[axis];
  if (instruction.operation == Operation::coordinate ||
      instruction.operation == Operation::parameter)
    return result;
  for (const int operand : instruction.operands)
    result.defined = result.defined && (operand < 0 || known[operand].defined);
  // Where a value may be infinite, another operation may make it none: ∞ − ∞, 0 · ∞.
  result.defined = result.defined && std::isfinite(result.range.magnitude()) &&
                   is_defined_over(instruction, known, box);
  return result;
}

// What an operation comes to over the box: another instruction as it is or negated, or a number.
struct Outcome {
  enum class Kind { itself, operand, opposite, number } kind = Kind::itself;
  int operand = -1;
  double number = 0;
};

Outcome one_of(int operand) { return {Outcome::Kind::operand, operand, 0}; }
Outcome number(double value) { return {Outcome::Kind::number, -1, value}; }
Outcome truth(Truth known) {
  return known == Truth::unknown ? Outcome{} : number(known == Truth::yes ? 1 : 0);
}

// The conditions are those of the rules (core/jet_piecewise.hpp), over the whole box.
Outcome outcome_of(const Instruction& instruction, const std::vector<RangeOver>& ranges) {
  const auto [first, second, third] = instruction.operands;
  const auto known = [&](int operand) {
    return operand < 0 ? RangeOver{{}, true, false} : ranges[operand];
  };
  const auto [a, a_defined, a_vanishes] = known(first);
  const auto [b, b_defined, b_vanishes] = known(second);
  // The branch that an `if` does not take is not looked at.
  if (!a_defined || (!b_defined && instruction.operation != Operation::select)) return {};
  switch (instruction.operation) {
    case Operation::min:
      return a.high <= b.low ? one_of(first) : b.high < a.low ? one_of(second) : Outcome{};
    case Operation::max:
      return b.high <= a.low ? one_of(first) : a.high < b.low ? one_of(second) : Outcome{};
    case Operation::multiply:
      return a_vanishes || b_vanishes ? number(0) : Outcome{};
    case Operation::select:
      if (a.excludes_zero()) return one_of(second);
      return a.is_zero() ? one_of(third) : Outcome{};
    case Operation::abs:
      if (a.low >= 0) return one_of(first);
      return a.high < 0 ? Outcome{Outcome::Kind::opposite, first, 0} : Outcome{};
    case Operation::sign:
      return a.low > 0 ? number(1) : a.high < 0 ? number(-1) : Outcome{};
    case Operation::step:
      return truth(less_equal(Interval(0), a));
    case Operation::less:
      return truth(less(a, b));
    case Operation::less_equal:
      return truth(less_equal(a, b));
    case Operation::equal:
      return truth(equal(a, b));
    case Operation::floor: {
      const double low = std::floor(a.low) + 0.0;  // as the rule: not −0
      return low == std::floor(a.high) && std::isfinite(low) ? number(low) : Outcome{};
    }
    default:
      return {};
  }
}

}  // namespace

bool has_branches(Operation operation) {
  switch (operation) {
    case Operation::min:
    case Operation::max:
    case Operation::select:
    case Operation::abs:
    case Operation::sign:
    case Operation::step:
    case Operation::less:
    case Operation::less_equal:
    case Operation::equal:
    case Operation::floor:
      return true;
    default:
      return false;
  }
}

std::vector<RangeOver> ranges_over(const std::vector<Instruction>& instructions, const Box& box) {
  std::vector<RangeOver> ranges;
  ranges.reserve(instructions.size());
  for (const Instruction& instruction : instructions)
    ranges.push_back(known_of(instruction, ranges, box));
  return ranges;
}

std::vector<int> pruned(const std::vector<Instruction>& instructions,
                        const std::vector<RangeOver>& ranges, const std::vector<int>& roots,
                        InstructionTable& table) {
  // From the roots down along the branches that are taken: most of a large tape is never looked at.
  std::vector<Outcome> outcomes(instructions.size());
  std::vector<char> needed(instructions.size(), 0);
  for (const int root : roots) needed[root] = 1;
  for (std::size_t i = instructions.size(); i-- > 0;) {
    if (!needed[i]) continue;
    const Outcome& outcome = outcomes[i] = outcome_of(instructions[i], ranges);
    if (outcome.operand >= 0) needed[outcome.operand] = 1;
    if (outcome.kind != Outcome::Kind::itself) continue;
    for (const int operand : instructions[i].operands)
      if (operand >= 0) needed[operand] = 1;
  }
  std::vector<int> place(instructions.size(), -1);
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    if (!needed[i]) continue;
    const Outcome& outcome = outcomes[i];
    Instruction copy;
    switch (outcome.kind) {
      case Outcome::Kind::operand:
        place[i] = place[outcome.operand];
        continue;
      case Outcome::Kind::number:
        copy.number = outcome.number;
        break;
      case Outcome::Kind::opposite:
        copy.operation = Operation::negate;
        copy.operands[0] = place[outcome.operand];
        break;
      case Outcome::Kind::itself:
        copy = instructions[i];
        copy.order = 0;
        for (int& operand : copy.operands)
          if (operand >= 0) operand = place[operand];
        break;
    }
    place[i] = table.add(std::move(copy));
  }
  return place;
}

}  // namespace rfm
