// Bounds of combinations of polynomials over boxes.

#include <algorithm>
#include <cmath>

#include "basis/tensor_polynomials.hpp"
#include "core/error.hpp"

namespace rfm {

FunctionBounds TensorPolynomials::bounds(std::span<const double> coefficients,
                                         const Box& box) const {
  if (coefficients.size() != factors_.size())
    throw InvalidArgument("polynomials take a coefficient each");
  if (family_.kind == PolynomialFamily::Kind::trigonometric)
    return GlobalSpace::bounds(coefficients, box);
  const int line = line_size(), d = dimension();
  // f(c + r t) = Σ_j powers[axis][f + j line] tʲ, |t| ≤ 1: derivatives times rʲ / j!.
  std::array<std::vector<double>, 3> powers;
  Point radius{};
  for (int axis = 0; axis < 3; ++axis) {
    powers[axis].assign(static_cast<std::size_t>(line) * line, 0.0);
    if (axis >= d) {
      powers[axis][0] = 1;
      continue;
    }
    const double half = 0.5 * box_.length(axis), middle = box.interval(axis).middle();
    // Degenerate boxes are widened by what does not count.
    radius[axis] =
        std::max({box.high[axis] - middle, middle - box.low[axis], 1e-13 * half}) * (1 + 1e-15);
    evaluate_line((middle - box_.low[axis]) / half - 1, line - 1, powers[axis].data());
    double scale = 1;
    for (int j = 0; j < line; ++j) {
      for (int f = 0; f < line; ++f) powers[axis][f + j * line] *= scale;
      scale *= radius[axis] / half / (j + 1);
    }
  }
  // Of the whole combination, by powers of t in each axis; and how large its terms are.
  const int third = d > 2 ? line : 1, second = d > 1 ? line : 1;
  std::vector<double> sums(static_cast<std::size_t>(line) * second * third, 0.0);
  std::vector<double> sizes(sums.size(), 0.0);
  for (std::size_t f = 0; f < factors_.size(); ++f) {
    const auto& [a, b, c] = factors_[f];
    for (int l = 0; l <= c; ++l)
      for (int k = 0; k <= b; ++k) {
        const double outer = coefficients[f] * powers[1][b + k * line] * powers[2][c + l * line];
        for (int j = 0; j <= a; ++j) {
          const double term = outer * powers[0][a + j * line];
          const std::size_t at = static_cast<std::size_t>((l * second + k) * line + j);
          sums[at] += term;
          sizes[at] += std::fabs(term);
        }
      }
  }
  // Recurrences of derivatives lose digits by sums of numbers of one sign.
  constexpr double rounding = 1e-12;
  FunctionBounds bounds;
  double middle = 0, reach = 0;
  Point slope{}, change{};
  for (int l = 0; l < third; ++l)
    for (int k = 0; k < second; ++k)
      for (int j = 0; j < line; ++j) {
        const std::size_t at = static_cast<std::size_t>((l * second + k) * line + j);
        const double size = std::fabs(sums[at]), lost = rounding * sizes[at];
        const std::array<int, 3> exponent{j, k, l};
        if (j + k + l == 0) {
          middle = sums[at];
          reach += lost;
        } else {
          reach += size + lost;
        }
        for (int axis = 0; axis < d; ++axis) {
          if (exponent[axis] == 0) continue;
          const double part = exponent[axis] / radius[axis];
          if (j + k + l == 1) {
            slope[axis] = part * sums[at];
            change[axis] += part * lost;
          } else {
            change[axis] += part * (size + lost);
          }
        }
      }
  bounds.value = Interval(middle - reach, middle + reach);
  for (int axis = 0; axis < d; ++axis)
    bounds.gradient[axis] = Interval(slope[axis] - change[axis], slope[axis] + change[axis]);
  return bounds;
}

}  // namespace rfm
