#pragma once

#include "core/jet_functions.hpp"
#include "core/jet_piecewise.hpp"
#include "core/jet_r_functions.hpp"

namespace rfm {

// Jet rules of the R-functions of two arguments (r_functions.hpp says what they are for). Jets are
// those of the plain formula, whose derivatives do not cancel; the value is taken from a form that
// keeps its relative accuracy next to the boundary, where the plain formula is a small difference
// of large numbers. Bounds use that R-conjunctions and disjunctions increase in both arguments: the
// range over a box of arguments is that between two corners.

/// 2ab / (a + b + root): what a + b − root is for a + b > 0, up to a constant factor, where
/// (a + b)² − root² is a multiple of ab. The larger factor is divided first: nothing underflows.
template <class T>
T quotient_form(const T& a, const T& b, const T& root) {
  const auto first = farther_from_zero(a, b);
  const T larger = select(first, a, b), smaller = select(first, b, a);
  return T(2.0) * smaller * (larger / (a + b + root));
}

/// √(a² + b² − 2αab) as √(½(1 + α)(a − b)² + ½(1 − α)(a + b)²), in which nothing cancels.
template <class T, int N, int K>
Jet<T, N, K> third_side(const Jet<T, N, K>& a, const Jet<T, N, K>& b, double alpha) {
  return hypot(scaled(T(std::sqrt(0.5 * (1 + alpha))), a - b),
               scaled(T(std::sqrt(0.5 * (1 - alpha))), a + b));
}

/// The Rα-conjunction (a + b − √(a² + b² − 2αab)) / (1 + α), its value taken as 2ab / (a + b + √…)
/// for a + b > 0.
template <class T, int N, int K>
Jet<T, N, K> ralpha_conjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, double alpha) {
  const Jet<T, N, K> root = third_side(a, b, alpha);
  Jet<T, N, K> result = scaled(T(1 / (1 + alpha)), a + b - root);
  if constexpr (is_bound<T>) {
    result.c[0] = narrowed_to_corners(result.c[0], a.c[0], b.c[0], [alpha](auto x, auto y) {
      return ralpha_conjunction(x, y, alpha);
    });
  } else {
    result.c[0] = select(less(T(0.0), a.c[0] + b.c[0]), quotient_form(a.c[0], b.c[0], root.c[0]),
                         result.c[0]);
  }
  return result;
}

template <class T, int N, int K>
Jet<T, N, K> ralpha_disjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, double alpha) {
  return -ralpha_conjunction(-a, -b, alpha);
}

/// The exclusive or of R₀, (¬a ∧ b) ∨ (a ∧ ¬b) = 2√(a² + b² − ab) − 2√(a² + b²), as
/// −2ab / (√(a² + b² − ab) + √(a² + b²)): Shapiro (1991), example 1.1. 0 at a = b = 0, with
/// derivatives 0 by convention.
template <class T, int N, int K>
Jet<T, N, K> r0_exclusive_or(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  const Jet<T, N, K> roots = third_side(a, b, 0.5) + hypot(a, b);
  Jet<T, N, K> result = scaled(T(-2.0), a * b) / roots;
  if constexpr (is_bound<T>) {
    // The sum of the roots is at least (√3/2 + 1) max(|a|, |b|).
    result.c[0] = narrowed_to_smaller(result.c[0], a.c[0], b.c[0], 1.0718);
  } else {
    const auto first = farther_from_zero(a.c[0], b.c[0]);
    const T larger = select(first, a.c[0], b.c[0]), smaller = select(first, b.c[0], a.c[0]);
    result.c[0] = T(-2.0) * smaller * (larger / roots.c[0]);
    result = select(equal(roots.c[0], T(0.0)), Jet<T, N, K>(), result);
  }
  return result;
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

/// The p-norm of two plain numbers as |larger| (1 + excess), excess = (1 + |t|^p)^{1/p} − 1 ≥ 0 in
/// a form that is accurate for small t = smaller / larger.
template <class T>
struct PNorm {
  T larger, smaller, excess;

  PNorm(const T& a, const T& b, int p) {
    const auto first = farther_from_zero(a, b);
    larger = select(first, a, b);
    smaller = select(first, b, a);
    using Number = Jet<T, 1, 0>;
    const T t = select(equal(larger, T(0.0)), T(0.0), smaller / larger);
    const T power = absolute_power(Number::constant(t), p).c[0];
    const T root = root_of_degree(Number::constant(T(1.0) + power), p).c[0];
    T sum = T(1.0);  // 1 + r + … + r^{p−1} = (r^p − 1) / (r − 1)
    for (int k = 1; k < p; ++k) sum = sum * root + T(1.0);
    excess = power / sum;
  }
};

/// The Rp-conjunction a + b − (a^p + b^p)^{1/p}, p even. With the larger of the two in size L, the
/// other s and the norm |L| (1 + e), its value is s − e L where L > 0, else s + 2L + e L.
template <class T, int N, int K>
Jet<T, N, K> rp_conjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, int p) {
  Jet<T, N, K> result = a + b - root_of_degree(integer_power(a, p) + integer_power(b, p), p);
  if constexpr (is_bound<T>) {
    result.c[0] = narrowed_to_corners(result.c[0], a.c[0], b.c[0],
                                      [p](auto x, auto y) { return rp_conjunction(x, y, p); });
  } else {
    const PNorm<T> norm(a.c[0], b.c[0], p);
    const T &larger = norm.larger, &smaller = norm.smaller;
    result.c[0] = select(less(T(0.0), larger), smaller - norm.excess * larger,
                         smaller + (T(2.0) + norm.excess) * larger);
  }
  return result;
}

template <class T, int N, int K>
Jet<T, N, K> rp_disjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b, int p) {
  return -rp_conjunction(-a, -b, p);
}

/// R-equivalence ab / (|a|^p + |b|^p)^{1/p}, eq. (5.3) of Shapiro (2007); 0 at a = b = 0, with
/// derivatives 0 by convention.
template <class T, int N, int K>
Jet<T, N, K> rp_equivalence(const Jet<T, N, K>& a, const Jet<T, N, K>& b, int p) {
  const Jet<T, N, K> norm = root_of_degree(absolute_power(a, p) + absolute_power(b, p), p);
  Jet<T, N, K> result = a * b / norm;
  if constexpr (is_bound<T>) {
    result.c[0] = narrowed_to_smaller(result.c[0], a.c[0], b.c[0], 1.0);
  } else {
    const PNorm<T> parts(a.c[0], b.c[0], p);
    const T size = parts.smaller / (T(1.0) + parts.excess);
    result.c[0] = select(less(T(0.0), parts.larger), size, -size);
    result = select(equal(norm.c[0], T(0.0)), Jet<T, N, K>::constant(result.c[0]), result);
  }
  return result;
}

}  // namespace rfm
