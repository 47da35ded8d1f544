#pragma once

#include <span>

namespace rfm {

/// The n-point Gauss–Legendre rule on [0, 1]: ∫₀¹ f ≈ Σ weights[i] f(nodes[i]), exact for
/// polynomials of degree ≤ 2n − 1 and no further. Nodes ascend and are symmetric about 1/2.
struct GaussRule {
  std::span<const double> nodes;
  std::span<const double> weights;
  int size() const { return static_cast<int>(nodes.size()); }
};

inline constexpr int max_gauss_points = 64;

/// Nodes are roots of the Legendre polynomial Pₙ found by Newton's method in extended precision, so
/// both nodes and weights are right to rounding. Computed once and shared; thread-safe. Throws
/// `InvalidArgument` unless 1 ≤ `points` ≤ `max_gauss_points`.
const GaussRule& gauss_legendre(int points);

}  // namespace rfm
