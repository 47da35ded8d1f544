#include "core/point_program.hpp"
#include "core/tape_polynomial.hpp"
#include "core/tape_program.hpp"

namespace rfm {

class PointProgram::Compiler {
 public:
  Compiler(const Tape::Program& program, int dimension)
      : code_(program.instructions),
        dimension_(dimension),
        place_(code_.size(), -1),
        needed_(code_.size(), false) {
    polynomials_.reserve(code_.size());  // `known_` points into it
    for (const Instruction& instruction : code_) {
      const auto found = recognise(instruction, known_);
      known_.push_back(found ? &polynomials_.emplace_back(*found) : nullptr);
    }
  }

  std::optional<PointProgram> run(int root) {
    result_.dimension_ = dimension_;
    needed_[root] = true;
    for (int i = root; i >= 0; --i) {
      if (!needed_[i] || is_step(i)) continue;
      for (const int operand : code_[i].operands)
        if (operand >= 0) needed_[operand] = true;
    }
    for (int i = 0; i <= root; ++i) {
      if (!needed_[i]) continue;
      place_[i] = is_step(i) ? add_quadric(*known_[i]) : add_operation(code_[i]);
      if (place_[i] < 0 || result_.steps_.size() > capacity) return {};
    }
    return std::move(result_);
  }

 private:
  // Whether an instruction with all below it is one polynomial that is worth a step of its own.
  bool is_step(int i) const {
    const Polynomial* const p = known_[i];
    if (!p) return false;
    int axes = 0;
    for (int axis = 0; axis < dimension_; ++axis) axes += p->depends_on(axis);
    if (dimension_ < 3 && p->depends_on(2)) return false;
    if (dimension_ < 2 && p->depends_on(1)) return false;
    return axes > 1 || !p->is_affine();
  }

  int add(Code code, int first = 0, int second = 0, double number = 0) {
    result_.steps_.push_back(
        {code, static_cast<std::int16_t>(first), static_cast<std::int16_t>(second), number});
    return static_cast<int>(result_.steps_.size()) - 1;
  }

  int add_quadric(const Polynomial& p) {
    result_.quadrics_.emplace_back(Quadric{p.origin, p.constant, p.linear, p.square});
    return add(Code::quadric, static_cast<int>(result_.quadrics_.size()) - 1);
  }

  int add_power(int base, int exponent) {
    while (exponent % 2 == 0) base = add(Code::square, base), exponent /= 2;
    int power = base;
    for (exponent /= 2; exponent > 0; exponent /= 2) {
      base = add(Code::square, base);
      if (exponent % 2 == 1) power = add(Code::multiply, power, base);
    }
    return power;
  }

  // −1 for what a program cannot do.
  int add_operation(const Instruction& instruction) {
    const auto operand = [&](int k) {
      return instruction.operands[k] < 0 ? 0 : place_[instruction.operands[k]];
    };
    const int a = operand(0), b = operand(1);
    switch (instruction.operation) {
      case Operation::constant:
        if (std::isnan(instruction.number)) return -1;  // slopes of it are not numbers either
        return add(Code::constant, 0, 0, instruction.number);
      case Operation::coordinate:
        if (instruction.index >= dimension_) return -1;
        return add(static_cast<Code>(static_cast<int>(Code::x) + instruction.index));
      case Operation::scale:
        return add(Code::scale, a, 0, instruction.number);
      case Operation::offset:
        return add(Code::offset, a, 0, instruction.number);
      case Operation::integer_power:
        if (instruction.index < 1 || instruction.index > 64) return -1;
        return add_power(a, instruction.index);
#define RFM_STEP(id)  \
  case Operation::id: \
    return add(Code::id, a, b);
        RFM_STEP(add)
        RFM_STEP(subtract)
        RFM_STEP(multiply)
        RFM_STEP(divide)
        RFM_STEP(negate)
        RFM_STEP(sqrt)
        RFM_STEP(exp)
        RFM_STEP(log)
        RFM_STEP(sin)
        RFM_STEP(cos)
        RFM_STEP(hypot)
        RFM_STEP(min)
        RFM_STEP(max)
#undef RFM_STEP
      default:
        return -1;
    }
  }

  const std::vector<Instruction>& code_;
  int dimension_;
  std::vector<int> place_;
  std::vector<bool> needed_;
  std::vector<Polynomial> polynomials_;
  std::vector<const Polynomial*> known_;
  PointProgram result_;
};

std::optional<PointProgram> PointProgram::compiled(const Field& field, int dimension) {
  const auto program = compile({field}, {1}, dimension);
  return Compiler(*program, dimension).run(program->root_instructions[0]);
}

}  // namespace rfm
