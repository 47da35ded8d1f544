#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/quadric.hpp"

namespace rfm {
namespace {

struct Sample {
  Quadric quadric;
  Line line;
};

Sample random_sample(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  Sample sample;
  for (auto* numbers : {&sample.quadric.origin, &sample.quadric.linear, &sample.line.origin,
                        &sample.line.direction})
    for (double& number : *numbers) number = uniform(generator);
  for (double& a : sample.quadric.square) a = uniform(generator);
  sample.quadric.constant = uniform(generator);
  return sample;
}

TEST(QuadricLine, AlongALineAQuadricIsItsPolynomial) {
  std::mt19937 generator(1);
  for (int trial = 0; trial < 200; ++trial) {
    const auto [quadric, line] = random_sample(generator);
    const LinePolynomial polynomial = quadric.along(line);
    for (const double t : {-1.5, 0.0, 0.25, 2.0}) {
      const double size = 200 * (1 + t * t);  // the largest terms
      EXPECT_NEAR(polynomial.value(t), quadric.value(line.at(t)), 1e-15 * size);
      double slope = 0;
      for (int axis = 0; axis < 3; ++axis)
        slope += quadric.slope(line.at(t), axis) * line.direction[axis];
      EXPECT_NEAR(polynomial.linear + 2 * polynomial.square * t, slope, 1e-15 * size);
    }
  }
}

TEST(QuadricLine, BoundsHoldValueAndSlopeAndAreOfSecondOrder) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const auto [quadric, line] = random_sample(generator);
    const double radius = std::pow(0.5, trial % 12), middle = 2 * uniform(generator) - 1;
    const LineBounds bounds = quadric.bounds(line, {middle - radius, middle + radius});
    const LinePolynomial p = quadric.along(line);
    for (int i = 0; i < 20; ++i) {
      const double t = middle + radius * (2 * uniform(generator) - 1);
      EXPECT_TRUE(bounds.value.contains(p.value(t)));
      EXPECT_TRUE(bounds.slope.contains(p.linear + 2 * p.square * t));
    }
    // The range of b t + a t² is narrower than the bounds by 2 |a| r² at most.
    const double slope = std::fabs(p.linear + 2 * p.square * middle);
    EXPECT_LE(bounds.value.width(),
              2 * radius * slope + 2 * std::fabs(p.square) * radius * radius + 1e-12);
    EXPECT_LE(bounds.slope.width(), 4 * std::fabs(p.square) * radius + 1e-12);
  }
}

}  // namespace
}  // namespace rfm
