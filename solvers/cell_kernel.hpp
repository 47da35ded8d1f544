#pragma once

#include <span>
#include <vector>

#include "solvers/basis_values.hpp"
#include "solvers/outer_products.hpp"

namespace rfm {

/// The matrices and loads of one cell for one integrand: with X the derivatives of basis functions
/// at all points of the cell,
///
///     K = Σ_points w (M X)ᵀ C (M X),       f = Σ_points w (M X)ᵀ (b − C g).
///
/// Blocks of slots and unknowns that vanish are known beforehand and skipped. One per thread.
class CellKernel {
 public:
  /// Interaction of two undetermined functions; of a symmetric matrix, row ≥ column.
  struct Pairing {
    int row_unknown = 0, column_unknown = 0;
    /// Places in `left` and `right` for each slot over which the product sums.
    std::vector<std::pair<int, int>> slots;
  };

  /// Only the lower triangle is computed if the whole matrix is `symmetric`, which one integrand
  /// cannot know.
  CellKernel(const CompiledIntegrand& integrand, std::span<const TensorProductSpace> spaces,
             bool symmetric);

  const std::vector<Pairing>& pairings() const { return pairings_; }
  /// Unknowns that have a load.
  const std::vector<int>& loaded() const { return loaded_; }

  /// Points first … of `values`, as many as `basis` holds.
  void compute(const IntegrandValues& values, int first, const BasisValues& basis);

  /// Matrix of pairing i: matrix(i)[b + a · stride(i)] for row function b and column function a.
  /// For an unknown with itself only b ≥ a is set if the matrix is symmetric.
  const double* matrix(int pairing) const { return matrices_[pairing].data(); }
  int stride(int pairing) const { return padded_[pairings_[pairing].row_unknown]; }
  /// Load of unknown loaded()[i].
  const double* load(int i) const { return loads_[i].data(); }

 private:
  // M X of one slot and one unknown: a sum over entries of M.
  struct Left {
    int slot = 0, unknown = 0;
    std::vector<int> entries;
    std::vector<double> data;
  };
  // C M X of one slot and one unknown: a sum over entries of C and the blocks they meet.
  struct Right {
    int slot = 0, unknown = 0;
    std::vector<std::pair<int, int>> terms;
    std::vector<double> data;
  };
  void add_loads();
  void compute_left(Left& left, const IntegrandValues& values, int first, const BasisValues& basis);
  void compute_right(Right& right, const IntegrandValues& values, int first, int points);
  void combine(std::vector<double>& result, int points, int length) const;

  const CompiledIntegrand& integrand_;
  bool symmetric_;
  std::vector<int> padded_;
  std::vector<Left> left_;
  std::vector<Right> right_;
  std::vector<Pairing> pairings_;
  std::vector<int> loaded_;
  std::vector<std::pair<int, int>> load_terms_;  // basis derivative, place in `loaded_`
  std::vector<std::vector<double>> matrices_, loads_;
  std::vector<VectorPair> pairs_;
  std::vector<WeightedVectors> terms_;
};

}  // namespace rfm
