#include "core/interval.hpp"

#include <numbers>

namespace rfm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

// NaN from inf − inf or 0 · inf means that nothing is known of that end, and an end that overflowed
// is known to lie beyond the largest number. Below the normal numbers errors are absolute; an end
// that is exactly 0 stays so.
double lowered(double low, double relative) {
  if (std::isnan(low)) return -infinity;
  if (low == infinity) return std::numeric_limits<double>::max();
  const double below = low - relative * std::fabs(low);
  return low != 0 && std::fabs(low) < std::numeric_limits<double>::min() ? below - denormal : below;
}
Interval widened(double low, double high, double relative) {
  return {lowered(low, relative), -lowered(-high, relative)};
}

constexpr double basic_margin = 0x1p-52;
constexpr double library_margin = 0x1p-50;
constexpr double cube_root_margin = 0x1p-49;

Interval outward(double low, double high) { return widened(low, high, basic_margin); }
Interval library(double low, double high) { return widened(low, high, library_margin); }

// For results that are positive: an end that has underflowed to 0 is not exactly 0.
Interval positive(double low, double high, double relative) {
  const Interval wide = widened(low, high, relative);
  return {std::max(wide.low, 0.0), std::max(wide.high, denormal)};
}

template <class Function>
Interval increasing(const Interval& a, Function&& function) {
  return library(function(a.low), function(a.high));
}

}  // namespace

Interval operator+(const Interval& a, const Interval& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  return outward(a.low + b.low, a.high + b.high);
}

Interval operator-(const Interval& a, const Interval& b) {
  if (b.is_zero()) return a;
  return outward(a.low - b.high, a.high - b.low);
}

Interval operator-(const Interval& a) { return {-a.high, -a.low}; }

Interval operator*(const Interval& a, const Interval& b) {
  if (a.is_zero() || b.is_zero()) return {};
  // The convention 0 · ∞ = 0 is right for enclosures: the infinite end is a bound, not a value.
  const auto product = [](double x, double y) { return x == 0 || y == 0 ? 0.0 : x * y; };
  const double p = product(a.low, b.low), q = product(a.low, b.high);
  const double r = product(a.high, b.low), s = product(a.high, b.high);
  Interval wide = outward(std::min({p, q, r, s}), std::max({p, q, r, s}));
  // An end of 0 is exact only if the signs of the factors say so; otherwise it has underflowed.
  const bool not_negative = (a.low >= 0 && b.low >= 0) || (a.high <= 0 && b.high <= 0);
  const bool not_positive = (a.low >= 0 && b.high <= 0) || (a.high <= 0 && b.low >= 0);
  if (wide.low == 0 && !not_negative) wide.low = -denormal;
  if (wide.high == 0 && !not_positive) wide.high = denormal;
  return wide;
}

Interval operator/(const Interval& a, const Interval& b) {
  if (!b.excludes_zero()) return Interval::entire();
  if (a.is_zero()) return {};
  Interval inverse = outward(1 / b.high, 1 / b.low);
  // Of an infinite divisor the quotient is 0 as a limit, with a sign that ⌊a / b⌋ sees.
  if (inverse.is_zero()) inverse = b.low > 0 ? Interval(0, denormal) : Interval(-denormal, 0);
  return a * inverse;
}

// Of what nothing is known, as where an argument may be no number, no function tells more.
static bool is_entire(const Interval& a) { return a.low == -infinity && a.high == infinity; }

Interval square(const Interval& a) {
  if (is_entire(a)) return a;
  if (a.is_zero()) return {};
  const double low = a.low * a.low, high = a.high * a.high;
  if (a.low <= 0 && a.high >= 0) return positive(0, std::max(low, high), basic_margin);
  return positive(std::min(low, high), std::max(low, high), basic_margin);
}

