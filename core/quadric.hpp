#pragma once

#include <array>
#include <optional>

#include "core/field.hpp"
#include "core/field_source.hpp"
#include "core/line.hpp"

namespace rfm {

/// A polynomial of degree ≤ 2: c + b·t + tᵀAt with t = x − origin and A symmetric. The origin is
/// its centre where it has one within reach, so that a small circle far from the coordinate origin
/// loses no digits.
struct Quadric {
  Point origin{};
  double constant = 0;
  std::array<double, 3> linear{};
  /// A: xx, xy, xz, yy, yz, zz.
  std::array<double, 6> square{};

  static constexpr int square_index(int i, int j) {
    constexpr int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return index[i][j];
  }

  bool is_affine() const;
  double value(const Point& x) const;
  double slope(const Point& x, int axis) const;
  Point gradient(const Point& x) const;
  /// Rigorous bounds of the value and gradient; the gradient, which is affine, is enclosed exactly
  /// up to rounding, the value by the better of the natural and the mean value form.
  FunctionBounds bounds(const Box& box) const;
  Interval value_bounds(const Box& box) const;
  /// Rigorous bounds of value and slope along the part `range` of a line.
  LineBounds bounds(const Line& line, const Interval& range) const;
  /// The polynomial along a line.
  LinePolynomial along(const Line& line) const;
};

/// The field as a quadric, if its expression is a polynomial of degree ≤ 2 in x, y, z: sums,
/// products, powers and divisions by constants are recognised.
std::optional<Quadric> as_quadric(const Field& field, int dimension);

}  // namespace rfm
