#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

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
/// Numbers of variables and orders beyond those compiled into tapes have `DynamicJet`
/// (core/dynamic_jet.hpp), to which the same rules apply.
template <class T, int N, int K>
struct Jet {
  static_assert(N >= 1 && N <= maximum_variables && K >= 0);
  static constexpr int size = jet_size(N, K);
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

/// Enumerates the multi-indices of degree ≤ `left` in the axes from `axis` on, into their places.
template <int N, std::size_t size>
constexpr void list_exponents(std::array<MultiIndex, size>& list, MultiIndex index, int axis,
                              int left) {
  if (axis == N) {
    list[jet_index(N, index)] = index;
    return;
  }
  for (int power = 0; power <= left; ++power) {
    index[axis] = static_cast<std::uint8_t>(power);
    list_exponents<N>(list, index, axis + 1, left - power);
  }
}

/// The multi-indices of a jet, in order.
template <int N, int K>
constexpr auto jet_exponents() {
  std::array<MultiIndex, jet_size(N, K)> list{};
  list_exponents<N>(list, MultiIndex{}, 0, K);
  return list;
}

/// Multi-indices of a jet in order, computed at compile time.
template <int N, int K>
struct JetTables {
  static constexpr auto exponents = jet_exponents<N, K>();
};

/// A term of the product of two jets: the coefficients that are multiplied.
struct JetProductTerm {
  std::uint8_t left, right;
};

/// The terms of which coefficient `result` of a product in N variables is the sum, by their left
/// factors: the first has right = `result`, the last left = `result`. They do not depend on the
/// order of the jets.
template <int N, int result>
constexpr auto jet_product_terms() {
  constexpr auto exponents = jet_exponents<N, jet_degree(N, result)>();
  constexpr MultiIndex total = exponents[result];
  constexpr int count = (total[0] + 1) * (total[1] + 1) * (total[2] + 1) * (total[3] + 1);
  std::array<JetProductTerm, count> terms{};
  int place = 0;
  for (int left = 0; left <= result; ++left)
    if (divides(exponents[left], total))
      terms[place++] = {static_cast<std::uint8_t>(left),
                        static_cast<std::uint8_t>(jet_index(N, total - exponents[left]))};
  return terms;
}

/// Coefficient `result` of the product of two jets; without its last term it is what the
/// coefficients of `a` before `result` contribute.
template <int N, int result, bool with_last, class T, std::size_t size>
T convolution(const std::array<T, size>& a, const std::array<T, size>& b) {
  static constexpr auto terms = jet_product_terms<N, result>();
  // A value is rounded before it is used further, alike in every evaluator.
  if constexpr (result == 0) return T(0.0) + a[0] * b[0];
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    T sum = a[0] * b[terms[0].right];
    ((sum = sum + a[terms[i + 1].left] * b[terms[i + 1].right]), ...);
    return sum;
  }
  (std::make_index_sequence<terms.size() - (with_last ? 1 : 2)>{});
}

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

template <class T, int N, int K>
Jet<T, N, K> operator/(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  // q b = a, solved coefficient by coefficient in ascending degree: no powers of 1/b. The value is
  // rounded once, so that it does not depend on the order.
  Jet<T, N, K> quotient;
  quotient.c[0] = a.c[0] / b.c[0];
  if constexpr (K > 0) {
    const T inverse = T(1.0) / b.c[0];
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      ((quotient.c[i + 1] = remainder<N, i + 1>(a.c[i + 1], quotient.c, b.c) * inverse), ...);
    }
    (std::make_index_sequence<quotient.size - 1>{});
  }
  return quotient;
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

template <class T, int N, int K>
Jet<T, N, K> integer_power(const Jet<T, N, K>& a, int exponent) {
  if (exponent < 0) return Jet<T, N, K>(1.0) / integer_power(a, -exponent);
  if (exponent == 0) return Jet<T, N, K>(1.0);
  Jet<T, N, K> base = a;
  while (exponent % 2 == 0) base = square(base), exponent /= 2;
  Jet<T, N, K> result = base;
  for (exponent /= 2; exponent > 0; exponent /= 2) {
    base = square(base);
    if (exponent % 2 == 1) result = result * base;
  }
  return result;
}

/// aᵉ, e known up to `lost`, beside a factor known up to `relative`: both are made up for in
/// bounds, |a^δ − 1| ≤ 2 |δ log a| as long as that is small; plain numbers are what they are.
template <class T>
T power_known_to(const T& a, double exponent, double, double) {
  using rfm::power;
  return power(a, exponent);
}
inline Interval power_known_to(const Interval& a, double exponent, double lost, double relative) {
  const double error = error_of_power(a, relative, lost);
  return power(a, exponent) * Interval(1 - error, 1 + error);
}

