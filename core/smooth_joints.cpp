#include "core/smooth_joints.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/boundary_part.hpp"
#include "core/point_algebra.hpp"
#include "core/quadric.hpp"
#include "core/sign_tree.hpp"

namespace rfm {
namespace {

using Pair = std::pair<int, int>;

// Solves the symmetric positive definite system of up to three equations by elimination.
Point solved(std::array<std::array<double, 3>, 3> matrix, Point right, int size) {
  for (int i = 0; i < size; ++i)
    for (int row = i + 1; row < size; ++row) {
      const double factor = matrix[row][i] / matrix[i][i];
      for (int column = i; column < size; ++column)
        matrix[row][column] -= factor * matrix[i][column];
      right[row] -= factor * right[i];
    }
  for (int i = size - 1; i >= 0; --i) {
    for (int column = i + 1; column < size; ++column) right[i] -= matrix[i][column] * right[column];
    right[i] /= matrix[i][i];
  }
  return right;
}

// Two surfaces, and the components of ∇f × ∇g, which vanish where they are parallel.
class Contact {
 public:
  Contact(const Field& f, const Field& g, int dimension) : dimension_(dimension) {
    functions_.emplace_back(f, dimension);
    functions_.emplace_back(g, dimension);
    for (int axis = dimension == 2 ? 2 : 0; axis < 3; ++axis) {
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      functions_.emplace_back(partial(f, a) * partial(g, b) - partial(f, b) * partial(g, a),
                              dimension);
    }
  }

  // Where both vanish and are parallel, near `start`: damped least squares, each function over the
  // length of its gradient.
  std::optional<Point> touching_point(Point point, double scale) const {
    constexpr int max_steps = 60;
    for (int step = 0; step < max_steps; ++step) {
      std::array<std::array<double, 3>, 3> matrix{};
      Point right{};
      double residual = 0;
      for (const LevelFunction& function : functions_) {
        Point gradient{};
        double value = function.value_and_gradient(point, gradient);
        const double slope = norm(gradient);
        if (!std::isfinite(value) || !std::isfinite(slope)) return {};
        if (!(slope > 0)) continue;  // identically zero, as between lines
        value /= slope;
        residual += value * value;
        for (int i = 0; i < dimension_; ++i) {
          right[i] -= gradient[i] / slope * value;
          for (int j = 0; j < dimension_; ++j)
            matrix[i][j] += gradient[i] * gradient[j] / (slope * slope);
        }
      }
      residual = std::sqrt(residual);
      if (residual <= 1e-12 * scale) return point;
      // Along a curve of contact nothing holds the point.
      for (int i = 0; i < dimension_; ++i) matrix[i][i] += 1e-10 + 1e-3 * residual / scale;
      const Point move = solved(matrix, right, dimension_);
      for (int i = 0; i < dimension_; ++i) point[i] += move[i];
    }
    return {};
  }

 private:
  int dimension_;
  std::vector<LevelFunction> functions_;
};

class JointSearch {
 public:
  JointSearch(const RegionEvaluator& region, const Box& bounds)
      : region_(region), tree_(region, bounds), scale_(bounds.longest_side()) {
    for (int k = 0; k < region.primitive_count(); ++k) {
      const QuadricEvaluator* quadric = region.level(k).quadric();
      is_flat_.push_back(quadric &&
                         as_quadric(primitive(k).level, region.dimension())->is_affine());
    }
  }

  std::set<int> run() {
    tree_.search(
        [&](const SignTree::Node& node) {
          return node.inside == Truth::unknown && node.undecided.size() > 1 && has_curved(node);
        },
        [&](const SignTree::Node& node) {
          look(node.box);
          return true;
        });
    return joints_;
  }

 private:
  const Primitive& primitive(int k) const { return *region_.region().primitives()[k]; }

  bool has_curved(const SignTree::Node& node) const {
    return std::ranges::any_of(node.undecided, [&](int k) { return !is_flat_[k]; });
  }

  void look(const Box& box) {
    std::vector<int> here;
    std::vector<FunctionBounds> bounds;
    for (int k = 0; k < region_.primitive_count(); ++k) {
      // What is nowhere positive, as −|x|, bounds nothing.
      if (primitive(k).selects_only || region_.level(k).range().high <= 0) continue;
      FunctionBounds known = region_.level(k).bounds(box);
      if (known.value.low > 0 || known.value.high < 0) continue;
      here.push_back(k);
      bounds.push_back(std::move(known));
    }
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Pair pair{here[j], here[i]};
        if ((is_flat_[pair.first] && is_flat_[pair.second]) || known_.contains(pair)) continue;
        if (!may_be_parallel(bounds[j], bounds[i])) continue;
        const bool is_one = same_surface(primitive(pair.first).level, primitive(pair.second).level,
                                         region_.dimension());
        const bool does_join = !is_one && joins(pair, box);
        if (is_one || does_join) known_.insert(pair);
        if (does_join) joints_.insert({pair.first, pair.second});
      }
  }

