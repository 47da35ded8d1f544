#include "core/boundary_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/boundary_piece.hpp"
#include "core/error.hpp"
#include "core/normalization_length.hpp"
#include "core/quadric.hpp"
#include "core/r_functions.hpp"

namespace rfm {
namespace {

constexpr double rounding = 1e-12;

double entry(const Quadric& quadric, int i, int j) {
  return quadric.square[Quadric::square_index(i, j)];
}

double largest(const Quadric& quadric) {
  double size = 0;
  for (const double value : quadric.square) size = std::max(size, std::fabs(value));
  return size;
}

// ∂Q/∂x_i as an affine field.
Field slope_field(const Quadric& quadric, int axis, int dimension) {
  Field slope = quadric.linear[axis];
  for (int j = 0; j < dimension; ++j)
    slope = slope + 2 * entry(quadric, axis, j) * (coordinate(j) - quadric.origin[j]);
  return slope;
}

// Whether two polynomials are multiples of each other, seen at points that determine a polynomial
// of degree 2, as far apart as the surface is large.
bool same_surface(const Quadric& a, const Quadric& b, int dimension) {
  const double square = largest(a);
  const double size = square > 0 && a.constant != 0 ? std::sqrt(std::fabs(a.constant) / square) : 1;
  constexpr double places[] = {-1, 0.3, 1.1};
  std::array<double, 27> first{}, second{};
  double product = 0, norm = 0, most = 0;
  for (int i = 0; i < 27; ++i) {
    Point point = a.origin;
    const int index[] = {i % 3, i / 3 % 3, i / 9};
    for (int axis = 0; axis < dimension; ++axis) point[axis] += size * places[index[axis]];
    first[i] = a.value(point);
    second[i] = b.value(point);
    product += first[i] * second[i];
    norm += second[i] * second[i];
    most = std::max(most, std::fabs(first[i]));
  }
  for (int i = 0; i < 27; ++i)
    if (!(std::fabs(first[i] - product / norm * second[i]) <= rounding * most)) return false;
  return true;
}

Point times(const Quadric& quadric, const Point& v) {
  Point image{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) image[i] += entry(quadric, i, j) * v[j];
  return image;
}

double dot_product(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// On {Q = 0} the slope |∇Q| is factor · |height|, the height an affine function of slope 1.
struct ConeSlope {
  Point axis{};
  double factor = 0;
  Field height;
};

// Of right circular cones. A = μI + d aaᵀ has a simple eigenvalue λ = μ + d, with
// 3 tr A² − (tr A)² = 2d². Then |∇Q|² − 4μQ = |b|² − 4μc + 4d (a·b)(a·t) + 4λd (a·t)², which is the
// square of √(4λd) (a·t) + d (a·b)/√(λd) where λd > 0 and the constants agree.
std::optional<ConeSlope> cone_slope(const Quadric& q) {
  double trace = 0, square = 0, far = 0;
  for (int i = 0; i < 3; ++i) {
    trace += entry(q, i, i);
    far = std::max(far, std::fabs(q.origin[i]));
    for (int j = 0; j < 3; ++j) square += entry(q, i, j) * entry(q, i, j);
  }
  const double size = largest(q),
               difference = std::sqrt(0.5 * std::max(3 * square - trace * trace, 0.0));
  for (const double d : {difference, -difference}) {
    const double mu = (trace - d) / 3, lambda = mu + d;
    if (!(lambda * d > rounding * size * size)) continue;
    // The column of d aaᵀ on whose axis it is largest; and whether it is of rank one.
    int largest_axis = 0;
    for (int i = 1; i < 3; ++i)
      if ((entry(q, i, i) - mu) * d > (entry(q, largest_axis, largest_axis) - mu) * d)
        largest_axis = i;
    Point a{};
    for (int i = 0; i < 3; ++i) a[i] = entry(q, i, largest_axis) - (i == largest_axis ? mu : 0);
    const double length = std::sqrt(dot_product(a, a));
    for (double& component : a) component /= length;
    bool is_of_revolution = true;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        is_of_revolution = is_of_revolution && std::fabs(entry(q, i, j) - (i == j ? mu : 0) -
                                                         d * a[i] * a[j]) <= rounding * size;
    if (!is_of_revolution) continue;
    const double linear = dot_product(q.linear, q.linear), along = dot_product(a, q.linear);
    const double defect = linear - 4 * mu * q.constant - d / lambda * along * along;
    if (std::fabs(defect) >
        rounding * (linear + 4 * std::fabs(mu * q.constant)) + std::pow(rounding * far * size, 2))
      continue;
    Field height = 0.5 * along / lambda;
    for (int i = 0; i < 3; ++i) height = height + a[i] * (coordinate(i) - q.origin[i]);
    return ConeSlope{a, 2 * std::sqrt(lambda * d), height};
  }
  return std::nullopt;
}

// n·d − cos(angle) times the height. Along the axis n·d is one number on each nappe.
BoundaryPart part_of_cone(const Quadric& quadric, const ConeSlope& cone, const Field& outward,
                          const Point& direction, double cosine) {
  Field along = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    along = along + direction[axis] / cone.factor * slope_field(quadric, axis, 3);
  const Point image = times(quadric, direction);
  const double axial = dot_product(image, cone.axis);
  Point across = image;
  for (int axis = 0; axis < 3; ++axis) across[axis] -= axial * cone.axis[axis];
  if (outward.is_constant() &&
      std::sqrt(dot_product(across, across)) <= rounding * largest(quadric)) {
    const double above = 2 * outward.constant() * axial / cone.factor;
    const bool upper = above - cosine >= -rounding, lower = -above - cosine >= -rounding;
    if (upper == lower)
      return {upper ? BoundaryPart::Extent::all : BoundaryPart::Extent::none, above - cosine, {}};
    return {BoundaryPart::Extent::some, upper ? cone.height : -cone.height, {cone.height}};
  }
  const Field limit = cosine * cone.height;
  return {BoundaryPart::Extent::some,
          outward * along - cosine * abs(cone.height),
          {along - limit, along + limit}};
}

}  // namespace

bool same_surface(const Field& a, const Field& b, int dimension) {
  if (a.same_as(b)) return true;
  const auto p = as_quadric(a, dimension), q = as_quadric(b, dimension);
  return p && q && same_surface(*p, *q, dimension);
}

std::optional<double> constant_slope(const Field& function, int dimension) {
  const std::optional<Quadric> q = as_quadric(function, dimension);
  if (!q) return std::nullopt;
  double square = 0;
  for (int i = 0; i < dimension; ++i) square += q->linear[i] * q->linear[i];
  if (q->is_affine()) return square > 0 ? std::optional(std::sqrt(square)) : std::nullopt;
  // 4A² = κA, 4Ab = κb, |b|² = g² + κc.
  double trace = 0, norm = 0;
  for (int i = 0; i < dimension; ++i) {
    trace += entry(*q, i, i);
    for (int j = 0; j < dimension; ++j) norm += entry(*q, i, j) * entry(*q, i, j);
  }
  if (trace == 0) return std::nullopt;
  const double kappa = 4 * norm / trace, size = largest(*q);
  for (int i = 0; i < dimension; ++i) {
    double image = 0;
    for (int j = 0; j < dimension; ++j) {
      double product = 0;
      for (int k = 0; k < dimension; ++k) product += entry(*q, i, k) * entry(*q, k, j);
      if (std::fabs(4 * product - kappa * entry(*q, i, j)) > rounding * size * size)
        return std::nullopt;
      image += entry(*q, i, j) * q->linear[j];
    }
    if (std::fabs(4 * image - kappa * q->linear[i]) > rounding * size * std::sqrt(square))
      return std::nullopt;
  }
  const double slope = square - kappa * q->constant;
  return slope > 0 ? std::optional(std::sqrt(slope)) : std::nullopt;
}

BoundaryPart part_with_normal(int primitive, const RegionEvaluator& region, const Point& direction,
                              double angle) {
  const int dimension = region.dimension();
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(length > 0)) throw InvalidArgument("a normal of length 0 has no direction");
  const Field& level = region.region().primitives()[primitive]->level;
  const std::optional<double> slope = constant_slope(level, dimension);
  if (const auto q = as_quadric(level, dimension); q && dimension == 3 && !slope && !q->is_affine())
    if (const auto cone = cone_slope(*q)) {
      const Point d{direction[0] / length, direction[1] / length, direction[2] / length};
      return part_of_cone(*q, *cone, outward_sign(primitive, region), d, std::cos(angle));
    }
  const Field function = slope ? level : normalize_by_itself(level, dimension);
  const std::optional<Quadric> quadric = slope ? as_quadric(level, dimension) : std::nullopt;
  Field along = 0.0;
  for (int axis = 0; axis < dimension; ++axis) {
    const double component = direction[axis] / length / slope.value_or(1);
    along = along + component * (quadric ? slope_field(*quadric, axis, dimension)
                                         : partial(function, axis));
  }
  const Field where = outward_sign(primitive, region) * along - std::cos(angle);
  if (!where.is_constant()) return {BoundaryPart::Extent::some, where, {where}};
  // Rounding must not tell a face from the direction that was meant for it.
  const bool inside = where.constant() >= -rounding;
  return {inside ? BoundaryPart::Extent::all : BoundaryPart::Extent::none, where, {}};
}

BoundaryPart part_touching(int primitive, const RegionEvaluator& region, const Region& shape) {
  const auto& own = region.region().primitives()[primitive];
  BooleanExpression inside = shape.expression();
  std::vector<Field> ends;
  for (std::size_t k = 0; k < shape.primitives().size(); ++k)
    if (same_surface(own->level, shape.primitives()[k]->level, region.dimension()))
      inside = inside.restricted(static_cast<int>(k), true) |
               inside.restricted(static_cast<int>(k), false);
    else
      ends.push_back(shape.primitives()[k]->level);
  if (inside.is_constant(true)) return {BoundaryPart::Extent::all, 1.0, {}};
  if (inside.is_constant(false)) return {BoundaryPart::Extent::none, -1.0, {}};
  return {BoundaryPart::Extent::some, implicit(inside.negations_at_leaves(), shape, RAlpha{1}),
          std::move(ends)};
}

}  // namespace rfm