/// aᵉ⁻ᵏ for a ≥ 0 as it stands in the k-th derivative of aᵉ, beside a coefficient that has at most
/// 3k roundings; e − k itself is rounded.
template <class T>
T lowered_power(const T& a, double exponent, int k) {
  const double lowered = exponent - k, back = lowered - exponent;
  const double lost = (exponent - (lowered - back)) + (-k - back);
  return power_known_to(a, lowered, lost, k * 0x1p-51);
}

/// aᵉ for a ≥ 0; at a = 0 the singular coefficients are 0.
template <class T, int N, int K>
Jet<T, N, K> real_power(const Jet<T, N, K>& a, double exponent) {
  using rfm::power;
  TaylorSeries<T, K> taylor;
  taylor[0] = power(a.c[0], exponent);
  double binomial = 1;
  for (int k = 1; k <= a.order(); ++k) {
    binomial *= (exponent - (k - 1)) / k;
    const T singular = T(binomial) * lowered_power(a.c[0], exponent, k);
    taylor[k] = exponent >= k ? singular : select(equal(a.c[0], T(0.0)), T(0.0), singular);
  }
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> sqrt(const Jet<T, N, K>& a) {
  using std::sqrt;
  TaylorSeries<T, K> taylor;
  taylor[0] = sqrt(a.c[0]);
  if (a.order() > 0) {
    const T inverse = reciprocal_or_zero(a.c[0]);
    for (int k = 1; k <= a.order(); ++k) taylor[k] = T((1.5 - k) / k) * taylor[k - 1] * inverse;
  }
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> cbrt(const Jet<T, N, K>& a) {
  using std::cbrt;
  TaylorSeries<T, K> taylor;
  taylor[0] = cbrt(a.c[0]);
  if (a.order() > 0) {
    const T inverse = reciprocal_or_zero(a.c[0]);
    for (int k = 1; k <= a.order(); ++k) taylor[k] = T((4.0 / 3 - k) / k) * taylor[k - 1] * inverse;
  }
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> exp(const Jet<T, N, K>& a) {
  using std::exp;
  TaylorSeries<T, K> taylor;
  taylor[0] = exp(a.c[0]);
  for (int k = 1; k <= a.order(); ++k) taylor[k] = taylor[k - 1] * T(1.0 / k);
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> log(const Jet<T, N, K>& a) {
  using std::log;
  TaylorSeries<T, K> taylor;
  taylor[0] = log(a.c[0]);
  if (a.order() > 0) {
    // Where the logarithm is not defined its derivatives are not either.
    const T inverse = nan_where_nan(reciprocal_or_zero(a.c[0]), taylor[0]);
    T power = inverse;
    for (int k = 1; k <= a.order(); ++k) {
      taylor[k] = T((k % 2 == 1 ? 1.0 : -1.0) / k) * power;
      power = power * inverse;
    }
  }
  return compose(a, taylor);
}

/// The Taylor coefficients of a function whose derivatives repeat as `first`, `second`, ± those.
template <class T, int K>
TaylorSeries<T, K> alternating_series(int order, const T& first, const T& second, double sign) {
  TaylorSeries<T, K> taylor;
  double factor = 1;
  for (int k = 0; k <= order; ++k) {
    if (k > 0) factor /= k;
    if (k > 1 && k % 2 == 0) factor *= sign;
    taylor[k] = T(factor) * (k % 2 == 0 ? first : second);
  }
  return taylor;
}

template <class T, int N, int K>
Jet<T, N, K> sin(const Jet<T, N, K>& a) {
  using std::cos, std::sin, rfm::cos, rfm::sin;
  if (a.order() == 0) return Jet<T, N, K>::constant(sin(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), sin(a.c[0]), cos(a.c[0]), -1));
}

template <class T, int N, int K>
Jet<T, N, K> cos(const Jet<T, N, K>& a) {
  using std::cos, std::sin, rfm::cos, rfm::sin;
  if (a.order() == 0) return Jet<T, N, K>::constant(cos(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), cos(a.c[0]), -sin(a.c[0]), -1));
}

template <class T, int N, int K>
Jet<T, N, K> sinh(const Jet<T, N, K>& a) {
  using std::cosh, std::sinh;
  if (a.order() == 0) return Jet<T, N, K>::constant(sinh(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), sinh(a.c[0]), cosh(a.c[0]), 1));
}

template <class T, int N, int K>
Jet<T, N, K> cosh(const Jet<T, N, K>& a) {
  using std::cosh, std::sinh;
  if (a.order() == 0) return Jet<T, N, K>::constant(cosh(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), cosh(a.c[0]), sinh(a.c[0]), 1));
}

