#include "problems/defined_regions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/diagnosis.hpp"
#include "core/tape.hpp"

namespace rfm {

void check_regions_are_defined(const Problem& problem, const RegionEvaluator& region,
                               const DomainRule& rule) {
  const int dimension = rule.dimension();
  const SurfacePoints& points = rule.boundary().points;
  MistakeList mistakes;
  const auto check = [&](const BoundaryTarget& target) {
    if (!target.where) return;
    const Tape where({*target.where}, {0}, dimension);
    for (int i = 0; i < points.size(); ++i) {
      const std::string& piece = region.region().primitives()[points.numbers[i]]->name;
      if (std::ranges::find(target.pieces, piece) == target.pieces.end()) continue;
      const Point point = points.point(i);
      if (!std::isnan(where.value(point))) continue;
      mistakes.add(fmt::format("the 'where' of the region '{}' is not a number at {} on '{}'{}",
                               target.name, point_text(point, dimension), piece,
                               diagnosis_suffix(*target.where, point, dimension)),
                   target.place);
      return;
    }
  };
  for (const Condition& condition : problem.conditions)
    for (const BoundaryTarget& target : condition.targets) check(target);
  for (const Probe& probe : problem.probes)
    if (probe.boundary) check(*probe.boundary);
  mistakes.throw_if_any();
}

}  // namespace rfm
