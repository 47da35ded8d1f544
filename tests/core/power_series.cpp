#include "tests/core/power_series.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace rfm::reference {
namespace {

using rfm::operator+;  // of multi-indices; that of series hides it

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Real pi() { return 4 * atan(Real(1)); }

bool is_nan(const Real& x) { return (boost::multiprecision::isnan)(x); }

std::vector<MultiIndex> monomials(int variables, int order) {
  std::vector<MultiIndex> list(jet_size(variables, order));
  MultiIndex at{};
  const std::function<void(int, int)> fill = [&](int axis, int left) {
    if (axis == variables) return void(list[jet_index(variables, at)] = at);
    for (int power = 0; power <= left; ++power) {
      at[axis] = static_cast<std::uint8_t>(power);
      fill(axis + 1, left - power);
    }
    at[axis] = 0;
  };
  fill(0, order);
  return list;
}

// The place of the product of two monomials, −1 beyond the order.
const std::vector<std::vector<int>>& products(int variables, int order) {
  static std::map<std::pair<int, int>, std::vector<std::vector<int>>> known;
  auto& table = known[{variables, order}];
  if (!table.empty()) return table;
  const auto list = monomials(variables, order);
  for (const MultiIndex& a : list) {
    table.emplace_back();
    for (const MultiIndex& b : list)
      table.back().push_back(degree(a) + degree(b) <= order ? jet_index(variables, a + b) : -1);
  }
  return table;
}

PowerSeries zero_like(const PowerSeries& a, const PowerSeries& b) {
  const PowerSeries& shape = a.c.size() >= b.c.size() ? a : b;
  return {shape.variables, shape.order};
}

PowerSeries constant_like(const PowerSeries& a, Real value) {
  PowerSeries constant(a.variables, a.order);
  constant.c[0] = std::move(value);
  return constant;
}

// f(a) from the Taylor coefficients of f at the value of a, one more than the order.
PowerSeries composed(const PowerSeries& a, const std::vector<Real>& taylor) {
  PowerSeries increment = a, power = constant_like(a, 1), sum = constant_like(a, taylor[0]);
  increment.c[0] = 0;
  for (int k = 1; k <= a.order; ++k) {
    power = power * increment;
    for (std::size_t i = 0; i < sum.c.size(); ++i)
      if (power.c[i] != 0) sum.c[i] += taylor[k] * power.c[i];
  }
  return sum;
}

PowerSeries own_variable(const PowerSeries& a) {
  PowerSeries x(1, std::max(a.order, 1));
  x.c[0] = a.c[0];
  x.c[1] = 1;
  return x;
}

// f(a) from its value and the series of its derivative in one variable.
PowerSeries integrated(const PowerSeries& a, const Real& value, const PowerSeries& derivative) {
  std::vector<Real> taylor{value};
  for (int k = 1; k <= a.order; ++k) taylor.push_back(derivative.c[k - 1] / k);
  return composed(a, taylor);
}

PowerSeries power_with_number(const PowerSeries& a, const Real& exponent) {
  const Real& x = a.c[0];
  const bool is_whole = floor(exponent) == exponent;
  std::vector<Real> taylor;
  Real binomial = 1;
  for (int k = 0; k <= a.order; ++k) {
    if (k > 0) binomial *= (exponent - (k - 1)) / k;
    const Real rest = exponent - k;
    if (binomial == 0)
      taylor.push_back(0);
    else if (x == 0 && (!is_whole || rest < 0)) {
      incidents().corner = true;
      taylor.push_back(rest > 0 ? Real(0) : not_a_number);
    } else if (x == 0)
      taylor.push_back(rest == 0 ? binomial : Real(0));
    else if (is_whole)
      taylor.push_back(binomial * (x < 0 && fmod(rest, 2) != 0 ? -1 : 1) *
                       exp(rest * log(Real(fabs(x)))));
    else
      taylor.push_back(x < 0 ? not_a_number : Real(binomial * exp(rest * log(x))));
  }
  return composed(a, taylor);
}

PowerSeries circular(const PowerSeries& a, const Real& first, const Real& second, int sign) {
  std::vector<Real> taylor;
  Real factor = 1;
  for (int k = 0; k <= a.order; ++k) {
    if (k > 0) factor /= k;
    if (k > 1 && k % 2 == 0) factor *= sign;
    taylor.push_back(factor * (k % 2 == 0 ? first : second));
  }
  return composed(a, taylor);
}

bool order_of(const PowerSeries& a, const PowerSeries& b) {
  if (a.value() == b.value()) incidents().corner = true;
  return a.value() < b.value();
}

}  // namespace

