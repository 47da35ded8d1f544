#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "core/jet_product.hpp"
#include "core/multi_index.hpp"
#include "core/scalar.hpp"

namespace rfm {

/// A function at a point together with all its partial derivatives up to order K in N variables:
/// the truncated Taylor polynomial
///
///     f(a + h) = Σ_{|α| ≤ K} c_α h^α + O(|h|^{K+1}),      c_α = ∂^α f(a) / α! .
///
/// Jets add and multiply as polynomials of which terms beyond degree K are dropped, and a function
/// of one variable is composed with a jet by its own Taylor coefficients. So a formula evaluated
/// with jets gives exact derivatives of any order; there are no finite differences anywhere.
///
///     auto x = Jet<double, 2, 2>::variable(0, 0.5), y = Jet<double, 2, 2>::variable(1, 2.0);
///     auto f = sin(x) * exp(y);
///     f.derivative({1, 1})                                       // f_xy = cos(0.5) e²
///
/// T is the kind of number: `double` for single points, `Batch` for several points at once,
/// `Interval` and `TaylorBound` for enclosures over a box. Coefficients are ordered as in
/// core/multi_index.hpp, so a jet of lower order is a prefix.
///
/// Where a function is not differentiable (√ and |·| at 0, the corner of an R-function) its
/// derivatives are finite by convention: singular coefficients are 0. Where it is undefined
/// (√ of a negative number) the result is NaN.
///
/// This header has the algebra of jets; functions of them are in core/jet_functions.hpp, and those
/// that choose between branches in core/jet_piecewise.hpp.
///
/// Numbers of variables and orders beyond those compiled into tapes have `DynamicJet`
/// (core/dynamic_jet.hpp), to which the same rules apply.
template <class T, int N, int K>
struct Jet {
  static_assert(N >= 1 && N <= maximum_variables && K >= 0);
  static constexpr int size = jet_size(N, K);
  static_assert(size <= 1 << 16, "places of coefficients have 16 bits (JetProductTerm)");
  static constexpr int order() { return K; }
  std::array<T, size> c{};

  Jet() {
    for (T& coefficient : c) coefficient = T(0.0);
  }
  Jet(double number) : Jet() { c[0] = T(number); }  // NOLINT: numbers are jets
  static Jet constant(const T& value) {
    Jet jet;
    jet.c[0] = value;
    return jet;
  }
  static Jet variable(int axis, const T& value) {
    Jet jet = constant(value);
    if constexpr (K >= 1) jet.c[1 + axis] = T(1.0);
    return jet;
  }

  const T& value() const { return c[0]; }
  /// ∂^α f, with |α| ≤ K.
  T derivative(const MultiIndex& alpha) const {
    return c[jet_index(N, alpha)] * T(factorial(alpha));
  }
};

template <class T, int N, int K>
Jet<T, N, K> operator+(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  Jet<T, N, K> sum;
  for (int i = 0; i < sum.size; ++i) sum.c[i] = a.c[i] + b.c[i];
  return sum;
}

template <class T, int N, int K>
Jet<T, N, K> operator-(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  Jet<T, N, K> difference;
  for (int i = 0; i < difference.size; ++i) difference.c[i] = a.c[i] - b.c[i];
  return difference;
}

template <class T, int N, int K>
Jet<T, N, K> operator-(const Jet<T, N, K>& a) {
  Jet<T, N, K> negative;
  for (int i = 0; i < negative.size; ++i) negative.c[i] = -a.c[i];
  return negative;
}

template <class T, int N, int K>
Jet<T, N, K> scaled(const T& factor, const Jet<T, N, K>& a) {
  Jet<T, N, K> product;
  for (int i = 0; i < product.size; ++i) product.c[i] = factor * a.c[i];
  return product;
}

template <class T, int N, int K>
Jet<T, N, K> operator*(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  Jet<T, N, K> product;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((product.c[i] = convolution<N, i, true>(a.c, b.c)), ...);
  }
  (std::make_index_sequence<product.size>{});
  return product;
}

