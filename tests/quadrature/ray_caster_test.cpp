#include "quadrature/ray_caster.hpp"

#include <gmock/gmock.h>

#include <random>

#include "core/primitives.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using test::pi;

namespace {

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

Line towards(const Point& from, const Point& target) {
  const Point d = target - from;
  const double l = length(d);
  return {from, {d[0] / l, d[1] / l, d[2] / l}};
}

Box cube(double half, int dimension) {
  return {dimension, {-half, -half, -half}, {half, half, half}};
}

struct Scene {
  explicit Scene(const Region& region)
      : evaluator(region), rays(evaluator, cube(2.5, region.dimension())) {}
  std::optional<RayHit> operator()(const Line& ray) const { return rays.first_entry(ray); }
  std::string hit_name(const Line& ray) const {
    const auto hit = rays.first_entry(ray);
    return hit ? evaluator.region().primitives()[hit->primitive]->name : "nothing";
  }

  RegionEvaluator evaluator;
  RayCaster rays;
};

/// A ray from outside the ball of radius 10 through a random point of [−1.2, 1.2]³.
template <class Random>
Line random_ray(Random& random) {
  std::uniform_real_distribution<double> side(-1.2, 1.2), angle(-1, 1);
  Point outward{angle(random), angle(random), angle(random)};
  const double scale = 10 / length(outward);
  const Point target{side(random), side(random), side(random)};
  return towards({scale * outward[0], scale * outward[1], scale * outward[2]}, target);
}

TEST(RayCaster, MeetsASphereWhereTheQuadraticFormulaSays) {
  const Scene scene(sphere({0.1, -0.2, 0.3}, 0.8));
  std::mt19937 random(1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Line ray = random_ray(random);
    const Point to_center = Point{0.1, -0.2, 0.3} - ray.origin;
    const double along = dot(to_center, ray.direction);
    const double distance_squared = dot(to_center, to_center) - along * along;
    const auto hit = scene(ray);
    ASSERT_EQ(hit.has_value(), distance_squared < 0.64);
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->position, along - std::sqrt(0.64 - distance_squared), 1e-12);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(hit->normal[axis], (hit->point[axis] - Point{0.1, -0.2, 0.3}[axis]) / 0.8, 1e-12);
  }
  EXPECT_GT(hits, 500);
}

TEST(RayCaster, MeetsATorusOnTheCirclesOfItsSections) {
  // Rays in the plane through the axis meet two circles of radius 0.3 about (±1, 0); rays along
  // z = h in the plane of the middle circle two circles of radius 1 ± √(0.09 − h²).
  const Scene scene(torus({0, 0, 0}, {0, 0, 1}, 1, 0.3));
  for (const double height : {-0.29, -0.1, 0.0, 0.2, 0.299999}) {
    const double outer = 1 + std::sqrt(0.09 - height * height), inner = 2 - outer;
    for (const double offset : {0.0, 0.3, 0.9, 1.1}) {
      const auto hit = scene({{5, offset, height}, {-1, 0, 0}});
      ASSERT_EQ(hit.has_value(), offset < outer);
      if (hit) {
        EXPECT_NEAR(hit->point[0], std::sqrt(outer * outer - offset * offset), 1e-12);
      }
      // From within the hole.
      if (offset >= inner) continue;
      const auto from_hole = scene({{0, offset, height}, {-1, 0, 0}});
      ASSERT_TRUE(from_hole);
      EXPECT_NEAR(from_hole->point[0], -std::sqrt(inner * inner - offset * offset), 1e-12);
      EXPECT_GT(from_hole->normal[0], 0);
    }
  }
}

