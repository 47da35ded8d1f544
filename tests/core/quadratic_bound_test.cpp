#include "core/quadratic_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rfm {
namespace {

using Vector = QuadraticModel::Vector<double>;
using Matrix = QuadraticModel::Matrix<double>;

// value + gradient · s + ½ sᵀHs with numbers for intervals.
QuadraticModel model_of(double value, const Vector& gradient, const Matrix& hessian, int size,
                        const Interval& range) {
  QuadraticModel model;
  model.size = size;
  model.value = value;
  for (int i = 0; i < size; ++i) {
    model.gradient[i] = gradient[i];
    model.range[i] = range;
    for (int j = 0; j < size; ++j) model.hessian[i][j] = hessian[i][j];
  }
  return model;
}

TEST(QuadraticBound, IsTheMinimumOfAConvexFunction) {
  // 1 + 3s + 2t + (4s² + 2st + 2t²)/2: the gradient vanishes at s = −4/7, t = −5/7.
  const Matrix hessian{{{4, 1}, {1, 2}}};
  const double inside = lower_bound(model_of(1, {3, 2}, hessian, 2, {-1, 1}));
  EXPECT_NEAR(inside, 1 - 0.5 * (3 * 4 + 2 * 5) / 7.0, 1e-14);
  EXPECT_LE(inside, 1 - 11.0 / 7);
  // In [0, 1]² it is 1, at the corner; in [−½, 1]² it is on the side s = −½, at t = −½ again.
  EXPECT_NEAR(lower_bound(model_of(1, {3, 2}, hessian, 2, {0, 1})), 1, 1e-14);
  EXPECT_NEAR(lower_bound(model_of(1, {3, 2}, hessian, 2, {-0.5, 1})),
              1 - 1.5 - 1 + (4 * 0.25 + 2 * 0.25 + 2 * 0.25) / 2, 1e-14);
}

TEST(QuadraticBound, IsBelowEveryValueForEveryMatrixOfTheInterval) {
  std::mt19937 generator(7);
  const auto uniform = [&] { return -1 + 2 * 0x1p-32 * generator(); };
  int sharp = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const int n = 1 + trial % 6;
    QuadraticModel model;
    model.size = n;
    model.value = uniform();
    const double width = trial % 3 == 0 ? 0 : 0.3 * std::fabs(uniform()), shift = 2 * uniform();
    for (int i = 0; i < n; ++i) {
      model.gradient[i] = uniform();
      const double a = uniform(), b = uniform();
      model.range[i] = Interval(std::min(a, b), std::max(a, b));
      for (int j = 0; j <= i; ++j) {
        const double middle = uniform() + (i == j ? shift : 0);
        model.hessian[i][j] = model.hessian[j][i] = Interval(middle - width, middle + width);
      }
    }
    const double bound = lower_bound(model);
    double least = INFINITY;
    for (int sample = 0; sample < 300; ++sample) {
      Vector s{};
      for (int i = 0; i < n; ++i) {
        const double t = std::clamp(0.5 + 0.7 * uniform(), 0.0, 1.0);
        s[i] = model.range[i].low + t * model.range[i].width();
      }
      double value = model.value.low;
      for (int i = 0; i < n; ++i) {
        value += model.gradient[i].low * s[i];
        for (int j = 0; j <= i; ++j) {
          // The lowest matrix for this s.
          const double product = s[i] * s[j] * (i == j ? 0.5 : 1.0);
          value += product * (product > 0 ? model.hessian[i][j].low : model.hessian[i][j].high);
        }
      }
      least = std::min(least, value);
    }
    ASSERT_LE(bound, least) << trial;
    sharp += bound > least - 0.1;
  }
  EXPECT_GT(sharp, 100);
}

TEST(QuadraticBound, LosesNoMoreThanTwiceTheNegativeCurvature) {
  // s² − t² on [−h, h]²: −h². A shift applies to both variables.
  const double bound = lower_bound(model_of(0, {}, {{{2, 0}, {0, -2}}}, 2, {-0.1, 0.1}));
  EXPECT_LE(bound, -0.01);
  EXPECT_GE(bound, -4.1 * 0.01);
}

TEST(QuadraticBound, OfSomethingUnboundedIsNothing) {
  QuadraticModel model = model_of(1, {}, {{{2}}}, 1, {-1, 1});
  model.hessian[0][0] = Interval::entire();
  EXPECT_EQ(lower_bound(model), -INFINITY);
}

TEST(ShiftedCholesky, ShiftsByAtMostTwiceWhatIsNeeded) {
  EXPECT_EQ(ShiftedCholesky({{{2}, {1, 2}}}, 2).shift, 0);
  const ShiftedCholesky shifted({{{1}, {2, 1}}}, 2);  // eigenvalues −1 and 3
  EXPECT_GE(shifted.shift, 1);
  EXPECT_LE(shifted.shift, 2.01);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = 0;
      for (int k = 0; k <= j; ++k) sum += shifted.factor[i][k] * shifted.factor[j][k];
      EXPECT_NEAR(sum, i == j ? 1 + shifted.shift : 2, 1e-14);
    }
}

}  // namespace
}  // namespace rfm
