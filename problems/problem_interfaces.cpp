#include "problems/problem_interfaces.hpp"

#include <algorithm>

#include "problems/interpolation.hpp"
#include "problems/structure_options.hpp"

namespace rfm {

ProblemInterfaces::ProblemInterfaces(const Problem& problem) {
  for (const Material& material : problem.physics.materials)
    if (material.region) add_boundary_of(*material.region);
  const StructureOptions inner = structure_options(problem);
  for (const InterfaceCondition& interface : inner.interfaces) add_boundary_of(interface.region);
  for (const WindowOption& window : inner.windows) add_boundary_of(window.region);
  for (const SetValue& value : inner.values)
    if (value.where.surface) levels_.emplace_back(*value.where.surface, problem.dimension);
  if (problem.physics.type == PhysicsType::interpolation)
    for (const InterpolationDatum& datum : inner_interpolation_data(problem)) {
      if (datum.region) add_boundary_of(*datum.region);
      if (datum.surface) levels_.emplace_back(*datum.surface, problem.dimension);
    }
  for (const Probe& probe : problem.probes)
    if (probe.region) add_boundary_of(*probe.region);
  for (const Probe& probe : problem.probes)
    if (probe.boundary) add_ends(*probe.boundary, problem.dimension);
  for (const Condition& condition : problem.conditions)
    for (const BoundaryTarget& target : condition.targets) add_ends(target, problem.dimension);
  if (problem.physics.custom)
    for (const CustomPhysics::BoundaryForm& form : problem.physics.custom->boundary)
      for (const BoundaryTarget& target : form.targets) add_ends(target, problem.dimension);
}

void ProblemInterfaces::add_boundary_of(const Region& region) {
  for (const auto& primitive : region.primitives())
    levels_.emplace_back(primitive->level, region.dimension());
}

// Several pieces, and several conditions and probes, have ends in common.
void ProblemInterfaces::add_ends(const BoundaryTarget& target, int dimension) {
  const auto is_known = [&](const Field& end) {
    return std::ranges::any_of(functions_, [&](const Field& other) { return other.same_as(end); });
  };
  const auto add = [&](const PartEnds& part) {
    BoundaryEnds ends{static_cast<int>(levels_.size()), 0, part.locator};
    // Those that a locator knows by number stay together.
    if (part.locator && is_known(part.functions.front())) return;
    for (const Field& end : part.functions) {
      if (!part.locator && is_known(end)) continue;
      functions_.push_back(end);
      levels_.emplace_back(end, dimension);
    }
    ends.end = static_cast<int>(levels_.size());
    if (ends.end > ends.begin) ends_.push_back(ends);
  };
  if (target.where) add({{*target.where}});
  for (const PartEnds& part : target.ends) add(part);
}

}  // namespace rfm