/// Taylor coefficients of the solution of f′ = 1 + sign f²: tan (+) and tanh (−).
template <class T, int K>
TaylorSeries<T, K> riccati_series(int order, const T& value, double sign) {
  TaylorSeries<T, K> taylor;
  taylor[0] = value;
  for (int k = 0; k < order; ++k) {
    T sum = T(0.0);
    for (int i = 0; i <= k; ++i) sum = sum + taylor[i] * taylor[k - i];
    taylor[k + 1] = T(1.0 / (k + 1)) * (T(k == 0 ? 1.0 : 0.0) + T(sign) * sum);
  }
  return taylor;
}

template <class T, int N, int K>
Jet<T, N, K> tan(const Jet<T, N, K>& a) {
  using std::tan;
  return compose(a, riccati_series<T, K>(a.order(), tan(a.c[0]), 1));
}

template <class T, int N, int K>
Jet<T, N, K> tanh(const Jet<T, N, K>& a) {
  using std::tanh;
  return compose(a, riccati_series<T, K>(a.order(), tanh(a.c[0]), -1));
}

/// The jet in one variable at the value of `a`, one order lower: derivatives of inverse functions
/// are built from it.
template <class T, int N, int K>
auto own_variable(const Jet<T, N, K>& a) {
  return Jet<T, 1, (K > 0 ? K - 1 : 0)>::variable(0, a.c[0]);
}

template <class T, int N, int K>
Jet<T, N, K> asin(const Jet<T, N, K>& a) {
  using std::asin;
  if (a.order() == 0) return Jet<T, N, K>::constant(asin(a.c[0]));
  const auto x = own_variable(a);
  const decltype(x) one(1.0);
  // (1 − x)(1 + x) does not cancel next to ±1, where the derivatives are 0 by convention.
  const auto rest = (one - x) * (one + x);
  const auto regular = real_power(rest, -0.5);
  return compose_primitive(a, T(asin(a.c[0])),
                           select(equal(rest.c[0], T(0.0)), decltype(regular)(), regular));
}

template <class T, int N, int K>
Jet<T, N, K> acos(const Jet<T, N, K>& a) {
  using std::acos;
  Jet<T, N, K> result = -asin(a);
  result.c[0] = acos(a.c[0]);
  return result;
}

template <class T, int N, int K>
Jet<T, N, K> atan(const Jet<T, N, K>& a) {
  using std::atan;
  if (a.order() == 0) return Jet<T, N, K>::constant(atan(a.c[0]));
  const auto x = own_variable(a);
  const decltype(x) one(1.0);
  return compose_primitive(a, T(atan(a.c[0])), one / (one + x * x));
}

template <class T, int N, int K>
Jet<T, N, K> asinh(const Jet<T, N, K>& a) {
  using std::asinh;
  if (a.order() == 0) return Jet<T, N, K>::constant(asinh(a.c[0]));
  const auto x = own_variable(a);
  const decltype(x) one(1.0);
  return compose_primitive(a, T(asinh(a.c[0])), real_power(one + x * x, -0.5));
}

template <class T, int N, int K>
Jet<T, N, K> erf(const Jet<T, N, K>& a) {
  using std::erf;
  if (a.order() == 0) return Jet<T, N, K>::constant(erf(a.c[0]));
  const auto x = own_variable(a);
  return compose_primitive(a, T(erf(a.c[0])),
                           scaled(T(2 * std::numbers::inv_sqrtpi), exp(-(x * x))));
}

/// The angle of (x, y): all derivatives are those of atan(y/x) or of −atan(x/y), whichever quotient
/// is the smaller.
template <class T, int N, int K>
Jet<T, N, K> atan2(const Jet<T, N, K>& y, const Jet<T, N, K>& x) {
  using std::atan2;
  Jet<T, N, K> angle;
  if constexpr (K != 0) {
    const auto steep = farther_from_zero(y.c[0], x.c[0]);
    const Jet<T, N, K> numerator = select(steep, x, y), denominator = select(steep, y, x);
    const Jet<T, N, K> flat = atan(numerator / denominator);
    const auto origin = equal(square(x.c[0]) + square(y.c[0]), T(0.0));
    angle = select(origin, Jet<T, N, K>(), select(steep, -flat, flat));
  }
  angle.c[0] = atan2(y.c[0], x.c[0]);
  return angle;
}

