#include "core/field_node.hpp"

#include <string>

#include "core/error.hpp"

namespace rfm {
namespace {

constexpr int bits_per_axis = 5;  // orders up to 16

// A sampled field at a place.
Field node_of(const Field::Node& like, std::vector<Field> arguments) {
  auto node = std::make_shared<Field::Node>();
  node->operation = like.operation;
  node->number = like.number;
  node->index = like.index;
  node->source = like.source;
  node->defined_everywhere = false;
  node->arguments = std::move(arguments);
  return Field(std::shared_ptr<const Field::Node>(std::move(node)));
}

}  // namespace

Field with_arguments(const Field& f, std::vector<Field> arguments) {
  const Field::Node& node = f.node();
  if (arguments.size() != node.arguments.size())
    throw InvalidArgument("a node has as many arguments as its operation takes");
  switch (node.operation) {  // those that simplify
    case Operation::add:
      return arguments[0] + arguments[1];
    case Operation::subtract:
      return arguments[0] - arguments[1];
    case Operation::multiply:
      return arguments[0] * arguments[1];
    case Operation::divide:
      return arguments[0] / arguments[1];
    case Operation::negate:
      return -arguments[0];
    case Operation::select:
      return select(arguments[0], arguments[1], arguments[2]);
    case Operation::integer_power:
    case Operation::real_power:
      return pow(arguments[0], node.number);
    case Operation::power:
      return pow(arguments[0], arguments[1]);
    case Operation::partial:
      return partial(arguments[0], node.index);
    case Operation::source:
      return node_of(node, std::move(arguments));
    default: {
      const OperationRow* row = find_operation(node.operation);
      if (!row) return f;  // a leaf
      return apply(node.operation, std::move(arguments),
                   row->numbers > 0 ? std::optional(node.number) : std::nullopt);
    }
  }
}

Field field_at(std::shared_ptr<const FieldSource> source, std::vector<Field> place,
               const MultiIndex& alpha) {
  if (!source) throw InvalidArgument("a field needs a source, got none");
  const int dimension = source->valid().dimension;
  if (static_cast<int>(place.size()) != dimension)
    throw InvalidArgument("a sampled field in " + std::to_string(dimension) +
                          "D is evaluated at places with as many coordinates, got " +
                          std::to_string(place.size()));
  Field::Node like;
  like.operation = Operation::source;
  like.source = std::move(source);
  for (int axis = 0; axis < 3; ++axis) like.index |= alpha[axis] << (bits_per_axis * axis);
  return node_of(like, std::move(place));
}

MultiIndex source_derivative(int index) {
  MultiIndex alpha{};
  for (int axis = 0; axis < 3; ++axis)
    alpha[axis] =
        static_cast<std::uint8_t>(index >> (bits_per_axis * axis) & ((1 << bits_per_axis) - 1));
  return alpha;
}

}  // namespace rfm