TEST(RayCaster, NamesTheFaceOfABoxAndItsNormal) {
  const Scene scene(box({-1, -1, 0}, {0, 1, 2}, 3));
  const Point low{-1, -1, 0}, high{0, 1, 2};
  const std::array<Point, 6> outward{
      {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
  const std::array<std::string, 6> names{"left", "right", "bottom", "top", "back", "front"};
  for (std::size_t face = 0; face < 6; ++face) {
    Point target{-0.7, 0.8, 1.7};
    for (int axis = 0; axis < 3; ++axis)
      if (outward[face][axis] != 0) target[axis] = outward[face][axis] > 0 ? high[axis] : low[axis];
    Point from = target;
    for (int axis = 0; axis < 3; ++axis) from[axis] += 7 * outward[face][axis] + 0.01 * axis;
    const Line ray = towards(from, target);
    const auto hit = scene(ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(scene.hit_name(ray), names[face]);
    EXPECT_LT(length(hit->point - target), 1e-13);
    EXPECT_EQ(hit->normal, outward[face]);
  }
}

TEST(RayCaster, MeetsSideAndFlatEndsOfACylinder) {
  const Scene scene(cylinder({0, 0, 0}, {0, 0, 1}, 0.5, 2));
  const auto end = scene({{0.3, 0.2, 9}, {0, 0, -1}});
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->point[2], 1, 1e-14);
  EXPECT_NEAR(end->normal[2], 1, 1e-14);
  const auto side = scene({{9, 0.3, 0.7}, {-1, 0, 0}});
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->point[0], 0.4, 1e-14);
  EXPECT_NEAR(side->normal[0], 0.8, 1e-14);
  EXPECT_NEAR(side->normal[1], 0.6, 1e-14);
  EXPECT_FALSE(scene({{9, 0.3, 1 + 1e-9}, {-1, 0, 0}}));
  EXPECT_TRUE(scene({{9, 0.3, 1 - 1e-9}, {-1, 0, 0}}));
}

TEST(RayCaster, SeesTheFarWallThroughAHole) {
  // A ball with a bore along x from the outside to an inner ball.
  const Scene scene(
      (sphere({0, 0, 0}, 1).named("outer") - sphere({0, 0, 0}, 0.6).named("inner")) -
      (cylinder({0, 0, 0}, {1, 0, 0}, 0.2) & half_space({0, 0, 0}, {1, 0, 0})).named("bore"));
  const Line through{{5, 0.1, 0.05}, {-1, 0, 0}};
  const auto hit = scene(through);
  ASSERT_TRUE(hit);
  EXPECT_EQ(scene.hit_name(through), "inner");
  EXPECT_NEAR(hit->point[0], -std::sqrt(0.36 - 0.0125), 1e-14);
  EXPECT_GT(hit->normal[0], 0);
  EXPECT_EQ(scene.hit_name({{5, 0.21, 0}, {-1, 0, 0}}), "outer");
  EXPECT_EQ(scene.hit_name(towards({5, 0, 0}, {0.8, 0.2, 0})), "bore.side");
}

TEST(RayCaster, MissesNoWallOfThickness1e_6) {
  // Half a shell: from the cut side rays meet its inside; a wall seen from its edge is 10⁻⁶ wide.
  const double inner = 1 - 1e-6;
  const Scene scene(
      (sphere({0, 0, 0}, 1).named("outer") - sphere({0, 0, 0}, inner).named("inner")) &
      half_space({0, 0, 0}, {-1, 0, 0}).named("cut"));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(-0.7, 0.7);
  for (int i = 0; i < 2000; ++i) {
    const double y = part(random), z = part(random);
    const auto from_inside = scene({{3, y, z}, {-1, 0, 0}});
    ASSERT_TRUE(from_inside);
    EXPECT_NEAR(from_inside->point[0], -std::sqrt(inner * inner - y * y - z * z), 1e-13);
    const auto from_outside = scene({{-3, y, z}, {1, 0, 0}});
    ASSERT_TRUE(from_outside);
    EXPECT_NEAR(from_outside->point[0], -std::sqrt(1 - y * y - z * z), 1e-13);
    const double angle = pi * part(random), middle = 1 - 0.5e-6;
    EXPECT_EQ(scene.hit_name({{3, middle * std::cos(angle), middle * std::sin(angle)}, {-1, 0, 0}}),
              "cut");
  }
}

TEST(RayCaster, TellsAGrazingRayFromOneThatPasses) {
  const Scene ball(sphere({0, 0, 0}, 1));
  const Scene ring(torus({0, 0, 0}, {0, 0, 1}, 0.7, 0.3));
  for (const Scene* scene : {&ball, &ring}) {
    const double top = scene == &ball ? 1 : 0.3, middle = scene == &ball ? 0 : 0.7;
    for (const double angle : {0.0, 0.4, 1.2}) {
      const Point direction{-std::cos(angle), -std::sin(angle), 0};
      for (const double gap : {1e-3, 1e-6, 1e-9, 1e-11}) {
        Point from{middle - 3 * direction[0], -3 * direction[1], top + gap};
        EXPECT_FALSE((*scene)({from, direction})) << gap;
        from[2] = top - gap;
        const auto hit = (*scene)({from, direction});
        ASSERT_TRUE(hit) << gap << " at angle " << angle;
        EXPECT_NEAR(hit->point[2], top - gap, 1e-14);
      }
    }
  }
}

TEST(RayCaster, FindsTheCutFaceOfAFunctionThatIsNoPolynomial) {
  // A gyroid in a ball, halved by a plane: on the plane x = 0 it is inside where
  // sin y cos z + sin z ≥ 0 (arguments times 4).
  const Field x = 4 * x_coordinate(), y = 4 * y_coordinate(), z = 4 * z_coordinate();
  const Region gyroid = level_set(sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x), 3);
  const Scene scene((gyroid.named("gyroid") & sphere({0, 0, 0}, 1).named("ball")) &
                    half_space({0, 0, 0}, {-1, 0, 0}).named("cut"));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-0.7, 0.7);
  for (int i = 0; i < 1000; ++i) {
    const double b = part(random), c = part(random);
    const double level = std::sin(4 * b) * std::cos(4 * c) + std::sin(4 * c);
    if (std::fabs(level) < 1e-9) continue;
    const Line ray{{2, b, c}, {-1, 0, 0}};
    const auto hit = scene(ray);
    if (level > 0) {
      ASSERT_TRUE(hit);
      EXPECT_EQ(scene.hit_name(ray), "cut");
      EXPECT_NEAR(hit->point[0], 0, 1e-15);
    } else if (hit) {
      EXPECT_LT(hit->point[0], 0);
      EXPECT_NE(scene.hit_name(ray), "cut");
    }
  }
}

