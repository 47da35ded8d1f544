#pragma once

#include "core/jet_powers.hpp"
#include "core/jet_r_functions.hpp"
#include "core/jet_third_side.hpp"

namespace rfm {

// Jet rules of the R-functions of two arguments (r_functions.hpp says what they are for). They are
// written with parts in which nothing cancels: next to the boundary the plain formulas are small
// differences of large numbers, with derivatives that are, too. Bounds use the plain formulas, and
// that R-conjunctions and disjunctions increase in both arguments: the range over a box of
// arguments is that between two corners.

/// The third side √(a² + b² − 2αab) for bounds, as √(½(1 + α)(a − b)² + ½(1 − α)(a + b)²).
template <class T, int N, int K>
Jet<T, N, K> third_side(const Jet<T, N, K>& a, const Jet<T, N, K>& b, double alpha) {
  return hypot(scaled(T(std::sqrt(0.5 * (1 + alpha))), a - b),
               scaled(T(std::sqrt(0.5 * (1 - alpha))), a + b));
}

/// The Rα-conjunction (a + b − √(a² + b² − 2αab)) / (1 + α), its value for a + b > 0 taken as
/// 2ab / (a + b + √…), the larger factor divided first.
template <class T, int N, int K>
Jet<T, N, K> ralpha_conjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, double alpha) {
  const T inverse(1 / (1 + alpha));
  if constexpr (is_bound<T>) {
    Jet<T, N, K> result = scaled(inverse, a + b - third_side(a, b, alpha));
    result.c[0] = narrowed_to_corners(result.c[0], a.c[0], b.c[0], [alpha](auto x, auto y) {
      return ralpha_conjunction(x, y, alpha);
    });
    return result;
  } else {
    return of_degree_one(a, b, [&](const Jet<T, N, K>& x, const Jet<T, N, K>& y, T& of_smaller) {
      const ThirdSide side(x, y, alpha);
      Jet<T, N, K> result = scaled(inverse, side.difference(alpha));
      const T sum = x.c[0] + y.c[0];
      const auto stable = less(T(0.0), sum);
      of_smaller = select(stable, T(T(2.0) * (side.larger.c[0] / (sum + side.root))), T(0.0));
      result.c[0] = select(stable, T(0.0), T((sum - side.root) * inverse));
      return result;
    });
  }
}

template <class T, int N, int K>
Jet<T, N, K> ralpha_disjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, double alpha) {
  return -ralpha_conjunction(-a, -b, alpha);
}

/// The exclusive or of R₀, (¬a ∧ b) ∨ (a ∧ ¬b) = 2√(a² + b² − ab) − 2√(a² + b²), its value taken as
/// −2ab / (√(a² + b² − ab) + √(a² + b²)): Shapiro (1991), example 1.1. 0 at a = b = 0, with
/// derivatives 0 by convention.
template <class T, int N, int K>
Jet<T, N, K> r0_exclusive_or(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  if constexpr (is_bound<T>) {
    Jet<T, N, K> result = scaled(T(-2.0), a * b) / (third_side(a, b, 0.5) + hypot(a, b));
    // The sum of the roots is at least (√3/2 + 1) max(|a|, |b|).
    result.c[0] = narrowed_to_smaller(result.c[0], a.c[0], b.c[0], -1.0718);
    return result;
  } else {
    return of_degree_one(a, b, [](const Jet<T, N, K>& x, const Jet<T, N, K>& y, T& of_smaller) {
      const ThirdSide acute(x, y, 0.5), right(x, y, 0);
      // The longer sides of the two triangles drop out, and of the rests w the difference d is
      // known: d (w + w′ + 2|L|) = ¼S² − σS w, w of the acute one.
      const Jet<T, N, K> side = select(right.positive, right.smaller, -right.smaller);
      const Jet<T, N, K> size = select(right.positive, right.larger, -right.larger);
      const Jet<T, N, K> divisor = acute.rest + right.rest + scaled(T(2.0), size);
      const Jet<T, N, K> rest = side * (scaled(T(0.25), side) - acute.rest) /
                                select(right.corner, Jet<T, N, K>(1.0), divisor);
      Jet<T, N, K> result = -side - scaled(T(2.0), rest);
      of_smaller = select(right.corner, T(0.0),
                          T(T(-2.0) * (right.larger.c[0] / (acute.root + right.root))));
      result.c[0] = T(0.0);
      return select(right.corner, Jet<T, N, K>(), result);
    });
  }
}

/// a^(1/p), a ≥ 0, with square roots as far as p is even. At a = 0 the singular coefficients are 0.
template <class T, int N, int K>
Jet<T, N, K> root_of_degree(const Jet<T, N, K>& a, int p) {
  if (p == 1) return a;
  if (p % 2 == 0) return root_of_degree(sqrt(a), p / 2);
  return p == 3 ? cbrt(a) : real_power(a, 1.0 / p);
}

/// |a|^p.
template <class T, int N, int K>
Jet<T, N, K> absolute_power(const Jet<T, N, K>& a, int p) {
  return p % 2 == 0 ? integer_power(a, p) : p == 1 ? abs(a) : abs(a) * integer_power(a, p - 1);
}

