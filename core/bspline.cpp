#include "core/bspline.hpp"

#include <string>

#include "core/error.hpp"

namespace rfm {
namespace {

void require_degree(int degree, int order) {
  if (degree < 0 || degree > maximum_spline_degree)
    throw InvalidArgument("the degree of a spline must lie between 0 and " +
                          std::to_string(maximum_spline_degree) + ", got " +
                          std::to_string(degree));
  if (order < 0) throw InvalidArgument("the order of a derivative cannot be negative");
}

}  // namespace

void evaluate_bsplines(int degree, int order, double s, double* values) {
  require_degree(degree, order);
  static_assert(maximum_spline_degree == 8);
  switch (degree) {
    case 0:
      return evaluate_bsplines<0>(s, order, values);
    case 1:
      return evaluate_bsplines<1>(s, order, values);
    case 2:
      return evaluate_bsplines<2>(s, order, values);
    case 3:
      return evaluate_bsplines<3>(s, order, values);
    case 4:
      return evaluate_bsplines<4>(s, order, values);
    case 5:
      return evaluate_bsplines<5>(s, order, values);
    case 6:
      return evaluate_bsplines<6>(s, order, values);
    case 7:
      return evaluate_bsplines<7>(s, order, values);
    default:
      return evaluate_bsplines<8>(s, order, values);
  }
}

BSplineTable::BSplineTable(int degree, int order, std::span<const double> abscissae)
    : degree_(degree), order_(order), abscissa_count_(static_cast<int>(abscissae.size())) {
  require_degree(degree, order);
  const std::size_t size = std::size_t(order + 1) * (degree + 1);
  values_.resize(abscissae.size() * size);
  for (std::size_t i = 0; i < abscissae.size(); ++i)
    evaluate_bsplines(degree, order, abscissae[i], values_.data() + i * size);
}

BlossomMatrix bernstein_from_bsplines(int degree, double low, double high) {
  require_degree(degree, 0);
  BlossomMatrix matrix{};
  for (int k = 0; k <= degree; ++k) {
    // De Boor's algorithm with degree − k arguments `low` and k arguments `high`, applied to all
    // unit vectors of coefficients at once: row i holds the weights of the intermediate point i.
    BlossomMatrix points{};
    for (int i = 0; i <= degree; ++i) points[i][i] = 1;
    for (int r = 1; r <= degree; ++r) {
      const double t = r <= degree - k ? low : high;
      for (int i = degree; i >= r; --i) {
        const double weight = (t + (degree - i)) / (degree - r + 1);
        const double other = ((1 - t) + (i - r)) / (degree - r + 1);
        for (int c = 0; c <= degree; ++c)
          points[i][c] = other * points[i - 1][c] + weight * points[i][c];
      }
    }
    matrix[k] = points[degree];
  }
  return matrix;
}

}  // namespace rfm
