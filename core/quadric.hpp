#pragma once

#include <array>
#include <cmath>
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
  // Multiply-adds are written out, so that the value at a point is the same to the last bit
  // wherever this is inlined: boxes on both sides of a face must see the same sign.
  double value(const Point& point) const {
    const double x = point[0] - origin[0], y = point[1] - origin[1], z = point[2] - origin[2];
    const double p =
        std::fma(2, std::fma(square[1], y, square[2] * z), std::fma(square[0], x, linear[0]));
    const double q = std::fma(2 * square[4], z, std::fma(square[3], y, linear[1]));
    const double r = std::fma(square[5], z, linear[2]);
    return std::fma(x, p, std::fma(y, q, std::fma(z, r, constant)));
  }
  double slope(const Point& point, int axis) const {
    const double x = point[0] - origin[0], y = point[1] - origin[1], z = point[2] - origin[2];
    const double sum =
        std::fma(square[square_index(axis, 0)], x,
                 std::fma(square[square_index(axis, 1)], y, square[square_index(axis, 2)] * z));
    return std::fma(2, sum, linear[axis]);
  }
  Point gradient(const Point& x) const { return {slope(x, 0), slope(x, 1), slope(x, 2)}; }
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
