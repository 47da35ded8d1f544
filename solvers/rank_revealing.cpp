#include "solvers/rank_revealing.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace rfm {

RankRevealing::RankRevealing(const SparseMatrix& lower) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(lower)};
  if (solver.info() != Eigen::Success)
    throw ComputationError("the eigenvalues of the system of equations were not found");
  values_ = solver.eigenvalues();
  vectors_ = solver.eigenvectors();
  const double least = static_cast<double>(values_.size()) *
                       std::numeric_limits<double>::epsilon() * values_.cwiseAbs().maxCoeff();
  smallest_kept_ = values_.cwiseAbs().maxCoeff();
  for (double& value : values_) {
    if (std::abs(value) <= least) {
      value = std::numeric_limits<double>::infinity();
      ++dependent_;
    } else {
      smallest_kept_ = std::min(smallest_kept_, std::abs(value));
    }
  }
  if (dependent_ == values_.size())
    throw ComputationError("the system of equations is singular: all of it vanishes");
}

Eigen::VectorXd RankRevealing::solve(const Eigen::VectorXd& load) const {
  return vectors_ * (vectors_.transpose() * load).cwiseQuotient(values_);
}

}  // namespace rfm
