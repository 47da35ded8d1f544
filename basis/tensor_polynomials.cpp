#include "basis/tensor_polynomials.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace rfm {
namespace {

// Frequencies count as degrees: functions 2 j − 1 and 2 j are cos and sin of j.
int degree_of(PolynomialFamily::Kind kind, int function) {
  return kind == PolynomialFamily::Kind::trigonometric ? (function + 1) / 2 : function;
}

}  // namespace

TensorPolynomials::TensorPolynomials(const Box& box, const PolynomialFamily& family)
    : box_(box), family_(family) {
  if (family.degree < 0) throw InvalidArgument("the degree of polynomials cannot be negative");
  for (int axis = 0; axis < box.dimension; ++axis)
    if (!(box.length(axis) > 0)) throw InvalidArgument("polynomials need a box with an extent");
  const std::array<int, 3> count{line_size(), box.dimension > 1 ? line_size() : 1,
                                 box.dimension > 2 ? line_size() : 1};
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i) {
        const int sum =
            degree_of(family.kind, i) + degree_of(family.kind, j) + degree_of(family.kind, k);
        if (!family.total || sum <= family.degree) factors_.push_back({i, j, k});
      }
}

int TensorPolynomials::line_size() const {
  const bool pairs = family_.kind == PolynomialFamily::Kind::trigonometric;
  return pairs ? 2 * family_.degree + 1 : family_.degree + 1;
}

// Recurrences over the degree, differentiated k times: P⁽ᵏ⁾ₙ₊₁ = P⁽ᵏ⁾ₙ₋₁ + (2n + 1) P⁽ᵏ⁻¹⁾ₙ for k >
// 0 (Legendre), T⁽ᵏ⁾ₙ₊₁ = 2ξ T⁽ᵏ⁾ₙ + 2k T⁽ᵏ⁻¹⁾ₙ − T⁽ᵏ⁾ₙ₋₁ (Chebyshev).
void TensorPolynomials::evaluate_line(double xi, int order, double* values) const {
  const int count = line_size();
  for (int k = 0; k <= order; ++k) {
    double* f = values + std::ptrdiff_t(k) * count;
    const double* lower = k > 0 ? f - count : nullptr;
    f[0] = k == 0 ? 1 : 0;
    switch (family_.kind) {
      case PolynomialFamily::Kind::legendre:
        if (count > 1) f[1] = k == 0 ? xi : k == 1 ? 1 : 0;
        for (int n = 1; n + 1 < count; ++n)
          f[n + 1] = k == 0 ? ((2 * n + 1) * xi * f[n] - n * f[n - 1]) / (n + 1)
                            : f[n - 1] + (2 * n + 1) * lower[n];
        break;
      case PolynomialFamily::Kind::chebyshev:
        if (count > 1) f[1] = k == 0 ? xi : k == 1 ? 1 : 0;
        for (int n = 1; n + 1 < count; ++n)
          f[n + 1] = 2 * xi * f[n] - f[n - 1] + (k > 0 ? 2 * k * lower[n] : 0);
        break;
      case PolynomialFamily::Kind::power:
        for (int n = 1; n < count; ++n) f[n] = k == 0 ? xi * f[n - 1] : n * lower[n - 1];
        break;
      case PolynomialFamily::Kind::trigonometric:
        for (int j = 1; 2 * j < count; ++j) {
          const double frequency = 0.5 * std::numbers::pi * j, size = std::pow(frequency, k);
          const double angle = frequency * xi + 0.5 * std::numbers::pi * k;
          f[2 * j - 1] = size * std::cos(angle);
          f[2 * j] = size * std::sin(angle);
        }
    }
  }
}

void TensorPolynomials::evaluate(const std::array<const double*, 3>& coordinates, int count,
                                 const MultiIndex& derivative, double* values) const {
  const int line = line_size();
  std::array<std::vector<double>, 3> tables;
  std::array<const double*, 3> row{};
  const double one = 1;
  for (int axis = 0; axis < dimension(); ++axis)
    tables[axis].resize(std::size_t(derivative[axis] + 1) * line);
  for (int q = 0; q < count; ++q) {
    double scale = 1;
    row = {&one, &one, &one};
    for (int axis = 0; axis < dimension(); ++axis) {
      const double half = 0.5 * box_.length(axis);
      evaluate_line((coordinates[axis][q] - box_.low[axis]) / half - 1, derivative[axis],
                    tables[axis].data());
      row[axis] = tables[axis].data() + std::ptrdiff_t(derivative[axis]) * line;
      scale /= std::pow(half, derivative[axis]);
    }
    for (int axis = dimension(); axis < 4; ++axis)
      if (derivative[axis] > 0) scale = 0;
    double* to = values + std::ptrdiff_t(q) * size();
    for (const auto& [i, j, k] : factors_) *to++ = scale * row[0][i] * row[1][j] * row[2][k];
  }
}

}  // namespace rfm
