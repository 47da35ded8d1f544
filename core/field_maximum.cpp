#include "core/field_maximum.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "core/contour_distance.hpp"
#include "core/ellipsoid_distance.hpp"
#include "core/graph_walk.hpp"
#include "core/mesh_distance.hpp"
#include "core/operations.hpp"
#include "core/table.hpp"

namespace rfm {
namespace {

struct Candidate {
  Box box;
  double at_most;
  bool operator<(const Candidate& other) const { return at_most < other.at_most; }
};

}  // namespace

FieldMaximum field_maximum(const LevelFunction& f, const RegionEvaluator& region, const Box& bounds,
                           const Point& start, const FieldMaximumOptions& options) {
  FieldMaximum best{f.value(start), start};
  std::priority_queue<Candidate> queue;
  const auto offer = [&](const Box& box, double known) {
    ++best.boxes;
    if (region.contains(box) == Truth::no) return;
    const double at_most = std::min(known, f.bounds(box).value.high);
    if (!(at_most > best.value)) return;
    const Point center = box.center();
    if (region.contains(center)) {
      const double value = f.value(center);
      if (value > best.value) {
        best.value = value;
        best.at = center;
      }
    }
    queue.push({box, at_most});
  };
  offer(bounds, INFINITY);
  const double size = f.bounds(bounds).value.magnitude();
  const double enough = options.tolerance * (std::isfinite(size) ? size : std::fabs(best.value));
  while (!queue.empty() && best.boxes < options.most_boxes &&
         queue.top().at_most > best.value + enough) {
    const Candidate candidate = queue.top();
    queue.pop();
    for (const Box& half : bisect(candidate.box, candidate.box.longest_axis()))
      offer(half, candidate.at_most);
  }
  best.at_most = queue.empty() ? best.value : std::max(best.value, queue.top().at_most);
  return best;
}

bool is_geometric(const Field& f) {
  return !any_node(f, [](const Field& field) {
    if (field.node().operation != Operation::source) return false;
    const FieldSource* source = field.node().source.get();
    return dynamic_cast<const ContourDistance*>(source) == nullptr &&
           dynamic_cast<const EllipsoidDistance*>(source) == nullptr &&
           dynamic_cast<const MeshSquareDistance*>(source) == nullptr &&
           dynamic_cast<const Table*>(source) == nullptr;
  });
}

}  // namespace rfm
