#include "core/derivative_fields.hpp"

#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "core/jet_shape.hpp"
#include "core/normalization_length.hpp"

namespace rfm {
namespace {

// Polynomials in one variable with fields as coefficients, truncated at a degree.
using Polynomial = std::vector<Field>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size(), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; i + j < a.size(); ++j)
      result[i + j] = result[i + j] + product_or_nothing(a[i], b[j]);
  return result;
}

Polynomial derivative(Polynomial a) {
  for (std::size_t i = 1; i < a.size(); ++i) a[i - 1] = static_cast<double>(i) * a[i];
  a.back() = 0.0;
  return a;
}

double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

void check_order(int order) {
  if (order < 0 || order > maximum_order)
    throw InvalidArgument("derivatives have orders 0 to " + std::to_string(maximum_order) +
                          ", got " + std::to_string(order));
}

}  // namespace

std::vector<Field> hessian(const Field& f, int dimension) {
  std::vector<Field> rows(static_cast<std::size_t>(dimension) * dimension);
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j)
      rows[i * dimension + j] = rows[j * dimension + i] = partial(partial(f, i), j);
  return rows;
}

Field divergence(const std::vector<Field>& v) {
  Field sum = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) sum = sum + partial(v[i], static_cast<int>(i));
  return sum;
}

Field directional_derivative(const Field& f, const std::vector<Field>& v, int order) {
  const int dimension = static_cast<int>(v.size());
  if (dimension < 1 || dimension > 3)
    throw InvalidArgument("a direction has 1 to 3 components, got " + std::to_string(dimension));
  check_order(order);
  const JetShape& shape = JetShape::get(dimension, order);
  Field sum = 0.0;
  for (int i = order > 0 ? shape.size(order - 1) : 0; i < shape.size(); ++i) {
    const MultiIndex& alpha = shape.exponent(i);
    Field term = factorial(order) / rfm::factorial(alpha) * partial(f, alpha);
    for (int axis = 0; axis < dimension; ++axis)
      term = product_or_nothing(term, pow(v[axis], alpha[axis]));
    sum = sum + term;
  }
  return sum;
}

Field iterated_directional_derivative(const Field& f, const std::vector<Field>& v, int order) {
  check_order(order);
  Field derivative = f;
  for (int k = 0; k < order; ++k) derivative = directional_derivative(derivative, v, 1);
  return derivative;
}

Field normalize(const Field& f, int dimension, int order, double length) {
  if (order < 1 || order > 4)
    throw InvalidArgument("functions are normalised to orders 1 to 4, got " +
                          std::to_string(order));
  const Field omega = normalize_within(f, length, dimension);
  if (order == 1) return omega;
  std::vector<Field> normal = gradient(omega, dimension);
  // The length of the gradient is 1 on the boundary: 1/|∇ω| as a binomial series in |∇ω|² − 1.
  const Field excess = inward_derivative(omega, omega, dimension) - 1.0;
  Field inverse_length = 1.0, power = 1.0;
  for (int k = 1; k <= order - 2; ++k) {
    power = power * (0.5 - k) / static_cast<double>(k) * excess;
    inverse_length = inverse_length + power;
  }
  for (Field& component : normal) component = component * inverse_length;

  Polynomial first, current;
  for (int k = 0; k <= order; ++k)
    first.push_back(directional_derivative(omega, normal, k) / factorial(k));
  current = first;
  Polynomial first_power = first;
  for (int k = 2; k <= order; ++k) {
    first_power = product(first_power, first);
    Polynomial derived = current;
    for (int i = 0; i < k; ++i) derived = derivative(derived);
    const Polynomial correction = product(first_power, derived);
    for (int i = 0; i <= order; ++i) current[i] = current[i] - correction[i] / factorial(k);
  }
  return current[0];
}

}  // namespace rfm
