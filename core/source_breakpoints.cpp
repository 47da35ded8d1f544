#include "core/source_breakpoints.hpp"

#include <algorithm>
#include <optional>

#include "core/field_node.hpp"
#include "core/graph_walk.hpp"
#include "core/quadric.hpp"

namespace rfm {
namespace {

/// offset + slope · (x_axis − origin).
struct AxisMap {
  int axis;
  double origin, slope, offset;
};

std::optional<AxisMap> axis_map(const Field& component, int dimension) {
  const std::optional<Quadric> polynomial = as_quadric(component, dimension);
  if (!polynomial || !polynomial->is_affine()) return std::nullopt;
  std::optional<AxisMap> map;
  for (int axis = 0; axis < 3; ++axis) {
    if (polynomial->linear[axis] == 0) continue;
    if (map) return std::nullopt;
    map = {axis, polynomial->origin[axis], polynomial->linear[axis], polynomial->constant};
  }
  return map;
}

}  // namespace

std::vector<const Field::Node*> sources_of(const Field& field) {
  std::vector<const Field::Node*> sources;
  any_node(field, [&](const Field& part) {
    if (part.node().source) sources.push_back(&part.node());
    return false;
  });
  return sources;
}

std::array<std::vector<double>, 3> source_breakpoints(const Field& field, int dimension) {
  std::array<std::vector<double>, 3> breakpoints;
  for (const Field::Node* node : sources_of(field))
    for (int own = 0; own < node->source->valid().dimension; ++own) {
      const auto component = static_cast<std::size_t>(own);
      const std::optional<AxisMap> map = node->arguments.empty()
                                             ? AxisMap{own, 0, 1, 0}
                                             : axis_map(node->arguments[component], dimension);
      if (!map || map->axis >= dimension) continue;
      for (const double knot : node->source->breakpoints(own))
        breakpoints[static_cast<std::size_t>(map->axis)].push_back(
            map->origin + (knot - map->offset) / map->slope);
    }
  for (auto& list : breakpoints) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return breakpoints;
}

}  // namespace rfm
