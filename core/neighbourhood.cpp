#include "core/neighbourhood.hpp"

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/point_algebra.hpp"
#include "core/point_fields.hpp"
#include "core/quadric.hpp"
#include "core/segment_distance.hpp"
#include "core/triangle_ends.hpp"

namespace rfm {
namespace {

void require_positive(double distance) {
  if (!(distance > 0))
    throw InvalidArgument("a distance must be positive, got " + std::to_string(distance));
}

// Of an arc or a circle about `center`: across it, and around its ends.
Neighbourhood around_arc(const ThinSet& arc, const Point& center, double radius, double distance) {
  const Field from_circle = sqrt(square_distance(center, arc.dimension)) - radius;
  Neighbourhood result{distance * distance - from_circle * from_circle, {}};
  result.ends.functions.push_back(end_around(center, radius + distance, arc.dimension));
  if (radius > distance)
    result.ends.functions.push_back(end_around(center, radius - distance, arc.dimension));
  if (arc.points.empty()) return result;
  Field from_ends = 0.0;
  std::array<Field, 2> sides;  // of the lines through the ends, ≥ 0 towards the arc
  for (int i = 0; i < 2; ++i) {
    const Point& end = arc.points[i];
    const Field square = square_distance(end, 2);
    from_ends = i == 0 ? square : min(from_ends, square);
    const double turn = i == 0 ? 1 : -1;
    sides[i] = height_along({-turn * (end[1] - center[1]), turn * (end[0] - center[0])}, center, 2);
    result.ends.functions.push_back(end_around(end, distance, 2));
  }
  const Field beside =
      arc.bulge <= 1 ? min(sides[0], sides[1]) : max(sides[0], sides[1]);  // 1: half a turn
  result.where = select(step(beside), result.where, distance * distance - from_ends);
  return result;
}

// Of all of a line or a circle, a plane or a sphere.
Neighbourhood around_surface(const ThinSet& set, double distance) {
  if (!set.where.is_constant() && set.points.empty())
    throw InvalidArgument("the distance from a part of a curve that a formula gives is not known");
  const std::optional<Quadric> q = as_quadric(*set.surface, set.dimension);
  if (q && q->is_affine()) {
    const double slope = std::sqrt(dot(q->linear, q->linear));
    const Field height = *set.surface / slope;
    return {distance * distance - height * height, {{distance - height, distance + height}}};
  }
  if (q) {
    const double curvature = q->square[0];
    bool is_round = q->linear == Point{} && -q->constant / curvature > 0;
    for (int i = 0; i < set.dimension; ++i)
      for (int j = 0; j < set.dimension; ++j)
        is_round = is_round && std::fabs(q->square[Quadric::square_index(i, j)] -
                                         (i == j ? curvature : 0)) <= 1e-14 * std::fabs(curvature);
    if (is_round) return around_arc(set, q->origin, std::sqrt(-q->constant / curvature), distance);
  }
  throw InvalidArgument(
      "the distance from a curve that a formula gives is known for lines and "
      "circles only");
}

}  // namespace

Neighbourhood neighbourhood(const std::vector<Triangle>& triangles, double distance) {
  require_positive(distance);
  const Field square = field(std::make_shared<const MeshSquareDistance>(triangles));
  return {distance * distance - square, ends_around(triangles, distance, 3)};
}

Neighbourhood neighbourhood(const ThinSet& set, double distance) {
  require_positive(distance);
  const int dimension = set.dimension;
  const auto is_curved = [](const ThinSet& part) {
    return part.surface && (part.points.empty() || part.bulge != 0);
  };
  if (set.parts.empty() && is_curved(set)) return around_surface(set, distance);
  const std::vector<ThinSet> parts = set.parts.empty() ? std::vector{set} : set.parts;
  std::vector<Triangle> triangles;
  for (const ThinSet& part : parts) {
    if (is_curved(part))
      throw InvalidArgument("the distance from several sets is known for straight ones only");
    const std::vector<Point>& p = part.points;
    triangles.push_back({p[0], p[p.size() > 1 ? 1 : 0], p.back()});
  }
  if (parts[0].points.size() == 3) return neighbourhood(triangles, distance);
  Neighbourhood result{0.0, ends_around(triangles, distance, dimension)};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::vector<Point>& p = parts[i].points;
    const Field square =
        p.size() == 1 ? square_distance(p[0], dimension)
                      : field(std::make_shared<const SegmentDistance>(p[0], p[1], dimension));
    const Field within = distance * distance - square;
    result.where = i == 0 ? within : max(result.where, within);
  }
  return result;
}

}  // namespace rfm
