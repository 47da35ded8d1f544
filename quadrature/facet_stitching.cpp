#include "quadrature/facet_stitching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

using Side = std::pair<int, int>;

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

template <class Visit>
void for_each_side(const std::vector<Facet>& facets, Visit&& visit) {
  for (const Facet& facet : facets)
    for (int i = 0; i < 3; ++i)
      visit(Side{facet.vertices[i], facet.vertices[(i + 1) % 3]}, facet.primitive);
}

// Directed sides and how many more there are of them than of their opposites.
std::map<Side, int> open_sides(const std::vector<Facet>& facets) {
  std::map<Side, int> balance;
  for_each_side(facets, [&](const Side& side, int) {
    ++balance[side];
    --balance[{side.second, side.first}];
  });
  std::erase_if(balance, [](const auto& side) { return side.second <= 0; });
  return balance;
}

// The piece at each of some sides. Where a side is that of two pieces, the one is meant whose
// opposite is missing.
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

// Takes directed sides apart into loops that visit no vertex twice. Where several sides leave a
// vertex the one that turns back most is taken: the two sides of a crack are next to each other.
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

// The part of a loop from one of its places to another, both included.
std::vector<int> way(const std::vector<int>& loop, std::size_t from, std::size_t to) {
  std::vector<int> vertices{loop[from]};
  while (from != to) {
    from = (from + 1) % loop.size();
    vertices.push_back(loop[from]);
  }
  return vertices;
}

std::vector<double> arc_lengths(const std::vector<int>& way, const std::vector<Point>& vertices) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < way.size(); ++i)
    lengths.push_back(lengths.back() + distance(vertices[way[i - 1]], vertices[way[i]]));
  return lengths;
}

// What the triangle at a directed side gets, and the piece it comes from: where a side is that of
// two triangles, as on an edge of the region, it is for the one of the same piece.
struct Insertion {
  std::vector<int> vertices;
  int primitive = 0;
};
using Insertions = std::map<Side, Insertion>;
using Primitives = std::map<Side, int>;

// Gives the sides of `to` the vertices inside `from`, which runs the opposite way between the same
// ends.
void insert(const std::vector<int>& to, const std::vector<int>& from,
            const std::vector<Point>& vertices, const Primitives& primitives,
            Insertions& insertions) {
  const std::vector<double> at = arc_lengths(to, vertices), source = arc_lengths(from, vertices);
  std::size_t side = 0;
  for (std::size_t i = from.size() - 2; i > 0; --i) {
    const double share = (source.back() - source[i]) / source.back();
    while (side + 2 < to.size() && at[side + 1] / at.back() <= share) ++side;
    Insertion& insertion = insertions[{to[side], to[side + 1]}];
    insertion.vertices.push_back(from[i]);
    insertion.primitive = primitives.at({from[i], from[i + 1]});
  }
}

void close_crack(const std::vector<int>& loop, const std::vector<Point>& vertices,
                 const Primitives& primitives, Insertions& insertions) {
  std::size_t first = 0, second = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    for (std::size_t j = i + 1; j < loop.size(); ++j) {
      const double between = distance(vertices[loop[i]], vertices[loop[j]]);
      if (between <= farthest) continue;
      farthest = between;
      first = i;
      second = j;
    }
  const std::vector<int> there = way(loop, first, second), back = way(loop, second, first);
  const double out = arc_lengths(there, vertices).back(), in = arc_lengths(back, vertices).back();
  // The two ways along a crack are of nearly one length.
  constexpr double alike = 0.7;
  if (std::min(out, in) < alike * std::max(out, in)) return;
  insert(there, back, vertices, primitives, insertions);
  insert(back, there, vertices, primitives, insertions);
}

