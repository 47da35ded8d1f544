#include "quadrature/local_structure.hpp"

#include <algorithm>
#include <numbers>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;
// Directions nearer to each other are one.
constexpr double same_direction = 1e-9;

// Signs of the half-spaces in a direction, and which of them it lies on.
struct SignsAlong {
  SignsAlong(const std::vector<Point>& gradients, const Point& direction) {
    for (std::size_t k = 0; k < gradients.size(); ++k) {
      const double slope = dot(gradients[k], direction) / norm(gradients[k]);
      if (std::fabs(slope) <= same_direction)
        flat.push_back(static_cast<int>(k));
      else if (slope > 0)
        positive |= 1u << k;
    }
  }
  unsigned positive = 0;
  std::vector<int> flat;
};

// The structure along a direction: planes that contain it, the signs of the others fixed.
LocalStructure structure_along(const LocalStructure& structure, const Point& direction) {
  const SignsAlong signs(structure.gradients, direction);
  LocalStructure result;
  result.inside = structure.inside;
  for (int k = static_cast<int>(structure.gradients.size()) - 1; k >= 0; --k)
    if (std::ranges::find(signs.flat, k) == signs.flat.end())
      result.inside.fix(k, signs.positive >> k & 1);
  for (const int k : signs.flat) {
    result.primitives.push_back(structure.primitives[k]);
    result.gradients.push_back(structure.gradients[k]);
  }
  return result;
}

// The lines in which two of the planes meet, in both directions.
std::vector<Point> common_lines(const std::vector<Point>& gradients) {
  std::vector<Point> directions;
  for (std::size_t i = 0; i < gradients.size(); ++i)
    for (std::size_t j = i + 1; j < gradients.size(); ++j) {
      const Point t = cross(gradients[i], gradients[j]);
      const double length = norm(t);
      if (!(length > same_direction * norm(gradients[i]) * norm(gradients[j]))) continue;
      for (const double sign : {1.0, -1.0}) {
        const Point direction = scaled(sign / length, t);
        if (std::ranges::none_of(directions, [&](const Point& other) {
              return norm(along(other, -1, direction)) <= same_direction;
            }))
          directions.push_back(direction);
      }
    }
  return directions;
}

// Oosterom and Strackee (1983): the solid angle of three unit vectors.
double triangle_angle(const Point& a, const Point& b, const Point& c) {
  return 2 * std::atan2(std::fabs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

// Of a convex cone with the extreme directions `rays`.
double cone_angle(std::vector<Point> rays) {
  if (rays.size() < 3) return 0;
  Point middle{};
  for (const Point& ray : rays) middle = along(middle, 1, ray);
  const double length = norm(middle);
  if (!(length > same_direction)) return 0;
  middle = scaled(1 / length, middle);
  const auto [u, v] = plane_across(middle);
  const auto angle = [&](const Point& ray) { return std::atan2(dot(ray, v), dot(ray, u)); };
  std::ranges::sort(rays, {}, angle);
  double sum = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
    sum += triangle_angle(middle, rays[i], rays[(i + 1) % rays.size()]);
  return sum;
}

}  // namespace

std::array<Point, 2> plane_across(const Point& direction) {
  int least = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::fabs(direction[axis]) < std::fabs(direction[least])) least = axis;
  Point unit{};
  unit[least] = 1;
  const Point first = cross(direction, unit);
  const Point u = scaled(1 / norm(first), first);
  const Point second = cross(direction, u);
  return {u, scaled(1 / norm(second), second)};
}

LocalStructure::LocalStructure(const RegionEvaluator& region, const TruthTable& table,
                               std::span<const int> variables, const Point& point, double distance)
    : inside(table) {
  for (int v = static_cast<int>(variables.size()) - 1; v >= 0; --v) {
    Point gradient{};
    const double value = region.level(variables[v]).value_and_gradient(point, gradient);
    if (std::fabs(value) > distance * norm(gradient)) {
      inside.fix(v, value >= 0);
    } else {
      primitives.push_back(variables[v]);
      gradients.push_back(gradient);
    }
  }
  std::ranges::reverse(primitives);
  std::ranges::reverse(gradients);
}

SectorWalk walk_sectors(const LocalStructure& structure, const Point& u, const Point& v) {
  // Directions in which a half-plane begins or ends.
  std::vector<double> turns;
  for (const Point& gradient : structure.gradients) {
    const double normal = std::atan2(dot(gradient, v), dot(gradient, u));
    for (const double side : {-0.5, 0.5}) {
      const double turn = std::remainder(normal + side * pi, 2 * pi);
      if (std::ranges::none_of(turns, [&](double other) {
            return std::fabs(std::remainder(other - turn, 2 * pi)) <= same_direction;
          }))
        turns.push_back(turn);
    }
  }
  std::ranges::sort(turns);
  SectorWalk result;
  const std::size_t count = turns.size();
  std::vector<bool> inside(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double width = i + 1 < count ? turns[i + 1] - turns[i] : turns[0] + 2 * pi - turns[i];
    const double middle = turns[i] + 0.5 * width;
    const double c = std::cos(middle), s = std::sin(middle);
    unsigned signs = 0;
    for (std::size_t k = 0; k < structure.gradients.size(); ++k)
      if (c * dot(structure.gradients[k], u) + s * dot(structure.gradients[k], v) > 0)
        signs |= 1u << k;
    inside[i] = structure.inside.value(signs);
    if (inside[i]) result.angle += width;
  }
  std::vector<double> rays;
  for (std::size_t i = 0; i < count; ++i)
    if (inside[i] != inside[(i + count - 1) % count]) rays.push_back(turns[i]);
  result.rays = static_cast<int>(rays.size());
  result.is_corner = result.rays > 2 ||
                     (result.rays == 2 && std::fabs(rays[1] - rays[0] - pi) > 2 * same_direction);
  return result;
}

VertexStructure vertex_structure(const LocalStructure& structure) {
  VertexStructure result;
  const std::vector<Point> lines = common_lines(structure.gradients);
  std::vector<Point> edges;
  for (const Point& direction : lines) {
    const auto [u, v] = plane_across(direction);
    if (walk_sectors(structure_along(structure, direction), u, v).is_corner)
      edges.push_back(direction);
  }
  result.edges = static_cast<int>(edges.size());
  const bool passes = edges.size() == 2 && norm(along(edges[0], 1, edges[1])) <= same_direction;
  result.is_vertex = !edges.empty() && !passes;
  const unsigned assignments = 1u << structure.gradients.size();
  for (unsigned signs = 0; signs < assignments; ++signs) {
    if (!structure.inside.value(signs)) continue;
    std::vector<Point> rays;
    for (const Point& direction : lines) {
      const SignsAlong at(structure.gradients, direction);
      unsigned flat = 0;
      for (const int k : at.flat) flat |= 1u << k;
      if (((at.positive ^ signs) & ~flat & (assignments - 1)) == 0) rays.push_back(direction);
    }
    result.solid_angle += cone_angle(std::move(rays));
  }
  return result;
}

}  // namespace rfm
