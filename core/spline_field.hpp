#pragma once

#include <memory>
#include <vector>

#include "core/field_source.hpp"
#include "core/grid.hpp"

namespace rfm {

/// A tensor-product spline on a grid as a field: f(x) = Σ_j c_j B_{j₁}(x) B_{j₂}(y) B_{j₃}(z), with
/// the B-splines of core/grid_splines.hpp. Along axis a there are cells(a) + degree splines;
/// coefficients are numbered with x running fastest.
///
/// The field is degree − 1 times continuously differentiable; jets of any order are those of the
/// polynomial piece of the cell that holds the point (a point on a grid line belongs to the cell
/// above it). Points farther than 10⁻⁹ of a side outside the grid give NaN.
class SplineField final : public FieldSource {
 public:
  /// Throws `InvalidArgument` on a degree outside 0 … 8, coefficients too many, few or infinite.
  SplineField(const Grid& grid, int degree, std::vector<double> coefficients);

  /// Number of coefficients that a grid and a degree ask for.
  static int coefficient_count(const Grid& grid, int degree);

  const Grid& grid() const { return grid_; }
  int degree() const { return degree_; }
  const std::vector<double>& coefficients() const { return coefficients_; }

  /// Jets in `variables` ≥ 1 variables of any order that jets have; derivatives above the degree
  /// along an axis are zero, and derivatives along axes beyond the grid's
  /// dimension are zero. Coordinates are needed for the grid's own axes only.
  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  /// The hull of Bernstein coefficients on the box, cell by cell: at most O(size²) wider than the
  /// range, and rigorous (rounding included). A box that reaches outside the grid is unbounded.
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override;

 private:
  template <int degree>
  void evaluate_degree(const std::array<const double*, 3>& coordinates, int count, int variables,
                       int order, double* jets, int stride) const;
  FunctionBounds cell_bounds(const std::array<int, 3>& cell, const Box& box) const;

  Grid grid_;
  int degree_;
  std::array<int, 3> splines_{1, 1, 1};  // along each axis
  std::array<double, 3> tolerance_{};
  std::vector<double> coefficients_;
};

}  // namespace rfm
