#pragma once

#include <type_traits>
#include <utility>

#include "core/jet_third_side.hpp"
#include "core/r_bounds.hpp"

namespace rfm {

/// Value and derivatives to second order of the R₀-functions a + b ∓ s, s = √(a² + b²) (upper sign:
/// conjunction), from those of a and b: with p = 1 ∓ a/s, q = 1 ∓ b/s and w = (b ∇a − a ∇b) / s
///
///     ∇ = p ∇a + q ∇b,      H = p Hₐ + q H_b ∓ w wᵀ / s ,
///
/// for the Hessian of √(a² + b²) is of rank one beside those of its arguments. Nothing cancels:
/// with n the argument nearer to zero and f the other one the value is n (1 ∓ n / (s + |f|)) where
/// ±f > 0, and there the weight 1 ∓ f/s is n² / (s (s + |f|)). So where a = 0 and the other
/// argument is inactive, v = a and ∇ = ∇a up to rounding of a itself, however deep such functions
/// are nested. Where a = b = 0, p = q = 1 by convention (jet.hpp). The functions are homogeneous,
/// so that arguments whose squares would overflow or underflow are scaled by a power of two.
template <class T>
struct R0Weights {
  T value, p, q;
  T a_part, b_part;  ///< ±a/s, ±b/s, or 0 where s = 0
  T curvature;       ///< ±1/s over `factor`, or 0 where s = 0
  T factor = T(1.0);
  bool has_factor = false;

  [[gnu::always_inline]] R0Weights(const T& a, const T& b, bool conjunction) {
    using std::abs, std::max;
    const T size = max(T(abs(a)), T(abs(b)));
    const auto large = less(T(0x1p480), size), small = less(size, T(0x1p-480));
    if (any(large) || any(small)) {
      has_factor = true;
      factor = select(large, T(0x1p-600), select(small, T(0x1p800), T(1.0)));
      compute(a, b, factor * a, factor * b, T(1.0) / factor, factor * size, conjunction);
    } else {
      compute(a, b, a, b, T(1.0), size, conjunction);
    }
  }

 private:
  // With a and b = `back` times the scaled x and y, of which the larger has absolute value `size`.
  [[gnu::always_inline]] void compute(const T& a, const T& b, const T& x, const T& y, const T& back,
                                      const T& size, bool conjunction) {
    using std::abs, std::sqrt;
    const auto signed_by = [&](const T& number) { return conjunction ? number : T(-number); };
    const auto first = less(T(abs(x)), T(abs(y)));
    const T near = select(first, x, y), far = select(first, y, x);
    const auto stable = less(T(0.0), signed_by(far));
    const T root = sqrt(x * x + y * y);
    const T inverse = select(equal(root, T(0.0)), T(0.0), T(1.0) / root);
    const T part = near / (root + size);
    const T ratio = T(1.0) - signed_by(part);
    value = select(stable, T(select(first, a, b) * ratio), T((x + y - signed_by(root)) * back));
    // The weight of the nearer argument is exactly 1 and the other one exactly 0 where it is
    // negligible.
    curvature = signed_by(inverse);
    a_part = x * curvature;
    b_part = y * curvature;
    const T of_near = T(1.0) - near * curvature;
    const T of_far = select(stable, T(near * inverse * part), T(T(1.0) - far * curvature));
    p = select(first, of_near, of_far);
    q = select(first, of_far, of_near);
  }
};

/// One of the two functions for jets of order K ≤ 2: `a(i)` and `b(i)` are the coefficients of the
/// arguments, `result(i, c)` receives those of the result in order. Coefficient by coefficient in
/// the code, not in loops over arrays: those GCC would keep in memory.
template <bool conjunction, class T, int N, int K>
[[gnu::always_inline]] inline void r0_function(const auto& a, const auto& b, const auto& result) {
  static_assert(0 <= K && K <= 2);
  const T a0 = a(0), b0 = b(0);
  const R0Weights<T> at(a0, b0, conjunction);
  result(0, at.value);
  if constexpr (K >= 1) [&]<std::size_t... axis>(std::index_sequence<axis...>) {
      const std::array<T, N> w{(at.b_part * a(1 + axis) - at.a_part * b(1 + axis))...};
      (result(1 + axis, T(at.p * a(1 + axis) + at.q * b(1 + axis))), ...);
      if constexpr (K == 2) {
        std::array<T, N> bent{(at.curvature * w[axis])...};
        if (at.has_factor) [[unlikely]]
          ((bent[axis] = at.factor * bent[axis]), ...);
        const auto second = [&]<std::size_t i, std::size_t j>() {
          constexpr int k = jet_index(N, unit_index(i) + unit_index(j));
          const T bend = T(i == j ? 0.5 : 1.0) * (bent[i] * w[j]);
          result(k, T(at.p * a(k) + at.q * b(k) - bend));
        };
        const auto row = [&]<std::size_t i>() {
          const auto entry = [&]<std::size_t j>() {
            if constexpr (i <= j) second.template operator()<i, j>();
          };
          (entry.template operator()<axis>(), ...);
        };
        (row.template operator()<axis>(), ...);
      }
    }
  (std::make_index_sequence<N>{});
}

template <class T, int N, int K>
Jet<T, N, K> r0_conjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b);

/// The same for bounds and for jets of any order: composed, with the value in the stable form.
template <bool conjunction, class Number>
Number r0_composed(const Number& a, const Number& b) {
  if constexpr (!conjunction) {
    return -r0_composed<true>(-a, -b);
  } else {
    using T = std::decay_t<decltype(a.c[0])>;
    if constexpr (is_bound<T>) {
      Number result = a + b - hypot(a, b);
      result.c[0] =
          narrowed_to_corners(result.c[0], a.c[0], b.c[0],
                              [](const auto& x, const auto& y) { return r0_conjunction(x, y); });
      return result;
    } else {
      Number result = of_degree_one(a, b, [](const Number& x, const Number& y, T&) {
        return ThirdSide(x, y, 0).difference(0);
      });
      result.c[0] = R0Weights<T>(a.c[0], b.c[0], true).value;
      return result;
    }
  }
}

template <bool conjunction, class T, int N, int K>
Jet<T, N, K> r0_function(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  if constexpr (!is_plain<T> || N < 1 || K < 0) {
    return r0_composed<conjunction>(a, b);
  } else {
    Jet<T, N, K> result;
    if constexpr (K > 2) result = r0_composed<conjunction>(a, b);
    r0_function<conjunction, T, N, (K < 2 ? K : 2)>([&](int i) { return a.c[i]; },
                                                    [&](int i) { return b.c[i]; },
                                                    [&](int i, const T& c) { result.c[i] = c; });
    return result;
  }
}

/// The R₀-conjunction a + b − √(a² + b²): positive exactly where both are.
template <class T, int N, int K>
Jet<T, N, K> r0_conjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return r0_function<true>(a, b);
}

/// The R₀-disjunction a + b + √(a² + b²) = −(−a ∧ −b).
template <class T, int N, int K>
Jet<T, N, K> r0_disjunction(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return r0_function<false>(a, b);
}

}  // namespace rfm
