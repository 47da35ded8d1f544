#pragma once

#include <vector>

#include "core/field.hpp"
#include "core/field_source.hpp"

namespace rfm {

/// A function of one variable through given points: the C² cubic spline with "not-a-knot" ends (the
/// third derivative does not jump at the second and at the last but one point). It reproduces cubic
/// polynomials and is of order h⁴ up to both ends; the "natural" spline, whose second derivative
/// vanishes at the ends, is only of order h² there. Of two points it is the line, of three the
/// parabola. Outside the points it is not a number: a table does not extrapolate.
///
/// As a source it is a function of the coordinate `axis` alone. Source: C. de Boor, A Practical
/// Guide to Splines (2001), chapter IV.
class Table final : public FieldSource {
 public:
  /// Throws `InvalidArgument` unless there are at least two points, as many values as abscissae,
  /// all finite, and the abscissae ascend.
  Table(std::vector<double> abscissae, const std::vector<double>& values, int axis = 0);

  /// f^(k)(x) / k!, k = 0 … 3, or NaN outside.
  std::array<double, 4> taylor(double x) const;

  /// Jets of any order; points farther than 10⁻⁹ of the range outside of it give NaN.
  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  /// The range of the cubic pieces, up to rounding. A box that reaches outside is unbounded.
  FunctionBounds bounds(const Box& box) const override;
  /// Inner points; the third derivative jumps there.
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override;

 private:
  /// value + (x − start)(slope + (x − start)(bend + (x − start) twist)).
  struct Piece {
    double value, slope, bend, twist;
  };
  int locate(double x) const;

  int axis_;
  double tolerance_;
  std::vector<double> abscissae_;
  std::vector<Piece> pieces_;
};

/// The table as a function of `argument`. Throws `InvalidArgument` as its constructor does.
Field table(const std::vector<double>& abscissae, const std::vector<double>& values,
            const Field& argument);

}  // namespace rfm
