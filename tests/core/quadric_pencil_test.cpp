#include "core/quadric_pencil.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "core/primitives.hpp"

namespace rfm {
namespace {

Quadric quadric_of(const Region& shape) {
  return *as_quadric(shape.primitives().at(0)->level, shape.dimension());
}

bool are_apart(const Region& a, const Region& b, const Box& box) {
  const Quadric f = quadric_of(a), g = quadric_of(b);
  return are_apart(&f, &g, box);
}

const Box plane{2, {-1.3, -1.1, 0}, {1.2, 1.4, 0}}, space{3, {-1.3, -1.1, -1.2}, {1.2, 1.4, 1.5}};

TEST(QuadricPencil, TellsConcentricShapesApartDownToRounding) {
  for (const double gap : {0.5, 1e-3, 1e-8, 1e-13}) {
    const Point centre{0.1, -0.2, 0.3};
    EXPECT_TRUE(are_apart(circle(centre, 1), circle(centre, 1 + gap), plane)) << gap;
    EXPECT_TRUE(are_apart(sphere(centre, 1 + gap), sphere(centre, 1), space)) << gap;
    EXPECT_TRUE(are_apart(half_plane({0, 0}, {1, 2}), half_plane({gap, 2 * gap}, {-3, -6}), plane))
        << gap;
  }
  const Point centre{0.1, -0.2, 0.3}, radii{0.9, 0.5, 0.7};
  const Point wider{0.9 * (1 + 1e-8), 0.5 * (1 + 1e-8), 0.7 * (1 + 1e-8)};
  EXPECT_TRUE(are_apart(ellipsoid(centre, radii, {1, 2, 3}, 0.4),
                        ellipsoid(centre, wider, {1, 2, 3}, 0.4), space));
}

// Of quadrics through one point, in every box around it however small.
TEST(QuadricPencil, NeverSeparatesWhatMeets) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const Point common{uniform(random), uniform(random), uniform(random)};
    const auto through = [&] {
      const Point centre{uniform(random), uniform(random), uniform(random)};
      Quadric quadric;
      quadric.origin = centre;
      for (double& entry : quadric.square) entry = uniform(random);
      for (double& entry : quadric.linear) entry = uniform(random);
      quadric.constant = -quadric.value(common);  // zero there, up to rounding
      return quadric;
    };
    const Quadric f = through(), g = through();
    const double size = std::pow(10.0, -6 * std::fabs(uniform(random)));
    Box box{3, common, common};
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] -= size * std::fabs(uniform(random)) + 1e-14;
      box.high[axis] += size * std::fabs(uniform(random)) + 1e-14;
    }
    EXPECT_FALSE(are_apart(&f, &g, box)) << i;
  }
  // Touching, equal, and crossing as far away as the box reaches.
  EXPECT_FALSE(are_apart(circle({0, 0}, 1), circle({0.5, 0}, 0.5), plane));
  EXPECT_FALSE(are_apart(circle({0, 0}, 1), circle({0, 0}, 1), plane));
  EXPECT_FALSE(are_apart(half_plane({0, 0}, {0, 1}), half_plane({1.19, 0}, {0.01, 1}), plane));
}

TEST(QuadricPencil, KnowsNothingOfOtherFunctions) {
  const Quadric circle_alone = quadric_of(circle({0, 0}, 1));
  EXPECT_FALSE(are_apart(&circle_alone, nullptr, plane));
  EXPECT_FALSE(are_apart(nullptr, &circle_alone, plane));
}

// At points of the box where f has the sign named, g has the sign that follows.
TEST(QuadricPencil, ImpliesOnlySignsThatFollow) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<int, 4> kinds{};
  for (int i = 0; i < 4000; ++i) {
    const auto any = [&] {
      Quadric quadric;
      for (double& entry : quadric.linear) entry = uniform(random);
      for (double& entry : quadric.square) entry = 0.2 * uniform(random);
      quadric.constant = 0.5 * uniform(random);
      return quadric;
    };
    const Quadric f = any(), g = any();
    const double size = 0.05 + 0.3 * std::fabs(uniform(random));
    const Box box{3, {-size, -size, -size}, {size, size, size}};
    const auto implied = implied_signs(&f, &g, box);
    EXPECT_EQ(implied.has_value(), are_apart(&f, &g, box));
    if (!implied) continue;
    ++kinds[2 * implied->of_f + implied->of_g];
    for (int k = 0; k < 200; ++k) {
      const Point x{size * uniform(random), size * uniform(random), size * uniform(random)};
      const double of_f = f.value(x), of_g = g.value(x);
      if (implied->of_f ? of_f >= 0 : of_f <= 0) {
        EXPECT_TRUE(implied->of_g ? of_g > 0 : of_g < 0);
      }
    }
  }
  for (const int count : kinds) EXPECT_GT(count, 50) << "each of the four kinds is met";
}

}  // namespace
}  // namespace rfm
