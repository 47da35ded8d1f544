// From instructions to the steps that evaluate blocks: which instructions are polynomials in closed
// form, where every coefficient lies, and which registers share rows.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/tape_memory.hpp"
#include "core/tape_polynomial.hpp"
#include "core/tape_program.hpp"
#include "core/tape_step_writer.hpp"

namespace rfm {
namespace {

constexpr int row = Tape::block_size;
constexpr int forever = 1 << 30;

class Lowering {
 public:
  Lowering(Tape::Program& program, const std::vector<int>& orders, int dimension)
      : program_(program),
        steps_(program),
        code_(program.instructions),
        dimension_(dimension),
        order_(code_.size(), -1),
        last_use_(code_.size(), -1),
        registers_(code_.size()),
        owned_(code_.size()),
        pool_(dimension * row) {
    known_.resize(code_.size());
    if (dimension <= 3) find_polynomials();
    find_orders(orders);
  }

  void run() {
    for (int i = 0; i < static_cast<int>(code_.size()); ++i)
      if (order_[i] >= 0 && is_held_row(i)) add_held_row(i);
    for (int i = 0; i < static_cast<int>(code_.size()); ++i) {
      if (order_[i] < 0) continue;
      make(i);
      for_used_operands(i, [&](int operand) { release(operand, i); });
    }
    collect_roots();
    finish();
  }

 private:
  // Rows of a register: all of them, or those of value and gradient.
  struct Rows {
    int offset = 0, count = 0;
  };

  // Leaves are read where they lie; polynomials are known beyond their value; all else is computed
  // coefficient by coefficient.
  bool is_leaf(int i) const {
    const Operation operation = code_[i].operation;
    return operation == Operation::constant || operation == Operation::coordinate ||
           operation == Operation::parameter;
  }
  // A coordinate that is no variable and differs from point to point, unlike the time.
  bool is_held_row(int i) const {
    const Instruction& instruction = code_[i];
    return instruction.operation == Operation::coordinate && instruction.variable < 0 &&
           instruction.index != 3;
  }
  // Written before the first step, it has a row that no register shares.
  void add_held_row(int i) {
    const int offset = pool_.take(1);
    registers_[i].value = Part::varying(offset);
    program_.inputs.push_back({i, offset, true});
  }
  const Polynomial* polynomial(int i) const { return known_[i]; }
  bool is_sum(int i) const { return known_[i] && known_[i]->summable && !is_leaf(i); }

  void find_polynomials() {
    polynomials_.reserve(code_.size());  // `known_` points into it
    for (std::size_t i = 0; i < code_.size(); ++i)
      if (const auto found = recognise(code_[i], known_))
        known_[i] = &polynomials_.emplace_back(*found);
  }

  void for_used_operands(int i, const auto& visit) const {
    if (is_leaf(i) || is_sum(i)) return;
    for (const int operand : code_[i].operands)
      if (operand >= 0) visit(operand);
  }

  void find_orders(const std::vector<int>& orders) {
    for (std::size_t r = 0; r < orders.size(); ++r) {
      const int root = program_.root_instructions[r];
      order_[root] = std::max(order_[root], orders[r]);
      last_use_[root] = forever;
    }
    for (int i = static_cast<int>(code_.size()) - 1; i >= 0; --i) {
      if (order_[i] < 0) continue;
      highest_ = std::max(highest_, order_[i]);
      const int own = polynomial(i) ? 0 : order_[i];
      const int needed = own + (code_[i].operation == Operation::partial ? 1 : 0);
      for_used_operands(i, [&](int operand) {
        order_[operand] = std::max(order_[operand], needed);
        last_use_[operand] = std::max(last_use_[operand], i);
      });
    }
  }

  void release(int i, int user) {
    if (last_use_[i] != user) return;
    last_use_[i] = forever;  // an argument may occur twice
    for (const Rows& rows : owned_[i])
      if (rows.count > 0) pool_.give_back(rows.offset, rows.count);
  }

  int take(int i, int rows) {
    const int offset = pool_.take(rows);
    Rows& owned = owned_[i][owned_[i][0].count > 0 ? 1 : 0];
    owned = {offset, rows};
    return offset;
  }

  // Constant parts are placed behind the varying ones: their offsets are settled at the end.
  Part constant_part(const std::vector<double>& coefficients) {
    return Part::constant(constants_.find(coefficients));
  }
  Part zeros(int rows) { return constant_part(std::vector<double>(std::max(rows, 1))); }
  int rest_size(int order) const {
    return order < 2 ? 0 : jet_size(dimension_, order) - 1 - dimension_;
  }

  void make(int i) {
    if (is_leaf(i)) return make_leaf(i);
    if (polynomial(i)) return make_polynomial(i);
    const Instruction& instruction = code_[i];
    const int offset = take(i, jet_size(dimension_, order_[i]));
    registers_[i] = Register::dense(offset, dimension_);
    Step& step = add_step(find_kernel(instruction.operation, dimension_, order_[i]), i, offset);
    step.order = static_cast<std::int16_t>(order_[i]);
    step.variables = static_cast<std::int16_t>(dimension_);
    if (instruction.operation == Operation::source) step.index = i;
  }

