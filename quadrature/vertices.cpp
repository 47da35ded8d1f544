#include "quadrature/vertices.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>

#include "core/point_algebra.hpp"
#include "quadrature/candidate_boxes.hpp"
#include "quadrature/local_structure.hpp"
#include "quadrature/zero_isolation.hpp"

namespace rfm {
namespace {

double maximum_distance(const Point& a, const Point& b) {
  double distance = 0;
  for (int axis = 0; axis < 3; ++axis) distance = std::max(distance, std::fabs(a[axis] - b[axis]));
  return distance;
}

class VertexFinder {
 public:
  VertexFinder(const RegionEvaluator& region, const Box& box)
      : region_(region), box_(box), size_(box.longest_side()) {}

  VertexSearch run() {
    // Small enough that few primitives meet in a part.
    constexpr double parts = 16;
    if (box_.dimension > 1)
      result_.crowded_boxes = visit_candidate_boxes(region_, box_, size_ / parts,
                                                    [&](const CandidateBox& part) { visit(part); });
    std::ranges::sort(result_.vertices, {}, &Vertex::point);
    for (const auto& [surfaces, boxes] : of_two_)
      if (!touching_along_a_curve_.contains(surfaces))
        unresolved_.insert(unresolved_.end(), boxes.begin(), boxes.end());
    for (const auto& [surfaces, boxes] : of_three_)
      if (!sharing_a_curve_.contains(surfaces))
        unresolved_.insert(unresolved_.end(), boxes.begin(), boxes.end());
    cluster_unresolved();
    return std::move(result_);
  }

 private:
  void visit(const CandidateBox& part) {
    if (box_.dimension == 2) {
      for (const PrimitivePair& pair : part.pairs) search(part, {pair.first, pair.second});
      return;
    }
    for (const PrimitivePair& pair : part.pairs) search_contact(part, pair);
    const int count = static_cast<int>(part.primitives.size());
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j)
        for (int k = j + 1; k < count; ++k)
          if (is_triple(part, {i, j, k})) search(part, {i, j, k});
  }

  // Three surfaces, two pairs of which may form edges.
  static bool is_triple(const CandidateBox& part, const std::array<int, 3>& variables) {
    int pairs = 0;
    for (const PrimitivePair& pair : part.pairs)
      pairs += std::ranges::count(variables, pair.first) == 1 &&
               std::ranges::count(variables, pair.second) == 1;
    return pairs >= 2;
  }

  void search(const CandidateBox& part, std::vector<int> variables) {
    static constexpr std::array<int, 3> axes{0, 1, 2};
    std::vector<const LevelFunction*> functions;
    for (const int v : variables) functions.push_back(&region_.level(part.primitives[v]));
    const std::span used(axes.begin(), static_cast<std::size_t>(box_.dimension));
    const auto isolate = [&](const Box& box, const ZeroSearchOptions& options) {
      ZeroSet zeros = isolate_zeros(functions, box, used, options);
      for (const Point& point : zeros.zeros) add(part, point);
      return std::move(zeros.unresolved);
    };
    if (box_.dimension == 2) {
      const std::vector<Box> boxes = isolate(part.box, {});
      unresolved_.insert(unresolved_.end(), boxes.begin(), boxes.end());
      return;
    }
    std::array<int, 3> surfaces{};
    for (int i = 0; i < 3; ++i) surfaces[i] = part.surfaces[variables[i]];
    std::ranges::sort(surfaces);
    // Three surfaces may have a curve in common, as a plane, the torus that rounds its edge and the
    // surface that tells one from the other: of boxes along it there are many before they are
    // small.
    constexpr double coarse = 0x1p-7, fine = 0x1p-14;
    constexpr int most_coarse = 128, most_fine = 256;
    const std::vector<Box> boxes = isolate(part.box, {coarse, most_coarse});
    if (boxes.size() >= most_coarse) sharing_a_curve_.insert(surfaces);
    if (boxes.empty() || sharing_a_curve_.contains(surfaces)) return;
    std::vector<Box>& small = of_three_[surfaces];
    std::size_t count = 0;
    for (const Box& box : boxes) {
      const std::vector<Box> found = isolate(box, {fine / coarse, most_fine});
      small.insert(small.end(), found.begin(), found.end());
      count += found.size();
      if (count < most_fine) continue;
      sharing_a_curve_.insert(surfaces);
      return;
    }
  }

