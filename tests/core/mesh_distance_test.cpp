#include "core/mesh_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

// The square [0, 1]² in the plane z = 0 in 2 n² triangles.
std::vector<Triangle> square(int n) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto at = [n](int a, int b) { return Point{double(a) / n, double(b) / n, 0}; };
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return triangles;
}

double exact(const Point& p) {
  double sum = p[2] * p[2];
  for (int axis = 0; axis < 2; ++axis) sum += std::pow(std::max({0.0, -p[axis], p[axis] - 1}), 2);
  return sum;
}

TEST(MeshDistance, IsThatOfTheSquareWhateverItsTriangles) {
  std::mt19937 generator(1);
  const auto uniform = [&] { return -1 + 3 * 0x1p-32 * generator(); };
  for (const int n : {1, 2, 7}) {
    const Field distance = field(std::make_shared<const MeshSquareDistance>(square(n)));
    for (int i = 0; i < 300; ++i) {
      const Point at{uniform(), uniform(), uniform()};
      const PointJet jet = evaluate(distance, at, 2);
      EXPECT_NEAR(jet.value(), exact(at), 1e-14);
      const bool beside[] = {at[0] > 0 && at[0]<1, at[1]> 0 && at[1] < 1, false};
      for (int axis = 0; axis < 3; ++axis) {
        const double nearest = axis < 2 ? std::min(1.0, std::max(0.0, at[axis])) : 0.0;
        const int k[] = {axis == 0, axis == 1, axis == 2};
        EXPECT_NEAR(jet.derivative(k[0], k[1], k[2]), 2 * (at[axis] - nearest), 1e-14);
        EXPECT_NEAR(jet.derivative(2 * k[0], 2 * k[1], 2 * k[2]), beside[axis] ? 0 : 2, 1e-14);
      }
      EXPECT_NEAR(jet.derivative(1, 1, 0), 0, 1e-14);
    }
  }
}

TEST(MeshDistance, BoundsHoldAndAreOfSecondOrder) {
  const MeshSquareDistance source(square(3));
  std::mt19937 generator(2);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * 0x1p-32 * generator();
  };
  for (int i = 0; i < 300; ++i) {
    const double side = std::pow(10.0, uniform(-4, -0.3));
    Box box{3, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = uniform(-1, 2);
      box.high[axis] = box.low[axis] + side;
    }
    const FunctionBounds bounds = source.bounds(box);
    double least = 1e9, most = 0;
    for (int j = 0; j < 40; ++j) {
      const Point at{uniform(box.low[0], box.high[0]), uniform(box.low[1], box.high[1]),
                     uniform(box.low[2], box.high[2])};
      const double value = exact(at);
      EXPECT_TRUE(bounds.value.contains(value));
      least = std::min(least, value);
      most = std::max(most, value);
      for (int axis = 0; axis < 3; ++axis) {
        const double nearest = axis < 2 ? std::min(1.0, std::max(0.0, at[axis])) : 0.0;
        EXPECT_TRUE(bounds.gradient[axis].contains(2 * (at[axis] - nearest)));
      }
    }
    // The range is at most twice what the slope makes of the box, and the rest of second order.
    const Point center = box.center();
    const double slope = 2 * std::sqrt(exact(center));
    EXPECT_LE(bounds.value.width(), 2 * slope * side + 12 * side * side + 1e-13);
  }
}

TEST(MeshDistance, NeedsTriangles) { EXPECT_THROW(MeshSquareDistance({}), InvalidArgument); }

}  // namespace
}  // namespace rfm
