#pragma once

#include <array>
#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "solvers/integrand_values.hpp"

namespace rfm {

/// Derivatives of the functions of a cell at a set of points: what the undetermined functions
/// contribute to an integrand. Computed once for all cells inside, and anew for the points of each
/// cut cell.
class BasisValues {
 public:
  BasisValues(std::span<const TensorProductSpace> spaces,
              std::span<const CompiledIntegrand::BasisDerivative> derivatives);

  /// The points `first` … `last` − 1 in cell `cell`.
  void evaluate(int cell, const IntegrandPoints& points, int first, int last);
  /// The tensor product of `nodes` ∈ [0, 1] along each axis, x running fastest, in any cell of a
  /// grid of equal cells.
  void evaluate_reference(std::span<const double> nodes);

  int points() const { return points_; }
  /// ∂^β of the functions of unknown k at all points, for basis derivative m = (k, β):
  /// values(m)[i + q · padded], zero for the padding.
  const double* values(int basis_derivative) const { return values_[basis_derivative].data(); }
  /// Padded number of functions of an unknown on a cell.
  int padded_functions(int unknown) const { return padded_[unknown]; }

 private:
  void set_points(int points);
  void evaluate_point(int point, const std::array<int, 3>& cell,
                      const std::array<double, 3>& reference);

  std::span<const TensorProductSpace> spaces_;
  std::span<const CompiledIntegrand::BasisDerivative> derivatives_;
  std::vector<int> padded_;
  std::vector<double> scale_;  // h^−β
  std::vector<int> order_;     // highest derivative along an axis, per unknown
  std::vector<std::vector<double>> values_;
  int points_ = 0;
};

}  // namespace rfm
