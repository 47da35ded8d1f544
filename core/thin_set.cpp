#include "core/thin_set.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conditional_r_functions.hpp"
#include "core/error.hpp"
#include "core/normalization_length.hpp"
#include "core/point_algebra.hpp"
#include "core/point_fields.hpp"
#include "core/r_equivalence.hpp"
#include "core/trim.hpp"

namespace rfm {
Field trimming_conjunction(const std::vector<Field>& fields, const Field& gamma,
                           const ConditionalOptions& options) {
  if (fields.empty()) throw InvalidArgument("the conjunction of no fields does not exist");
  if (!(options.a > 0))
    throw InvalidArgument("the factor of a conditional R-function must be positive");
  if (options.k < 2 || options.k > 16 || options.k % 2 != 0)
    throw InvalidArgument("the exponent of a conditional R-function must be even, from 2 to 16");
  const Field s = options.a * pow(gamma, double(options.k));
  Field joined = fields[0];
  for (std::size_t i = 1; i < fields.size(); ++i)
    joined = conditional_conjunction(joined, fields[i], s);
  return joined;
}

ThinSet point_set(const Point& point, int dimension) {
  ThinSet set;
  set.dimension = dimension;
  set.function = sqrt(square_distance(point, dimension));
  set.points = {point};
  return set;
}

ThinSet segment_set(const Point& from, const Point& to, int dimension) {
  if (dimension < 2 || dimension > 3)
    throw InvalidArgument("segments lie in 2 or 3 dimensions, not in " + std::to_string(dimension));
  const Point step = difference(to, from);
  const double size = norm(step);
  if (!(size > 0)) throw InvalidArgument("the ends of a segment must differ");
  const Point middle{0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 0.5 * (from[2] + to[2])};
  const Point direction = unit(step);
  ThinSet set;
  set.dimension = dimension;
  set.points = {from, to};
  set.where = (0.25 * size * size - square_distance(middle, dimension)) / size;
  set.ends = {set.where};
  if (dimension == 2) {
    set.surface = height_along({-direction[1], direction[0]}, from, 2);
    set.function = trim(*set.surface, set.where, size);
    return set;
  }
  // Two planes through the line: the sum of their squares loses no digits near it.
  const Point pole = std::fabs(direction[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};
  const Point normal = unit(cross(direction, pole)), binormal = cross(direction, normal);
  set.function = trim_of_square(
      pow(height_along(normal, from, 3), 2.0) + pow(height_along(binormal, from, 3), 2.0),
      set.where, size);
  return set;
}

ThinSet arc_set(const Point& center, double radius, double from, double to) {
  constexpr double full = 2 * std::numbers::pi, rounding = 1e-12;
  if (!(radius > 0)) throw InvalidArgument("the radius of an arc must be positive");
  if (!(to > from) || to - from > full * (1 + rounding))
    throw InvalidArgument("the angles of an arc must ascend by at most a full turn");
  ThinSet set;
  set.surface = (radius * radius - square_distance(center, 2)) * (0.5 / radius);
  if (to - from >= full * (1 - rounding)) {
    set.function = abs(*set.surface);
    return set;
  }
  // Beyond the chord, seen from the centre along the middle of the arc.
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  set.where =
      height_along({std::cos(middle), std::sin(middle)}, center, 2) - radius * std::cos(half);
  set.ends = {set.where};
  set.function = trim(*set.surface, set.where, radius);
  set.bulge = std::tan(0.25 * (to - from));
  for (const double angle : {from, to})
    set.points.push_back(
        {center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle)});
  return set;
}

ThinSet level_curve_set(const Field& of, const std::optional<Field>& where, int dimension) {
  ThinSet set;
  set.dimension = dimension;
  set.surface = of;
  const Field gamma = normalize_by_itself(of, dimension);
  const std::optional<Quadric> quadric = as_quadric(of, dimension);
  const double length = quadric ? length_of(*quadric) : 1;
  set.function = where ? trim(gamma, *where, std::isfinite(length) ? length : 1) : abs(gamma);
  if (where) {
    set.where = *where;
    set.ends = {*where};
  }
  return set;
}

ThinSet triangle_set(const Point& a, const Point& b, const Point& c,
                     const ConditionalOptions& options) {
  const Point corners[] = {a, b, c};
  const Point area = cross(difference(b, a), difference(c, a));
  const double size =
      std::max({norm(difference(b, a)), norm(difference(c, b)), norm(difference(a, c))});
  if (!(norm(area) > 1e-14 * size * size))
    throw InvalidArgument("the corners of a triangle must not lie on a line");
  const Point normal = unit(area);
  ThinSet set;
  set.dimension = 3;
  set.points = {a, b, c};
  set.surface = height_along(normal, a, 3);
  for (int i = 0; i < 3; ++i) {
    const Point edge = unit(difference(corners[(i + 1) % 3], corners[i]));
    set.ends.push_back(height_along(cross(normal, edge), corners[i], 3));
  }
  std::vector<Field> in_lengths;
  for (const Field& end : set.ends) in_lengths.push_back(end / size);
  set.where = size * trimming_conjunction(in_lengths, *set.surface / size, options);
  set.function = trim(*set.surface, set.where, size);
  return set;
}

Field joined(const std::vector<ThinSet>& sets, int p) {
  std::vector<Field> functions;
  for (const ThinSet& set : sets) functions.push_back(set.function);
  return equivalence(functions, p);
}

Field polyline_function(const std::vector<Point>& points, int dimension, int p) {
  std::vector<ThinSet> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    segments.push_back(segment_set(points[i], points[i + 1], dimension));
  return joined(segments, p);
}

ThinSet composite_set(std::vector<ThinSet> parts) {
  ThinSet set;
  set.function = joined(parts);
  set.dimension = parts[0].dimension;
  set.parts = std::move(parts);
  return set;
}

}  // namespace rfm
