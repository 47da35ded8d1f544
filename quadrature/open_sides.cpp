#include "quadrature/open_sides.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

class LoopFinder {
 public:
  LoopFinder(const std::map<Side, int>& sides, const std::vector<Point>& vertices)
      : vertices_(vertices) {
    for (const auto& [side, count] : sides)
      for (int i = 0; i < count; ++i) leaving_[side.first].push_back(side.second);
  }

  std::vector<std::vector<int>> run() {
    std::vector<std::vector<int>> loops;
    for (auto& [start, targets] : leaving_)
      while (!targets.empty()) {
        std::vector<int> path{start};
        std::unordered_map<int, std::size_t> place{{start, 0}};
        while (!path.empty()) {
          const int next = take(path);
          if (next < 0) break;  // a dead end: no loop
          const auto seen = place.find(next);
          if (seen == place.end()) {
            place[next] = path.size();
            path.push_back(next);
            continue;
          }
          const auto first = path.begin() + static_cast<std::ptrdiff_t>(seen->second);
          loops.emplace_back(first, path.end());
          for (auto vertex = first + 1; vertex != path.end(); ++vertex) place.erase(*vertex);
          path.erase(first + 1, path.end());
          if (path.size() == 1 && leaving_[path[0]].empty()) break;
        }
      }
    return loops;
  }

 private:
  int take(const std::vector<int>& path) {
    std::vector<int>& targets = leaving_[path.back()];
    if (targets.empty()) return -1;
    std::size_t best = 0;
    if (path.size() > 1) {
      const Point& here = vertices_[path.back()];
      const Point back = difference(vertices_[path[path.size() - 2]], here);
      double most = -std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < targets.size(); ++i) {
        const Point on = difference(vertices_[targets[i]], here);
        const double turn =
            (back[0] * on[0] + back[1] * on[1] + back[2] * on[2]) / std::hypot(on[0], on[1], on[2]);
        if (turn > most) {
          most = turn;
          best = i;
        }
      }
    }
    const int target = targets[best];
    targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(best));
    return target;
  }

  const std::vector<Point>& vertices_;
  std::map<int, std::vector<int>> leaving_;
};

}  // namespace

std::map<Side, int> open_sides(const std::vector<Facet>& facets) {
  std::map<Side, int> balance;
  for_each_side(facets, [&](const Side& side, int) {
    ++balance[side];
    --balance[{side.second, side.first}];
  });
  std::erase_if(balance, [](const auto& side) { return side.second <= 0; });
  return balance;
}

std::map<Side, int> primitives_at(const std::map<Side, int>& sides,
                                  const std::vector<Facet>& facets) {
  std::set<std::pair<Side, int>> present;
  for_each_side(facets, [&](const Side& side, int primitive) {
    if (sides.contains(side) || sides.contains({side.second, side.first}))
      present.insert({side, primitive});
  });
  std::map<Side, int> primitives;
  for (const auto& [side, primitive] : present) {
    if (!sides.contains(side)) continue;
    const bool has_opposite = present.contains({{side.second, side.first}, primitive});
    if (!has_opposite)
      primitives[side] = primitive;
    else
      primitives.try_emplace(side, primitive);
  }
  return primitives;
}

std::vector<std::vector<int>> side_loops(const std::map<Side, int>& sides,
                                         const std::vector<Point>& vertices) {
  return LoopFinder(sides, vertices).run();
}

}  // namespace rfm
