// From instructions to the steps that evaluate blocks: which instructions are polynomials in closed
// form, where every coefficient lies, and which registers share rows.
#include <algorithm>
#include <optional>

#include "core/tape_memory.hpp"
#include "core/tape_polynomial.hpp"
#include "core/tape_program.hpp"

namespace rfm {
namespace {

constexpr int row = Tape::block_size;
constexpr int forever = 1 << 30;

class Lowering {
 public:
  Lowering(Tape::Program& program, const std::vector<int>& orders, int dimension)
      : program_(program),
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
      for (const int operand : used_operands(i)) release(operand, i);
    }
    collect_roots();
    finish();
  }

 private:
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

  std::vector<int> used_operands(int i) const {
    std::vector<int> used;
    if (is_leaf(i) || is_sum(i)) return used;
    for (const int operand : code_[i].operands)
      if (operand >= 0) used.push_back(operand);
    return used;
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
      for (const int operand : used_operands(i)) {
        order_[operand] = std::max(order_[operand], needed);
        last_use_[operand] = std::max(last_use_[operand], i);
      }
    }
  }

  void release(int i, int user) {
    if (last_use_[i] != user) return;
    last_use_[i] = forever;  // an argument may occur twice
    for (const auto& [offset, rows] : owned_[i]) pool_.give_back(offset, rows);
  }

  int take(int i, int rows) {
    const int offset = pool_.take(rows);
    owned_[i].push_back({offset, rows});
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
    return push(step, {code_[i].number});
  }

  Step& push(Step step, std::initializer_list<double> constants) {
    constants_of_step_.push_back(static_cast<int>(program_.step_constants.size()));
    program_.step_constants.insert(program_.step_constants.end(), constants);
    program_.steps.push_back(step);
    return program_.steps.back();
  }

  void make_leaf(int i) {
    const Instruction& leaf = code_[i];
    const int rest = rest_size(order_[i]);
    Register& result = registers_[i];
    result.rest = zeros(rest);
    result.gradient = zeros(dimension_);
    if (leaf.operation == Operation::constant) {
      result.value = constant_part({leaf.number});
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
      add_sum(p, offset, slopes);
    } else {
      const int offset = take(i, 1);
      result.value = Part::varying(offset);
      add_step(find_kernel(code_[i].operation, dimension_, 0), i, offset);
      if (slopes) {
        const int gradient = take(i, dimension_);
        result.gradient = Part::varying(gradient);
        add_gradient(p, gradient);
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

  Part coordinate(int axis) const { return Part::varying(axis * row); }

  void add_sum(const Polynomial& p, int result, bool slopes) {
    const Polynomial::Sum& sum = p.sum;
    Step step;
    step.result = result;
    push(step, {sum.scale, sum.first, sum.last});
    Step& pushed = program_.steps.back();
    auto& numbers = program_.step_constants;
    if (p.is_affine() || sum.count == 0) {
      pushed.kernel = affine_kernel(sum.count);
      for (int k = 0; k < sum.count; ++k) {
        pushed.arguments[k].value = coordinate(sum.axis[k]);
        numbers.insert(numbers.end(), {sum.factor[k], p.origin[sum.axis[k]]});
      }
      return;
    }
    pushed.kernel = quadratic_sum_kernel(dimension_, slopes);
    std::array<int, 3> order = sum.axis;
    int count = sum.count;
    for (int axis = 0; axis < dimension_; ++axis)
      if (std::find(order.begin(), order.begin() + count, axis) == order.begin() + count)
        order[count++] = axis;
    for (int k = 0; k < dimension_; ++k) {
      const bool term = k < sum.count;
      const double factor = term ? sum.factor[k] : 0;
      const bool squared = term && sum.squared[k];
      pushed.arguments[k].value = coordinate(order[k]);
      pushed.index |= order[k] << (2 * k);
      numbers.insert(numbers.end(),
                     {p.origin[order[k]], squared ? 0 : factor, squared ? factor : 0});
    }
  }

  void add_gradient(const Polynomial& p, int result) {
    Step step;
    step.kernel = quadric_gradient_kernel(dimension_);
    step.result = result;
    for (int axis = 0; axis < dimension_; ++axis) step.arguments[axis].value = coordinate(axis);
    push(step, {});
    auto& numbers = program_.step_constants;
    numbers.insert(numbers.end(), p.origin.begin(), p.origin.begin() + dimension_);
    for (int a = 0; a < dimension_; ++a) {
      numbers.push_back(p.linear[a]);
      for (int b = 0; b < dimension_; ++b)
        numbers.push_back(2 * p.square[Polynomial::square_index(a, b)]);
    }
  }

  // Roots are dense; those that are not yet are copied.
  void collect_roots() {
    for (const int root : program_.root_instructions) {
      if (is_leaf(root) || polynomial(root)) {
        const int rows = jet_size(dimension_, order_[root]);
        Step step;
        step.kernel = find_kernel(Operation::offset, dimension_, order_[root]);
        step.arguments[0] = registers_[root];
        step.result = take(root, rows);
        step.order = static_cast<std::int16_t>(order_[root]);
        step.variables = static_cast<std::int16_t>(dimension_);
        push(step, {0.0});
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
    for (std::size_t i = 0; i < program_.steps.size(); ++i) {
      Step& step = program_.steps[i];
      step.constants = program_.step_constants.data() + constants_of_step_[i];
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
  const std::vector<Instruction>& code_;
  int dimension_;
  int highest_ = 0;
  std::vector<Polynomial> polynomials_;
  std::vector<const Polynomial*> known_;
  std::vector<int> order_, last_use_;
  std::vector<Register> registers_;
  std::vector<std::vector<std::pair<int, int>>> owned_;
  RowPool pool_;
  ConstantPool constants_;
  std::vector<int> constants_of_step_;
};

}  // namespace

void lower(Tape::Program& program, const std::vector<int>& orders, int dimension) {
  Lowering(program, orders, dimension).run();
}

}  // namespace rfm