/// (L^p + |S|^p)^{1/p} − L for L ≥ |S|, L > 0: of squares for even p, since the norm N of those and
/// w satisfy w² + 2Lw = N − L²; else L ((1 + |S/L|^p)^{1/p} − 1), its value in a form that is
/// accurate for small S/L. Not for bounds.
template <class Number>
Number norm_excess(const Number& larger, const Number& smaller, int p) {
  using T = std::decay_t<decltype(larger.c[0])>;
  using std::sqrt;
  const T& size = larger.c[0];
  if (p == 1) return abs(smaller);
  if (p % 2 == 0) {
    const Number rest = norm_excess(square(larger), square(smaller), p / 2);
    const T value = rest.c[0] / (size + T(sqrt(size * size + rest.c[0])));
    return quadratic_root(scaled(T(2.0), larger), rest, value);
  }
  const Number power = absolute_power(smaller / larger, p);
  Number excess = root_of_degree(power + Number(1.0), p);
  const T root = excess.c[0];
  T sum = T(1.0);  // 1 + r + … + r^{p−1} = (r^p − 1) / (r − 1)
  for (int k = 1; k < p; ++k) sum = sum * root + T(1.0);
  excess.c[0] = power.c[0] / sum;
  return excess * larger;
}

/// The p-norm of two jets as |L| + w, L the argument farther from zero, S the other one. Not for
/// bounds.
template <class Number>
struct PNorm {
  Number larger, smaller, size, excess;  ///< L, S, |L|, w; |L| is 1 where L = 0
  using T = std::decay_t<decltype(larger.c[0])>;
  using Mask = decltype(less(T(), T()));
  Mask positive, corner;  ///< L > 0, a = b = 0

  PNorm(const Number& a, const Number& b, int p) {
    const Mask first = farther_from_zero(a.c[0], b.c[0]);
    larger = select(first, a, b);
    smaller = select(first, b, a);
    positive = less(T(0.0), larger.c[0]);
    corner = equal(larger.c[0], T(0.0));
    size = select(corner, Number(1.0), select(positive, larger, -larger));
    // Powers of the arguments to more than the fourth may overflow: of multiples near 1, with
    // values that are divided, since p magnifies what the quotient of the two loses.
    const T unit = p > 4 ? size.c[0] : T(1.0), inverse = T(1.0) / unit;
    const auto multiple = [&](const Number& f) {
      Number result = scaled(inverse, f);
      result.c[0] = f.c[0] / unit;
      return result;
    };
    excess = p > 4 ? scaled(unit, norm_excess(multiple(size), multiple(smaller), p))
                   : norm_excess(size, smaller, p);
  }
};

/// The Rp-conjunction a + b − (a^p + b^p)^{1/p}, p even: S − w where L > 0, else S + 2L − w.
template <class T, int N, int K>
Jet<T, N, K> rp_conjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, int p) {
  if constexpr (is_bound<T>) {
    Jet<T, N, K> result = a + b - root_of_degree(integer_power(a, p) + integer_power(b, p), p);
    result.c[0] = narrowed_to_corners(result.c[0], a.c[0], b.c[0],
                                      [p](auto x, auto y) { return rp_conjunction(x, y, p); });
    return result;
  } else {
    if (p == 2) return r0_conjunction(a, b);  // the same, with fewer roundings
    return of_degree_one(a, b, [p](const Jet<T, N, K>& x, const Jet<T, N, K>& y, T& of_smaller) {
      const PNorm norm(x, y, p);
      const Jet<T, N, K>& rest = norm.excess;
      Jet<T, N, K> result =
          norm.smaller + select(norm.positive, -rest, scaled(T(2.0), norm.larger) - rest);
      result = select(norm.corner, x + y, result);
      of_smaller = T(1.0);
      result.c[0] = select(norm.positive, T(-rest.c[0]), T(T(2.0) * norm.larger.c[0] - rest.c[0]));
      return result;
    });
  }
}

template <class T, int N, int K>
Jet<T, N, K> rp_disjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, int p) {
  return -rp_conjunction(-a, -b, p);
}

/// R-equivalence ab / (|a|^p + |b|^p)^{1/p} = ±S (1 − w / (|L| + w)), eq. (5.3) of Shapiro (2007);
/// 0 at a = b = 0, with derivatives 0 by convention.
template <class T, int N, int K>
Jet<T, N, K> rp_equivalence(const Jet<T, N, K>& a, const Jet<T, N, K>& b, int p) {
  if constexpr (is_bound<T>) {
    Jet<T, N, K> result = a * b / root_of_degree(absolute_power(a, p) + absolute_power(b, p), p);
    result.c[0] = narrowed_to_smaller(result.c[0], a.c[0], b.c[0], 1.0);
    return result;
  } else {
    return of_degree_one(a, b, [p](const Jet<T, N, K>& x, const Jet<T, N, K>& y, T& of_smaller) {
      const PNorm norm(x, y, p);
      const Jet<T, N, K> length = norm.size + norm.excess;
      const Jet<T, N, K> smaller = select(norm.positive, norm.smaller, -norm.smaller);
      Jet<T, N, K> result = smaller * (Jet<T, N, K>(1.0) - norm.excess / length);
      of_smaller = norm.larger.c[0] / length.c[0];
      result.c[0] = T(0.0);
      return select(norm.corner, Jet<T, N, K>(), result);
    });
  }
}

}  // namespace rfm
