#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "core/error.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

/// Loads do not balance on what the equations leave free, so that there is no steady solution.
class UnbalancedLoads : public ComputationError {
 public:
  /// `kernel`: as `Kernel::weights`; `missing`: as `Kernel::imbalance`.
  UnbalancedLoads(Eigen::MatrixXd kernel, double missing);

  const Eigen::MatrixXd& kernel() const { return kernel_; }
  double missing() const { return missing_; }

 private:
  Eigen::MatrixXd kernel_;
  double missing_;
};

/// What a system K c = f does not see: the part of a few candidate functions (constants, rigid
/// motions, the level of a pressure) on which K vanishes. It is found from the matrix, scaled, so
/// that nobody has to say what a problem leaves free, and combinations count, as a rotation about
/// another point does.
///
/// Quadrature may miss zero by more than rounding, as of ∫ div v, v = 0 on a curved boundary. What
/// nearly vanishes therefore counts, too, where a rule with more points leaves a tenth of it at
/// most: what holds a function softly stays.
///
/// Of the kernel's functions as many coefficients are held at zero: the system without it has the
/// same solutions up to the kernel, if the loads are compatible. A kernel whose functions are no
/// candidates is not seen, and the system stays singular. Functions that have no entry at all, as
/// the constant among polynomials, are in it.
class Kernel {
 public:
  /// `candidates` are columns of coefficients, independent of each other; `finer` makes the same
  /// system with a rule of more points, if it should be needed. Throws `InvalidArgument` if their
  /// length does not fit.
  Kernel(const LinearSystem& system, const Eigen::MatrixXd& candidates,
         const std::function<LinearSystem()>& finer = {});

  int size() const { return static_cast<int>(pinned_.size()); }
  /// Column k: the weights of the candidates in function k of the kernel.
  const Eigen::MatrixXd& weights() const { return weights_; }
  /// The system with one coefficient per function held at zero.
  LinearSystem pinned(LinearSystem system) const;
  /// How far the equations that were given up are from holding for a solution of the pinned system,
  /// relative to the sum of all loads: rounding if the loads are compatible with the kernel.
  double incompatibility(const LinearSystem& system, const Eigen::VectorXd& solution) const;
  /// The same of a residual that is left by a solution of any equations, where loads are known.
  double imbalance(const Eigen::VectorXd& residual, const Eigen::VectorXd& loads) const;
  /// What quadrature, which keeps the balance to its own error, may leave of it.
  static constexpr double largest_imbalance = 1e-6;

 private:
  void find(const SparseMatrix& matrix, Eigen::MatrixXd& basis, Eigen::MatrixXd& weights,
            const std::function<LinearSystem()>& finer);

  Eigen::MatrixXd weights_;
  std::vector<Eigen::Index> pinned_;
  Eigen::VectorXd rows_, columns_;  // the scaling
};

}  // namespace rfm
