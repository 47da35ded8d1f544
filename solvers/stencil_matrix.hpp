#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

/// A matrix of splines under assembly. Two splines of a uniform grid interact only when
/// their places differ by at most a degree, so every column is a small dense box of numbers, found
/// without search:
///
///     column j (degree q):   rows at places j − q … j + p along each axis (degree p)
///
/// Of a symmetric matrix only blocks below the diagonal are kept, and of the diagonal blocks the
/// lines of the box from the centre on. Local matrices are added run by run along x; `compress`
/// turns the boxes into the usual sparse columns.
class StencilMatrix {
 public:
  /// The spaces of the undetermined functions, all on one grid; `coupled[k · n + l]` tells whether
  /// functions k and l interact at all (of a symmetric matrix, k ≥ l). Throws `InvalidArgument`
  /// when the grids differ.
  StencilMatrix(std::span<const TensorProductSpace> spaces, const std::vector<bool>& coupled,
                bool symmetric = true);

  /// Adds the interaction on one cell of the functions of `row_unknown` with those of
  /// `column_unknown` (of a symmetric matrix, ≤ `row_unknown`): entries local[b + a · stride] for
  /// local functions b (rows) and a (columns), numbered with x fastest. For a function with itself
  /// only b ≥ a counts if the matrix is symmetric, and splines that a space leaves out do not. Two
  /// threads may add at once if their cells share no spline.
  void add(int cell, int row_unknown, int column_unknown, const double* local, int stride);

  /// The lower triangle of a symmetric matrix, else all of it.
  SparseMatrix compress() const;

  /// First unknown coefficient of each undetermined function, and their total number.
  const std::vector<int>& offsets() const { return offsets_; }

 private:
  struct Block {
    int row_unknown = 0, column_unknown = 0;
    std::array<int, 3> width{1, 1, 1};
    int first_line = 0;  // lines of the box before this one lie above the diagonal
    std::size_t column_size = 0;
    std::vector<double> values;
  };
  // Calls visit(row, value) for every stored entry of a column, rows ascending.
  template <class Visit>
  void visit_column(int unknown, int function, Visit&& visit) const;

  std::span<const TensorProductSpace> spaces_;
  bool symmetric_;
  std::vector<int> offsets_;
  std::vector<Block> blocks_;
  std::vector<int> block_number_;  // of (row unknown, column unknown), −1 if not coupled
};

}  // namespace rfm
