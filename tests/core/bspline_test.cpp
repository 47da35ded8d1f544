#include "core/bspline.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

const std::vector<double> abscissae{0.0, 1e-9, 0.1, 0.37, 0.5, 0.81, 1 - 1e-9, 1.0};

double binomial(int n, int k) {
  double product = 1;
  for (int i = 1; i <= k; ++i) product = product * (n - k + i) / i;
  return product;
}

// Elementary symmetric polynomial of degree k in the interior knots of the spline that starts at
// `start`, divided by binomial(p, k): the coefficient of s^k in Marsden's identity.
double marsden_coefficient(int degree, int k, double start) {
  std::vector<double> symmetric(degree + 1, 0.0);
  symmetric[0] = 1;
  for (int j = 1; j <= degree; ++j)
    for (int m = j; m >= 1; --m) symmetric[m] += (start + j) * symmetric[m - 1];
  return symmetric[k] / binomial(degree, k);
}

class BSplinesOfDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(BSpline, BSplinesOfDegree, testing::Range(0, maximum_spline_degree + 1));
// Of degree 0 splines are constants that jump.
class SmoothBSplinesOfDegree : public BSplinesOfDegree {};
INSTANTIATE_TEST_SUITE_P(BSpline, SmoothBSplinesOfDegree,
                         testing::Range(1, maximum_spline_degree + 1));

TEST_P(BSplinesOfDegree, FormAPositivePartitionOfUnityWhoseDerivativesSumToZero) {
  const int degree = GetParam(), order = degree + 2;
  const BSplineTable table(degree, order, abscissae);
  for (int a = 0; a < table.abscissa_count(); ++a)
    for (int k = 0; k <= order; ++k) {
      double sum = 0, magnitude = 0;
      for (const double value : table.values(a, k)) {
        sum += value;
        magnitude += std::abs(value);
        if (k == 0) {
          EXPECT_GE(value, 0);
        }
        if (k > degree) {
          EXPECT_EQ(value, 0);
        }
      }
      EXPECT_NEAR(sum, k == 0 ? 1 : 0, 4e-16 * (magnitude + 1)) << "s = " << abscissae[a];
    }
}

TEST_P(BSplinesOfDegree, ReproducePolynomialsAndTheirDerivativesByMarsdensIdentity) {
  const int degree = GetParam();
  const BSplineTable table(degree, degree, abscissae);
  for (int power = 0; power <= degree; ++power)
    for (int a = 0; a < table.abscissa_count(); ++a)
      for (int k = 0; k <= degree; ++k) {
        double sum = 0, magnitude = 1;
        for (int i = 0; i <= degree; ++i) {
          const double term =
              marsden_coefficient(degree, power, i - degree) * table.values(a, k)[i];
          sum += term;
          magnitude += std::abs(term);
        }
        double expected = k > power ? 0 : std::pow(abscissae[a], power - k);
        for (int m = 0; m < k; ++m) expected *= power - m;
        EXPECT_NEAR(sum, expected, 1e-15 * magnitude)
            << "power " << power << ", derivative " << k << ", s = " << abscissae[a];
      }
}

TEST_P(BSplinesOfDegree, AreAccurateRelativeToTheirOwnSizeAtTheEndsOfTheirSupport) {
  const int degree = GetParam();
  std::vector<double> values(degree + 1);
  for (const double s : {1e-30, 1e-9, 1e-3}) {
    evaluate_bsplines(degree, 0, s, values.data());
    EXPECT_NEAR(values[degree] / (std::pow(s, degree) / std::tgamma(degree + 1)), 1, 1e-14);
  }
}

TEST_P(SmoothBSplinesOfDegree, JoinSmoothlyAcrossCells) {
  const int degree = GetParam();
  const BSplineTable table(degree, degree - 1, std::vector<double>{0.0, 1.0});
  for (int k = 0; k < degree; ++k) {
    EXPECT_NEAR(table.values(1, k)[0], 0, 1e-15);       // the leaving spline ends at zero
    EXPECT_NEAR(table.values(0, k)[degree], 0, 1e-15);  // the entering spline starts at zero
    for (int i = 0; i < degree; ++i)
      EXPECT_NEAR(table.values(1, k)[i + 1], table.values(0, k)[i], 1e-13) << "derivative " << k;
  }
}

TEST_P(BSplinesOfDegree, HaveBernsteinCoefficientsOnAnySubinterval) {
  const int degree = GetParam();
  const double low = 0.2, high = 0.7;
  const BlossomMatrix matrix = bernstein_from_bsplines(degree, low, high);
  std::vector<double> values(degree + 1);
  for (const double t : {0.0, 0.25, 0.6, 1.0}) {
    evaluate_bsplines(degree, 0, low + t * (high - low), values.data());
    for (int i = 0; i <= degree; ++i) {
      double sum = 0;
      for (int k = 0; k <= degree; ++k) {
        EXPECT_GE(matrix[k][i], 0);
        sum += matrix[k][i] * binomial(degree, k) * std::pow(t, k) * std::pow(1 - t, degree - k);
      }
      EXPECT_NEAR(sum, values[i], 1e-15);
    }
  }
}

TEST(BSpline, KnownValuesOfTheCubic) {
  std::vector<double> values(8);
  evaluate_bsplines(3, 1, 0.0, values.data());
  const double expected[] = {1 / 6., 4 / 6., 1 / 6., 0, -0.5, 0, 0.5, 0};
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(values[i], expected[i], 1e-16);
}

TEST(BSpline, DegreesThatDoNotExistAreRefused) {
  double value;
  EXPECT_THROW(evaluate_bsplines(-1, 0, 0.5, &value), InvalidArgument);
  EXPECT_THROW(BSplineTable(9, 0, abscissae), InvalidArgument);
  EXPECT_THROW(BSplineTable(3, -1, abscissae), InvalidArgument);
}

}  // namespace
}  // namespace rfm
