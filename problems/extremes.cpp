#include "problems/extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/field_maximum.hpp"
#include "quadrature/integrate.hpp"
#include "solvers/stationary_point.hpp"

namespace rfm {
namespace {

constexpr double nowhere = -std::numeric_limits<double>::infinity();

void keep_larger(Extreme& best, const Extreme& other) {
  if (other.value > best.value) best = other;
}

// Values of a field at the points of a block where `where` is ≥ 0.
class PointScan {
 public:
  PointScan(const Field& f, const std::optional<Field>& where, int dimension)
      : tape_({f, where.value_or(1.0)}, {0, 0}, dimension), workspace_(tape_) {}

  template <class Visit>
  void visit(const QuadratureBlock& block, const Visit& visit) {
    tape_.evaluate({block.coordinates, block.count}, workspace_);
    for (int i = 0; i < block.count; ++i) {
      if (workspace_.coefficient(1)[i] < 0) continue;
      Point point{};
      for (int axis = 0; axis < tape_.dimension(); ++axis) point[axis] = block.coordinates[axis][i];
      for (const int root : {1, 0})  // what is not a number would pass for smaller than all else
        if (!std::isfinite(workspace_.coefficient(root)[i]))
          throw ComputationError((root == 1 ? "the condition of its part" : "its value") +
                                 std::string(" is not a finite number at the point ") +
                                 point_text(point, tape_.dimension()) +
                                 diagnosis_suffix(tape_.roots()[root], point, tape_.dimension()));
      visit(i, point, workspace_.coefficient(0)[i]);
    }
  }

 private:
  Tape tape_;
  Tape::Workspace workspace_;
};

// Improves a sampled maximum: stationary points on every set of boundaries near it.
class Improvement {
 public:
  Improvement(const Field& f, const RegionEvaluator& region, const Grid& grid,
              const std::optional<Field>& where, const Extreme& start)
      : region_(region),
        has_where_(where.has_value()),
        start_(start),
        best_(start),
        scale_(grid.box().longest_side()),
        near_(primitives_near(region, grid, start.at)),
        points_(f, constraints(region, near_, where), grid.dimension()) {
    reach_ = grid.largest_diagonal();
  }

  // Over the sets of at most `dimension` boundaries that hold all of `always`.
  Extreme run(const std::vector<int>& always) {
    std::vector<int> active;
    for (int k : always)
      active.push_back(static_cast<int>(std::ranges::find(near_, k) - near_.begin()));
    try_sets(active, 0);
    return best_;
  }

 private:
  static std::vector<int> primitives_near(const RegionEvaluator& region, const Grid& grid,
                                          const Point& point) {
    const double reach = grid.largest_diagonal();
    std::vector<int> near;
    for (int k = 0; k < region.primitive_count(); ++k) {
      Point gradient;
      const double value = region.level(k).value_and_gradient(point, gradient);
      if (std::fabs(value) <= reach * std::hypot(gradient[0], gradient[1], gradient[2]))
        near.push_back(k);
    }
    return near;
  }

  static std::vector<Field> constraints(const RegionEvaluator& region, const std::vector<int>& near,
                                        const std::optional<Field>& where) {
    std::vector<Field> fields;
    for (int k : near) fields.push_back(region.region().primitives()[k]->level);
    if (where) fields.push_back(*where);
    return fields;
  }

  void try_sets(std::vector<int>& active, int first) {
    if (const auto place = points_.find(active, start_.at, 2 * reach_)) offer(*place);
    if (static_cast<int>(active.size()) == region_.dimension()) return;
    const int count = static_cast<int>(near_.size()) + (has_where_ ? 1 : 0);
    for (int k = first; k < count; ++k) {
      if (std::ranges::find(active, k) != active.end()) continue;
      active.push_back(k);
      try_sets(active, k + 1);
      active.pop_back();
    }
  }

  void offer(const Point& place) {
    if (!region_.contains(place, 1e-12 * scale_)) return;
    if (has_where_ && !(points_.constraint(static_cast<int>(near_.size()), place) >= -1e-12))
      return;
    const double value = points_.value(place);
    if (std::isfinite(value)) keep_larger(best_, {value, place});
  }

  const RegionEvaluator& region_;
  bool has_where_;
  Extreme start_, best_;
  double scale_, reach_ = 0;
  std::vector<int> near_;
  StationaryPoints points_;
};

}  // namespace

Extreme maximum_over_boundary(const Field& f, const RegionEvaluator& region, const DomainRule& rule,
                              const std::vector<int>& primitives,
                              const std::optional<Field>& where) {
  PointScan scan(f, where, rule.dimension());
  Extreme best{nowhere, {}};
  int best_primitive = -1;
  const SurfaceBlocks blocks(rule.boundary());
  for (int k = 0; k < blocks.count(); ++k) {
    const QuadratureBlock block = blocks.block(k);
    scan.visit(block, [&](int i, const Point& point, double value) {
      if (!primitives.empty() &&
          std::ranges::find(primitives, block.numbers[i]) == primitives.end())
        return;
      if (value > best.value) {
        best = {value, point};
        best_primitive = block.numbers[i];
      }
    });
  }
  if (best_primitive < 0)
    throw ComputationError("a probe over a part of the boundary has no points");
  return Improvement(f, region, rule.grid(), where, best).run({best_primitive});
}

Extreme maximum_over_volume(const Field& f, const RegionEvaluator& region, const DomainRule& rule) {
  PointScan scan(f, {}, rule.dimension());
  Extreme best{nowhere, {}};
  const VolumeBlocks blocks(rule);
  VolumeBlocks::Buffer buffer;
  for (int k = 0; k < blocks.count(); ++k)
    scan.visit(blocks.block(k, buffer), [&](int, const Point& point, double value) {
      keep_larger(best, {value, point});
    });
  if (!std::isfinite(best.value))
    throw ComputationError("a probe over a part of the domain has no points");
  best = Improvement(f, region, rule.grid(), {}, best).run({});
  if (is_geometric(f)) {
    const LevelFunction function(f, rule.dimension());
    const FieldMaximum found = field_maximum(function, region, rule.grid().box(), best.at);
    keep_larger(best, {found.value, found.at});
  }
  keep_larger(best, maximum_over_boundary(f, region, rule, {}));
  return best;
}

}  // namespace rfm
