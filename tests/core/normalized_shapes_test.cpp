// Every shape the program has, and what is claimed of its functions: |∇ω| = 1 on its boundary,
// higher normal derivatives 0 to the order of normalisation, and kept by every rule that keeps it.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/curved_polygon.hpp"
#include "core/derivative_fields.hpp"
#include "core/evaluate.hpp"
#include "core/exact_distances.hpp"
#include "core/function_shaping.hpp"
#include "core/intersection.hpp"
#include "core/mapped_region.hpp"
#include "core/polygon.hpp"
#include "core/primitives.hpp"
#include "core/profile_bodies.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Point oblique{1, 2, -2};

struct Shape {
  const char* name;
  Region region;
  bool exact = false;  ///< its functions are distances
};

std::ostream& operator<<(std::ostream& stream, const Shape& shape) { return stream << shape.name; }

// One side, with the Euclidean distance for its function.
Region exact(const Region& region, const Field& distance) {
  return with_function(region, distance);
}

std::vector<Shape> shapes() {
  const Region profile = box({0.2, -0.5}, {1.1, 0.6}).named("b") - circle({0.7, 0}, 0.3).named("c");
  const CurvedContour curved{
      {{-1, -0.7}, {1, -0.8}, {1.1, 0.6}, {-0.9, 0.8}},
      {{.bulge = 0.3}, {.bulge = -0.2}, {.conic = EdgeCurve::Conic{{0, 1.3}, 0.7}}, {}}};
  return {
      {"half plane", half_plane({0.3, -0.2}, {3, -4}), true},
      {"circle", circle({0.2, -0.1}, 0.9)},
      {"exact circle", exact(circle({0.2, -0.1}, 0.9), ball_distance({0.2, -0.1}, 0.9, 2)), true},
      {"ellipse", ellipse({0.1, 0}, {1.2, 0.6}, 0.4)},
      {"exact ellipse",
       exact(ellipse({0.1, 0}, {1.2, 0.6}, 0.4),
             ellipsoid_distance({0.1, 0, 0}, {1.2, 0.6, 1}, {0, 0, 1}, 0.4, 2)),
       true},
      {"rectangle", box({-0.7, -0.5}, {0.9, 0.6}), true},
      {"strip", strip({0.1, 0}, {1, 2}, 0.8), true},
      {"sector", sector({0.1, 0}, 1.1, 0.3, 4.5, 0.4)},
      {"polygon", polygon({{-1, -1}, {1, -0.9}, {0.1, 0}, {1.2, 1}, {-0.9, 0.8}}), true},
      {"curved polygon", curved_polygon({curved}).region},
      {"conic", quadric({1, 0.3, -1.4, 0.2, 0.1, 0.5})},
      {"half space", half_space({0.1, 0.2, 0}, oblique), true},
      {"sphere", sphere({0.1, 0.2, 0}, 1)},
      {"exact sphere", exact(sphere({0.1, 0.2, 0}, 1), ball_distance({0.1, 0.2, 0}, 1, 3)), true},
      {"ellipsoid", ellipsoid({0.1, 0, 0.2}, {0.7, 1.1, 0.9}, oblique, 0.8)},
      {"exact ellipsoid",
       exact(ellipsoid({0.1, 0, 0.2}, {0.7, 1.1, 0.9}, oblique, 0.8),
             ellipsoid_distance({0.1, 0, 0.2}, {0.7, 1.1, 0.9}, oblique, 0.8, 3)),
       true},
      {"box", box({-0.7, -0.5, -0.4}, {0.9, 0.6, 0.8}, 3), true},
      {"cylinder", cylinder({0.1, 0, 0}, oblique, 0.7, 1.5)},
      {"exact cylinder",
       exact(cylinder({0.1, 0, 0}, oblique, 0.7), cylinder_distance({0.1, 0, 0}, oblique, 0.7)),
       true},
      {"cone", cone({0, 0.3, 0}, oblique, 0.6, 1.3)},
      {"exact cone",
       exact(cone({0, 0.3, 0}, oblique, 0.6), cone_distance({0, 0.3, 0}, oblique, 0.6)), true},
      {"torus", torus({0, 0, 0.1}, oblique, 0.9, 0.3)},
      {"exact torus",
       exact(torus({0, 0, 0.1}, oblique, 0.9, 0.3), torus_distance({0, 0, 0.1}, oblique, 0.9, 0.3)),
       true},
      {"capsule", capsule({-0.5, 0, 0}, {0.5, 0.3, 0.1}, 0.5)},
      {"exact capsule",
       exact(capsule({-0.5, 0, 0}, {0.5, 0.3, 0.1}, 0.5),
             capsule_distance({-0.5, 0, 0}, {0.5, 0.3, 0.1}, 0.5)),
       true},
      {"quadric", quadric({1, -0.7, 0.6, 0.2, -0.1, 0.3, 0.1, 0.2, -0.1, -0.4}, 3)},
      {"extrusion", extrusion(profile, -0.4, 0.9)},
      {"revolution", revolution(profile, {0.1, 0, 0}, oblique)},
      {"moved shape",
       transformed(profile, {.scale = 0.8, .angle = 0.7, .translation = {0.2, 0.1}})},
      {"moved body", transformed(cone({0, 0, -0.5}, {0, 0, 1}, 0.6, 1),
                                 {.scale = 1.3, .angle = 1.1, .axis = oblique})}};
}

