#include "core/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/field_node.hpp"
#include "core/multi_index.hpp"

namespace rfm {
namespace {

constexpr double outside_tolerance = 1e-9;  // of the range, as for splines on a grid

/// Slopes at the points, from continuity of the second derivative inside and of the third at the
/// second and at the last but one point: a tridiagonal system.
std::vector<double> not_a_knot_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> h(n - 1), secant(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = x[i + 1] - x[i];
    secant[i] = (y[i + 1] - y[i]) / h[i];
  }
  if (n == 2) return {secant[0], secant[0]};
  if (n == 3) {
    const double bend = (secant[1] - secant[0]) / (h[0] + h[1]);
    return {secant[0] - h[0] * bend, secant[0] + h[0] * bend, secant[1] + h[1] * bend};
  }
  std::vector<double> lower(n), diagonal(n), upper(n), slopes(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    lower[i] = h[i];
    diagonal[i] = 2 * (h[i - 1] + h[i]);
    upper[i] = h[i - 1];
    slopes[i] = 3 * (h[i] * secant[i - 1] + h[i - 1] * secant[i]);
  }
  const auto end = [](double h0, double h1, double s0, double s1) {
    return ((3 * h0 + 2 * h1) * h1 * s0 + h0 * h0 * s1) / (h0 + h1);
  };
  diagonal[0] = h[1];
  upper[0] = h[0] + h[1];
  slopes[0] = end(h[0], h[1], secant[0], secant[1]);
  diagonal[n - 1] = h[n - 3];
  lower[n - 1] = h[n - 3] + h[n - 2];
  slopes[n - 1] = end(h[n - 2], h[n - 3], secant[n - 2], secant[n - 3]);
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    slopes[i] -= factor * slopes[i - 1];
  }
  slopes[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;)
    slopes[i] = (slopes[i] - upper[i] * slopes[i + 1]) / diagonal[i];
  return slopes;
}

// Bounds of c0 + s (c1 + s (c2 + s c3)) for s in [low, high]: ends and stationary points. These are
// found with terms of order 1, so that no square overflows or is lost.
Interval cubic_range(double c0, double c1, double c2, double c3, double low, double high) {
  double least = INFINITY, most = -INFINITY;
  const auto visit = [&](double s) {
    const double value = c0 + s * (c1 + s * (c2 + s * c3));
    least = std::min(least, value);
    most = std::max(most, value);
  };
  visit(low);
  visit(high);
  const double size = std::max(std::fabs(low), std::fabs(high));
  const double a1 = size * c1, a2 = size * (size * c2), a3 = size * (size * (size * c3));
  const double largest = std::max({std::fabs(a1), std::fabs(a2), std::fabs(a3)});
  if (largest > 0) {
    const double b1 = a1 / largest, b2 = a2 / largest, b3 = a3 / largest;
    const double discriminant = b2 * b2 - 3 * b1 * b3;
    const double q = -(b2 + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b2));
    for (const double t : {q / (3 * b3), b1 / q})
      if (t * size > low && t * size < high) visit(t * size);
  }
  const double margin =
      1e-14 *
      (std::fabs(c0) + size * (std::fabs(c1) + size * (std::fabs(c2) + size * std::fabs(c3))));
  return {least - margin - 0x1p-1070, most + margin + 0x1p-1070};
}

}  // namespace

Table::Table(std::vector<double> abscissae, const std::vector<double>& values, int axis)
    : axis_(axis), tolerance_(0), abscissae_(std::move(abscissae)) {
  if (axis < 0 || axis > 2) throw InvalidArgument("a table is a function of x, y or z");
  if (abscissae_.size() != values.size())
    throw InvalidArgument("a table needs as many values as abscissae");
  if (abscissae_.size() < 2) throw InvalidArgument("a table needs at least two points");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(abscissae_[i]) || !std::isfinite(values[i]))
      throw InvalidArgument("point " + std::to_string(i + 1) + " of a table is not finite");
    if (i > 0 && !(abscissae_[i - 1] < abscissae_[i]))
      throw InvalidArgument("the abscissae of a table must ascend, but point " +
                            std::to_string(i + 1) + " does not lie above the one before it");
  }
  tolerance_ = outside_tolerance * (abscissae_.back() - abscissae_.front());
  const std::vector<double> slopes = not_a_knot_slopes(abscissae_, values);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double h = abscissae_[i + 1] - abscissae_[i];
    const double secant = (values[i + 1] - values[i]) / h;
    pieces_.push_back({values[i], slopes[i], (3 * secant - 2 * slopes[i] - slopes[i + 1]) / h,
                       (slopes[i] + slopes[i + 1] - 2 * secant) / (h * h)});
    const Piece& piece = pieces_.back();
    for (const double coefficient : {piece.slope, piece.bend, piece.twist})
      if (!std::isfinite(coefficient))
        throw InvalidArgument("a table has values so large, or abscissae so close, at point " +
                              std::to_string(i + 1) + " that its slopes overflow");
  }
}