/// `coefficient` less what the coefficients of `quotient` before `result` contribute to that
/// coefficient of `quotient` · b.
template <int N, int result, class T, std::size_t size>
T remainder(T coefficient, const std::array<T, size>& quotient, const std::array<T, size>& b) {
  static constexpr auto terms = jet_product_terms<N, result>();
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((coefficient = coefficient - quotient[terms[i].left] * b[terms[i].right]), ...);
  }
  (std::make_index_sequence<terms.size() - 1>{});
  return coefficient;
}

/// The quotient of which the value is known: q b = a, solved coefficient by coefficient in
/// ascending degree, without powers of 1/b. `divided` divides by the value of b.
template <class T, int N, int K>
void solve_quotient(const Jet<T, N, K>& a, const Jet<T, N, K>& b, Jet<T, N, K>& quotient,
                    const auto& divided) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((quotient.c[i + 1] = divided(remainder<N, i + 1>(a.c[i + 1], quotient.c, b.c))), ...);
  }
  (std::make_index_sequence<quotient.size - 1>{});
}
/// The same where the value of b is so large or small that its reciprocal is no use.
template <class T, int N, int K>
[[gnu::noinline, gnu::cold]] void solve_extreme_quotient(const Jet<T, N, K>& a,
                                                         const Jet<T, N, K>& b,
                                                         Jet<T, N, K>& quotient) {
  solve_quotient(a, b, quotient, [&](const T& rest) { return T(rest / b.c[0]); });
}

template <class T, int N, int K>
Jet<T, N, K> operator/(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  // The value is rounded once, so that it does not depend on the order.
  Jet<T, N, K> quotient;
  quotient.c[0] = a.c[0] / b.c[0];
  if constexpr (K > 0) {
    if constexpr (is_plain<T>) {
      if (any(has_no_reciprocal(b.c[0]))) [[unlikely]] {
        solve_extreme_quotient(a, b, quotient);
        return quotient;
      }
    }
    const T inverse = T(1.0) / b.c[0];
    solve_quotient(a, b, quotient, [&](const T& rest) { return T(rest * inverse); });
  }
  return quotient;
}

/// The solution q of q² + p q = r of which the value is known, coefficient by coefficient in
/// ascending degree: q_α (p₀ + 2 q₀) = r_α − q₀ p_α − Σ q_β (p + q)_{α−β}, 0 < β < α. The value of
/// r is not used.
template <class T, int N, int K>
Jet<T, N, K> quadratic_root(const Jet<T, N, K>& p, const Jet<T, N, K>& r, const T& value) {
  Jet<T, N, K> root = Jet<T, N, K>::constant(value), factor = p;
  const T inverse = T(1.0) / (p.c[0] + (value + value));
  const auto solve = [&]<int i>() {
    static constexpr auto terms = jet_product_terms<N, i>();
    T rest = r.c[i] - value * p.c[i];
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      ((rest = rest - root.c[terms[k + 1].left] * factor.c[terms[k + 1].right]), ...);
    }
    (std::make_index_sequence<terms.size() - 2>{});
    root.c[i] = rest * inverse;
    factor.c[i] = p.c[i] + root.c[i];
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) { (solve.template operator()<i + 1>(), ...); }
  (std::make_index_sequence<root.size - 1>{});
  return root;
}

/// A place of a jet that is known at compile time.
template <int i>
using Place = std::integral_constant<int, i>;