// Derivatives of orders 0 to 3 of a function along a straight line.
std::array<double, 4> derivatives_along(const Tape& tape, const Point& at, const Point& v) {
  Tape::Workspace workspace(tape);
  tape.evaluate({{&at[0], &at[1], &at[2]}, 1}, workspace);
  const int dimension = tape.dimension(), order = tape.order(0);
  std::array<double, 4> result{};
  for (int i = 0; i <= order; ++i)
    for (int j = 0; i + j <= order; ++j)
      for (int k = 0; i + j + k <= order && (dimension == 3 || k == 0); ++k) {
        const int n = i + j + k,
                  index = jet_index(dimension, {std::uint8_t(i), std::uint8_t(j), std::uint8_t(k)});
        result[n] += (n < 2    ? 1
                      : n == 2 ? 2
                               : 6) *
                     std::pow(v[0], i) * std::pow(v[1], j) * std::pow(v[2], k) *
                     workspace.coefficient(0, index)[0];
      }
  return result;
}

struct BoundaryPoint {
  int primitive;
  Point at, normal;  ///< the unit normal along the gradient
};

// Points of the zero sets of all primitives; with `whole`, of those that lie on the boundary of the
// region, away from other primitives, with the normal that points inside.
std::vector<BoundaryPoint> points_of(const Region& region, bool whole) {
  const RegionEvaluator evaluator(region);
  std::mt19937 generator(11);
  const auto uniform = [&] { return -1.5 + 3 * 0x1p-32 * generator(); };
  std::vector<BoundaryPoint> points;
  for (int k = 0; k < evaluator.primitive_count(); ++k) {
    if (region.primitives()[k]->selects_only) continue;
    int found = 0;
    for (int trial = 0; trial < 400 && found < 12; ++trial) {
      const Point start{uniform(), uniform(), region.dimension() == 3 ? uniform() : 0};
      const auto zero = nearest_zero(evaluator.level(k), start);
      if (!zero) continue;
      BoundaryPoint point{k, *zero, {}};
      const double value = evaluator.level(k).value_and_gradient(*zero, point.normal);
      const double slope = std::hypot(point.normal[0], point.normal[1], point.normal[2]);
      if (!(slope > 0.05) || std::fabs(value) > 1e-12) continue;  // singular, or far away
      for (double& component : point.normal) component /= slope;
      if (whole) {
        bool alone = true;
        for (int other = 0; other < evaluator.primitive_count(); ++other) {
          Point gradient;
          const double there = evaluator.level(other).value_and_gradient(*zero, gradient);
          alone = alone &&
                  (other == k ||
                   std::fabs(there) > 0.05 * std::hypot(gradient[0], gradient[1], gradient[2]));
        }
        const auto inside = [&](double step) {
          Point beside = *zero;
          for (int axis = 0; axis < 3; ++axis) beside[axis] += step * point.normal[axis];
          return evaluator.contains(beside);
        };
        if (!alone || inside(1e-6) == inside(-1e-6)) continue;
        if (inside(-1e-6))
          for (double& component : point.normal) component = -component;
      }
      points.push_back(point);
      ++found;
    }
  }
  return points;
}

class EveryShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(NormalizedShapes, EveryShape, testing::ValuesIn(shapes()));

