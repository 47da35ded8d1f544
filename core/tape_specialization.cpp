#include "core/tape_specialization.hpp"

#include <cmath>

#include "core/operation_rules.hpp"

namespace rfm {
namespace {

using Bounds = Jet<Interval, 1, 0>;

Interval range_of(const Instruction& instruction, const std::vector<Interval>& known,
                  const Box& box) {
  const auto operand = [&](int k) {
    return Bounds::constant(instruction.operands[k] < 0 ? Interval()
                                                        : known[instruction.operands[k]]);
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
Outcome outcome_of(const Instruction& instruction, const std::vector<Interval>& ranges) {
  const auto [first, second, third] = instruction.operands;
  const Interval a = first < 0 ? Interval() : ranges[first];
  const Interval b = second < 0 ? Interval() : ranges[second];
  switch (instruction.operation) {
    case Operation::min:
      return a.high <= b.low ? one_of(first) : b.high < a.low ? one_of(second) : Outcome{};
    case Operation::max:
      return b.high <= a.low ? one_of(first) : a.high < b.low ? one_of(second) : Outcome{};
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
      const double low = std::floor(a.low);
      return low == std::floor(a.high) && std::isfinite(low) ? number(low) : Outcome{};
    }
    default:
      return {};
  }
}

}  // namespace

std::vector<Interval> ranges_over(const std::vector<Instruction>& instructions, const Box& box) {
  std::vector<Interval> ranges;
  ranges.reserve(instructions.size());
  for (const Instruction& instruction : instructions)
    ranges.push_back(range_of(instruction, ranges, box));
  return ranges;
}

std::vector<int> pruned(const std::vector<Instruction>& instructions,
                        const std::vector<Interval>& ranges, const std::vector<int>& roots,
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