  // A step with the operands, index and number of instruction `i`.
  Step& add_step(Kernel kernel, int i, int result) {
    Step step;
    step.kernel = kernel;
    step.index = code_[i].index;
    step.result = result;
    for (int k = 0; k < 3; ++k)
      if (code_[i].operands[k] >= 0) step.arguments[k] = registers_[code_[i].operands[k]];
    return steps_.push(step, {code_[i].number});
  }

  void make_leaf(int i) {
    const Instruction& leaf = code_[i];
    const int rest = rest_size(order_[i]);
    Register& result = registers_[i];
    result.rest = zeros(rest);
    result.gradient = zeros(dimension_);
    if (leaf.operation == Operation::constant) {
      result.value = constant_part({leaf.number});
      if (std::isnan(leaf.number)) {  // nor are its derivatives numbers
        result.gradient = constant_part(std::vector<double>(dimension_, leaf.number));
        result.rest = constant_part(std::vector<double>(std::max(rest, 1), leaf.number));
      }
    } else if (leaf.variable >= 0) {
      std::vector<double> unit(dimension_);
      unit[leaf.variable] = 1;
      result.value = Part::varying(leaf.variable * row);
      result.gradient = constant_part(unit);
    } else if (!is_held_row(i)) {
      const int offset = constants_.add({0.0});
      program_.inputs.push_back({i, offset, false});
      result.value = Part::constant(offset);
    }
  }

  void make_polynomial(int i) {
    const Polynomial& p = *polynomial(i);
    const int order = order_[i];
    Register& result = registers_[i];
    const bool slopes = order >= 1 && !p.is_affine();
    if (is_sum(i)) {
      const int offset = take(i, slopes ? 1 + dimension_ : 1);
      result.value = Part::varying(offset);
      result.gradient = Part::varying(offset + row);
      add_sum(steps_, p, offset, slopes, dimension_);
    } else {
      const int offset = take(i, 1);
      result.value = Part::varying(offset);
      add_step(find_kernel(code_[i].operation, dimension_, 0), i, offset);
      if (slopes) {
        const int gradient = take(i, dimension_);
        result.gradient = Part::varying(gradient);
        add_gradient(steps_, p, gradient, dimension_);
      }
    }
    if (order >= 1 && !slopes)
      result.gradient = constant_part({p.linear.begin(), p.linear.begin() + dimension_});
    if (order < 2) return;
    std::vector<double> rest(rest_size(order));
    for (int a = 0; a < dimension_; ++a)
      for (int b = a; b < dimension_; ++b)
        rest[jet_index(dimension_, unit_index(a) + unit_index(b)) - 1 - dimension_] =
            (a == b ? 1 : 2) * p.square[Polynomial::square_index(a, b)];
    result.rest = constant_part(rest);
  }

  // Roots are dense; those that are not yet are copied.
  void collect_roots() {
    for (const int root : program_.root_instructions) {
      if (is_leaf(root) || polynomial(root)) {
        const int rows = jet_size(dimension_, order_[root]);
        Step step;
        step.kernel = find_kernel(Operation::offset, dimension_, order_[root]);
        step.arguments[0] = registers_[root];
        step.result = pool_.take(rows);
        step.order = static_cast<std::int16_t>(order_[root]);
        step.variables = static_cast<std::int16_t>(dimension_);
        steps_.push(step, {0.0});
        program_.root_offsets.push_back(step.result);
      } else {
        program_.root_offsets.push_back(registers_[root].value.offset());
      }
    }
  }

  void finish() {
    const auto settle = [this](Part& part) {
      if (part.stride() == 0) part = Part::constant(part.offset() + pool_.size());
    };
    steps_.finish();
    for (Step& step : program_.steps) {
      for (Register& argument : step.arguments) {
        settle(argument.value);
        settle(argument.gradient);
        settle(argument.rest);
      }
    }
    for (auto& input : program_.inputs)
      if (!input.is_row) input.offset += pool_.size();
    program_.varying_size = pool_.size();
    program_.constant_parts = std::move(constants_).numbers();
  }

  Tape::Program& program_;
  StepWriter steps_;
  const std::vector<Instruction>& code_;
  int dimension_;
  int highest_ = 0;
  std::vector<Polynomial> polynomials_;
  std::vector<const Polynomial*> known_;
  std::vector<int> order_, last_use_;
  std::vector<Register> registers_;
  std::vector<std::array<Rows, 2>> owned_;
  RowPool pool_;
  ConstantPool constants_;
};

}  // namespace

void lower(Tape::Program& program, const std::vector<int>& orders, int dimension) {
  Lowering(program, orders, dimension).run();
}

}  // namespace rfm
