#include "core/thin_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_functions.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;

double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }
Point mixed(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

double slope(const Field& f, const Point& at, int dimension) {
  const PointJet jet = evaluate(f, at, 1, dimension);
  return std::hypot(jet.derivative(1, 0, 0), jet.derivative(0, 1, 0),
                    dimension == 3 ? jet.derivative(0, 0, 1) : 0.0);
}

std::vector<double> hessian(const Field& f, const Point& at, int dimension) {
  const PointJet jet = evaluate(f, at, 2, dimension);
  std::vector<double> entries;
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; i + j <= 2; ++j)
      if (dimension == 3)
        entries.push_back(jet.derivative(i, j, 2 - i - j));
      else if (i + j == 2)
        entries.push_back(jet.derivative(i, j));
  return entries;
}

// Second derivatives on both sides of a place agree as those of a C² function do: their difference
// shrinks with the distance.
void expect_twice_differentiable(const Field& f, const Point& at, const Point& across,
                                 int dimension) {
  for (const double small : {1e-6, 1e-8}) {
    const auto before = hessian(
        f, mixed(at, {at[0] + across[0], at[1] + across[1], at[2] + across[2]}, -small), dimension);
    const auto after = hessian(
        f, mixed(at, {at[0] + across[0], at[1] + across[1], at[2] + across[2]}, small), dimension);
    for (std::size_t i = 0; i < before.size(); ++i) {
      ASSERT_TRUE(std::isfinite(before[i]) && std::isfinite(after[i]));
      EXPECT_NEAR(before[i], after[i], 2e3 * small);
    }
  }
}

const Point p{0.2, -0.1}, q{1.4, 0.8};

TEST(ThinSet, OfASegmentIsZeroExactlyOnItAndNormalised) {
  const Field omega = segment_set(p, q).function;
  for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0})
    EXPECT_NEAR(value_at(omega, mixed(p, q, t)), 0, 1e-15);
  for (const double t : {0.1, 0.5, 0.9}) EXPECT_NEAR(slope(omega, mixed(p, q, t), 2), 1, 1e-12);
  for (const double t : {-0.5, -1e-6, 1 + 1e-6, 1.7}) {
    const double beyond = 1.5 * (t < 0 ? -t : t - 1);
    const double value = value_at(omega, mixed(p, q, t));
    EXPECT_NEAR(value, beyond + beyond * beyond / 1.5, 1e-9);  // |λ| = (s² − L²/4)/L, s = L/2 + d
  }
  std::mt19937 generator(1);
  for (int i = 0; i < 300; ++i) {
    const Point at{generator() * 0x1p-31 - 0.5, generator() * 0x1p-31 - 0.5};
    EXPECT_GT(value_at(omega, at), 0);
  }
}

TEST(ThinSet, OfASegmentIsTwiceDifferentiableOffIt) {
  const ThinSet segment = segment_set(p, q);
  // On the circle λ = 0 and on the line beyond the ends.
  for (const double turn : {-1.9, -0.7, 0.5, 1.0, 1.6, 2.4}) {  // from the line
    const Point n{std::cos(turn + std::atan2(3, 4)), std::sin(turn + std::atan2(3, 4))};
    const Point at{0.8 + 0.75 * n[0], 0.35 + 0.75 * n[1]};
    EXPECT_NEAR(value_at(segment.where, at), 0, 1e-15);
    expect_twice_differentiable(segment.function, at, n, 2);
  }
  for (const double t : {-0.7, 1.3})
    expect_twice_differentiable(segment.function, mixed(p, q, t), {-0.6, 0.8}, 2);
}

TEST(ThinSet, OfASegmentInSpaceIsTheDistanceNextToIt) {
  const Point a{0.1, 0.2, 0.3}, b{1, -0.5, 1.1};
  const Field omega = segment_set(a, b, 3).function;
  for (const double t : {0.0, 0.25, 1.0}) EXPECT_NEAR(value_at(omega, mixed(a, b, t)), 0, 1e-15);
  const Point axis{0.9, -0.7, 0.8}, normal{0.7 / std::hypot(0.7, 0.9), 0.9 / std::hypot(0.7, 0.9)};
  for (const double t : {0.3, 0.7})
    for (const double d : {1e-9, 1e-6, 1e-3}) {
      const Point on = mixed(a, b, t);
      const double value = value_at(omega, {on[0] + d * normal[0], on[1] + d * normal[1], on[2]});
      EXPECT_NEAR(value, d, 1e-15 + d * 10 * std::pow(d, 6));
    }
  EXPECT_GT(value_at(omega, mixed(a, b, -1e-3)), 1e-3 * length(axis));
  expect_twice_differentiable(omega, mixed(a, b, 1.4), normal, 3);
}

TEST(ThinSet, OfAnArcIsTrimmedByItsChord) {
  for (const double to : {0.9, 2.5, 4.5, 6.0}) {  // below and above half a turn
    const ThinSet arc = arc_set({1, 2}, 0.5, 0.3, to);
    for (double angle = 0.31; angle < 6.5; angle += 0.1) {
      const Point at{1 + 0.5 * std::cos(angle), 2 + 0.5 * std::sin(angle)};
      if (angle < to) {
        EXPECT_NEAR(value_at(arc.function, at), 0, 1e-15) << angle;
      } else if (angle < 0.29 + 2 * pi) {
        EXPECT_GT(value_at(arc.function, at), 1e-5) << angle;
      }
    }
    const double middle = 0.5 * (0.3 + to);
    const Point at{1 + 0.5 * std::cos(middle), 2 + 0.5 * std::sin(middle)};
    EXPECT_NEAR(slope(arc.function, at, 2), 1, 1e-12);
  }
  const Field circle = arc_set({0, 0}, 1, 0, 2 * pi).function;
  for (double angle = 0; angle < 7; angle += 0.5)
    EXPECT_NEAR(value_at(circle, {std::cos(angle), std::sin(angle)}), 0, 1e-15);
}

