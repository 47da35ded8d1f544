#include "quadrature/zero_isolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/least_side.hpp"

namespace rfm {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// The inverse of the leading n × n part (n ≤ 3), by Gauss-Jordan elimination with pivots.
std::optional<Matrix> inverse(Matrix a, int n) {
  Matrix b{};
  for (int i = 0; i < n; ++i) b[i][i] = 1;
  for (int column = 0; column < n; ++column) {
    int pivot = column;
    for (int i = column + 1; i < n; ++i)
      if (std::fabs(a[i][column]) > std::fabs(a[pivot][column])) pivot = i;
    std::swap(a[pivot], a[column]);
    std::swap(b[pivot], b[column]);
    const double scale = 1 / a[column][column];
    if (!std::isfinite(scale)) return {};
    for (int j = 0; j < n; ++j) {
      a[column][j] *= scale;
      b[column][j] *= scale;
    }
    for (int i = 0; i < n; ++i) {
      if (i == column) continue;
      const double factor = a[i][column];
      for (int j = 0; j < n; ++j) {
        a[i][j] -= factor * a[column][j];
        b[i][j] -= factor * b[column][j];
      }
    }
  }
  return b;
}

class ZeroIsolation {
 public:
  ZeroIsolation(std::span<const LevelFunction* const> functions, std::span<const int> axes)
      : functions_(functions), axes_(axes), n_(static_cast<int>(functions.size())) {}

  ZeroSet run(const Box& box, const ZeroSearchOptions& options) {
    double longest = 0;
    for (const int axis : axes_) longest = std::max(longest, box.length(axis));
    size_ = longest;
    smallest_ = options.smallest * longest;
    max_unresolved_ = options.max_unresolved;
    visit(box);
    return std::move(result_);
  }

  bool newton(double reach, Point& point) const {
    const Point start = point;
    double previous = INFINITY;
    for (int iteration = 0; iteration < 50; ++iteration) {
      std::array<double, 3> values{};
      const auto inverse_jacobian = linearised(point, values);
      if (!inverse_jacobian) return false;
      double length = 0, distance = 0, magnitude = 0;
      for (int i = 0; i < n_; ++i) {
        double step = 0;
        for (int j = 0; j < n_; ++j) step -= (*inverse_jacobian)[i][j] * values[j];
        double& x = point[axes_[i]];
        x += step;
        length = std::max(length, std::fabs(step));
        distance = std::max(distance, std::fabs(x - start[axes_[i]]));
        magnitude = std::max(magnitude, std::fabs(x));
      }
      if (!(distance <= reach)) return false;
      const double rounding = 1e-15 * (magnitude + reach);
      // Rounding keeps steps from vanishing; they stop shrinking there.
      if (length <= rounding || (length >= 0.5 * previous && length <= 100 * rounding)) return true;
      previous = length;
    }
    return false;
  }

 private:
  std::optional<Matrix> linearised(const Point& point, std::array<double, 3>& values) const {
    Matrix jacobian{};
    for (int i = 0; i < n_; ++i) {
      Point gradient{};
      values[i] = functions_[i]->value_and_gradient(point, gradient);
      for (int j = 0; j < n_; ++j) jacobian[i][j] = gradient[axes_[j]];
    }
    return inverse(jacobian, n_);
  }

  // Row sums of |I − Y J| over a box, weighted by the radii of the box: how far Newton's step from
  // the centre may be from the true one.
  std::array<double, 3> deviations(const Matrix& y, const Box& box) const {
    std::array<FunctionBounds, 3> bounds;
    for (int i = 0; i < n_; ++i) bounds[i] = functions_[i]->bounds(box);
    std::array<double, 3> sums{};
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) {
        Interval entry(i == j ? 1 : 0);
        for (int k = 0; k < n_; ++k)
          entry = entry - Interval(y[i][k]) * bounds[k].gradient[axes_[j]];
        sums[i] += entry.magnitude() * 0.5 * box.length(axes_[j]);
      }
    return sums;
  }

