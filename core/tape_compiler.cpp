#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"
#include "core/tape_program.hpp"

namespace rfm {
namespace {

// What makes two nodes the same function.
struct Key {
  Operation operation;
  int index;
  std::uint64_t number;
  const FieldSource* source;
  std::array<int, 3> operands;
  bool operator==(const Key&) const = default;
};

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    std::size_t hash = static_cast<std::size_t>(key.operation);
    const auto mix = [&hash](std::uint64_t value) {
      hash ^= value + 0x9e3779b97f4a7c15ull + (hash << 6) + (hash >> 2);
    };
    mix(static_cast<std::uint64_t>(key.index));
    mix(key.number);
    mix(reinterpret_cast<std::uintptr_t>(key.source));
    for (int operand : key.operands) mix(static_cast<std::uint64_t>(operand) + 1);
    return hash;
  }
};

class Compiler {
 public:
  explicit Compiler(int dimension) : dimension_(dimension) {}

  int add(const Field& root) {
    // Depth-first with a stack of our own: graphs may be deeper than the machine's stack.
    std::vector<const Field::Node*> pending{&root.node()};
    while (!pending.empty()) {
      const Field::Node* node = pending.back();
      if (number_of_.contains(node)) {
        pending.pop_back();
        continue;
      }
      bool ready = true;
      for (const Field& argument : node->arguments)
        if (!number_of_.contains(&argument.node())) {
          pending.push_back(&argument.node());
          ready = false;
        }
      if (!ready) continue;
      pending.pop_back();
      number_of_[node] = intern(*node);
    }
    return number_of_.at(&root.node());
  }

  std::vector<Instruction> instructions;

 private:
  int intern(const Field::Node& node) {
    Instruction instruction;
    instruction.operation = node.operation;
    instruction.index = node.index;
    instruction.number = node.number;
    instruction.source = node.source;
    for (std::size_t i = 0; i < node.arguments.size(); ++i)
      instruction.operands[i] = number_of_.at(&node.arguments[i].node());
    // A coordinate beyond the dimension is 0 for all points: nothing varies along it.
    if (node.operation == Operation::coordinate && node.index < 3 && node.index >= dimension_) {
      instruction.operation = Operation::constant;
      instruction.index = 0;
    }
    if (node.operation == Operation::partial && node.index >= dimension_) {
      instruction = Instruction();
    }
    simplify(instruction);
    const Key key{instruction.operation, instruction.index,
                  std::bit_cast<std::uint64_t>(instruction.number), instruction.source.get(),
                  instruction.operands};
    const auto [place, inserted] = known_.try_emplace(key, static_cast<int>(instructions.size()));
    if (inserted) instructions.push_back(std::move(instruction));
    return place->second;
  }

  bool constant(int operand) const {
    return instructions[operand].operation == Operation::constant;
  }

  // Sums and products with a constant need no jet for the constant.
  void simplify(Instruction& instruction) const {
    auto& [a, b, c] = instruction.operands;
    const auto become = [&](Operation operation, double number, int operand) {
      instruction.operation = operation;
      instruction.number = number;
      instruction.operands = {operand, -1, -1};
    };
    const auto number = [this](int operand) { return instructions[operand].number; };
    switch (instruction.operation) {
      case Operation::multiply:
        if (constant(b)) return become(Operation::scale, number(b), a);
        if (constant(a)) return become(Operation::scale, number(a), b);
        if (a == b) {
          become(Operation::integer_power, 2, a);
          instruction.index = 2;
          return;
        }
        if (a > b) std::swap(a, b);
        return;
      case Operation::add:
        if (constant(b)) return become(Operation::offset, number(b), a);
        if (constant(a)) return become(Operation::offset, number(a), b);
        if (a > b) std::swap(a, b);
        return;
      case Operation::subtract:
        if (constant(b)) return become(Operation::offset, -number(b), a);
        return;
      default:
        return;
    }
  }

  int dimension_;
  std::unordered_map<const Field::Node*, int> number_of_;
  std::unordered_map<Key, int, KeyHash> known_;
};

// Leaves out what no root needs: constants that went into `scale` and `offset`, and what stood
// below a derivative that is zero.
void remove_unused(std::vector<Instruction>& code, std::vector<int>& roots) {
  std::vector<int> place(code.size(), -1);
  for (int root : roots) place[root] = 0;
  for (std::size_t i = code.size(); i-- > 0;)
    if (place[i] == 0)
      for (int operand : code[i].operands)
        if (operand >= 0) place[operand] = 0;
  int count = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (place[i] < 0) continue;
    place[i] = count;
    Instruction instruction = std::move(code[i]);
    for (int& operand : instruction.operands)
      if (operand >= 0) operand = place[operand];
    code[count++] = std::move(instruction);
  }
  code.resize(count);
  for (int& root : roots) root = place[root];
}

}  // namespace

std::unique_ptr<const Tape::Program> compile(const std::vector<Field>& roots,
                                             const std::vector<int>& orders, int dimension) {
  Compiler compiler(dimension);
  auto program = std::make_unique<Tape::Program>();
  for (const Field& root : roots) program->root_instructions.push_back(compiler.add(root));
  std::vector<Instruction>& code = program->instructions = std::move(compiler.instructions);
  remove_unused(code, program->root_instructions);

  for (std::size_t i = 0; i < roots.size(); ++i) {
    Instruction& root = code[program->root_instructions[i]];
    root.order = std::max(root.order, orders[i]);
  }
  for (int i = static_cast<int>(code.size()) - 1; i >= 0; --i) {
    program->highest_order = std::max(program->highest_order, code[i].order);
    for (int operand : code[i].operands) {
      if (operand < 0) continue;
      const int needed = code[i].order + (code[i].operation == Operation::partial ? 1 : 0);
      code[operand].order = std::max(code[operand].order, needed);
    }
  }
  if (program->highest_order > highest_compiled_order(dimension))
    throw InvalidArgument("derivatives of order " + std::to_string(program->highest_order) +
                          " are needed, but in " + std::to_string(dimension) +
                          "D only orders up to " +
                          std::to_string(highest_compiled_order(dimension)) + " are available");
  lower(*program, orders, dimension);
  return program;
}

}  // namespace rfm