Incidents& incidents() {
  static Incidents met;
  return met;
}

PowerSeries PowerSeries::variable(int variables, int order, int axis, double value) {
  PowerSeries x(variables, order);
  x.c[0] = value;
  if (order > 0) x.c[1 + axis] = 1;
  return x;
}

bool PowerSeries::is_constant() const {
  for (std::size_t i = 1; i < c.size(); ++i)
    if (c[i] != 0) return false;
  return true;
}

PowerSeries operator+(const PowerSeries& a, const PowerSeries& b) {
  PowerSeries sum = zero_like(a, b);
  for (std::size_t i = 0; i < a.c.size(); ++i) sum.c[i] += a.c[i];
  for (std::size_t i = 0; i < b.c.size(); ++i) sum.c[i] += b.c[i];
  return sum;
}

PowerSeries operator-(const PowerSeries& a) {
  PowerSeries negative = a;
  for (Real& coefficient : negative.c) coefficient = -coefficient;
  return negative;
}

PowerSeries operator-(const PowerSeries& a, const PowerSeries& b) { return a + (-b); }

PowerSeries operator*(const PowerSeries& a, const PowerSeries& b) {
  PowerSeries product = zero_like(a, b);
  const auto& place = products(product.variables, product.order);
  for (std::size_t i = 0; i < a.c.size(); ++i) {
    if (a.c[i] == 0) continue;
    for (std::size_t j = 0; j < b.c.size(); ++j)
      if (place[i][j] >= 0 && b.c[j] != 0) product.c[place[i][j]] += a.c[i] * b.c[j];
  }
  return product;
}

PowerSeries operator/(const PowerSeries& a, const PowerSeries& b) {
  if (b.value() == 0) incidents().corner = true;
  std::vector<Real> taylor{1 / b.value()};  // of 1/b, a geometric series
  for (int k = 1; k <= b.order; ++k) taylor.push_back(-taylor.back() / b.value());
  return a * composed(b, taylor);
}

bool operator<(const PowerSeries& a, const PowerSeries& b) { return order_of(a, b); }
bool operator>(const PowerSeries& a, const PowerSeries& b) { return order_of(b, a); }
bool operator<=(const PowerSeries& a, const PowerSeries& b) {
  return order_of(a, b) || a.value() == b.value();
}
bool operator>=(const PowerSeries& a, const PowerSeries& b) { return b <= a; }
bool operator==(const PowerSeries& a, const PowerSeries& b) { return a.value() == b.value(); }
bool operator!=(const PowerSeries& a, const PowerSeries& b) { return !(a == b); }

PowerSeries pow(const PowerSeries& a, const PowerSeries& b) {
  return b.is_constant() && b.c.size() == 1 ? power_with_number(a, b.value()) : exp(b * log(a));
}

PowerSeries fabs(const PowerSeries& a) {
  if (a.value() == 0) incidents().corner = true;
  return a.value() < 0 ? -a : a;
}

PowerSeries floor(const PowerSeries& a) {
  const Real below = boost::multiprecision::floor(a.value());
  if (below == a.value()) incidents().corner = true;
  return constant_like(a, below);
}

PowerSeries floored_remainder(const PowerSeries& a, const PowerSeries& b) {
  const auto dividend = static_cast<double>(a.value()), divisor = static_cast<double>(b.value());
  double rest = std::fmod(dividend, divisor);  // exact
  if (rest == 0) incidents().corner = true;
  Real exact = rest;
  if (rest != 0 && (rest < 0) != (divisor < 0)) exact += b.value();
  const Real quotient = boost::multiprecision::round(Real((a.value() - exact) / b.value()));
  PowerSeries result = a - PowerSeries(quotient) * b;
  result.c[0] = exact;
  return result;
}

