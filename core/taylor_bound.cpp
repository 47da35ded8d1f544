#include "core/taylor_bound.hpp"

#include <cmath>
#include <numbers>

namespace rfm {
namespace {

// What may have underflowed in an operation: the smallest normal number, and slopes, to be
// multiplied by radii, by four denormal ones, 4 · 2⁻¹⁰⁷⁴ Σ rᵢ = 2⁻¹⁰²² · 2⁻⁵⁰ Σ rᵢ. Products of
// denormal numbers took half of the time of an operation.
double underflow_of(const std::array<double, maximum_variables>& radius) {
  double sum = 0;
  for (const double r : radius) sum += r;
  return std::numeric_limits<double>::min() * (1 + 0x1p-49 * sum);
}

thread_local std::array<double, maximum_variables> frame_radius{};
thread_local double frame_underflow = std::numeric_limits<double>::min();

void set_frame(const std::array<double, maximum_variables>& radius) {
  frame_radius = radius;
  frame_underflow = underflow_of(radius);
}

constexpr double huge = 1e200;

// What is left when the linear model is useless: the range alone.
TaylorBound from_range(const Interval& range, bool smooth) {
  return TaylorBound::of_range(range, smooth);
}

// Closes an operation: rounding margin, then the range from both sides. In place: a model is large
// beside what is done to it.
inline void close(TaylorBound& model) {
  const double extent = model.linear_extent();
  const double margin = 2e-15 * (std::fabs(model.value) + extent + model.error);
  model.error += margin + frame_underflow;
  const double reach = extent + model.error;
  if (!(reach < huge) || !(std::fabs(model.value) < huge))
    return void(model = from_range(model.range, model.smooth));
  model.range = intersection(model.range, Interval(model.value - reach, model.value + reach));
  // A model whose middle is not even a possible value says less than the range, and functions could
  // not be expanded about it: their second derivative is known over the range only.
  if (!model.range.contains(model.value)) model = from_range(model.range, model.smooth);
}

// f(a) from f and f′ at the centre, an enclosure of f″ over the range of a, and one of f.
TaylorBound composed(const TaylorBound& a, double f, double slope, const Interval& second,
                     const Interval& range, bool smooth) {
  if (a.is_zero() || (a.range.is_point() && a.linear_extent() == 0)) {
    return from_range(range, smooth);
  }
  const double distance =
      std::min(a.linear_extent() + a.error, (a.range - Interval(a.value)).magnitude());
  // The square must not underflow to an exact zero, which would silence an unbounded f″.
  const Interval remainder = Interval(0.5) * second * Interval(0, square(Interval(distance)).high);
  TaylorBound model;
  model.smooth = smooth;
  model.range = range;
  if (!(remainder.magnitude() < huge) || !std::isfinite(f) || !(std::fabs(slope) < huge))
    return from_range(range, smooth);
  model.value = f + remainder.middle();
  for (int axis = 0; axis < maximum_variables; ++axis) model.slope[axis] = slope * a.slope[axis];
  model.error = std::fabs(slope) * a.error + remainder.radius() + 1e-15 * std::fabs(f);
  close(model);
  return model;
}

}  // namespace

TaylorBound::Frame::Frame(const std::array<double, maximum_variables>& radius)
    : previous_(frame_radius) {
  set_frame(radius);
}
TaylorBound::Frame::~Frame() { set_frame(previous_); }

TaylorBound TaylorBound::of_range(const Interval& range, bool smooth) {
  TaylorBound model;
  model.range = range;
  model.smooth = smooth;
  if (range.magnitude() < huge) {
    model.value = range.middle();
    model.error = range.radius() + 1e-15 * range.magnitude();
    if (!range.is_zero()) model.error += std::numeric_limits<double>::min();
  } else {
    model.error = std::numeric_limits<double>::infinity();
  }
  return model;
}

TaylorBound TaylorBound::coordinate(const Interval& interval, int axis) {
  TaylorBound model;
  model.value = interval.middle();
  model.slope[axis] = 1;
  model.range = interval;
  // The middle and the radius are rounded, denormal ones to half of the smallest number.
  model.error = 2e-16 * interval.magnitude();
  if (!interval.is_point()) model.error += std::numeric_limits<double>::denorm_min();
  return model;
}

double TaylorBound::linear_extent() const {
  double extent = 0;
  for (int axis = 0; axis < maximum_variables; ++axis)
    extent += std::fabs(slope[axis]) * frame_radius[axis];
  return extent;
}

TaylorBound narrowed(TaylorBound a, const Interval& range) {
  a.range = intersection(a.range, range);
  return a.range.contains(a.value) ? a : from_range(a.range, a.smooth);
}

TaylorBound operator+(const TaylorBound& a, const TaylorBound& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  TaylorBound sum;
  sum.value = a.value + b.value;
  for (int axis = 0; axis < maximum_variables; ++axis)
    sum.slope[axis] = a.slope[axis] + b.slope[axis];
  sum.error = a.error + b.error;
  sum.range = a.range + b.range;
  sum.smooth = a.smooth && b.smooth;
  close(sum);
  return sum;
}

TaylorBound operator-(const TaylorBound& a) {
  TaylorBound negative = a;
  negative.value = -a.value;
  for (int axis = 0; axis < maximum_variables; ++axis) negative.slope[axis] = -a.slope[axis];
  negative.range = -a.range;
  return negative;
}

TaylorBound operator-(const TaylorBound& a, const TaylorBound& b) { return a + (-b); }

TaylorBound operator*(const TaylorBound& a, const TaylorBound& b) {
  if (a.is_zero() || b.is_zero()) return {};
  TaylorBound product;
  product.value = a.value * b.value;
  for (int axis = 0; axis < maximum_variables; ++axis)
    product.slope[axis] = a.value * b.slope[axis] + b.value * a.slope[axis];
  const double a_extent = a.linear_extent(), b_extent = b.linear_extent();
  product.error = (a_extent + a.error) * (b_extent + b.error) + std::fabs(a.value) * b.error +
                  std::fabs(b.value) * a.error;
  product.range = a.range * b.range;
  product.smooth = a.smooth && b.smooth;
  close(product);
  return product;
}

TaylorBound operator/(const TaylorBound& a, const TaylorBound& b) {
  const Interval inverse = Interval(1) / b.range;
  const bool regular = b.range.excludes_zero();
  const double f = 1 / b.value;
  const TaylorBound reciprocal =
      regular ? composed(b, f, -f * f, Interval(2) * inverse * square(inverse), inverse, b.smooth)
              : from_range(inverse, false);
  return a * reciprocal;
}

TaylorBound& operator+=(TaylorBound& a, const TaylorBound& b) { return a = a + b; }

TaylorBound square(const TaylorBound& a) {
  return composed(a, a.value * a.value, 2 * a.value, 2, square(a.range), a.smooth);
}

TaylorBound power(const TaylorBound& a, double e) {
  // Whole exponents know negative arguments. Those so large that e − 2 is rounded do not count.
  const bool whole = e == std::floor(e) && std::fabs(e) < 0x1p52;
  if (whole && (e >= 2 || a.range.excludes_zero()))
    return composed(a, std::pow(a.value, e), e * std::pow(a.value, e - 1),
                    Interval(e) * (Interval(e) - Interval(1)) * power(a.range, e - 2),
                    power(a.range, e), a.smooth);
  const bool regular = a.range.low > 0;
  const double f = std::pow(std::max(a.value, 0.0), e);
  const Interval range = power(a.range, e);
  // By division: exponents e − 1 and e − 2 would be rounded.
  const Interval second = regular
                              ? Interval(e) * (Interval(e) - Interval(1)) * range / square(a.range)
                              : Interval::entire();
  return composed(a, f, e * f / a.value, second, range, a.smooth && regular);
}

TaylorBound power_known_to(const TaylorBound& a, double exponent, double lost, double relative) {
  const double error = error_of_power(a.range, relative, lost);
  return power(a, exponent) * TaylorBound::of_range({1 - error, 1 + error}, true);
}

TaylorBound sqrt(const TaylorBound& a) {
  // Relatively close to zero counts as touching it: rounding must not hide a kink.
  const bool regular = a.range.low > 1e-14 * a.range.high;
  const double f = std::sqrt(std::max(a.value, 0.0));
  const Interval second =
      regular ? Interval(-0.25) / (a.range * sqrt(a.range)) : Interval::entire();
  return composed(a, f, 0.5 / f, second, sqrt(a.range), a.smooth && regular);
}

TaylorBound cbrt(const TaylorBound& a) {
  const bool regular = a.range.excludes_zero();
  const double f = std::cbrt(a.value);
  const Interval root = cbrt(a.range);
  const Interval second =
      regular ? Interval(-2.0 / 9) * root / square(a.range) : Interval::entire();
  return composed(a, f, f / (3 * a.value), second, root, a.smooth && regular);
}

TaylorBound exp(const TaylorBound& a) {
  const double f = std::exp(a.value);
  const Interval range = exp(a.range);
  return composed(a, f, f, range, range, a.smooth);
}

TaylorBound log(const TaylorBound& a) {
  const bool regular = a.range.low > 0;
  const Interval second = regular ? Interval(-1) / square(a.range) : Interval::entire();
  return composed(a, std::log(std::max(a.value, 0.0)), 1 / a.value, second, log(a.range),
                  a.smooth && regular);
}

TaylorBound sin(const TaylorBound& a) {
  const Interval range = sin(a.range);
  return composed(a, std::sin(a.value), std::cos(a.value), -range, range, a.smooth);
}

TaylorBound cos(const TaylorBound& a) {
  const Interval range = cos(a.range);
  return composed(a, std::cos(a.value), -std::sin(a.value), -range, range, a.smooth);
}

TaylorBound tan(const TaylorBound& a) {
  const Interval range = tan(a.range);
  const bool regular = range.magnitude() < huge;
  const double f = std::tan(a.value);
  return composed(a, f, 1 + f * f, Interval(2) * range * (Interval(1) + square(range)), range,
                  a.smooth && regular);
}

TaylorBound asin(const TaylorBound& a) {
  const bool regular = a.range.low > -1 && a.range.high < 1;
  const Interval rest = Interval(1) - square(a.range);
  const Interval second = regular ? a.range / (rest * sqrt(rest)) : Interval::entire();
  return composed(a, std::asin(std::clamp(a.value, -1.0, 1.0)),
                  1 / std::sqrt((1 - a.value) * (1 + a.value)), second, asin(a.range),
                  a.smooth && regular);
}

TaylorBound acos(const TaylorBound& a) {
  TaylorBound angle = TaylorBound(std::numbers::pi / 2) - asin(a);
  angle.error += 1e-16;  // π is rounded
  angle.range = acos(a.range);
  close(angle);
  return angle;
}

TaylorBound atan(const TaylorBound& a) {
  const Interval rest = Interval(1) + square(a.range);
  return composed(a, std::atan(a.value), 1 / (1 + a.value * a.value),
                  Interval(-2) * a.range / square(rest), atan(a.range), a.smooth);
}

TaylorBound atan2(const TaylorBound& y, const TaylorBound& x) {
  const Interval range = atan2(y.range, x.range);
  const bool regular = !(x.range.low <= 0 && y.range.contains(0));
  const bool smooth = y.smooth && x.smooth && regular;
  if (!regular) return from_range(range, smooth);
  // The smaller quotient of the two is of second order, up to a multiple of π/2.
  constexpr double pi = std::numbers::pi;
  const bool steep = farther_from_zero(y.range, x.range) == Truth::yes;
  const double turn = steep             ? (y.range.low > 0 ? pi / 2 : -pi / 2)
                      : x.range.low > 0 ? 0
                      : y.range.low > 0 ? pi
                                        : -pi;
  TaylorBound angle = TaylorBound(turn) + (steep ? -atan(x / y) : atan(y / x));
  angle.error += 1e-15;  // π is rounded
  angle.range = range;
  angle.smooth = smooth;
  close(angle);
  return angle;
}

TaylorBound sinh(const TaylorBound& a) {
  const Interval range = sinh(a.range);
  return composed(a, std::sinh(a.value), std::cosh(a.value), range, range, a.smooth);
}

TaylorBound cosh(const TaylorBound& a) {
  const Interval range = cosh(a.range);
  return composed(a, std::cosh(a.value), std::sinh(a.value), range, range, a.smooth);
}

TaylorBound tanh(const TaylorBound& a) {
  const Interval range = tanh(a.range);
  const double f = std::tanh(a.value);
  return composed(a, f, 1 - f * f, Interval(-2) * range * (Interval(1) - square(range)), range,
                  a.smooth);
}

TaylorBound asinh(const TaylorBound& a) {
  const Interval rest = Interval(1) + square(a.range);
  return composed(a, std::asinh(a.value), 1 / std::sqrt(1 + a.value * a.value),
                  -a.range / (rest * sqrt(rest)), asinh(a.range), a.smooth);
}

TaylorBound erf(const TaylorBound& a) {
  const double scale = 2 * std::numbers::inv_sqrtpi;
  const Interval second = Interval(-2 * scale) * a.range * exp(-square(a.range));
  return composed(a, std::erf(a.value), scale * std::exp(-a.value * a.value), second, erf(a.range),
                  a.smooth);
}

TaylorBound floor(const TaylorBound& a) {
  const Interval range = floor(a.range);
  return from_range(range, a.smooth && range.is_point());
}

TaylorBound select(Truth condition, const TaylorBound& yes, const TaylorBound& no) {
  if (condition == Truth::yes) return yes;
  if (condition == Truth::no) return no;
  return from_range(hull(yes.range, no.range), false);
}

}  // namespace rfm