const Point corners[] = {{0, 0, 0}, {2, 0, 0}, {0.5, 1.5, 0}};

TEST(ThinSet, OfATriangleIsZeroExactlyOnItAndNormalised) {
  const ThinSet triangle = triangle_set(corners[0], corners[1], corners[2]);
  for (double s = 0.05; s < 1; s += 0.15)
    for (double t = 0.05; s + t < 1; t += 0.15) {
      const Point at{2 * s + 0.5 * t, 1.5 * t, 0};
      EXPECT_EQ(value_at(triangle.function, at), 0);
      EXPECT_NEAR(slope(triangle.function, at, 3), 1, 1e-12);
    }
  for (const Point& outside : {Point{-0.1, 0.3, 0}, Point{1, -1e-3, 0}, Point{2, 1, 0},
                               Point{0.8, 0.4, 1e-6}, Point{0.8, 0.4, -2}})
    EXPECT_GT(value_at(triangle.function, outside), 1e-7);
}

TEST(ThinSet, OfATriangleIsTwiceDifferentiableAboveItsCornersForAnyParameters) {
  for (const ConditionalOptions options :
       {ConditionalOptions{1, 2}, ConditionalOptions{0.3, 2}, ConditionalOptions{2, 4}}) {
    const Field omega = triangle_set(corners[0], corners[1], corners[2], options).function;
    for (const Point& corner : corners)
      for (const double z : {-0.4, 0.3, 1.0})
        expect_twice_differentiable(omega, {corner[0], corner[1], z}, {0.6, -0.8, 0}, 3);
    expect_twice_differentiable(omega, {-0.3, -0.2, 0}, {0, 0, 1}, 3);
  }
  // R₀ itself leaves a kink above every corner: what the condition is for.
  const ThinSet set = triangle_set(corners[0], corners[1], corners[2]);
  const Field sharp = conjunction(set.ends[0], set.ends[2]);
  const auto largest = [&](const Point& at) {
    double most = 0;
    for (const double entry : hessian(sharp, at, 3)) most = std::max(most, std::fabs(entry));
    return most;
  };
  EXPECT_GT(largest({-1e-6, -2e-6, 0.5}), 1e3);
}

TEST(ThinSet, JoinedIsTheClosedFormOfEquivalence) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0.2, 1.4}};
  for (const int order : {1, 2, 4}) {
    const Field omega = polyline_function(points, 2, order);
    for (const Point& at : {Point{0.4, 0.3}, Point{-1, 2}, Point{1.2, 0.1}}) {
      double sum = 0;
      for (int i = 0; i < 3; ++i)
        sum += std::pow(value_at(segment_set(points[i], points[i + 1]).function, at), -order);
      const double expected = std::pow(sum, -1.0 / order);
      EXPECT_NEAR(value_at(omega, at), expected, 1e-14 * expected);
    }
    for (int i = 0; i < 3; ++i) {
      const Point on = mixed(points[i], points[i + 1], 0.4);
      EXPECT_NEAR(value_at(omega, on), 0, 1e-15);
      EXPECT_NEAR(slope(omega, {on[0] + 1e-9, on[1] + 1e-9}, 2), 1, 1e-7);
    }
  }
}

TEST(ThinSet, TrimmingConjunctionIsR0OnTheSurfaceAndBelowItElsewhere) {
  const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
  const Field f = trimming_conjunction({x, y}, z, {0.7, 4});
  for (const double a : {-1.0, -1e-3, 0.2, 3.0})
    for (const double b : {-2.0, 1e-6, 0.5}) {
      const double exact = a + b - std::hypot(a, b);
      EXPECT_NEAR(value_at(f, {a, b, 0}), exact, 1e-15 * (1 + std::fabs(exact)));
      const double off = a + b - std::sqrt(a * a + b * b + 0.7 * 0.0625);
      EXPECT_NEAR(value_at(f, {a, b, -0.5}), off, 4e-15 * (1 + std::fabs(off)));
    }
  EXPECT_THROW(trimming_conjunction({x, y}, z, {0, 2}), InvalidArgument);
  EXPECT_THROW(trimming_conjunction({x, y}, z, {1, 3}), InvalidArgument);
}

TEST(ThinSet, DegenerateSetsAreRefused) {
  EXPECT_THROW(segment_set({1, 1}, {1, 1}), InvalidArgument);
  EXPECT_THROW(arc_set({0, 0}, 0, 0, 1), InvalidArgument);
  EXPECT_THROW(arc_set({0, 0}, 1, 1, 1), InvalidArgument);
  EXPECT_THROW(arc_set({0, 0}, 1, 0, 7), InvalidArgument);
  EXPECT_THROW(triangle_set({0, 0, 0}, {1, 1, 1}, {3, 3, 3}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