  // Where two surfaces of space touch in a point, or cross in curves that meet in a point: halves
  // boxes until they are few and small. Where they are many the surfaces touch along a curve or are
  // one, and there is no point to tell.
  void search_contact(const CandidateBox& part, const PrimitivePair& pair) {
    constexpr std::size_t most_boxes = 96;
    constexpr int halvings = 3 * 12;
    const std::array<int, 2> surfaces{
        std::min(part.surfaces[pair.first], part.surfaces[pair.second]),
        std::max(part.surfaces[pair.first], part.surfaces[pair.second])};
    if (touching_along_a_curve_.contains(surfaces)) return;
    const LevelFunction& f = region_.level(part.primitives[pair.first]);
    const LevelFunction& g = region_.level(part.primitives[pair.second]);
    std::vector<Box> boxes{part.box}, next;
    for (int level = 0; level < halvings && !boxes.empty(); ++level) {
      if (boxes.size() > most_boxes) {
        touching_along_a_curve_.insert(surfaces);
        return;
      }
      next.clear();
      for (const Box& box : boxes)
        for (const Box& half : bisect(box, box.longest_axis()))
          if (may_touch(f, g, half)) next.push_back(half);
      std::swap(boxes, next);
    }
    std::vector<Box>& small = of_two_[surfaces];
    small.insert(small.end(), boxes.begin(), boxes.end());
  }

  // Whether bounds leave open that both vanish in a box with parallel gradients.
  static bool may_touch(const LevelFunction& f, const LevelFunction& g, const Box& box) {
    const FunctionBounds a = f.bounds(box);
    if (a.value.excludes_zero()) return false;
    const FunctionBounds b = g.bounds(box);
    if (b.value.excludes_zero()) return false;
    for (int axis = 0; axis < 3; ++axis) {
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      if ((a.gradient[i] * b.gradient[j] - a.gradient[j] * b.gradient[i]).excludes_zero())
        return false;
    }
    return true;
  }

  void add(const CandidateBox& part, const Point& point) {
    constexpr double same = 1e-9;
    for (const Vertex& other : result_.vertices)
      if (maximum_distance(other.point, point) <= same * size_) return;
    constexpr double rounding = 1e-12;
    const LocalStructure structure(region_, part.table, part.primitives, point, rounding * size_);
    Vertex vertex{point, structure.primitives, 0, 0};
    if (box_.dimension == 2) {
      const SectorWalk walk = walk_sectors(structure, {1, 0, 0}, {0, 1, 0});
      if (!walk.is_corner) return;
      vertex.angle = walk.angle;
      vertex.edges = walk.rays;
    } else {
      const VertexStructure corner = vertex_structure(structure);
      if (!corner.is_vertex) return;
      vertex.angle = corner.solid_angle;
      vertex.edges = corner.edges;
    }
    result_.vertices.push_back(std::move(vertex));
  }

  // The middles of groups of boxes that touch.
  void cluster_unresolved() {
    std::vector<Box> groups;
    for (const Box& box : unresolved_) {
      Box grown = box;
      std::erase_if(groups, [&](const Box& group) {
        for (int axis = 0; axis < box_.dimension; ++axis)
          if (group.low[axis] > grown.high[axis] + box.length(axis) ||
              group.high[axis] < grown.low[axis] - box.length(axis))
            return false;
        for (int axis = 0; axis < box_.dimension; ++axis) {
          grown.low[axis] = std::min(grown.low[axis], group.low[axis]);
          grown.high[axis] = std::max(grown.high[axis], group.high[axis]);
        }
        return true;
      });
      groups.push_back(grown);
    }
    for (const Box& group : groups) result_.unresolved.push_back(group.center());
    std::ranges::sort(result_.unresolved);
  }

  const RegionEvaluator& region_;
  const Box& box_;
  double size_;
  std::vector<Box> unresolved_;
  // Of two or three surfaces, unless they touch along a curve or have one in common somewhere: then
  // no point of it is one to tell, however short the curve is in another part.
  std::map<std::array<int, 2>, std::vector<Box>> of_two_;
  std::set<std::array<int, 2>> touching_along_a_curve_;
  std::map<std::array<int, 3>, std::vector<Box>> of_three_;
  std::set<std::array<int, 3>> sharing_a_curve_;
  VertexSearch result_;
};

}  // namespace

VertexSearch find_vertices(const RegionEvaluator& region, const Box& box) {
  return VertexFinder(region, box).run();
}

}  // namespace rfm
