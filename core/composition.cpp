#include "core/composition.hpp"

#include <map>

#include "core/field_node.hpp"
#include "core/further_coordinate.hpp"
#include "core/graph_derivative.hpp"
#include "core/graph_walk.hpp"

namespace rfm {
namespace {

bool same_arguments(const Field& field, const std::vector<Field>& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (!arguments[i].same_as(field.node().arguments[i])) return false;
  return true;
}

}  // namespace

Field with_leaves(const Field& f, const std::function<Field(const Field&)>& leaf) {
  return walked<Field>(f, leaf, [](const Field& field, std::vector<Field> arguments) -> Field {
    return same_arguments(field, arguments) ? field : with_arguments(field, std::move(arguments));
  });
}

Field without_partials(const Field& f) {
  std::map<int, GraphDerivative> along;
  const auto variable = [](int axis) {
    return axis < 4 ? coordinate(axis) : further_coordinate(axis);
  };
  return walked<Field>(
      f, [](const Field& leaf) { return leaf; },
      [&](const Field& field, std::vector<Field> arguments) -> Field {
        const Field::Node& node = field.node();
        if (node.operation == Operation::partial)
          return along.try_emplace(node.index, variable(node.index)).first->second.of(arguments[0]);
        return same_arguments(field, arguments) ? field : with_arguments(field, arguments);
      });
}

Field compose(const Field& f, const std::vector<Field>& map) {
  const auto image = [&](int index) {
    return index < static_cast<int>(map.size()) ? map[index] : coordinate(index);
  };
  return with_leaves(without_partials(f), [&](const Field& leaf) -> Field {
    const Field::Node& node = leaf.node();
    if (node.operation == Operation::coordinate)
      return node.index < static_cast<int>(map.size()) ? map[node.index] : leaf;
    if (node.operation != Operation::source) return leaf;
    std::vector<Field> place;
    for (int axis = 0; axis < node.source->valid().dimension; ++axis) place.push_back(image(axis));
    return field_at(node.source, std::move(place));
  });
}

Field normalizer(const Field& f, const Field& omega, int dimension) {
  std::vector<Field> foot;
  for (int axis = 0; axis < dimension; ++axis)
    foot.push_back(coordinate(axis) - omega * partial(omega, axis));
  return compose(f, foot);
}

}  // namespace rfm
