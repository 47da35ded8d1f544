#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/field_node.hpp"
#include "core/instruction_table.hpp"
#include "core/tape_program.hpp"
#include "core/tape_specialization.hpp"

namespace rfm {
namespace {

class Compiler {
 public:
  explicit Compiler(const Variables& variables) : variables_(variables) {}

  int add(const Field& root) {
    // Depth-first with a stack of our own: graphs may be deeper than the machine's stack.
    std::vector<const Field::Node*> pending{&root.node()};
    while (!pending.empty()) {
      const Field::Node* node = pending.back();
      if (number_of(node) >= 0) {
        pending.pop_back();
        continue;
      }
      bool ready = true;
      for (const Field& argument : node->arguments)
        if (number_of(&argument.node()) < 0) {
          pending.push_back(&argument.node());
          ready = false;
        }
      if (!ready) continue;
      pending.pop_back();
      const int number = intern(*node);
      places_.find_or_insert(hash_of(node), static_cast<int>(nodes_.size()),
                             [](int) { return false; });
      nodes_.push_back({node, number});
    }
    return number_of(&root.node());
  }

  InstructionTable table;
  std::vector<std::string> parameter_names;  ///< by number
  bool has_held_partial = false;             ///< along a coordinate in which no jets are taken

 private:
  static std::uint64_t hash_of(const Field::Node* node) {
    return reinterpret_cast<std::uintptr_t>(node) >> 4;
  }
  int number_of(const Field::Node* node) const {
    const int place = places_.find(hash_of(node), [&](int i) { return nodes_[i].first == node; });
    return place < 0 ? -1 : nodes_[place].second;
  }

  void note_parameter(const Field::Node& node) {
    const auto number = static_cast<std::size_t>(node.index);
    if (number >= parameter_names.size()) parameter_names.resize(number + 1);
    if (!node.name) return;
    std::string& name = parameter_names[number];
    if (!name.empty() && name != *node.name)
      throw InvalidArgument("parameter number " + std::to_string(number) + " is called '" + name +
                            "' and '" + *node.name + "': parameters of two sets meet");
    name = *node.name;
  }

  int intern(const Field::Node& node) {
    if (node.operation == Operation::parameter) note_parameter(node);
    Instruction instruction;
    instruction.operation = node.operation;
    instruction.index = node.index;
    instruction.number = node.number;
    instruction.source = node.source;
    for (std::size_t i = 0; i < node.arguments.size(); ++i)
      instruction.operands[i] = number_of(&node.arguments[i].node());
    // Nothing varies along a coordinate that is 0 for all points.
    if (node.operation == Operation::coordinate || node.operation == Operation::partial) {
      instruction.variable = variables_.find(node.index);
      if (variables_.vanishes(node.index)) instruction = Instruction();
    }
    if (instruction.operation == Operation::partial) {
      has_held_partial = has_held_partial || instruction.variable < 0;
      instruction.index = std::exchange(instruction.variable, -1);
    }
    return table.add(std::move(instruction));
  }

  const Variables& variables_;
  std::vector<std::pair<const Field::Node*, int>> nodes_;  // with the numbers of instructions
  IndexTable places_;
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

// Instructions are complete: leaves out the useless ones and finds orders.
std::unique_ptr<const Tape::Program> finished(std::unique_ptr<Tape::Program> program,
                                              const std::vector<int>& orders) {
  std::vector<Instruction>& code = program->instructions;
  remove_unused(code, program->root_instructions);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    Instruction& root = code[program->root_instructions[i]];
    root.order = std::max(root.order, orders[i]);
  }
  int reached = 0;  // with the derivatives of sampled fields that are taken at mapped points
  for (int i = static_cast<int>(code.size()) - 1; i >= 0; --i) {
    const bool is_mapped = code[i].operation == Operation::source && code[i].operands[0] >= 0;
    const int taken = is_mapped ? degree(source_derivative(code[i].index)) : 0;
    reached = std::max(reached, code[i].order + taken);
    program->highest_order = std::max(program->highest_order, code[i].order);
    for (int operand : code[i].operands) {
      if (operand < 0) continue;
      const int needed = code[i].order + (code[i].operation == Operation::partial ? 1 : 0);
      code[operand].order = std::max(code[operand].order, needed);
    }
  }
  if (reached > maximum_order)
    throw InvalidArgument("derivatives of order " + std::to_string(reached) +
                          " are needed, but only orders up to " + std::to_string(maximum_order) +
                          " are available");
  return program;
}

}  // namespace

std::unique_ptr<const Tape::Program> compile(const std::vector<Field>& roots,
                                             const std::vector<int>& orders,
                                             const Variables& variables) {
  Compiler compiler(variables);
  auto program = std::make_unique<Tape::Program>(variables);
  for (const Field& root : roots) program->root_instructions.push_back(compiler.add(root));
  if (compiler.has_held_partial) {
    std::vector<Field> expressions;
    for (const Field& root : roots) expressions.push_back(without_partials(root));
    return compile(expressions, orders, variables);
  }
  program->instructions = std::move(compiler.table).take();
  program->parameter_names = std::move(compiler.parameter_names);
  return finished(std::move(program), orders);
}

std::unique_ptr<const Tape::Program> specialised(const Tape::Program& original,
                                                 const std::vector<int>& orders, const Box& box) {
  InstructionTable table;
  const std::vector<int> place =
      pruned(original.instructions, ranges_over(original.instructions, box),
             original.root_instructions, table);
  auto program = std::make_unique<Tape::Program>(original.variables);
  for (const int root : original.root_instructions)
    program->root_instructions.push_back(place[root]);
  program->parameter_names = original.parameter_names;
  program->instructions = std::move(table).take();
  return finished(std::move(program), orders);
}

}  // namespace rfm
