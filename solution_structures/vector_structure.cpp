#include "solution_structures/vector_structure.hpp"

#include <string>

#include "core/error.hpp"

namespace rfm {
namespace {

void require_equal(std::size_t a, std::size_t b) {
  if (a != b)
    throw InvalidArgument("vectors of " + std::to_string(a) + " and " + std::to_string(b) +
                          " components do not fit together");
}

}  // namespace

std::vector<Structure> undetermined_vector(int components, int first) {
  std::vector<Structure> psi;
  for (int i = 0; i < components; ++i) psi.push_back(Structure::undetermined(first + i));
  return psi;
}

std::vector<Structure> operator+(const std::vector<Structure>& a, const std::vector<Structure>& b) {
  require_equal(a.size(), b.size());
  std::vector<Structure> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.push_back(a[i] + b[i]);
  return sum;
}

std::vector<Structure> operator-(const std::vector<Structure>& a, const std::vector<Structure>& b) {
  require_equal(a.size(), b.size());
  std::vector<Structure> difference;
  for (std::size_t i = 0; i < a.size(); ++i) difference.push_back(a[i] - b[i]);
  return difference;
}

std::vector<Structure> operator*(const Field& factor, const std::vector<Structure>& a) {
  std::vector<Structure> product;
  for (const Structure& component : a) product.push_back(factor * component);
  return product;
}

std::vector<Structure> operator*(const std::vector<Field>& direction, const Structure& a) {
  std::vector<Structure> product;
  for (const Field& component : direction) product.push_back(component * a);
  return product;
}

std::vector<Structure> structures(const std::vector<Field>& fields) {
  return {fields.begin(), fields.end()};
}

Structure dot(const std::vector<Field>& a, const std::vector<Structure>& u) {
  require_equal(a.size(), u.size());
  Structure sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] * u[i];
  return sum;
}

Structure divergence(const std::vector<Structure>& u) {
  Structure sum;
  for (std::size_t i = 0; i < u.size(); ++i) sum = sum + partial(u[i], static_cast<int>(i));
  return sum;
}

std::vector<Structure> D(const Field& omega, const std::vector<Structure>& u, int dimension) {
  std::vector<Structure> derivative;
  for (const Structure& component : u) derivative.push_back(D(omega, component, dimension));
  return derivative;
}

}  // namespace rfm