TEST(RayCaster, NeverEntersEarlierOrLaterThanDenseSamplesSay) {
  const Field x = 5 * x_coordinate(), y = 5 * y_coordinate(), z = 5 * z_coordinate();
  const Region gyroid = level_set(sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x) - 0.2, 3);
  const Region block = box({-0.9, -0.8, -0.7}, {0.8, 0.9, 0.6}, 3);
  const std::vector<Region> regions{
      gyroid & block, block ^ torus({0.2, 0, 0}, {1, 1, 0}, 0.8, 0.25),
      (cone({0, 0, 1}, {0, 0, -1}, 0.5, 1.5) | cylinder({0, 0, 0}, {0, 1, 1}, 0.2, 2)) -
          sphere({0.3, 0, 0}, 0.35),
      ellipsoid({0, 0, 0}, {1, 0.5, 0.2}, {1, 1, 1}, 0.7) - torus({0, 0, 0}, {0, 0, 1}, 0.4, 0.1)};
  std::mt19937 random(4);
  constexpr int samples = 4000;
  for (const Region& region : regions) {
    const Scene scene(region);
    int hits = 0;
    for (int i = 0; i < 250; ++i) {
      const Line ray = random_ray(random);
      const auto hit = scene(ray);
      const double end = hit ? hit->position : 13;
      for (int s = 0; s < samples; ++s) {
        const double t = 7 + (end - 1e-10 - 7) * s / (samples - 1);
        ASSERT_FALSE(scene.evaluator.contains(ray.at(t)))
            << "inside at " << t << ", but the first entry is " << end;
      }
      if (!hit) continue;
      ++hits;
      EXPECT_TRUE(scene.evaluator.contains(ray.at(end + 1e-10)));
      EXPECT_LT(dot(hit->normal, ray.direction), 0);
      EXPECT_NEAR(length(hit->normal), 1, 1e-14);
    }
    EXPECT_GT(hits, 30);
  }
}

