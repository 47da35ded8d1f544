#include "quadrature/cell_surfaces.hpp"

#include <algorithm>
#include <set>

#include "quadrature/box_sides.hpp"
#include "quadrature/surface_candidates.hpp"

namespace rfm {
namespace {

// Breakpoints strictly between `low` and `high`, which are ascending.
std::span<const double> between(const std::vector<double>& breakpoints, double low, double high) {
  const auto first = std::ranges::upper_bound(breakpoints, low);
  const auto last = std::ranges::lower_bound(first, breakpoints.end(), high);
  return {first, last};
}

template <class Visit>
void visit_pieces(const Box& box, const Breakpoints& breakpoints, int axis, Visit&& visit) {
  if (axis == box.dimension) return visit(box);
  Box piece = box;
  const auto next = [&](double high) {
    piece.high[axis] = high;
    visit_pieces(piece, breakpoints, axis + 1, visit);
    piece.low[axis] = high;
  };
  for (const double place : between(breakpoints[axis], box.low[axis], box.high[axis])) next(place);
  next(box.high[axis]);
}

bool is_few(std::size_t primitives, std::size_t interfaces) {
  return primitives <= static_cast<std::size_t>(TruthTable::max_variables) &&
         primitives + interfaces <= static_cast<std::size_t>(ActiveSet::capacity);
}

// Roots and real powers, and bounds of them, take as long as many sums.
int weight_of(Operation operation) {
  constexpr int of_roots = 16;
  const bool is_root = operation == Operation::cbrt || operation == Operation::real_power ||
                       operation == Operation::power;
  return is_root ? of_roots : 1;
}

// The nodes of the graph of an expression, dear ones several times.
int count_operations(const Field& field, std::set<const Field::Node*>& seen) {
  if (!seen.insert(&field.node()).second) return 0;
  int count = weight_of(field.node().operation);
  for (const Field& argument : field.node().arguments) count += count_operations(argument, seen);
  return count;
}

}  // namespace

bool is_split(const Box& box, const Breakpoints& breakpoints) {
  for (int axis = 0; axis < box.dimension; ++axis)
    if (!between(breakpoints[axis], box.low[axis], box.high[axis]).empty()) return true;
  return false;
}

CellSurfaces::CellSurfaces(const RegionEvaluator& region, const Interfaces& interfaces)
    : region_(region), all_interfaces_(interfaces) {
  for (int k = 0; k < region.primitive_count(); ++k) {
    Surface& surface = primitives_.emplace_back(region.level(k));
    if (region.level(k).is_quadric()) continue;
    std::set<const Field::Node*> seen;
    surface.set_cost(
        WorkCost::of_operations(count_operations(region.region().primitives()[k]->level, seen)));
  }
  // Their expressions are not known any more.
  constexpr int operations_of_interface = 30;
  for (const LevelFunction& level : interfaces.levels()) {
    Surface& surface = interfaces_.emplace_back(level);
    if (!level.is_quadric()) surface.set_cost(WorkCost::of_operations(operations_of_interface));
  }
}

Breakpoints CellSurfaces::breakpoints(const Breakpoints& others) const {
  Breakpoints all = others;
  for (int axis = 0; axis < region_.dimension(); ++axis) {
    const auto add = [&](const std::vector<Surface>& surfaces) {
      for (const Surface& surface : surfaces) {
        const auto& more = surface.level()->breakpoints(axis);
        all[axis].insert(all[axis].end(), more.begin(), more.end());
      }
    };
    add(primitives_);
    add(interfaces_);
    std::ranges::sort(all[axis]);
  }
  return all;
}

ActiveSet CellSurfaces::active_set(const TruthTable& table, std::span<const int> primitives,
                                   std::span<const int> interfaces) const {
  ActiveSet active;
  active.table = table;
  for (const int k : primitives) active.add(primitives_[k], k);
  for (const int k : interfaces) active.add(interfaces_[k], k);
  return active;
}

Uncertified CellSurfaces::visit_cut_cell(const CellClassification& classification, int cut_cell,
                                         const Box& box, const Breakpoints& breakpoints,
                                         const BoxVisitor& visit) const {
  const auto primitives = classification.primitives(cut_cell);
  const auto interfaces = classification.interfaces(cut_cell);
  if (is_few(primitives.size(), interfaces.size())) {
    const ActiveSet active = active_set(classification.table(cut_cell), primitives, interfaces);
    visit_pieces(box, breakpoints, 0, [&](const Box& piece) { visit(piece, active); });
    return {};
  }
  Uncertified uncertified;
  visit_pieces(box, breakpoints, 0, [&](const Box& piece) {
    uncertified += visit_crowded(piece, SurfaceCandidates(region_, all_interfaces_), 0, visit);
  });
  return uncertified;
}

void CellSurfaces::visit_inside_cell(const Box& box, const Breakpoints& breakpoints,
                                     const BoxVisitor& visit) const {
  visit_pieces(box, breakpoints, 0, [&](const Box& piece) { visit(piece, ActiveSet{}); });
}

Uncertified CellSurfaces::visit_crowded(const Box& box, SurfaceCandidates candidates, int depth,
                                        const BoxVisitor& visit) const {
  const Truth inside = candidates.narrow(box, true, region_, all_interfaces_);
  if (inside == Truth::no) return {};
  if (is_few(candidates.primitives.size(), candidates.interfaces.size())) {
    const TruthTable table = candidates.make_table(region_.region().expression());
    visit(box, active_set(table, candidates.primitives, candidates.interfaces));
    return {};
  }
  const int max_depth = 12 * box.dimension;
  if (depth == max_depth) {
    ActiveSet center;
    center.table = TruthTable(region_.contains(box.center()));
    visit(box, center);
    return {1, box.measure(),
            static_cast<double>(candidates.primitives.size()) * measure_of_sides(box)};
  }
  Uncertified uncertified;
  for (const Box& half : bisect(box, box.longest_axis()))
    uncertified += visit_crowded(half, candidates, depth + 1, visit);
  return uncertified;
}

}  // namespace rfm
