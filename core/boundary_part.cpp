#include "core/boundary_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/boundary_piece.hpp"
#include "core/error.hpp"
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
  const Field function = slope ? level : normalize(level, dimension);
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