TEST(RayCaster, MeetsFacesThatCoincideOnce) {
  // Two boxes share the face x = 0; what is subtracted ends on it too.
  const Region left = box({-1, -1, -1}, {0, 1, 1}, 3), right = box({0, -1, -1}, {1, 1, 1}, 3);
  const Scene both(left.named("a") | right.named("b"));
  const auto hit = both({{3, 0.2, 0.1}, {-1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point[0], 1, 1e-14);
  const Scene rest((left.named("a") | right.named("b")) -
                   box({0, -2, -2}, {2, 2, 2}, 3).named("c"));
  const auto cut = rest({{3, 0.2, 0.1}, {-1, 0, 0}});
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->point[0], 0, 1e-14);
  EXPECT_EQ(cut->normal, (Point{1, 0, 0}));
}

TEST(RayCaster, MeetsWhatBeginsInAPlaneThatHalvesTheBounds) {
  // Parts of space end in the plane y = 0, in which the upper half of a tube begins. Outside the
  // tube rays pass the plane and meet the wall, whatever the rounding of their place on it.
  const Scene scene((cylinder({0, 0, 0}, {0, 0, 1}, 1, 4).named("tube") -
                     cylinder({0, 0, 0}, {0, 0, 1}, 0.5).named("bore")) &
                    half_space({0, 0, 0}, {0, 1, 0}).named("cut"));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  for (int i = 0; i < 20000; ++i) {
    const double x = place(random), z = place(random);
    const Line ray = towards({3 + x, -7, 2}, {x, 0, z});  // through the plane y = 0
    const auto hit = scene(ray);
    const double radius = std::fabs(x);
    if (std::fabs(radius - 1) < 1e-9 || std::fabs(radius - 0.5) < 1e-9) continue;
    if (radius > 0.5 && radius < 1) {
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->point[1], 0, 1e-14);
      EXPECT_EQ(scene.hit_name(ray), "cut");
    } else if (radius < 0.5) {
      ASSERT_TRUE(hit) << x << " " << z;
      EXPECT_NEAR(std::hypot(hit->point[0], hit->point[1]), 0.5, 1e-13);
      EXPECT_EQ(scene.hit_name(ray), "bore.side");
    } else if (hit) {
      EXPECT_NEAR(std::hypot(hit->point[0], hit->point[1]), 1, 1e-13);
    }
  }
}

TEST(RayCaster, OfARayThatStartsInsideIsItsStart) {
  const Scene scene(sphere({0, 0, 0}, 1));
  const auto hit = scene({{0.3, 0, 0}, {0, 0, 1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->primitive, RayHit::none);
  EXPECT_EQ(hit->position, 0);
}

TEST(RayCaster, WorksInThePlane) {
  const Scene scene(circle({0, 0}, 1) - circle({0.5, 0}, 0.2));
  const auto hit = scene({{3, 0.6, 0}, {-1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point[0], 0.8, 1e-14);
  const auto from_hole = scene({{0.5, 0, 0}, {-1, 0, 0}});
  ASSERT_TRUE(from_hole);
  EXPECT_NEAR(from_hole->point[0], 0.3, 1e-14);
}

}  // namespace
