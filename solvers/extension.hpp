#pragma once

#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "quadrature/domain_rule.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

/// Extended splines (basis/web_extension.hpp) of several spaces on the grid of a rule.
struct SplineExtension {
  /// E: coefficients of all splines are E times those of the inner ones.
  SparseMatrix matrix;
  /// The inner ones among all functions.
  std::vector<Eigen::Index> inner;

  SplineExtension(std::span<const TensorProductSpace> spaces, const DomainRule& rule);
  /// Eᵀ K E y = Eᵀ f: the same equations for the extended splines.
  LinearSystem extended(const LinearSystem& system) const;
  /// y of coefficients c = E y: those of the inner ones. By columns.
  Eigen::MatrixXd reduced(const Eigen::MatrixXd& coefficients) const;
};

}  // namespace rfm
