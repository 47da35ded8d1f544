#include "quadrature/facet_stitching.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/point_algebra.hpp"
#include "quadrature/open_sides.hpp"
#include "quadrature/polygon_division.hpp"

namespace rfm {
namespace {

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
    lengths.push_back(lengths.back() + norm(difference(vertices[way[i - 1]], vertices[way[i]])));
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
      const double between = norm(difference(vertices[loop[i]], vertices[loop[j]]));
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
      divide_polygon(polygon, sides, vertices, facet.primitive, result);
  }
  return result;
}

double extent(const std::vector<int>& loop, const std::vector<Point>& vertices) {
  double largest = 0;
  for (const int vertex : loop)
    largest = std::max(largest, norm(difference(vertices[loop[0]], vertices[vertex])));
  return largest;
}

// Fills loops with triangles of the piece beside them.
void fill_holes(std::vector<Facet>& facets, const std::vector<Point>& vertices, double size) {
  const std::map<Side, int> open = open_sides(facets);
  const Primitives primitive = primitives_at(open, facets);
  for (std::vector<int>& loop : side_loops(open, vertices)) {
    if (loop.size() < 3 || extent(loop, vertices) > size) continue;
    const int beside = primitive.at({loop[0], loop[1]});
    std::ranges::reverse(loop);
    divide_polygon(loop, std::vector<unsigned>(loop.size(), 0), vertices, beside, facets);
  }
}

}  // namespace

int count_open_sides(const std::vector<Facet>& facets) {
  int count = 0;
  for (const auto& side : open_sides(facets)) count += side.second;
  return count;
}

std::vector<Facet> stitched(const std::vector<Facet>& facets, const std::vector<Point>& vertices,
                            double largest_hole) {
  std::vector<Facet> result = facets;
  // Once is enough but where vertices of several cracks are next to each other.
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    Insertions insertions;
    const std::map<Side, int> open = open_sides(result);
    const Primitives primitives = primitives_at(open, result);
    for (const std::vector<int>& loop : side_loops(open, vertices))
      if (loop.size() > 2) close_crack(loop, vertices, primitives, insertions);
    if (insertions.empty()) break;
    result = divided(result, vertices, insertions);
  }
  fill_holes(result, vertices, largest_hole);
  return result;
}

}  // namespace rfm
