#include "core/normalization_length.hpp"

#include <limits>

#include "core/error.hpp"

namespace rfm {

Field normalize_within(const Field& f, double length, int dimension) {
  if (!(length > 0)) throw InvalidArgument("a length to normalise by must be positive");
  const Field slope = inward_derivative(f, f, dimension);
  if (length == std::numeric_limits<double>::infinity()) return f / sqrt(slope);
  return f / sqrt(pow(f / length, 2.0) + slope);
}

double length_of(const Quadric& quadric) {
  const auto& [xx, xy, xz, yy, yz, zz] = quadric.square;
  const double square = std::sqrt(xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz));
  const double slope = std::hypot(quadric.linear[0], quadric.linear[1], quadric.linear[2]);
  const double parabolic = slope / square,
               central = std::sqrt(std::fabs(quadric.constant) / square);
  // What is left of the slope at a centre is rounding.
  constexpr double rounding = 1e-6;
  const double length = parabolic > rounding * central ? parabolic : central;
  return length > 0 && std::isfinite(length) ? length : std::numeric_limits<double>::infinity();
}

Field normalize_by_itself(const Field& level, int dimension, double otherwise) {
  const std::optional<Quadric> quadric = as_quadric(level, dimension);
  return normalize_within(level, quadric ? length_of(*quadric) : otherwise, dimension);
}

}  // namespace rfm
