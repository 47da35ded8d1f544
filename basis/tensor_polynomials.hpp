#pragma once

#include <vector>

#include "basis/global_space.hpp"

namespace rfm {

/// Products f_i(ξ) f_j(η) f_k(ζ) of functions of one variable, with ξ, η, ζ from −1 to 1 over a
/// box:
///
/// - Legendre's and Chebyshev's polynomials and the powers, all of which span the polynomials, but
///   powers are nearly dependent: from degree 16 on little is left of sixteen digits;
/// - 1, cos(π j ξ / 2), sin(π j ξ / 2): the period is twice the box, so that functions need not be
///   periodic on it (Fourier extension).
///
/// Solutions that are analytic beyond the domain converge exponentially in the degree, others with
/// an order that their smoothness gives.
struct PolynomialFamily {
  enum class Kind { legendre, chebyshev, power, trigonometric } kind = Kind::legendre;
  int degree = 8;  ///< of polynomials; the highest j of sines and cosines
  /// i + j + k ≤ degree, (degree + d choose d) polynomials; or each of them, (degree + 1)^d.
  bool total = true;
};

class TensorPolynomials final : public GlobalSpace {
 public:
  /// Throws `InvalidArgument` on a negative degree or a box without extent.
  TensorPolynomials(const Box& box, const PolynomialFamily& family);

  int dimension() const override { return box_.dimension; }
  int size() const override { return static_cast<int>(factors_.size()); }
  void evaluate(const std::array<const double*, 3>& coordinates, int count,
                const MultiIndex& derivative, double* values) const override;
  Box valid() const override { return box_; }
  /// By the polynomial's own powers about the centre of the box: of second order, exact where it is
  /// linear. Of sines and cosines nothing is told.
  FunctionBounds bounds(std::span<const double> coefficients, const Box& box) const override;

  /// The functions of one variable and their derivatives up to `order` at ξ:
  /// values[f + k * count], count = `line_size()`.
  void evaluate_line(double xi, int order, double* values) const;
  int line_size() const;

 private:
  Box box_;
  PolynomialFamily family_;
  std::vector<std::array<int, 3>> factors_;  // of each function, by axis
};

}  // namespace rfm