template <class T, int N, int K>
Jet<T, N, K> floor(const Jet<T, N, K>& a) {
  using std::floor;
  return Jet<T, N, K>::constant(floor(a.c[0]));
}

// What depends on a comparison with NaN is NaN itself: a point outside the domain of a function
// must not pass for the other side of a condition.

template <class T, int N, int K>
Jet<T, N, K> nan_where_nan(Jet<T, N, K> f, const T& argument) {
  for (T& coefficient : f.c) coefficient = nan_where_nan(coefficient, argument);
  return f;
}

/// 1 where the mask holds, else 0.
template <class T, int N, int K>
Jet<T, N, K> indicator(const auto& mask, const T& argument) {
  return nan_where_nan(Jet<T, N, K>::constant(select(mask, T(1.0), T(0.0))), argument);
}

template <class T, int N, int K>
Jet<T, N, K> step(const Jet<T, N, K>& a) {
  return indicator<T, N, K>(less_equal(T(0.0), a.c[0]), a.c[0]);
}

template <class T, int N, int K>
Jet<T, N, K> less_than(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return nan_where_nan(indicator<T, N, K>(less(a.c[0], b.c[0]), a.c[0]), b.c[0]);
}

template <class T, int N, int K>
Jet<T, N, K> at_most(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return nan_where_nan(indicator<T, N, K>(less_equal(a.c[0], b.c[0]), a.c[0]), b.c[0]);
}

template <class T, int N, int K>
Jet<T, N, K> equals(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return nan_where_nan(indicator<T, N, K>(equal(a.c[0], b.c[0]), a.c[0]), b.c[0]);
}

template <class T, int N, int K>
Jet<T, N, K> choose(const Jet<T, N, K>& condition, const Jet<T, N, K>& yes,
                    const Jet<T, N, K>& no) {
  return nan_where_nan(select(equal(condition.c[0], T(0.0)), no, yes), condition.c[0]);
}

template <class T, int N, int K>
Jet<T, N, K> sign(const Jet<T, N, K>& a) {
  const T negative_or_zero = select(less(a.c[0], T(0.0)), T(-1.0), T(0.0));
  return nan_where_nan(
      Jet<T, N, K>::constant(select(less(T(0.0), a.c[0]), T(1.0), negative_or_zero)), a.c[0]);
}

template <class T, int N, int K>
Jet<T, N, K> abs(const Jet<T, N, K>& a) {
  return select(less(a.c[0], T(0.0)), -a, a);
}

template <class T, int N, int K>
Jet<T, N, K> min(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return select(less_or_nan(b.c[0], a.c[0]), b, a);
}

template <class T, int N, int K>
Jet<T, N, K> max(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return select(greater_or_nan(b.c[0], a.c[0]), b, a);
}

/// a − b ⌊a / b⌋.
template <class T, int N, int K>
Jet<T, N, K> mod(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  if constexpr (requires { floored_remainder(a.c[0], b.c[0]); }) {
    // Next to multiples of b the quotient may round to the wrong whole number.
    using std::floor;
    const T rest = floored_remainder(a.c[0], b.c[0]);
    Jet<T, N, K> result = a - scaled(T(floor((a.c[0] - rest) / b.c[0] + T(0.5))), b);
    result.c[0] = rest;
    return result;
  } else {
    return a - b * floor(a / b);
  }
}

/// aᵇ = exp(b log a); at a = 0 its limit, 0⁰ = 1, and derivatives 0 by convention.
template <class T, int N, int K>
Jet<T, N, K> general_power(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  const Jet<T, N, K> regular = exp(b * log(a));
  const T limit = select(equal(b.c[0], T(0.0)), T(1.0), regular.c[0]);
  return select(equal(a.c[0], T(0.0)), Jet<T, N, K>::constant(limit), regular);
}

/// √(a² + b²); numbers whose squares would overflow or underflow are scaled by a power of two.
template <class T, int N, int K>
Jet<T, N, K> hypot(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  T scale;
  if (!squares_need_scale(a.c[0], b.c[0], scale)) return sqrt(square(a) + square(b));
  return scaled(T(1.0) / scale, sqrt(square(scaled(scale, a)) + square(scaled(scale, b))));
}

}  // namespace rfm
