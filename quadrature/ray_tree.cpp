#include "quadrature/ray_tree.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"

namespace rfm {
namespace {

// Parts are known in boxes that are larger than themselves by this part of the whole.
constexpr double margin = 1e-10;

}  // namespace

class RayTree::Builder {
 public:
  Builder(const RegionEvaluator& region, int max_depth, RayTree& tree)
      : region_(region),
        max_depth_(max_depth),
        margin_(margin * tree.bounds_.longest_side()),
        tree_(tree) {}

  void build(int node, const Box& box, SurfaceCandidates candidates, int depth) {
    Box enlarged = box;
    for (int axis = 0; axis < box.dimension; ++axis) {
      enlarged.low[axis] -= margin_;
      enlarged.high[axis] += margin_;
    }
    Truth inside = candidates.narrow(enlarged, false, region_, {});
    if (inside == Truth::unknown && !all_quadrics(candidates))
      inside = candidates.narrow(enlarged, true, region_, {});
    if (inside != Truth::unknown || depth >= max_depth_ || is_simple(candidates, enlarged, depth)) {
      tree_.nodes_[node].below = part(candidates, inside);
      tree_.nodes_[node].gradients = static_cast<int>(tree_.gradients_.size());
      if (inside == Truth::unknown)
        for (const int k : candidates.primitives) {
          const LevelFunction& level = region_.level(k);
          tree_.gradients_.push_back(level.is_quadric() ? RayTree::Gradient{}
                                                        : level.bounds(enlarged).gradient);
        }
      return;
    }
    const int axis = box.longest_axis(), below = static_cast<int>(tree_.nodes_.size());
    const auto halves = bisect(box, axis);
    tree_.nodes_[node] = {halves[0].high[axis], below, axis, 0};
    tree_.nodes_.resize(tree_.nodes_.size() + 2);
    build(below, halves[0], candidates, depth + 1);
    build(below + 1, halves[1], std::move(candidates), depth + 1);
  }

 private:
  bool all_quadrics(const SurfaceCandidates& candidates) const {
    return std::ranges::all_of(candidates.primitives,
                               [&](int k) { return region_.level(k).is_quadric(); });
  }

  // Quadrics are met in closed form: no need of small parts. Other functions are easy where they
  // are monotone in all directions but those that graze their surface.
  bool is_simple(const SurfaceCandidates& candidates, const Box& box, int depth) const {
    const std::size_t count = candidates.primitives.size();
    constexpr std::size_t few = 3;
    if (all_quadrics(candidates)) return count <= few;
    constexpr int small = 9;
    if (count > 1 || depth < small) return false;
    const FunctionBounds bounds = region_.level(candidates.primitives[0]).bounds(box);
    double middle = 0, radius = 0;
    for (int axis = 0; axis < box.dimension; ++axis) {
      middle = std::hypot(middle, bounds.gradient[axis].middle());
      radius = std::hypot(radius, bounds.gradient[axis].radius());
    }
    constexpr double narrow = 0.25;
    return radius < narrow * middle;
  }

  // Many boxes share one part.
  int part(const SurfaceCandidates& candidates, Truth inside) {
    std::vector<Truth> key = candidates.signs;
    if (inside != Truth::unknown) key = {inside};
    const auto [place, is_new] =
        known_.try_emplace({key, candidates.primitives}, tree_.parts_.size());
    if (!is_new) return place->second;
    RegionPart& part = tree_.parts_.emplace_back();
    part.inside = inside;
    if (inside != Truth::unknown) return place->second;
    part.primitives = candidates.primitives;
    part.expression = region_.region().expression();
    std::vector<int> number(candidates.signs.size(), 0);
    for (std::size_t i = 0; i < part.primitives.size(); ++i)
      number[part.primitives[i]] = static_cast<int>(i);
    for (std::size_t k = 0; k < candidates.signs.size(); ++k)
      if (std::ranges::find(part.primitives, static_cast<int>(k)) == part.primitives.end())
        part.expression =
            part.expression.restricted(static_cast<int>(k), candidates.signs[k] == Truth::yes);
    part.expression = part.expression.renamed(number);
    return place->second;
  }

  const RegionEvaluator& region_;
  int max_depth_;
  double margin_;
  RayTree& tree_;
  std::map<std::pair<std::vector<Truth>, std::vector<int>>, int> known_;
};

RayTree::RayTree(const RegionEvaluator& region, const Box& bounds, int max_depth)
    : bounds_(bounds), nodes_(1) {
  if (max_depth < 0 || max_depth > max_allowed_depth)
    throw InvalidArgument("a tree for rays has 0 to " + std::to_string(max_allowed_depth) +
                          " halvings, got " + std::to_string(max_depth));
  Builder(region, max_depth, *this).build(0, bounds, SurfaceCandidates(region, {}), 0);
}

}  // namespace rfm
