#include "solvers/stationary_point.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

std::vector<Field> roots_of(const Field& f, const std::vector<Field>& constraints) {
  std::vector<Field> roots{f};
  roots.insert(roots.end(), constraints.begin(), constraints.end());
  return roots;
}

// Value, gradient and Hessian of one root at the point last evaluated.
struct Expansion {
  Expansion(const Tape::Workspace& workspace, int root, int dimension)
      : value(workspace.coefficient(root)[0]), gradient(dimension), hessian(dimension, dimension) {
    for (int i = 0; i < dimension; ++i) {
      gradient[i] = workspace.coefficient(root, 1 + i)[0];
      for (int j = 0; j < dimension; ++j) {
        const MultiIndex alpha = unit_index(i) + unit_index(j);
        hessian(i, j) =
            workspace.coefficient(root, jet_index(dimension, alpha))[0] * factorial(alpha);
      }
    }
  }
  double value;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

}  // namespace

StationaryPoints::StationaryPoints(const Field& f, const std::vector<Field>& constraints,
                                   int dimension)
    : dimension_(dimension),
      tape_(roots_of(f, constraints), std::vector<int>(1 + constraints.size(), 2), dimension),
      workspace_(tape_) {}

void StationaryPoints::evaluate(const Point& point) {
  PointBlock block;
  for (int axis = 0; axis < dimension_; ++axis) block.coordinates[axis] = &point[axis];
  block.count = 1;
  tape_.evaluate(block, workspace_);
}

void StationaryPoints::project(std::span<const int> active, Point& point) {
  const int n = dimension_, m = static_cast<int>(active.size());
  for (int step = 0; step < 4; ++step) {
    evaluate(point);
    Eigen::MatrixXd jacobian(m, n);
    Eigen::VectorXd residual(m);
    for (int k = 0; k < m; ++k) {
      const Expansion constraint(workspace_, 1 + active[k], n);
      jacobian.row(k) = constraint.gradient;
      residual[k] = -constraint.value;
    }
    if (!jacobian.allFinite() || !residual.allFinite()) return;
    const Eigen::VectorXd shortest = jacobian.completeOrthogonalDecomposition().solve(residual);
    for (int axis = 0; axis < n; ++axis) point[axis] += shortest[axis];
  }
}

std::optional<Point> StationaryPoints::find(std::span<const int> active, const Point& start,
                                            double reach) {
  constexpr int most_steps = 40;
  const int n = dimension_, m = static_cast<int>(active.size());
  Point point = start;
  double previous = reach;
  Eigen::VectorXd multipliers(m);
  for (int step = 0; step < most_steps; ++step) {
    evaluate(point);
    const Expansion f(workspace_, 0, n);
    Eigen::MatrixXd jacobian(m, n), system = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::VectorXd residual(n + m);
    std::vector<Expansion> constraints;
    for (int k = 0; k < m; ++k) {
      constraints.emplace_back(workspace_, 1 + active[k], n);
      // Scaled to unit slope, so that zero sets count and not the functions that describe them.
      const double slope = constraints[k].gradient.norm();
      if (!(slope > 0)) return std::nullopt;
      jacobian.row(k) = constraints[k].gradient / slope;
      constraints[k].hessian /= slope;
      residual[n + k] = -constraints[k].value / slope;
    }
    if (step == 0 && m > 0)
      multipliers = jacobian.transpose().completeOrthogonalDecomposition().solve(f.gradient);
    system.topLeftCorner(n, n) = f.hessian;
    for (int k = 0; k < m; ++k)
      system.topLeftCorner(n, n) -= multipliers[k] * constraints[k].hessian;
    system.topRightCorner(n, m) = -jacobian.transpose();
    system.bottomLeftCorner(m, n) = jacobian;
    residual.head(n) = jacobian.transpose() * multipliers - f.gradient;
    if (!system.allFinite() || !residual.allFinite()) return std::nullopt;
    const Eigen::VectorXd newton = system.completeOrthogonalDecomposition().solve(residual);
    multipliers += newton.tail(m);
    // Long steps are cut to half the reach: from a sample next to an extreme they overshoot.
    const double length = newton.head(n).norm();
    const double part = std::min(1.0, 0.5 * reach / std::max(length, 1e-300));
    for (int axis = 0; axis < n; ++axis) point[axis] += part * newton[axis];
    if (m > 0) project(active, point);
    double distance = 0;
    for (int axis = 0; axis < n; ++axis) distance = std::hypot(distance, point[axis] - start[axis]);
    if (!(distance <= reach)) return std::nullopt;
    // Converged to rounding, or to the noise of derivatives, where steps no longer shrink.
    if (length <= 1e-13 * reach || (length <= 1e-6 * reach && length > 0.5 * previous))
      return point;
    previous = length;
  }
  return std::nullopt;
}

}  // namespace rfm
