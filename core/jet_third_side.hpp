#pragma once

#include <cmath>

#include "core/jet.hpp"
#include "core/jet_functions.hpp"
#include "core/jet_piecewise.hpp"
#include "core/jet_scaling.hpp"
#include "core/r_bounds.hpp"

namespace rfm {

/// The third side of a triangle, √(a² + b² − 2αab), −1 ≤ α ≤ 1, as |L| − ασS + w with L the
/// argument that is farther from zero, σ its sign and S the other one, where
///
///     w² + 2(|L| − ασS) w = (1 − α²) S²,      w ≥ 0 .
///
/// Unlike a² + b² − 2αab and its root, the parts have derivatives in which nothing cancels, however
/// different in size a and b are; of the R-functions that are sums and differences of a, b and the
/// root the large parts drop out. Not for bounds.
template <class Number>
struct ThirdSide {
  Number larger, smaller;  ///< L, S
  Number rest;             ///< w, 0 with all derivatives where the root is 0
  using T = std::decay_t<decltype(larger.c[0])>;
  T root;  ///< the value of the third side
  using Mask = decltype(less(root, root));
  Mask positive;  ///< L > 0
  Mask corner;    ///< where the root is 0 and not smooth

  ThirdSide(const Number& a, const Number& b, double alpha) {
    using std::sqrt;
    const Mask first = farther_from_zero(a.c[0], b.c[0]);
    larger = select(first, a, b);
    smaller = select(first, b, a);
    positive = less(T(0.0), larger.c[0]);
    root = alpha == 0 ? T(sqrt(square(a.c[0]) + square(b.c[0])))
                      : T(sqrt(square(T(std::sqrt(0.5 * (1 + alpha))) * (a.c[0] - b.c[0])) +
                               square(T(std::sqrt(0.5 * (1 - alpha))) * (a.c[0] + b.c[0]))));
    corner = equal(root, T(0.0));
    const Number with_sign = select(positive, smaller, -smaller);
    const Number size = select(positive, larger, -larger);
    const Number part = alpha == 0 ? size : size - scaled(T(alpha), with_sign);
    const T bend = T((1 - alpha) * (1 + alpha));
    const T value = bend * smaller.c[0] * (smaller.c[0] / (part.c[0] + root));
    rest = quadratic_root(scaled(T(2.0), part), scaled(bend, square(smaller)), value);
    rest = select(corner, Number(), rest);
  }

  /// a + b − √…, which where L > 0 is (1 + α) S − w.
  Number difference(double alpha) const {
    const Number far = scaled(T(2.0), larger) + scaled(T(1 - alpha), smaller);
    const Number regular = select(positive, scaled(T(1 + alpha), smaller), far) - rest;
    return select(corner, larger + smaller, regular);
  }
};

/// √(a² + b²), at a = b = 0 with derivatives 0 by convention.
template <class T, int N, int K>
Jet<T, N, K> hypot(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  if constexpr (is_bound<T>) {
    return sqrt(square(a) + square(b));
  } else {
    return of_degree_one(a, b, [](const Jet<T, N, K>& x, const Jet<T, N, K>& y, T&) {
      const ThirdSide side(x, y, 0);
      Jet<T, N, K> result = select(side.positive, side.larger, -side.larger) + side.rest;
      result.c[0] = side.root;
      return select(side.corner, Jet<T, N, K>::constant(side.root), result);
    });
  }
}

}  // namespace rfm