int Table::locate(double x) const {
  const auto above = std::upper_bound(abscissae_.begin() + 1, abscissae_.end() - 1, x);
  return static_cast<int>(above - abscissae_.begin()) - 1;
}

std::array<double, 4> Table::taylor(double x) const {
  if (!(x >= abscissae_.front() - tolerance_ && x <= abscissae_.back() + tolerance_)) {
    std::array<double, 4> nothing;
    nothing.fill(std::numeric_limits<double>::quiet_NaN());
    return nothing;
  }
  const int i = locate(x);
  const auto& [value, slope, bend, twist] = pieces_[static_cast<std::size_t>(i)];
  const double s = x - abscissae_[static_cast<std::size_t>(i)];
  return {value + s * (slope + s * (bend + s * twist)), slope + s * (2 * bend + s * 3 * twist),
          bend + s * 3 * twist, twist};
}

void Table::evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                     int order, double* jets, int stride) const {
  const int size = jet_size(variables, order);
  for (int c = 0; c < size; ++c) std::fill_n(jets + std::ptrdiff_t(c) * stride, count, 0.0);
  for (int point = 0; point < count; ++point) {
    const std::array<double, 4> terms = taylor(coordinates[axis_][point]);
    if (std::isnan(terms[0]))
      for (int c = 0; c < size; ++c) jets[std::ptrdiff_t(c) * stride + point] = terms[0];
    for (int k = 0; k <= std::min(order, axis_ < variables ? 3 : 0); ++k) {
      MultiIndex index{};
      index[axis_] = static_cast<std::uint8_t>(k);
      jets[std::ptrdiff_t(jet_index(variables, index)) * stride + point] = terms[k];
    }
  }
}

FunctionBounds Table::bounds(const Box& box) const {
  FunctionBounds result;
  const double low = box.low[axis_], high = box.high[axis_];
  if (!(low >= abscissae_.front() - tolerance_ && high <= abscissae_.back() + tolerance_)) {
    result.value = result.gradient[axis_] = Interval::entire();
    result.smooth = false;
    return result;
  }
  for (int i = locate(low); i <= locate(high); ++i) {
    const auto& [value, slope, bend, twist] = pieces_[static_cast<std::size_t>(i)];
    const double start = abscissae_[static_cast<std::size_t>(i)];
    const double end = abscissae_[static_cast<std::size_t>(i) + 1];
    const bool is_last = i + 1 == static_cast<int>(pieces_.size());
    const double from = (i == 0 ? low : std::max(low, start)) - start;
    const double to = (is_last ? high : std::min(high, end)) - start;
    const Interval range = cubic_range(value, slope, bend, twist, from, to);
    const Interval slopes = cubic_range(slope, 2 * bend, 3 * twist, 0, from, to);
    const bool is_first = i == locate(low);
    result.value = is_first ? range : hull(result.value, range);
    result.gradient[axis_] = is_first ? slopes : hull(result.gradient[axis_], slopes);
  }
  return result;
}

std::vector<double> Table::breakpoints(int axis) const {
  if (axis != axis_ || abscissae_.size() < 5) return {};
  return {abscissae_.begin() + 2, abscissae_.end() - 2};
}

Box Table::valid() const {
  Box box;
  box.dimension = axis_ + 1;
  for (int axis = 0; axis < axis_; ++axis) box.low[axis] = -INFINITY, box.high[axis] = INFINITY;
  box.low[axis_] = abscissae_.front();
  box.high[axis_] = abscissae_.back();
  return box;
}

Field table(const std::vector<double>& abscissae, const std::vector<double>& values,
            const Field& argument) {
  const Field::Node& node = argument.node();
  const bool is_axis = node.operation == Operation::coordinate && node.index < 3;
  if (is_axis) return field(std::make_shared<Table>(abscissae, values, node.index));
  return field_at(std::make_shared<Table>(abscissae, values), {argument});
}

}  // namespace rfm