TEST_P(EveryShape, HasUnitSlopeOnItsBoundary) {
  const Region& region = GetParam().region;
  const std::vector<BoundaryPoint> points = points_of(region, false);
  std::vector<Tape> tapes;
  for (const auto& primitive : region.primitives())
    tapes.emplace_back(std::vector{primitive->function}, std::vector{3}, region.dimension());
  EXPECT_GE(points.size(), 12u);
  const RegionEvaluator evaluator(region);
  for (const BoundaryPoint& point : points) {
    // The other nappe of a cone is none of its own.
    if (GetParam().exact && region.primitives().back()->selects_only &&
        !evaluator.contains(point.at, 1e-9))
      continue;
    const auto d = derivatives_along(tapes[point.primitive], point.at, point.normal);
    const std::string& side = region.primitives()[point.primitive]->name;
    EXPECT_NEAR(d[0], 0, 1e-12) << side;
    EXPECT_NEAR(d[1], 1, 1e-12) << side;
    if (!GetParam().exact) continue;
    EXPECT_NEAR(d[2], 0, 1e-10) << side;  // distances, to every order
    EXPECT_NEAR(d[3], 0, 1e-8) << side;
  }
}

TEST_P(EveryShape, IsNormalizedToTheOrderAskedFor) {
  const Region& region = GetParam().region;
  const std::vector<BoundaryPoint> points = points_of(region, false);
  for (const int order : {2, 3}) {
    std::vector<Tape> tapes;
    for (const auto& primitive : region.primitives())
      tapes.emplace_back(std::vector{normalize(primitive->level, region.dimension(), order)},
                         std::vector{order}, region.dimension());
    for (const BoundaryPoint& point : points) {
      const auto d = derivatives_along(tapes[point.primitive], point.at, point.normal);
      EXPECT_NEAR(d[1], 1, 1e-12);
      for (int k = 2; k <= order; ++k)
        EXPECT_NEAR(d[k], 0, k == 2 ? 1e-9 : 1e-7) << order << ", " << k;
    }
  }
}

// Corrections of higher order are right near the surface: a function may vanish again far from it.
bool signs_agree(const Region& region, const Point& at, int order) {
  for (const auto& primitive : region.primitives()) {
    const double level = value_at(primitive->level, at);
    const double normalized = value_at(normalize(primitive->level, region.dimension(), order), at);
    if (std::fabs(level) > 1e-9 && (level > 0) != (normalized > 0)) return false;
  }
  return true;
}

// ω of the whole shape by a system of R-functions, its primitives normalised to `order`.
Field whole(const Region& region, const RSystem& system, int order) {
  std::vector<std::shared_ptr<const Primitive>> primitives;
  for (const auto& primitive : region.primitives()) {
    Primitive copy = *primitive;
    if (order > 1 && !copy.selects_only)
      copy.function = normalize(copy.level, region.dimension(), order);
    primitives.push_back(std::make_shared<const Primitive>(copy));
  }
  return implicit(Region(region.dimension(), primitives, region.expression()), system);
}

TEST_P(EveryShape, KeepsItsOrderUnderEverySystemThatKeepsIt) {
  const Region& region = GetParam().region;
  std::vector<BoundaryPoint> points = points_of(region, true);
  std::erase_if(points, [&](const auto& point) { return !signs_agree(region, point.at, 3); });
  EXPECT_GE(points.size(), 3u);
  const UserSystem user{.name = "mine",
                        .conjunction = [](const Field& x, const Field& y) { return min(x, y); },
                        .normalization_order = every_order};
  for (const RSystem& system :
       std::vector<RSystem>{RAlpha{}, RAlpha{0.5}, RAlpha{-0.5}, R1{}, Rp{2}, Rp{4}, Rp{6},
                            RAlphaField{0.3 + 0.1 * cos(x_coordinate())}, RCm{1}, user}) {
    const int order = std::min(3, normalization_order(system));
    const Tape tape({whole(region, system, order)}, {order}, region.dimension());
    for (const BoundaryPoint& point : points) {
      const auto d = derivatives_along(tape, point.at, point.normal);
      EXPECT_NEAR(d[1], 1, 1e-11) << system;
      for (int k = 2; k <= order; ++k)
        EXPECT_NEAR(d[k], 0, k == 2 ? 1e-8 : 2e-6) << system << ", " << k;
    }
  }
}

TEST_P(EveryShape, KeepsItsSlopeWhenItsFunctionsAreShaped) {
  const Region& region = GetParam().region;
  for (const bool saturated : {true, false}) {
    std::vector<Tape> tapes;
    for (const auto& primitive : region.primitives())
      tapes.emplace_back(std::vector{saturated ? saturate(primitive->function, {2, 1.5})
                                               : cap(primitive->function, 0.2)},
                         std::vector{1}, region.dimension());
    for (const BoundaryPoint& point : points_of(region, true))
      EXPECT_NEAR(std::fabs(derivatives_along(tapes[point.primitive], point.at, point.normal)[1]),
                  1, 1e-12);
  }
}

}  // namespace
}  // namespace rfm