PowerSeries sqrt(const PowerSeries& a) {
  PowerSeries root = power_with_number(a, Real(1) / 2);
  root.c[0] = sqrt(a.value());
  return root;
}

PowerSeries cbrt(const PowerSeries& a) {
  return a.value() < 0 ? -power_with_number(-a, Real(1) / 3) : power_with_number(a, Real(1) / 3);
}

PowerSeries exp(const PowerSeries& a) {
  std::vector<Real> taylor{exp(a.value())};
  for (int k = 1; k <= a.order; ++k) taylor.push_back(taylor.back() / k);
  return composed(a, taylor);
}

PowerSeries log(const PowerSeries& a) {
  if (a.value() == 0) incidents().corner = true;
  if (a.value() < 0 || is_nan(a.value()))
    return composed(a, std::vector<Real>(a.order + 1, not_a_number));
  std::vector<Real> taylor{log(a.value())};
  Real power = -1;
  for (int k = 1; k <= a.order; ++k) {
    power /= -a.value();
    taylor.push_back(power / k);
  }
  return composed(a, taylor);
}

PowerSeries sin(const PowerSeries& a) {
  return circular(a, Real(sin(a.value())), Real(cos(a.value())), -1);
}

PowerSeries cos(const PowerSeries& a) {
  return circular(a, Real(cos(a.value())), Real(-sin(a.value())), -1);
}

PowerSeries tan(const PowerSeries& a) {
  const PowerSeries x = own_variable(a), tangent = sin(x) / cos(x);
  return composed(a, tangent.c);
}

PowerSeries asin(const PowerSeries& a) {
  const Real& x = a.value();
  if (fabs(x) == 1) incidents().corner = true;
  const PowerSeries own = own_variable(a);
  return integrated(a, fabs(x) > 1 ? not_a_number : Real(asin(x)),
                    power_with_number(1.0 - own * own, Real(-1) / 2));
}

PowerSeries acos(const PowerSeries& a) { return PowerSeries(Real(pi() / 2)) - asin(a); }

PowerSeries atan(const PowerSeries& a) {
  const PowerSeries own = own_variable(a);
  return integrated(a, atan(a.value()), 1.0 / (1.0 + own * own));
}

PowerSeries atan2(const PowerSeries& y, const PowerSeries& x) {
  if (y.value() == 0 && x.value() <= 0) incidents().corner = incidents().cut = true;
  PowerSeries angle = fabs(Real(y.value())) > fabs(Real(x.value())) ? -atan(x / y) : atan(y / x);
  angle.c[0] = atan2(y.value(), x.value());
  return angle;
}

PowerSeries sinh(const PowerSeries& a) {
  return circular(a, Real(sinh(a.value())), Real(cosh(a.value())), 1);
}
PowerSeries cosh(const PowerSeries& a) {
  return circular(a, Real(cosh(a.value())), Real(sinh(a.value())), 1);
}

PowerSeries tanh(const PowerSeries& a) {
  const PowerSeries cosine = cosh(own_variable(a));
  return integrated(a, Real(tanh(a.value())), 1.0 / (cosine * cosine));
}

PowerSeries asinh(const PowerSeries& a) {
  const PowerSeries own = own_variable(a);
  return integrated(a, Real(asinh(a.value())), power_with_number(1.0 + own * own, Real(-1) / 2));
}

PowerSeries erf(const PowerSeries& a) {
  const PowerSeries own = own_variable(a);
  const Real scale = 2 / sqrt(pi());
  return integrated(a, Real(erf(a.value())), PowerSeries(scale) * exp(-(own * own)));
}

PowerSeries hypot(const PowerSeries& a, const PowerSeries& b) { return sqrt(a * a + b * b); }

}  // namespace rfm::reference