// a^exponent for a whole exponent of any size.
static Interval whole_power(const Interval& a, double exponent) {
  if (exponent < 0) {
    const Interval power = whole_power(a, -exponent);
    // Where an even power is 0 it is +0.
    if (power.low == 0 && std::fmod(exponent, 2) == 0) return outward(1 / power.high, infinity);
    return Interval(1) / power;
  }
  if (exponent == 0) return 1;
  if (exponent == 1 || a.is_zero()) return a;
  if (exponent == 2) return square(a);
  const double low = std::pow(a.low, exponent), high = std::pow(a.high, exponent);
  if (std::fmod(exponent, 2) != 0) {
    Interval wide = library(low, high);
    if (low == 0 && a.low < 0) wide.low = -denormal;
    if (high == 0 && a.high > 0) wide.high = denormal;
    return wide;
  }
  if (is_entire(a)) return a;
  if (a.low <= 0 && a.high >= 0) return positive(0, std::max(low, high), library_margin);
  return positive(std::min(low, high), std::max(low, high), library_margin);
}

Interval integer_power(const Interval& a, int exponent) { return whole_power(a, exponent); }

// Whether an argument may leave [least, most], but for rounding of what it is computed from.
static bool may_leave(const Interval& a, double least, double most = infinity) {
  constexpr double rounding = 1e-13;
  return !(a.low >= least - rounding * std::max(std::fabs(least), a.high)) ||
         !(a.high <= most * (1 + rounding));
}

Interval power(const Interval& a, double exponent) {
  if (exponent == std::floor(exponent)) return whole_power(a, exponent);
  if (may_leave(a, 0)) return Interval::entire();
  const double low = std::max(a.low, 0.0), high = a.high;
  const double p = std::pow(low, exponent), q = std::pow(high, exponent);
  if (high == 0 && exponent < 0) return Interval::entire();
  if (high == 0) return {std::min(p, q), std::max(p, q)};
  return positive(std::min(p, q), std::max(p, q), library_margin);
}

double error_of_power(const Interval& a, double relative, double lost) {
  constexpr double longest = 745;  // −log of the smallest number
  const auto size = [](double x) { return x > 0 ? std::fabs(std::log(x)) : longest; };
  return relative + 2 * std::fabs(lost) * std::min(std::max(size(a.low), size(a.high)), longest);
}

Interval sqrt(const Interval& a) {
  if (may_leave(a, 0)) return Interval::entire();
  const Interval wide = outward(std::sqrt(std::max(a.low, 0.0)), std::sqrt(a.high));
  return {std::max(wide.low, 0.0), wide.high};
}

Interval cbrt(const Interval& a) {
  return widened(std::cbrt(a.low), std::cbrt(a.high), cube_root_margin);
}

Interval exp(const Interval& a) {
  if (is_entire(a)) return a;
  return positive(std::exp(a.low), std::exp(a.high), library_margin);
}

Interval log(const Interval& a) {
  if (may_leave(a, 0)) return Interval::entire();
  return increasing(a, [](double x) { return x > 0 ? std::log(x) : -infinity; });
}

Interval cos(const Interval& a) {
  if (is_entire(a)) return a;
  constexpr double pi = std::numbers::pi;
  // Beyond 2⁵⁰ the period is lost in rounding.
  if (!(a.width() < 2 * pi) || a.magnitude() > 0x1p50) return {-1, 1};
  // k π in [low, high] for some even (odd) k makes the maximum (minimum) ±1. The quotient carries a
  // rounding error, so that multiples within it are counted too.
  const double slack = 4e-16 * (1 + a.magnitude() / pi);
  const double first = std::ceil(a.low / pi - slack), last = std::floor(a.high / pi + slack);
  bool even = false, odd = false;
  for (double k = first; k <= last && k <= first + 2; ++k)
    (std::fmod(k, 2.0) == 0 ? even : odd) = true;
  const double p = std::cos(a.low), q = std::cos(a.high);
  const Interval wide = library(std::min(p, q), std::max(p, q));
  return {odd ? -1 : std::max(-1.0, wide.low), even ? 1 : std::min(1.0, wide.high)};
}

