#include "core/normalization_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/curved_polygon.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/polygon.hpp"
#include "core/primitives.hpp"
#include "core/profile_bodies.hpp"
#include "core/r_functions.hpp"
#include "core/thin_set.hpp"

namespace rfm {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

double length_of(const Field& f, int dimension = 2) {
  return rfm::length_of(*as_quadric(f, dimension));
}

TEST(NormalizationLength, IsTheFormula49InLengths) {
  const Field f = 1.0 - x * x - 4.0 * y * y;
  for (const double length : {0.5, 3.0})
    for (const Point& at : {Point{0.3, 0.1}, Point{0, 0}, Point{2, -1}}) {
      const double value = value_at(f, at), slope = std::hypot(2 * at[0], 8 * at[1]);
      EXPECT_NEAR(value_at(normalize_within(f, length, 2), at),
                  value / std::hypot(value / length, slope), 1e-15);
    }
  EXPECT_NEAR(value_at(normalize_within(f, infinite, 2), {2, -1}), -7 / std::hypot(4, 8), 1e-15);
  EXPECT_THROW(normalize_within(f, 0, 2), InvalidArgument);
}

TEST(NormalizationLength, LevelsOffAtTheLength) {
  const Field f = 1.0 - x * x - 4.0 * y * y;
  EXPECT_NEAR(value_at(normalize_within(f, 0.5, 2), {0, 0}), 0.5, 1e-15);
  EXPECT_NEAR(value_at(implicit(ellipse({2, 1}, {3, 0.7})), {2, 1}), 0.7, 1e-15);
  EXPECT_NEAR(value_at(implicit(ellipsoid({2, 1, 0}, {3, 2, 0.7})), {2, 1, 0}), 0.7, 1e-15);
}

TEST(NormalizationLength, OfConicsIsTheirSmallerSize) {
  // |A| = √(1 + 1/16) of x²/4 + y² = 1.
  EXPECT_NEAR(length_of(1.0 - x * x / 4 - y * y), std::pow(1 + 1.0 / 16, -0.25), 1e-14);
  EXPECT_NEAR(length_of(9.0 - pow(x - 5, 2) / 4 - pow(y + 7, 2)), 3 * std::pow(17.0 / 16, -0.25),
              1e-13);
  EXPECT_NEAR(length_of(y - 2.0 * pow(x - 3, 2)), 0.5, 1e-14);
  EXPECT_EQ(length_of(x - 2.0 * y), infinite);
  EXPECT_EQ(length_of(x * y), infinite);
  EXPECT_EQ(length_of(z * z - x * x - y * y, 3), infinite);
}

struct Shape {
  const char* name;
  Region (*of_size)(double);
  Point at;
};

TEST(NormalizationLength, MakesFunctionsOfShapesProportionalToTheirSize) {
  const Shape shapes[] = {{"ellipse",
                           [](double L) {
                             return ellipse({0, 0}, {2 * L, L}, 0.3);
                           },
                           {0.2, 0.1}},
                          {"conic",
                           [](double L) {
                             return quadric({-1 / (L * L), 0, -4 / (L * L), 0, 0, 1});
                           },
                           {0.2, 0.1}},
                          {"parabola",
                           [](double L) {
                             return quadric({-1, 0.2, -0.01, 0, 3 * L, L * L});
                           },
                           {0.2, 0.1}},
                          {"ellipsoid",
                           [](double L) {
                             return ellipsoid({0, 0, 0}, {2 * L, L, L});
                           },
                           {0.2, 0.1, 0.1}},
                          {"torus",
                           [](double L) {
                             return torus({0, 0, 0}, {0, 0, 1}, 2 * L, 0.5 * L);
                           },
                           {2.1, 0.1, 0.1}},
                          {"cone",
                           [](double L) {
                             return cone({0, 0, 0}, {0, 0, 1}, 0.5, L);
                           },
                           {0.1, 0.1, 0.6}},
                          {"turned ring",
                           [](double L) {
                             return revolution(circle({2 * L, 0}, L * 0.5));
                           },
                           {2.1, 0.1, 0.1}},
                          {"turned disk",
                           [](double L) {
                             return revolution(circle({0.2 * L, 0}, L * 0.4));
                           },
                           {0.3, 0.1, 0.1}},
                          {"turned ellipse",
                           [](double L) {
                             return revolution(ellipse({2 * L, 0}, {L * 0.5, L * 0.3}, 0.2));
                           },
                           {2.1, 0.1, 0.1}},
                          {"turned triangle",
                           [](double L) {
                             return revolution(polygon({{L, 0}, {2 * L, 0.1 * L}, {1.2 * L, L}}));
                           },
                           {1.3, 0.3, 0.3}},
                          {"conic edge",
                           [](double L) {
                             const EdgeCurve::Conic conic{{0, 1.3 * L}, 0.7};
                             return curved_polygon({{{{-L, -L}, {L, -L}, {L, L}, {-L, L}},
                                                     {{}, {}, {.conic = conic}, {}}}})
                                 .region;
                           },
                           {0.3, 0.8}}};
  for (const Shape& shape : shapes) {
    const auto value = [&](double size) {
      const Point at{shape.at[0] * size, shape.at[1] * size, shape.at[2] * size};
      return value_at(implicit(shape.of_size(size)), at) / size;
    };
    const double expected = value(1);
    EXPECT_GT(std::fabs(expected), 0.01) << shape.name;
    for (const double size : {1e-6, 1e-3, 1e3, 1e6})
      EXPECT_NEAR(value(size), expected, 1e-10 * std::fabs(expected)) << shape.name << ", " << size;
  }
}

TEST(NormalizationLength, MakesFunctionsOfSetsProportionalToTheirSize) {
  using Make = ThinSet (*)(double);
  const Make sets[] = {
      [](double L) {
        return segment_set({0, 0}, {L, 0.2 * L});
      },
      [](double L) {
        return segment_set({0, 0, 0}, {L, 0.2 * L, 0.1 * L}, 3);
      },
      [](double L) {
        return arc_set({0, 0}, L, 0.3, 2);
      },
      [](double L) {
        return triangle_set({0, 0, 0}, {L, 0, 0}, {0, L, 0.2 * L});
      },
      [](double L) { return level_curve_set(L * L - x * x - 2.0 * y * y, x - 0.1 * L, 2); }};
  for (const Point& at : {Point{0.3, 0.4, 0.1}, Point{1.5, -0.3, 0.2}, Point{-0.4, 0.6, 0.7}})
    for (const Make& set : sets) {
      const auto value = [&](double size) {
        return value_at(set(size).function, {at[0] * size, at[1] * size, at[2] * size}) / size;
      };
      for (const double size : {1e-6, 1e-3, 1e3, 1e6})
        EXPECT_NEAR(value(size), value(1), 1e-10 * value(1)) << &set - sets << ", " << size;
    }
}

}  // namespace
}  // namespace rfm