  double contraction(const std::array<double, 3>& deviations, const Box& box) const {
    double largest = 0;
    for (int i = 0; i < n_; ++i)
      largest = std::max(largest, deviations[i] / (0.5 * box.length(axes_[i])));
    return largest;
  }
  double contraction(const Matrix& y, const Box& box) const {
    return contraction(deviations(y, box), box);
  }

  // Bounds of component i of Y F at a point.
  Interval newton_step(const Matrix& y, const Point& point, int i) const {
    const Box at{functions_[0]->dimension(), point, point};
    Interval step(0);
    for (int j = 0; j < n_; ++j) step = step + Interval(y[i][j]) * functions_[j]->value_bounds(at);
    return step;
  }

  bool is_proved_zero(const Point& point) const {
    std::array<double, 3> values{};
    const auto y = linearised(point, values);
    if (!y) return false;
    const double radius = 1e-6 * size_;
    Box around{functions_[0]->dimension(), point, point};
    for (const int axis : axes_) {
      around.low[axis] -= radius;
      around.high[axis] += radius;
    }
    const double left = 1 - contraction(*y, around);
    for (int i = 0; i < n_; ++i)
      if (!(newton_step(*y, point, i).magnitude() <= left * radius)) return false;
    return true;
  }

  void visit(const Box& box) {
    if (static_cast<int>(result_.unresolved.size()) >= max_unresolved_) return give_up(box);
    for (const LevelFunction* function : functions_)
      if (function->bounds(box).value.excludes_zero()) return;
    if (settled(box)) return;
    int longest = axes_[0];
    for (const int axis : axes_)
      if (box.length(axis) > box.length(longest)) longest = axis;
    if (box.length(longest) <= std::max(smallest_, least_side(box))) return give_up(box);
    for (const Box& half : bisect(box, longest)) visit(half);
  }

  void give_up(const Box& box) { result_.unresolved.push_back(box); }

  // Whether the zeros in `box` are known (and listed).
  bool settled(const Box& box) {
    const Point center = box.center();
    std::array<double, 3> values{};
    const auto y = linearised(center, values);
    if (!y) return false;
    const std::array<double, 3> margins = deviations(*y, box);
    // No zero can be as near as the sides if Newton's step leads beyond them for certain.
    constexpr double rounding = 1 + 1e-10;
    for (int i = 0; i < n_; ++i)
      if (newton_step(*y, center, i).mignitude() >
          rounding * (margins[i] + 0.5 * box.length(axes_[i])))
        return true;
    if (!(contraction(margins, box) < 1)) return false;
    Point point = center;
    if (!newton(4 * size_, point)) return false;
    Box hull = box;
    bool is_within = true;
    for (const int axis : axes_) {
      const double same = 1e-14 * (size_ + std::fabs(point[axis]));
      if (point[axis] < box.low[axis] - same || point[axis] > box.high[axis] + same)
        is_within = false;
      hull.low[axis] = std::min(hull.low[axis], point[axis]);
      hull.high[axis] = std::max(hull.high[axis], point[axis]);
    }
    if (!is_within) return contraction(*y, hull) < 1;
    if (!is_proved_zero(point)) return false;
    add(point);
    return true;
  }

  // Zeros on sides shared by boxes are found in both.
  void add(const Point& point) {
    for (const Point& other : result_.zeros) {
      double distance = 0;
      for (const int axis : axes_)
        distance = std::max(distance, std::fabs(other[axis] - point[axis]));
      if (distance <= 1e-9 * size_) return;
    }
    result_.zeros.push_back(point);
  }

  std::span<const LevelFunction* const> functions_;
  std::span<const int> axes_;
  int n_;
  double size_ = 0, smallest_ = 0;
  int max_unresolved_ = 0;
  ZeroSet result_;
};

}  // namespace

ZeroSet isolate_zeros(std::span<const LevelFunction* const> functions, const Box& box,
                      std::span<const int> axes, const ZeroSearchOptions& options) {
  return ZeroIsolation(functions, axes).run(box, options);
}

bool newton_zero(std::span<const LevelFunction* const> functions, std::span<const int> axes,
                 double reach, Point& point) {
  return ZeroIsolation(functions, axes).newton(reach, point);
}

}  // namespace rfm