Interval sin(const Interval& a) {
  if (is_entire(a)) return a;
  constexpr double half_pi = std::numbers::pi / 2;
  if (!(a.width() < 4 * half_pi) || a.magnitude() > 0x1p50) return {-1, 1};
  const double slack = 4e-16 * (1 + a.magnitude() / half_pi);
  // Extrema at π/2 + kπ: maxima for even k.
  const double first = std::ceil((a.low / half_pi - 1) / 2 - slack);
  const double last = std::floor((a.high / half_pi - 1) / 2 + slack);
  bool even = false, odd = false;
  for (double k = first; k <= last && k <= first + 2; ++k)
    (std::fmod(k, 2.0) == 0 ? even : odd) = true;
  const double p = std::sin(a.low), q = std::sin(a.high);
  const Interval wide = library(std::min(p, q), std::max(p, q));
  return {odd ? -1 : std::max(-1.0, wide.low), even ? 1 : std::min(1.0, wide.high)};
}

Interval tan(const Interval& a) {
  constexpr double pi = std::numbers::pi;
  const double slack = 4e-16 * (1 + a.magnitude() / pi);
  const double low = std::floor(a.low / pi + 0.5 - slack);
  const double high = std::floor(a.high / pi + 0.5 + slack);
  if (!(low == high) || a.magnitude() > 0x1p50) return Interval::entire();
  return increasing(a, [](double x) { return std::tan(x); });
}

Interval asin(const Interval& a) {
  if (may_leave(a, -1, 1)) return Interval::entire();
  return increasing({std::clamp(a.low, -1.0, 1.0), std::clamp(a.high, -1.0, 1.0)},
                    [](double x) { return std::asin(x); });
}

Interval acos(const Interval& a) {
  if (may_leave(a, -1, 1)) return Interval::entire();
  const Interval wide =
      library(std::acos(std::clamp(a.high, -1.0, 1.0)), std::acos(std::clamp(a.low, -1.0, 1.0)));
  return {std::max(wide.low, 0.0), wide.high};
}

Interval atan(const Interval& a) {
  if (is_entire(a)) return a;
  return increasing(a, [](double x) { return std::atan(x); });
}

Interval atan2(const Interval& y, const Interval& x) {
  constexpr double pi = std::numbers::pi;
  // On the cut itself the sign of zero decides between −π and π.
  const bool origin = x.contains(0) && y.contains(0);
  const bool meets_cut = x.low < 0 && y.contains(0);
  if (origin || meets_cut) return {-pi - 1e-15, pi + 1e-15};
  // Without the origin and the cut, extremes over a box are taken at its corners.
  const double p = std::atan2(y.low, x.low), q = std::atan2(y.low, x.high);
  const double r = std::atan2(y.high, x.low), s = std::atan2(y.high, x.high);
  Interval wide = library(std::min({p, q, r, s}), std::max({p, q, r, s}));
  // The angle is exactly 0 on the axis only; elsewhere it has underflowed.
  if (wide.low == 0 && y.low < 0) wide.low = -denormal;
  if (wide.high == 0 && y.high > 0) wide.high = denormal;
  return wide;
}

Interval sinh(const Interval& a) {
  return increasing(a, [](double x) { return std::sinh(x); });
}

Interval cosh(const Interval& a) {
  if (is_entire(a)) return a;
  const double p = std::cosh(a.low), q = std::cosh(a.high);
  const Interval wide = library(std::min(p, q), std::max(p, q));
  return {a.contains(0) ? 1 : std::max(1.0, wide.low), wide.high};
}

Interval tanh(const Interval& a) {
  if (is_entire(a)) return a;
  return increasing(a, [](double x) { return std::tanh(x); });
}

Interval asinh(const Interval& a) {
  return increasing(a, [](double x) { return std::asinh(x); });
}

Interval erf(const Interval& a) {
  if (is_entire(a)) return a;
  return increasing(a, [](double x) { return std::erf(x); });
}

Interval abs(const Interval& a) {
  return is_entire(a) ? a : Interval(a.mignitude(), a.magnitude());
}

Interval floor(const Interval& a) { return {std::floor(a.low), std::floor(a.high)}; }

Interval hypot(const Interval& a, const Interval& b) { return sqrt(square(a) + square(b)); }

Interval intersection(const Interval& a, const Interval& b) {
  const Interval common{std::max(a.low, b.low), std::min(a.high, b.high)};
  if (common.low <= common.high) return common;
  return a.width() < b.width() ? a : b;
}

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace rfm
