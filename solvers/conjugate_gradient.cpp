#include "solvers/conjugate_gradient.hpp"

#include <cmath>

namespace rfm {

ConjugateGradientResult conjugate_gradient(const SparseMatrix& lower,
                                           const Eigen::VectorXd& right_hand_side, double tolerance,
                                           int largest_iteration_count) {
  using Outcome = ConjugateGradientResult::Outcome;
  ConjugateGradientResult result;
  result.solution = Eigen::VectorXd::Zero(right_hand_side.size());
  const double size = right_hand_side.squaredNorm();
  if (size == 0) {
    result.outcome = Outcome::converged;
    result.relative_residual = 0;
    return result;
  }
  Eigen::VectorXd residual = right_hand_side, direction = residual, product(residual.size());
  double square = size;
  while (result.iterations < largest_iteration_count) {
    product = lower.selfadjointView<Eigen::Lower>() * direction;
    const double curvature = direction.dot(product);
    if (!(curvature > 0)) {
      result.outcome = Outcome::indefinite;
      return result;
    }
    const double step = square / curvature;
    result.solution += step * direction;
    residual -= step * product;
    ++result.iterations;
    const double next = residual.squaredNorm();
    result.relative_residual = std::sqrt(next / size);
    if (result.relative_residual <= tolerance) {
      result.outcome = Outcome::converged;
      return result;
    }
    direction = residual + (next / square) * direction;
    square = next;
  }
  return result;
}

}  // namespace rfm
