#pragma once

#include <array>
#include <span>
#include <vector>

namespace rfm {

/// Uniform B-splines on one cell, in its reference coordinate s ∈ [0, 1]: of degree p there are
/// p + 1 of them, numbered from the one that leaves at s = 1 to the one that enters at s = 0. In
/// cell c of a grid line, local function i is spline number c + i of that line; spline number j is
/// supported on the cells j − p … j.
///
/// Values come from the recurrence of Cox and de Boor,
///
///     B^q_i(s) = (s + q − i)/q · B^{q−1}_{i−1}(s) + (i + 1 − s)/q · B^{q−1}_i(s),
///
/// whose terms are all positive, so that even the tails of a spline, s^p/p! near the end of its
/// support, are accurate relative to their own size (the power form is not, and ruins the splines
/// that touch a domain by a sliver). Derivatives are differences of splines of lower degree,
///
///     d/ds B^q_i = B^{q−1}_{i−1} − B^{q−1}_i .
///
/// Source: C. de Boor, A Practical Guide to Splines (2001), chapters IX and X.
inline constexpr int maximum_spline_degree = 8;

/// Values and derivatives up to `order` of the degree + 1 splines at `s`:
/// `values[k · (degree + 1) + i]` = d^k B_i / ds^k. The degree is fixed at compilation; derivatives
/// of order above the degree are zero.
template <int degree>
inline void evaluate_bsplines(double s, int order, double* values) {
  constexpr int count = degree + 1;
  double spline[count] = {1.0};
  for (int q = 0; q <= degree; ++q) {
    if (q > 0) {
      const double scale = 1.0 / q;
      spline[q] = s * scale * spline[q - 1];
      for (int i = q - 1; i >= 1; --i)
        spline[i] = ((s + (q - i)) * spline[i - 1] + ((1 - s) + i) * spline[i]) * scale;
      spline[0] *= (1 - s) * scale;
    }
    const int k = degree - q;
    if (k > order) continue;
    double* derivative = values + k * count;
    for (int i = 0; i <= q; ++i) derivative[i] = spline[i];
    for (int r = q + 1; r <= degree; ++r) {
      derivative[r] = derivative[r - 1];
      for (int i = r - 1; i >= 1; --i) derivative[i] = derivative[i - 1] - derivative[i];
      derivative[0] = -derivative[0];
    }
  }
  for (int k = count; k <= order; ++k)
    for (int i = 0; i < count; ++i) values[k * count + i] = 0;
}

/// The same for a degree known at run time. Throws `InvalidArgument` unless 0 ≤ degree ≤ 8 and
/// order ≥ 0.
void evaluate_bsplines(int degree, int order, double s, double* values);

/// Values and derivatives of the splines of a cell at several abscissae of [0, 1]: the same numbers
/// for every cell of a uniform grid.
class BSplineTable {
 public:
  /// Throws `InvalidArgument` unless 0 ≤ degree ≤ 8 and order ≥ 0.
  BSplineTable(int degree, int order, std::span<const double> abscissae);

  int degree() const { return degree_; }
  int order() const { return order_; }
  int abscissa_count() const { return abscissa_count_; }
  /// d^derivative B_i / ds^derivative at an abscissa, for i = 0 … degree.
  std::span<const double> values(int abscissa, int derivative) const {
    const int count = degree_ + 1;
    return {values_.data() + (abscissa * (order_ + 1) + derivative) * count, std::size_t(count)};
  }

 private:
  int degree_, order_, abscissa_count_;
  std::vector<double> values_;
};

/// Bernstein coefficients from B-spline coefficients: with T the result, f(s) = Σ_i c_i B_i(s)
/// restricted to [low, high] ⊂ [0, 1] has the Bernstein coefficients b_k = Σ_i T[k][i] c_i. Every
/// entry is ≥ 0 and rows sum to one (T is the blossom of f at low, …, low, high, …, high), so that
/// the b_k bound f over [low, high] and cannot exceed the bounds that the c_i give.
using BlossomMatrix =
    std::array<std::array<double, maximum_spline_degree + 1>, maximum_spline_degree + 1>;
BlossomMatrix bernstein_from_bsplines(int degree, double low, double high);

}  // namespace rfm
