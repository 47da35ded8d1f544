#include "solution_structures/singular_functions.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.hpp"

namespace rfm {
namespace {

// r^α and αθ. The axis of the polar coordinates is the middle of the corner.
std::pair<Field, Field> power_and_phase(const Corner& corner, double alpha) {
  if (!(corner.opening > 0 && corner.opening <= 2 * std::numbers::pi + 1e-12 && alpha > 0))
    throw InvalidArgument(
        "a corner function needs an opening greater than 0, at most 2 pi, and a positive exponent");
  const double middle = corner.first + corner.opening / 2;
  const Field x = x_coordinate() - corner.vertex[0], y = y_coordinate() - corner.vertex[1];
  const Field along = std::cos(middle) * x + std::sin(middle) * y;
  const Field across = std::cos(middle) * y - std::sin(middle) * x;
  return {pow(x * x + y * y, alpha / 2), alpha * (atan2(across, along) + corner.opening / 2)};
}

}  // namespace

Field corner_sine(const Corner& corner, double alpha) {
  const auto [power, phase] = power_and_phase(corner, alpha);
  return power * sin(phase);
}

Field corner_cosine(const Corner& corner, double alpha) {
  const auto [power, phase] = power_and_phase(corner, alpha);
  return power * cos(phase);
}

Field crack_function(const Field& gamma, const Field& lambda) {
  // Beyond the tip √(λ² + γ²) + λ cancels: γ divided by the other root there.
  const Field radius = hypot(lambda, gamma);
  return select(apply(Operation::less, {0.0, lambda}),
                (2 * step(gamma) - 1) * sqrt(0.5 * (radius + lambda)),
                gamma / sqrt(2 * (radius - lambda)));
}

Structure cracked(const Field& gamma, const Field& lambda, const Structure& psi1,
                  const Structure& psi2) {
  return psi1 + crack_function(gamma, lambda) * psi2;
}

Structure enriched(const Structure& structure, const Field& factor, const Field& singular,
                   const Structure& psi) {
  return structure + (factor * singular) * psi;
}

Structure windowed(const Structure& structure, const Field& factor, const Field& omega, int m,
                   const Structure& psi) {
  if (m < 0) throw InvalidArgument("a window is differentiable a number of times from 0 on");
  const Field inside = apply(Operation::less, {0.0, omega});
  return structure + (factor * select(inside, pow(omega, m + 1), 0.0)) * psi;
}

}  // namespace rfm
