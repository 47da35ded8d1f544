#include "solution_structures/structure_formula.hpp"

#include <string>

#include "core/error.hpp"
#include "core/graph_walk.hpp"
#include "solution_structures/undetermined.hpp"

namespace rfm {
namespace {

struct Part {
  bool is_determined = true;  // no Ψ in it
  Structure structure;
};

[[noreturn]] void refuse(const std::string& what) {
  throw InvalidArgument("a structure must be affine in its undetermined functions: " + what);
}

Part leaf_part(const Field& leaf) {
  const std::optional<int> unknown = undetermined_index(leaf.node());
  return unknown ? Part{false, Structure::undetermined(*unknown)} : Part{true, leaf};
}

Structure combined(const Field& field, const std::vector<Part>& arguments) {
  const Field::Node& node = field.node();
  const auto structure = [&](std::size_t i) -> const Structure& { return arguments[i].structure; };
  const auto determined = [&](std::size_t i, const char* otherwise) -> const Field& {
    if (!arguments[i].is_determined) refuse(otherwise);
    return node.arguments[i];
  };
  switch (node.operation) {
    case Operation::add:
      return structure(0) + structure(1);
    case Operation::subtract:
      return structure(0) - structure(1);
    case Operation::negate:
      return -structure(0);
    case Operation::multiply:
      if (arguments[0].is_determined) return node.arguments[0] * structure(1);
      return determined(1, "a product of two of them is not") * structure(0);
    case Operation::divide:
      return structure(0) / determined(1, "they must not stand in a divisor");
    case Operation::select:
      return select(determined(0, "a condition must not depend on them"), structure(1),
                    structure(2));
    case Operation::partial:
      if (node.index > 2) refuse("derivatives are along x, y and z");
      return partial(structure(0), node.index);
    case Operation::source:
      refuse("they cannot be taken at another point");
    default: {
      const OperationRow* row = find_operation(node.operation);
      refuse((row ? std::string(row->name) : "this function") + " of one is not");
    }
  }
}

}  // namespace

Structure structure_of(const Field& formula) {
  const Part root =
      walked<Part>(formula, leaf_part, [](const Field& field, const std::vector<Part>& arguments) {
        bool is_determined = !undetermined_index(field.node());
        for (const Part& argument : arguments)
          is_determined = is_determined && argument.is_determined;
        return is_determined ? Part{true, field} : Part{false, combined(field, arguments)};
      });
  return root.structure.written_as(formula);
}

}  // namespace rfm
