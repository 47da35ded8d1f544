#include "solution_structures/structure.hpp"

#include <algorithm>

namespace rfm {

Structure Structure::undetermined(int unknown) {
  Structure psi;
  psi.terms_.push_back({unknown, MultiIndex{}, 1.0});
  return psi;
}

int Structure::derivative_order() const {
  int order = 0;
  for (const Term& term : terms_) order = std::max(order, degree(term.derivative));
  return order;
}

void Structure::add(const Term& term) {
  if (term.coefficient.is_constant(0)) return;
  const auto before = [](const Term& a, const Term& b) {
    return std::pair(a.unknown, a.derivative) < std::pair(b.unknown, b.derivative);
  };
  const auto place = std::ranges::lower_bound(terms_, term, before);
  if (place == terms_.end() || before(term, *place)) {
    terms_.insert(place, term);
    return;
  }
  place->coefficient = place->coefficient + term.coefficient;
  if (place->coefficient.is_constant(0)) terms_.erase(place);
}

Structure operator+(const Structure& a, const Structure& b) {
  Structure sum = a;
  sum.inhomogeneous_ = a.inhomogeneous_ + b.inhomogeneous_;
  for (const Structure::Term& term : b.terms_) sum.add(term);
  return sum;
}

Structure operator*(const Field& factor, const Structure& structure) {
  Structure product(product_or_nothing(factor, structure.inhomogeneous_));
  for (Structure::Term term : structure.terms_) {
    term.coefficient = product_or_nothing(factor, term.coefficient);
    product.add(term);
  }
  return product;
}

Structure operator-(const Structure& a) { return Field(-1.0) * a; }
Structure operator-(const Structure& a, const Structure& b) { return a + (-b); }

Structure partial(const Structure& structure, int axis) {
  Structure derivative(partial(structure.inhomogeneous_, axis));
  for (const Structure::Term& term : structure.terms_) {
    derivative.add({term.unknown, term.derivative, partial(term.coefficient, axis)});
    derivative.add({term.unknown, term.derivative + unit_index(axis), term.coefficient});
  }
  return derivative;
}

Structure partial(const Structure& structure, const MultiIndex& alpha) {
  Structure derivative = structure;
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < alpha[axis]; ++k) derivative = partial(derivative, axis);
  return derivative;
}

Structure D(const Field& omega, const Structure& structure, int dimension) {
  Structure sum;
  for (int axis = 0; axis < dimension; ++axis)
    sum = sum + partial(omega, axis) * partial(structure, axis);
  return sum;
}

}  // namespace rfm