/// Calls `solve` with the place of every coefficient but the value, in ascending degree.
template <class T, int N, int K>
void for_each_derivative(const Jet<T, N, K>&, const auto& solve) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (solve(Place<int(i) + 1>()), ...); }
  (std::make_index_sequence<Jet<T, N, K>::size - 1>{});
}
/// `rest` − Σ a_β b_{α−β}, 0 < β < α: what lower coefficients contribute to that of a product at a
/// place.
template <class T, int N, int K, int i>
T without_products(T rest, const Jet<T, N, K>& a, const Jet<T, N, K>& b, Place<i>) {
  static constexpr auto terms = jet_product_terms<N, i>();
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    ((rest = rest - a.c[terms[k + 1].left] * b.c[terms[k + 1].right]), ...);
  }
  (std::make_index_sequence<terms.size() - 2>{});
  return rest;
}
/// The degree of a coefficient of two jets that are combined.
template <class T, int N, int K>
constexpr int degree_at(const Jet<T, N, K>&, const Jet<T, N, K>&, int i) {
  return jet_degree(N, i);
}
/// A jet of the shape of another one of which only the value is not zero.
template <class T, int N, int K>
Jet<T, N, K> constant_like(const Jet<T, N, K>&, const T& value) {
  return Jet<T, N, K>::constant(value);
}

/// The Taylor coefficients f^(k)(a₀)/k!, k = 0 … order, of a function of one variable.
template <class T, int K>
using TaylorSeries = std::array<T, (K == run_time ? maximum_order : K) + 1>;

/// f(a), given the Taylor coefficients of f at the value of `a`, by Horner's rule. A sum that is
/// still to be multiplied by the increment `a` − a₀ k times is needed to degree K − k only.
template <class T, int N, int K>
Jet<T, N, K> compose(const Jet<T, N, K>& a, const TaylorSeries<T, K>& taylor) {
  Jet<T, N, K> result;
  result.c[0] = taylor[K];
  const auto multiply = [&]<int degree>() {
    // Downwards, so that the coefficients of lower degree are still those of the factor.
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      constexpr int last = jet_size(N, degree) - 1;
      ((result.c[last - i] = convolution<N, last - i, false>(result.c, a.c)), ...);
    }
    (std::make_index_sequence<jet_size(N, degree) - 1>{});
    result.c[0] = taylor[K - degree];
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) { (multiply.template operator()<i + 1>(), ...); }
  (std::make_index_sequence<K>{});
  return result;
}

/// Coefficient `i` of a jet.
template <class T, int N, int K>
T coefficient(const Jet<T, N, K>& a, int i) {
  return a.c[i];
}

/// f(a) from f(a₀) and the jet of f′ in one variable at a₀ (to order K − 1).
template <class T, int N, int K>
Jet<T, N, K> compose_primitive(const Jet<T, N, K>& a, const T& value, const auto& derivative) {
  TaylorSeries<T, K> taylor;
  taylor[0] = value;
  for (int k = 1; k <= a.order(); ++k) taylor[k] = coefficient(derivative, k - 1) * T(1.0 / k);
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> select(const auto& condition, const Jet<T, N, K>& yes, const Jet<T, N, K>& no) {
  Jet<T, N, K> chosen;
  for (int i = 0; i < chosen.size; ++i) chosen.c[i] = select(condition, yes.c[i], no.c[i]);
  return chosen;
}

template <class T, int N, int K>
Jet<T, N, K> square(const Jet<T, N, K>& a) {
  Jet<T, N, K> product = a * a;
  product.c[0] = square(a.c[0]);  // an enclosure of a square knows that it is not negative
  return product;
}

/// ∂a/∂(axis): one order less is meaningful, coefficients of degree K are zero.
template <class T, int N, int K>
Jet<T, N, K> differentiate(const Jet<T, N, K>& a, int axis) {
  using Tables = JetTables<N, K>;
  Jet<T, N, K> derivative;
  for (int i = 0; i < derivative.size; ++i) {
    const MultiIndex& alpha = Tables::exponents[i];
    if (degree(alpha) < K)
      derivative.c[i] = T(alpha[axis] + 1.0) * a.c[jet_index(N, alpha + unit_index(axis))];
  }
  return derivative;
}

}  // namespace rfm
