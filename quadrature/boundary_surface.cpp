#include "quadrature/boundary_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/boundary_piece.hpp"
#include "core/point_algebra.hpp"
#include "quadrature/facet_stitching.hpp"

namespace rfm {
namespace {

// Points nearer than `tolerance` get one number.
class PointWelder {
 public:
  explicit PointWelder(double tolerance) : tolerance_(tolerance), cell_(4 * tolerance) {}

  int number(const Point& point) {
    std::array<std::int64_t, 3> home{};
    for (int axis = 0; axis < 3; ++axis)
      home[axis] = static_cast<std::int64_t>(std::floor(point[axis] / cell_));
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const auto found =
          cells_.find(key({home[0] + neighbour % 3 - 1, home[1] + neighbour / 3 % 3 - 1,
                           home[2] + neighbour / 9 - 1}));
      if (found == cells_.end()) continue;
      for (const int known : found->second)
        if (std::hypot(points[known][0] - point[0], points[known][1] - point[1],
                       points[known][2] - point[2]) < tolerance_)
          return known;
    }
    points.push_back(point);
    cells_[key(home)].push_back(static_cast<int>(points.size()) - 1);
    return static_cast<int>(points.size()) - 1;
  }

  std::vector<Point> points;

 private:
  static std::uint64_t key(const std::array<std::int64_t, 3>& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t index : cell)
      hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15ull + (hash >> 29);
    return hash;
  }

  double tolerance_, cell_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

// Outward by the order of the vertices; its length is twice the measure in 3D, once in 2D.
Point facet_normal(std::span<const int> vertices, const std::vector<Point>& points) {
  const Point &a = points[vertices[0]], &b = points[vertices[1]];
  const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  if (vertices.size() == 2) return {u[1], -u[0], 0};
  const Point& c = points[vertices[2]];
  const Point v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Gives each piece, and each side of a primitive, points of its own with their normals.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const RegionEvaluator& region, const std::vector<Point>& points)
      : region_(region), points_(points) {
    for (int k = 0; k < region.primitive_count(); ++k) sides_.push_back(side_of(k, region));
  }

  void add(ElementShape shape, std::span<const int> vertices, int primitive) {
    const Point normal = facet_normal(vertices, points_);
    std::array<int, 3> own{};
    for (std::size_t i = 0; i < vertices.size(); ++i)
      own[i] = point(vertices[i], primitive, normal);
    surface_.facets.add(shape, std::span(own).first(vertices.size()));
  }

  BoundarySurface take() { return std::move(surface_); }

 private:
  int point(int vertex, int primitive, const Point& facet_normal) {
    Point normal{};
    region_.level(primitive).value_and_gradient(points_[vertex], normal);
    const bool against = sides_[primitive] == Side::positive ||
                         (sides_[primitive] == Side::both && dot(normal, facet_normal) < 0);
    const auto [place, is_new] =
        known_.try_emplace({vertex, primitive, against}, static_cast<int>(surface_.points.size()));
    if (!is_new) return place->second;
    normal = unit(normal);
    if (against) normal = {-normal[0], -normal[1], -normal[2]};
    if (!std::isfinite(dot(normal, normal))) normal = unit(facet_normal);
    surface_.points.push_back(points_[vertex]);
    surface_.normals.push_back(normal);
    surface_.primitives.push_back(primitive);
    return place->second;
  }

  const RegionEvaluator& region_;
  const std::vector<Point>& points_;
  std::vector<Side> sides_;
  BoundarySurface surface_;
  std::map<std::tuple<int, int, bool>, int> known_;
};

double size_of(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& point : points)
    for (const double coordinate : point) size = std::max(size, std::fabs(coordinate));
  return size;
}

}  // namespace

BoundarySurface boundary_surface(const RegionEvaluator& region, const Tessellation& tessellation) {
  constexpr double same_point = 1e-9;
  const ElementList& boundary = tessellation.boundary;
  PointWelder welder(same_point * size_of(tessellation.vertices));
  std::vector<Facet> triangles;
  std::vector<Facet> segments;  // their third vertex is not used
  for (int e = 0; e < boundary.size(); ++e) {
    const auto vertices = boundary.vertices(e);
    Facet facet{{}, tessellation.primitives[e]};
    for (std::size_t i = 0; i < vertices.size(); ++i)
      facet.vertices[i] = welder.number(tessellation.vertices[vertices[i]]);
    const auto& v = facet.vertices;
    if (v[0] == v[1]) continue;
    if (boundary.shapes[e] == ElementShape::segment)
      segments.push_back(facet);
    else if (v[1] != v[2] && v[2] != v[0])
      triangles.push_back(facet);
  }
  // What is left open near points where a surface is not smooth, as the apex of a cone.
  constexpr double small_hole = 0.02;
  triangles = stitched(triangles, welder.points, small_hole * size_of(tessellation.vertices));
  SurfaceBuilder builder(region, welder.points);
  std::map<int, int> balance;
  for (const Facet& segment : segments) {
    builder.add(ElementShape::segment, std::span(segment.vertices).first(2), segment.primitive);
    ++balance[segment.vertices[0]];
    --balance[segment.vertices[1]];
  }
  for (const Facet& triangle : triangles)
    builder.add(ElementShape::triangle, triangle.vertices, triangle.primitive);
  BoundarySurface surface = builder.take();
  surface.open_edges = count_open_sides(triangles);
  for (const auto& end : balance) surface.open_edges += std::abs(end.second);
  return surface;
}

}  // namespace rfm
