#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid.hpp"

namespace rfm {

/// A space for one undetermined function Ψ: tensor-product B-splines on the background grid
/// (core/grid_splines.hpp), without those whose support misses the region.
///
/// Every space is an extraction C · B of the plain splines B of a grid: here C selects rows, one
/// per *function* of the space. Functions are numbered in the order of their splines (x fastest),
/// so that the functions of a run of neighbouring splines have consecutive numbers. Cell work is
/// always done on plain splines, whose tables are the same for every cell.
///
/// The space has approximation order degree + 1 and is degree − 1 times continuously
/// differentiable. Not covered here: local refinement, extension (WEB), periodicity; they are
/// other choices of C on the same splines.
class TensorProductSpace {
 public:
  /// `cells[c]` ≠ 0 marks the cells of the grid that meet the region, or the part of it where
  /// functions are wanted (a band along the boundary, say); no flags mean all cells. Splines on a
  /// marked cell are kept, with their whole support.
  /// Throws `InvalidArgument` on a degree outside 1 … 8, a wrong number of flags, or when no cell
  /// is marked.
  TensorProductSpace(const Grid& grid, int degree, std::span<const std::uint8_t> cells = {});

  const Grid& grid() const { return grid_; }
  int dimension() const { return grid_.dimension(); }
  int degree() const { return degree_; }
  /// Number of functions, that is of unknown coefficients.
  int size() const { return static_cast<int>(spline_of_function_.size()); }

  /// Number of plain splines along an axis: cells + degree (1 beyond the dimension).
  int splines(int axis) const { return splines_[axis]; }
  int spline_count() const { return splines_[0] * splines_[1] * splines_[2]; }
  /// Number of a plain spline from its place along each axis.
  int spline(const std::array<int, 3>& place) const {
    return place[0] + splines_[0] * (place[1] + splines_[1] * place[2]);
  }
  /// The place along each axis of a plain spline.
  std::array<int, 3> place(int spline) const;
  /// The function that a plain spline is, or −1 if its support misses the region.
  int function_of_spline(int spline) const { return function_of_spline_[spline]; }
  int spline_of_function(int function) const { return spline_of_function_[function]; }

  /// (degree + 1)^dimension, the number of splines on a cell.
  int functions_per_cell() const;
  /// The functions on a cell, x fastest; `numbers` has room for functions_per_cell(). On a marked
  /// cell all exist; on others −1 stands for splines that were left out.
  void cell_functions(int cell, std::span<int> numbers) const;

  /// Coefficients of all plain splines, zero for those left out: Cᵀ c. Throws `InvalidArgument` if
  /// there are not size() coefficients.
  std::vector<double> expand(std::span<const double> coefficients) const;

 private:
  Grid grid_;
  int degree_;
  std::array<int, 3> splines_{1, 1, 1};
  std::vector<int> function_of_spline_;
  std::vector<int> spline_of_function_;
};

}  // namespace rfm
