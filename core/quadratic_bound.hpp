#pragma once

#include <array>

#include "core/interval.hpp"

namespace rfm {

/// A function of up to six variables by its Taylor expansion about a point:
///
///     value + gradient · s + ½ sᵀ H s,    sᵢ in rangeᵢ,  H = Hᵀ somewhere in `hessian`,
///
/// which holds with an enclosure of the second derivatives over all of the box (Lagrange's form of
/// the remainder).
struct QuadraticModel {
  static constexpr int maximum_size = 6;
  template <class T>
  using Vector = std::array<T, maximum_size>;
  template <class T>
  using Matrix = std::array<Vector<T>, maximum_size>;

  int size = 0;
  Interval value;
  Vector<Interval> gradient{};
  Matrix<Interval> hessian{};
  Vector<Interval> range{};
};

/// A rigorous lower bound of such a function. Where all of the matrices H are positive definite it
/// is the minimum over the box of the quadratic function with the least of them; in particular it
/// is `value`, up to rounding, about a stationary point. Elsewhere it is less by a
/// multiple of the most negative curvature times the square of the extents: by O(h³) where the
/// matrices are O(h) wide and one direction is weak.
double lower_bound(const QuadraticModel& model);

/// A lower triangular L with LLᵀ = A + shift·1 up to rounding, A's lower triangle given. The shift
/// is 0 where A is positive definite, else at most about twice the least that makes it so.
struct ShiftedCholesky {
  QuadraticModel::Matrix<double> factor{};
  double shift = 0;

  ShiftedCholesky(const QuadraticModel::Matrix<double>& matrix, int size);
  /// L⁻¹ b.
  QuadraticModel::Vector<double> forward(QuadraticModel::Vector<double> b) const;
  /// (LLᵀ)⁻¹ b.
  QuadraticModel::Vector<double> solve(const QuadraticModel::Vector<double>& b) const;

 private:
  bool factorise(const QuadraticModel::Matrix<double>& matrix);
  int size_;
};

}  // namespace rfm
