#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"

namespace rfm {

/// Weighted extended B-splines (K. Höllig, U. Reif, J. Wipper, SIAM J. Numer. Anal. 39, 2001): a
/// spline none of whose cells lies wholly inside the region (an outer one) is no function of its
/// own, but attached to inner ones,
///
///     B_i = b_i + Σ_j e_{i,j} b_j,      e_{i,j} = Π_ν Π_{μ ≠ i_ν} (j_ν − μ) / (i_ν − μ),
///
/// with i in the array of (p + 1)^d inner splines nearest to j, and μ over the array's places along
/// axis ν, where cells are equal; else with the factors by which the coefficient of j follows from
/// those of i in a polynomial, its blossom at the knots of j (core/grid_splines.hpp). Coefficients
/// of polynomials of degree p are continued, so that the order p + 1 stays, while the condition of
/// systems does not depend on how thinly the boundary cuts cells. The weight of the method is that
/// of the structure; what its authors divide it by is a scaling of the diagonal, which solvers do
/// anyhow.
class WebExtension {
 public:
  struct Entry {
    int function = 0;  ///< of the space
    int inner = 0;     ///< number among the inner functions
    double weight = 0;
  };

  /// `inside[c]` ≠ 0 marks the cells of the grid that lie inside the region. Throws
  /// `InvalidArgument` when there are not as many as cells, or when no (p + 1)^d inner splines are
  /// neighbours anywhere.
  WebExtension(const TensorProductSpace& space, std::span<const std::uint8_t> inside);

  /// The same with inner functions of one's own choice: `inner[f]` tells of function f.
  static WebExtension of_inner(const TensorProductSpace& space, const std::vector<bool>& inner);

  /// Number of inner functions.
  int size() const { return static_cast<int>(inner_.size()); }
  /// The functions of the space that are inner ones, ascending.
  const std::vector<int>& inner() const { return inner_; }
  /// b_function = … + weight B_inner: the coefficients of the space from those of the extended one.
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  WebExtension() = default;
  void extend(const TensorProductSpace& space, const std::vector<bool>& is_inner);

  std::vector<int> inner_;
  std::vector<Entry> entries_;
};

}  // namespace rfm
