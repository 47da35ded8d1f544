#include "solution_structures/structure.hpp"

#include <algorithm>

#include "core/composition.hpp"
#include "solution_structures/undetermined.hpp"

namespace rfm {

Structure Structure::undetermined(int unknown) {
  Structure psi;
  psi.formula_ = undetermined_function(unknown);
  psi.terms_.push_back({unknown, MultiIndex{}, 1.0});
  return psi;
}

int Structure::derivative_order() const {
  int order = 0;
  for (const Term& term : terms_) order = std::max(order, degree(term.derivative));
  return order;
}

int Structure::unknown_count() const { return terms_.empty() ? 0 : terms_.back().unknown + 1; }

Structure Structure::written_as(const Field& formula, const Call& call) const {
  Structure result = *this;
  result.formula_ = formula;
  // A constant or a leaf is as short as any call.
  if (!call.function.empty() && !formula.node().arguments.empty()) {
    result.calls_.push_back(call);
    result.calls_.back().value = formula;
  }
  return result;
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

void Structure::add_terms(const Structure& other, double sign) {
  for (const Term& term : other.terms_)
    add({term.unknown, term.derivative, sign > 0 ? term.coefficient : -term.coefficient});
}

void Structure::add_calls(const Structure& other) {
  for (const Call& call : other.calls_) {
    const auto same = [&](const Call& own) { return own.value.same_as(call.value); };
    if (std::ranges::none_of(calls_, same)) calls_.push_back(call);
  }
}

Structure operator+(const Structure& a, const Structure& b) {
  Structure sum = a;
  sum.inhomogeneous_ = a.inhomogeneous_ + b.inhomogeneous_;
  sum.formula_ = a.formula_ + b.formula_;
  sum.add_terms(b, 1);
  sum.add_calls(b);
  return sum;
}

Structure operator-(const Structure& a, const Structure& b) {
  Structure difference = a;
  difference.inhomogeneous_ = a.inhomogeneous_ - b.inhomogeneous_;
  difference.formula_ = a.formula_ - b.formula_;
  difference.add_terms(b, -1);
  difference.add_calls(b);
  return difference;
}

Structure operator-(const Structure& a) {
  Structure negated(-a.inhomogeneous_);
  negated.formula_ = -a.formula_;
  negated.add_terms(a, -1);
  negated.add_calls(a);
  return negated;
}

Structure operator*(const Field& factor, const Structure& structure) {
  Structure product(product_or_nothing(factor, structure.inhomogeneous_));
  product.formula_ = product_or_nothing(factor, structure.formula_);
  for (const Structure::Term& term : structure.terms_)
    product.add({term.unknown, term.derivative, product_or_nothing(factor, term.coefficient)});
  product.add_calls(structure);
  return product;
}

Structure operator/(const Structure& structure, const Field& divisor) {
  const auto divided = [&](const Field& f) { return f.is_constant(0) ? f : f / divisor; };
  Structure quotient(divided(structure.inhomogeneous_));
  quotient.formula_ = divided(structure.formula_);
  for (const Structure::Term& term : structure.terms_)
    quotient.add({term.unknown, term.derivative, divided(term.coefficient)});
  quotient.add_calls(structure);
  return quotient;
}

Structure partial(const Structure& structure, int axis) {
  Structure derivative(partial(structure.inhomogeneous_, axis));
  derivative.formula_ = partial(structure.formula_, axis);
  for (const Structure::Term& term : structure.terms_) {
    derivative.add({term.unknown, term.derivative, partial(term.coefficient, axis)});
    derivative.add({term.unknown, term.derivative + unit_index(axis), term.coefficient});
  }
  derivative.add_calls(structure);
  return derivative;
}

Structure partial(const Structure& structure, const MultiIndex& alpha) {
  Structure derivative = structure;
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < alpha[axis]; ++k) derivative = partial(derivative, axis);
  return derivative;
}

std::vector<Structure> gradient(const Structure& structure, int dimension) {
  std::vector<Structure> components;
  for (int axis = 0; axis < dimension; ++axis) components.push_back(partial(structure, axis));
  return components;
}

Structure D(const Field& omega, const Structure& structure, int dimension) {
  Structure sum;
  for (int axis = 0; axis < dimension; ++axis)
    sum = sum + partial(omega, axis) * partial(structure, axis);
  return sum.written_as(inward_derivative(structure.formula(), omega, dimension),
                        {{}, "D", {omega, structure.formula()}});
}

Structure select(const Field& condition, const Structure& yes, const Structure& no) {
  Structure chosen(select(condition, yes.inhomogeneous_, no.inhomogeneous_));
  chosen.formula_ = select(condition, yes.formula_, no.formula_);
  for (const Structure::Term& term : yes.terms_)
    chosen.add({term.unknown, term.derivative, select(condition, term.coefficient, 0.0)});
  for (const Structure::Term& term : no.terms_)
    chosen.add({term.unknown, term.derivative, select(condition, 0.0, term.coefficient)});
  chosen.add_calls(yes);
  chosen.add_calls(no);
  return chosen;
}

Structure normalized(const Field& f, const Field& omega, int dimension) {
  const Field value = normalizer(f, omega, dimension);
  return Structure(value).written_as(value, {{}, "normalizer", {f, omega}});
}

}  // namespace rfm