// Divides a polygon into the triangles of least total length of sides, none of them with all its
// corners on one side of the triangle that the polygon was (`side_of` of a vertex: up to two of 0 …
// 2 as bits).
class PolygonDivision {
 public:
  PolygonDivision(const std::vector<int>& polygon, const std::vector<unsigned>& sides,
                  const std::vector<Point>& vertices)
      : polygon_(polygon),
        sides_(sides),
        vertices_(vertices),
        cost_(polygon.size() * polygon.size(), 0.0),
        split_(polygon.size() * polygon.size(), 0) {
    const std::size_t count = polygon.size();
    for (std::size_t span = 2; span < count; ++span)
      for (std::size_t i = 0; i + span < count; ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = i + 1; k < i + span; ++k) {
          const double cost =
              cost_[index(i, k)] + cost_[index(k, i + span)] + corner_cost(i, k, i + span);
          if (cost < least) {
            least = cost;
            split_[index(i, i + span)] = k;
          }
        }
        cost_[index(i, i + span)] = least;
      }
  }

  void append(int primitive, std::vector<Facet>& facets) const {
    append(0, polygon_.size() - 1, primitive, facets);
  }

 private:
  std::size_t index(std::size_t i, std::size_t j) const { return i * polygon_.size() + j; }

  double corner_cost(std::size_t a, std::size_t b, std::size_t c) const {
    constexpr double forbidden = 1e6;
    const Point &p = vertices_[polygon_[a]], &q = vertices_[polygon_[b]],
                &r = vertices_[polygon_[c]];
    const double around = distance(p, q) + distance(q, r) + distance(r, p);
    return (sides_[a] & sides_[b] & sides_[c]) != 0 ? forbidden * around : around;
  }

  void append(std::size_t i, std::size_t j, int primitive, std::vector<Facet>& facets) const {
    if (j - i < 2) return;
    const std::size_t k = split_[index(i, j)];
    facets.push_back({{polygon_[i], polygon_[k], polygon_[j]}, primitive});
    append(i, k, primitive, facets);
    append(k, j, primitive, facets);
  }

  const std::vector<int>& polygon_;
  const std::vector<unsigned>& sides_;
  const std::vector<Point>& vertices_;
  std::vector<double> cost_;
  std::vector<std::size_t> split_;
};

}  // namespace

int count_open_sides(const std::vector<Facet>& facets) {
  int count = 0;
  for (const auto& side : open_sides(facets)) count += side.second;
  return count;
}

namespace {

std::vector<Facet> divided(const std::vector<Facet>& facets, const std::vector<Point>& vertices,
                           Insertions& insertions) {
  std::set<Side> has_own_piece;
  for_each_side(facets, [&](const Side& side, int primitive) {
    const auto found = insertions.find(side);
    if (found != insertions.end() && found->second.primitive == primitive)
      has_own_piece.insert(side);
  });
  std::vector<Facet> result;
  std::vector<int> polygon;
  std::vector<unsigned> sides;
  for (const Facet& facet : facets) {
    polygon.clear();
    sides.clear();
    for (unsigned i = 0; i < 3; ++i) {
      const Side side{facet.vertices[i], facet.vertices[(i + 1) % 3]};
      polygon.push_back(side.first);
      sides.push_back(1u << i | 1u << (i + 2) % 3);
      const auto inserted = insertions.find(side);
      if (inserted == insertions.end() ||
          (inserted->second.primitive != facet.primitive && has_own_piece.contains(side)))
        continue;
      for (const int vertex : inserted->second.vertices) {
        polygon.push_back(vertex);
        sides.push_back(1u << i);
      }
      insertions.erase(inserted);  // a side may occur twice, a crack is along one of them
    }
    if (polygon.size() == 3)
      result.push_back(facet);
    else
      PolygonDivision(polygon, sides, vertices).append(facet.primitive, result);
  }
  return result;
}

double extent(const std::vector<int>& loop, const std::vector<Point>& vertices) {
  double largest = 0;
  for (const int vertex : loop)
    largest = std::max(largest, distance(vertices[loop[0]], vertices[vertex]));
  return largest;
}

// Fills loops with triangles of the piece beside them.
void fill_holes(std::vector<Facet>& facets, const std::vector<Point>& vertices, double size) {
  const std::map<Side, int> open = open_sides(facets);
  const Primitives primitive = primitives_at(open, facets);
  for (std::vector<int>& loop : LoopFinder(open, vertices).run()) {
    if (loop.size() < 3 || extent(loop, vertices) > size) continue;
    const int beside = primitive.at({loop[0], loop[1]});
    std::ranges::reverse(loop);
    PolygonDivision(loop, std::vector<unsigned>(loop.size(), 0), vertices).append(beside, facets);
  }
}

}  // namespace

std::vector<Facet> stitched(const std::vector<Facet>& facets, const std::vector<Point>& vertices,
                            double largest_hole) {
  std::vector<Facet> result = facets;
  // Once is enough but where vertices of several cracks are next to each other.
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    Insertions insertions;
    const std::map<Side, int> open = open_sides(result);
    const Primitives primitives = primitives_at(open, result);
    for (const std::vector<int>& loop : LoopFinder(open, vertices).run())
      if (loop.size() > 2) close_crack(loop, vertices, primitives, insertions);
    if (insertions.empty()) break;
    result = divided(result, vertices, insertions);
  }
  fill_holes(result, vertices, largest_hole);
  return result;
}

}  // namespace rfm