  static bool may_be_parallel(const FunctionBounds& f, const FunctionBounds& g) {
    for (int axis = 0; axis < 3; ++axis) {
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      if ((f.gradient[a] * g.gradient[b] - f.gradient[b] * g.gradient[a]).excludes_zero())
        return false;
    }
    return true;
  }

  bool joins(const Pair& pair, const Box& box) {
    auto contact = contacts_.find(pair);
    if (contact == contacts_.end())
      contact = contacts_
                    .try_emplace(pair, primitive(pair.first).level, primitive(pair.second).level,
                                 region_.dimension())
                    .first;
    const auto point = contact->second.touching_point(box.center(), scale_);
    if (!point) return false;
    for (int axis = 0; axis < box.dimension; ++axis)
      if (std::fabs((*point)[axis] - box.center()[axis]) > box.longest_side()) return false;
    // Each bounds the region near by, on the same side of the common tangent.
    const auto first = outward(pair.first, *point), second = outward(pair.second, *point);
    return first && second && dot(*first, *second) > 0;
  }

  // The outward normal of a primitive's piece near a point; nothing if there is none of it.
  std::optional<Point> outward(int k, const Point& point) const {
    const int dimension = region_.dimension();
    constexpr int directions = 12;
    constexpr double pi = 3.14159265358979323846;
    for (const double distance : {1e-3 * scale_, 1e-2 * scale_})
      for (int i = 0; i < directions; ++i) {
        Point gradient{};
        region_.level(k).value_and_gradient(point, gradient);
        const double slope = norm(gradient);
        if (!(slope > 0)) return {};
        Point step = tangent(gradient, dimension, 2 * pi * (i + 0.37) / directions);
        if (dimension == 2 && i % 2 == 1) step = {-step[0], -step[1], 0};
        Point on = point;
        for (int axis = 0; axis < dimension; ++axis) on[axis] += distance * step[axis];
        for (int newton = 0; newton < 4; ++newton) {
          const double value = region_.level(k).value_and_gradient(on, gradient);
          const double square = dot(gradient, gradient);
          if (!(square > 0)) return {};
          for (int axis = 0; axis < dimension; ++axis) on[axis] -= value / square * gradient[axis];
        }
        std::vector<Truth> signs;
        for (int other = 0; other < region_.primitive_count(); ++other)
          signs.push_back(region_.level(other).value(on) >= 0 ? Truth::yes : Truth::no);
        signs[k] = Truth::yes;
        const bool with = region_.region().expression().evaluate(signs) == Truth::yes;
        signs[k] = Truth::no;
        const bool without = region_.region().expression().evaluate(signs) == Truth::yes;
        if (with == without) continue;
        const double sign = (with ? -1 : 1) / norm(gradient);
        return Point{sign * gradient[0], sign * gradient[1], sign * gradient[2]};
      }
    return {};
  }

  static Point tangent(const Point& normal, int dimension, double angle) {
    const double size = norm(normal);
    if (dimension == 2) return {-normal[1] / size, normal[0] / size, 0};
    int thinnest = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (std::fabs(normal[axis]) < std::fabs(normal[thinnest])) thinnest = axis;
    Point pole{};
    pole[thinnest] = 1;
    const auto cross = [](const Point& a, const Point& b) {
      return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    Point u = cross(normal, pole);
    const double across = norm(u);
    for (double& component : u) component /= across;
    const Point v = cross(normal, u);
    Point result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = std::cos(angle) * u[axis] + std::sin(angle) * v[axis] / size;
    return result;
  }

  const RegionEvaluator& region_;
  SignTree tree_;
  double scale_;
  std::vector<bool> is_flat_;
  std::map<Pair, Contact> contacts_;
  std::set<Pair> known_;
  std::set<int> joints_;
};

}  // namespace

std::set<int> smooth_joints(const RegionEvaluator& region, const Box& bounds) {
  if (region.dimension() < 2) return {};
  return JointSearch(region, bounds).run();
}

}  // namespace rfm
