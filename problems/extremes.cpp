#include "problems/extremes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/intersection.hpp"
#include "quadrature/integrate.hpp"

namespace rfm {
namespace {

// Values of a field at blocks of points, one after the other.
class PointScan {
 public:
  PointScan(const Field& f, const std::optional<Field>& allowed, int dimension)
      : tape_({f, allowed.value_or(1.0)}, {0}, dimension), workspace_(tape_) {}

  template <class Visit>
  void visit(const QuadratureBlock& block, const Visit& visit) {
    tape_.evaluate({block.coordinates, block.count}, workspace_);
    for (int i = 0; i < block.count; ++i) {
      if (!(workspace_.coefficient(1)[i] >= 0)) continue;
      Point point{};
      for (int axis = 0; axis < tape_.dimension(); ++axis) point[axis] = block.coordinates[axis][i];
      visit(i, point, workspace_.coefficient(0)[i]);
    }
  }

 private:
  Tape tape_;
  Tape::Workspace workspace_;
};

void keep_larger(Extreme& best, const Extreme& other) {
  if (other.value > best.value) best = other;
}

Extreme nothing_yet() { return {-std::numeric_limits<double>::infinity(), {}}; }

double largest_spacing(const Grid& grid) {
  double spacing = 0;
  for (int axis = 0; axis < grid.dimension(); ++axis)
    spacing = std::max(spacing, grid.spacing(axis));
  return spacing;
}

// Newton's method on ∇f = 0 from a sampled maximum; steps beyond a cell, or out of the region, end
// it.
Extreme improved_inside(const Field& f, const ScalarProblem& problem, const Grid& grid,
                        const std::optional<Field>& inside, const Extreme& start) {
  const int dimension = grid.dimension();
  const Tape tape({f, inside.value_or(1.0)}, {2, 0}, dimension);
  Tape::Workspace workspace(tape);
  const double reach = largest_spacing(grid);
  Extreme best = start;
  Point point = start.at;
  for (int step = 0; step < 20; ++step) {
    PointBlock block;
    for (int axis = 0; axis < dimension; ++axis) block.coordinates[axis] = &point[axis];
    block.count = 1;
    tape.evaluate(block, workspace);
    const double value = workspace.coefficient(0)[0];
    if (!std::isfinite(value) || !(workspace.coefficient(1)[0] >= 0)) break;
    keep_larger(best, {value, point});
    Eigen::VectorXd gradient(dimension);
    Eigen::MatrixXd hessian(dimension, dimension);
    for (int i = 0; i < dimension; ++i) {
      gradient[i] = workspace.coefficient(0, 1 + i)[0];
      for (int j = 0; j < dimension; ++j) {
        const MultiIndex alpha = unit_index(i) + unit_index(j);
        hessian(i, j) = workspace.coefficient(0, jet_index(dimension, alpha))[0] * factorial(alpha);
      }
    }
    const Eigen::VectorXd newton = hessian.ldlt().solve(-gradient);
    if (!newton.allFinite() || newton.norm() > reach) break;
    for (int i = 0; i < dimension; ++i) point[i] += newton[i];
    if (!problem.region().contains(point)) break;
    if (newton.norm() < 1e-14 * reach) break;
  }
  return best;
}

// Golden section along the curve {γ = 0} through the sampled maximum, within a cell on both sides.
Extreme improved_along_curve(const Field& f, const ScalarProblem& problem, const Grid& grid,
                             int primitive, const std::optional<Field>& where,
                             const Extreme& start) {
  const LevelFunction& level = problem.region().level(primitive);
  const Tape tape({f, where.value_or(1.0)}, {0}, 2);
  Point gradient;
  level.value_and_gradient(start.at, gradient);
  const double length = std::hypot(gradient[0], gradient[1]);
  const double scale = problem.bounds().longest_side();
  Extreme best = start;
  const auto value_at = [&](double t) {
    Point trial = start.at;
    trial[0] -= t * gradient[1] / length;
    trial[1] += t * gradient[0] / length;
    const auto foot = nearest_zero(level, trial);
    if (!foot || !problem.region().contains(*foot, 1e-12 * scale) || !(tape.value(*foot, 1) >= 0))
      return -std::numeric_limits<double>::infinity();
    const double value = tape.value(*foot);
    if (std::isfinite(value)) keep_larger(best, {value, *foot});
    return std::isfinite(value) ? value : -std::numeric_limits<double>::infinity();
  };
  constexpr double golden = 0.6180339887498949;
  double low = -largest_spacing(grid), high = largest_spacing(grid);
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = value_at(left), at_right = value_at(right);
  for (int i = 0; i < 60; ++i) {
    if (at_left > at_right) {
      high = right;
      right = left, at_right = at_left;
      left = high - golden * (high - low);
      at_left = value_at(left);
    } else {
      low = left;
      left = right, at_left = at_right;
      right = low + golden * (high - low);
      at_right = value_at(right);
    }
  }
  return best;
}

}  // namespace

Extreme maximum_over_boundary(const Field& f, const ScalarProblem& problem, const DomainRule& rule,
                              const std::vector<int>& primitives,
                              const std::optional<Field>& where) {
  PointScan scan(f, where, rule.dimension());
  Extreme best = nothing_yet();
  int best_primitive = -1;
  const SurfaceBlocks blocks(rule.boundary());
  for (int k = 0; k < blocks.count(); ++k) {
    const QuadratureBlock block = blocks.block(k);
    scan.visit(block, [&](int i, const Point& point, double value) {
      if (!primitives.empty() &&
          std::ranges::find(primitives, block.numbers[i]) == primitives.end())
        return;
      if (value > best.value) {
        best = {value, point};
        best_primitive = block.numbers[i];
      }
    });
  }
  if (best_primitive < 0)
    throw ComputationError("a probe over a part of the boundary has no points");
  return rule.dimension() == 2
             ? improved_along_curve(f, problem, rule.grid(), best_primitive, where, best)
             : best;
}

Extreme maximum_over_volume(const Field& f, const ScalarProblem& problem, const DomainRule& rule,
                            const std::optional<Field>& inside) {
  PointScan scan(f, inside, rule.dimension());
  Extreme best = nothing_yet();
  const VolumeBlocks blocks(rule);
  VolumeBlocks::Buffer buffer;
  for (int k = 0; k < blocks.count(); ++k)
    scan.visit(blocks.block(k, buffer), [&](int, const Point& point, double value) {
      keep_larger(best, {value, point});
    });
  if (!std::isfinite(best.value))
    throw ComputationError("a probe over a part of the domain has no points");
  best = improved_inside(f, problem, rule.grid(), inside, best);
  if (!inside) keep_larger(best, maximum_over_boundary(f, problem, rule, {}));
  return best;
}

}  // namespace rfm
