// Unions of thousands of spheres are roots nested as deep (A. Pasko et al. 1995, §5): here they
// lose no digits.
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/r_functions.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

struct Sphere {
  Point center;
  double radius;
  Field field() const {
    const Field x = x_coordinate() - center[0], y = y_coordinate() - center[1],
                z = z_coordinate() - center[2];
    return (radius * radius - (x * x + y * y + z * z)) * (0.5 / radius);
  }
};

// Disjoint spheres in the cells of a lattice.
std::vector<Sphere> lattice_of_spheres(int count) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Sphere> spheres;
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  for (int k = 0; k < count; ++k)
    spheres.push_back(
        {{k % side + 0.1 * uniform(generator), k / side % side + 0.1 * uniform(generator),
          k / side / side + 0.1 * uniform(generator)},
         0.2 + 0.1 * uniform(generator)});
  return spheres;
}

// The union in long double and its condition: how much value and gradient move, to first order,
// when coordinates of the point and the terms of the spheres' functions do by one unit of rounding.
struct Reference {
  long double value;
  std::array<long double, 3> gradient;
  long double value_condition, gradient_condition;

  Reference(const Sphere& sphere, const Point& point) {
    const long double r = sphere.radius;
    long double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const long double offset = static_cast<long double>(point[axis]) - sphere.center[axis];
      square += offset * offset;
      gradient[axis] = -offset / r;
    }
    value = (r * r - square) / (2 * r);
    value_condition = (r * r + square) / (2 * r);
    gradient_condition = std::sqrt(square) / r;
    for (int axis = 0; axis < 3; ++axis) {
      value_condition += std::fabs(gradient[axis] * point[axis]);
      gradient_condition += std::fabs(point[axis]) / r;
    }
  }
};

long double length(const std::array<long double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

Reference disjunction(const Reference& a, const Reference& b) {
  const long double s = std::hypot(a.value, b.value), sum = a.value + b.value;
  const long double x = a.value, y = b.value;
  Reference all = a;
  all.value = sum < 0 ? 2 * x * y / (sum - s) : sum + s;
  // 1 + x/s without cancellation.
  const long double p = x < 0 ? y * y / (s * (s - x)) : 1 + x / s;
  const long double q = y < 0 ? x * x / (s * (s - y)) : 1 + y / s;
  for (int axis = 0; axis < 3; ++axis)
    all.gradient[axis] = p * a.gradient[axis] + q * b.gradient[axis];
  all.value_condition = p * a.value_condition + q * b.value_condition;
  const long double turn =
      (std::fabs(y) * a.value_condition + std::fabs(x) * b.value_condition) / (s * s * s);
  all.gradient_condition =
      p * a.gradient_condition + q * b.gradient_condition +
      turn * (std::fabs(y) * length(a.gradient) + std::fabs(x) * length(b.gradient));
  return all;
}

template <class T>
T left_deep(const std::vector<T>& parts) {
  T all = parts[0];
  for (std::size_t k = 1; k < parts.size(); ++k) all = disjunction(all, parts[k]);
  return all;
}

template <class T>
T balanced(std::vector<T> level) {
  while (level.size() > 1) {
    std::vector<T> next;
    for (std::size_t k = 0; k + 1 < level.size(); k += 2)
      next.push_back(disjunction(level[k], level[k + 1]));
    if (level.size() % 2 == 1) next.push_back(level.back());
    level = std::move(next);
  }
  return level[0];
}

class NestedRoots : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Tree, NestedRoots, testing::Bool(),
                         [](const auto& info) { return info.param ? "Balanced" : "LeftDeep"; });

TEST_P(NestedRoots, OfAUnionOf10000SpheresLoseNoDigitsOnItsBoundary) {
  const auto spheres = lattice_of_spheres(10000);
  std::vector<Field> fields;
  for (const Sphere& sphere : spheres) fields.push_back(sphere.field());
  const Tape tape({GetParam() ? balanced(fields) : left_deep(fields)}, {1}, 3);
  Tape::Workspace workspace(tape);
  std::mt19937 generator(2);
  std::normal_distribution<double> normal;
  std::array<std::array<double, 64>, 3> points;
  std::array<std::size_t, 64> on;
  for (int i = 0; i < 64; ++i) {
    on[i] = i == 0 ? 0 : i == 1 ? spheres.size() - 1 : generator() % spheres.size();
    const Sphere& sphere = spheres[on[i]];
    const Point d{normal(generator), normal(generator), normal(generator)};
    const double length = std::hypot(d[0], d[1], d[2]);
    for (int axis = 0; axis < 3; ++axis)
      points[axis][i] = sphere.center[axis] + sphere.radius * (d[axis] / length);
  }
  tape.evaluate({{points[0].data(), points[1].data(), points[2].data()}, 64}, workspace);
  for (int i = 0; i < 64; ++i) {
    const Point point{points[0][i], points[1][i], points[2][i]};
    std::vector<Reference> parts;
    for (const Sphere& sphere : spheres) parts.push_back(Reference(sphere, point));
    const Reference exact = GetParam() ? balanced(parts) : left_deep(parts);
    constexpr double ulp = 0x1p-52;
    EXPECT_NEAR(workspace.coefficient(0)[i], static_cast<double>(exact.value),
                static_cast<double>(4 * ulp * exact.value_condition));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(workspace.coefficient(0, 1 + axis)[i], static_cast<double>(exact.gradient[axis]),
                  static_cast<double>(4 * ulp * exact.gradient_condition));
      // The union's boundary is that of the sphere: its normal, but for the distance of the point
      // from the boundary, some 1e-15, times the curvature of the union, 1 / |the others' union|.
      EXPECT_NEAR(workspace.coefficient(0, 1 + axis)[i],
                  static_cast<double>(parts[on[i]].gradient[axis]), 1e-11);
    }
  }
}

TEST(NestedRootsTogether, BothOrdersOfUnionAgreeAndAreNegativeOutside) {
  const auto spheres = lattice_of_spheres(1000);
  std::vector<Field> fields;
  for (const Sphere& sphere : spheres) fields.push_back(sphere.field());
  const Tape tape({left_deep(fields), balanced(fields)}, {0}, 3);
  for (const Sphere& sphere : spheres) {
    EXPECT_GT(tape.value(sphere.center, 0), 0);
    EXPECT_GT(tape.value(sphere.center, 1), 0);
    const Point outside{sphere.center[0] + 0.5, sphere.center[1], sphere.center[2]};
    EXPECT_LT(tape.value(outside, 0), 0);
    EXPECT_LT(tape.value(outside, 1), 0);
  }
}

}  // namespace
}  // namespace rfm
