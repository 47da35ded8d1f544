#include "problems/periodic_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/tape.hpp"

namespace rfm {
namespace {

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

// A side of the box of a grid.
struct Side {
  int primitive = 0, axis = 0;
  bool high = false;
};

Side side_of_box(const DocumentNode& name, const Region& region, const DomainRule& rule) {
  const auto& primitives = region.primitives();
  const auto found = std::ranges::find_if(
      primitives, [&](const auto& primitive) { return primitive->name == name.text; });
  const Box& box = rule.grid().box();
  const SurfacePoints& points = rule.boundary().points;
  for (int axis = 0; found != primitives.end() && axis < rule.dimension(); ++axis)
    for (const bool high : {false, true}) {
      const int primitive = static_cast<int>(found - primitives.begin());
      const double at = high ? box.high[axis] : box.low[axis];
      bool any = false, all = true;
      for (int i = 0; i < points.size(); ++i) {
        if (points.numbers[i] != primitive) continue;
        any = true;
        all = all && std::fabs(points.point(i)[axis] - at) < 1e-9 * box.longest_side();
      }
      if (any && all) return {primitive, axis, high};
    }
  refuse("'" + name.text + "' is no side of the box of the grid: periodic are two opposite ones",
         name.place);
}

}  // namespace

std::vector<PeriodicPair> periodic_pairs(const Problem& problem, const Region& region,
                                         const DomainRule& rule) {
  std::vector<PeriodicPair> pairs;
  const DocumentNode* conditions = problem.document.find("conditions");
  if (!conditions) return pairs;
  for (const DocumentNode& item : conditions->items) {
    const DocumentNode* periodic = item.find("periodic");
    if (!periodic) continue;
    const DocumentNode &at = *item.find("at"), &to = *periodic->find("to");
    if (!at.is_scalar()) refuse("one side is periodic to one other", at.place);
    const Side first = side_of_box(at, region, rule), second = side_of_box(to, region, rule);
    if (first.axis != second.axis || first.high == second.high)
      refuse(fmt::format("'{}' is not opposite to '{}'", to.text, at.text), to.place);
    pairs.push_back({first.primitive, second.primitive, first.axis, at.place});
  }
  return pairs;
}

std::array<bool, 3> periodic_axes(std::span<const PeriodicPair> pairs) {
  std::array<bool, 3> axes{};
  for (const PeriodicPair& pair : pairs) axes[pair.axis] = true;
  return axes;
}

void check_periodic(const std::vector<Structure>& structures, std::span<const PeriodicPair> pairs,
                    const DomainRule& rule) {
  std::vector<Field> fields;
  for (const Structure& structure : structures) {
    fields.push_back(structure.inhomogeneous());
    for (const Structure::Term& term : structure.terms()) fields.push_back(term.coefficient);
  }
  const Tape tape(fields, std::vector<int>(fields.size(), 0), rule.dimension());
  const Box& box = rule.grid().box();
  const SurfacePoints& points = rule.boundary().points;
  for (const PeriodicPair& pair : pairs) {
    const double first = rule.boundary_measure(pair.first);
    const double second = rule.boundary_measure(pair.second);
    if (std::fabs(first - second) > 1e-9 * first)
      refuse(fmt::format("the two sides are no images of each other: their measures are {:.10g} "
                         "and {:.10g}",
                         first, second),
             pair.place);
    for (int i = 0; i < points.size(); ++i) {
      if (points.numbers[i] != pair.first) continue;
      const Point here = points.point(i);
      Point there = here;
      there[pair.axis] = box.low[pair.axis] + box.high[pair.axis] - here[pair.axis];
      for (int f = 0; f < static_cast<int>(fields.size()); ++f) {
        const double a = tape.value(here, f), b = tape.value(there, f);
        if (std::fabs(a - b) <= 1e-8 * (1 + std::fabs(a))) continue;
        refuse(fmt::format("the structure is not periodic, {:.4g} at ({:.4g}, {:.4g}) and {:.4g} "
                           "on the other side: enforce values at what is between them weakly "
                           "(enforce: weak)",
                           a, here[0], here[1], b),
               pair.place);
      }
    }
  }
}

}  // namespace rfm
