#include "solvers/integrand.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace rfm {

Coefficient::Coefficient(const Field& field) { add({{}, field}); }

Coefficient Coefficient::normal(int axis) {
  if (axis < 0 || axis > 2) throw InvalidArgument("a normal has the components 0, 1 and 2");
  Coefficient result;
  result.add({unit_index(axis), Field(1.0)});
  return result;
}

void Coefficient::add(const Term& term) {
  if (term.field.is_constant(0)) return;
  const auto same = std::find_if(terms_.begin(), terms_.end(),
                                 [&](const Term& own) { return own.normal == term.normal; });
  if (same == terms_.end()) {
    terms_.push_back(term);
    return;
  }
  same->field = same->field + term.field;
  if (same->field.is_constant(0)) terms_.erase(same);
}

bool Coefficient::depends_on_normal() const {
  return std::any_of(terms_.begin(), terms_.end(),
                     [](const Term& term) { return degree(term.normal) > 0; });
}

Coefficient operator+(const Coefficient& a, const Coefficient& b) {
  Coefficient sum = a;
  for (const Coefficient::Term& term : b.terms_) sum.add(term);
  return sum;
}

Coefficient operator*(const Coefficient& a, const Coefficient& b) {
  Coefficient product;
  for (const Coefficient::Term& left : a.terms_)
    for (const Coefficient::Term& right : b.terms_)
      product.add({left.normal + right.normal, left.field * right.field});
  return product;
}

Coefficient operator-(const Coefficient& a) { return Coefficient(-1.0) * a; }
Coefficient operator-(const Coefficient& a, const Coefficient& b) { return a + (-b); }

int QuadraticEnergy::number(const Slot& slot) {
  const auto place = std::find(slots_.begin(), slots_.end(), slot);
  const int index = static_cast<int>(place - slots_.begin());
  if (place == slots_.end()) slots_.push_back(slot);
  return index;
}

void QuadraticEnergy::add_stiffness(const Slot& a, const Slot& b, const Coefficient& coefficient) {
  if (coefficient.is_zero()) return;
  const auto [row, column] = std::minmax({number(a), number(b)});
  for (Entry& entry : stiffness_)
    if (entry.row == row && entry.column == column) {
      entry.coefficient = entry.coefficient + coefficient;
      return;
    }
  stiffness_.push_back({row, column, coefficient});
}

void QuadraticEnergy::add_load(const Slot& a, const Coefficient& coefficient) {
  if (coefficient.is_zero()) return;
  const int slot = number(a);
  for (Load& load : load_)
    if (load.slot == slot) {
      load.coefficient = load.coefficient + coefficient;
      return;
    }
  load_.push_back({slot, coefficient});
}

bool QuadraticEnergy::depends_on_normal() const {
  return std::any_of(stiffness_.begin(), stiffness_.end(),
                     [](const Entry& entry) { return entry.coefficient.depends_on_normal(); }) ||
         std::any_of(load_.begin(), load_.end(),
                     [](const Load& load) { return load.coefficient.depends_on_normal(); });
}

}  // namespace rfm
