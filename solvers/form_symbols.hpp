#pragma once

#include <span>
#include <vector>

#include "core/field.hpp"
#include "core/multi_index.hpp"
#include "solvers/integrand.hpp"

namespace rfm {

/// Component `component` of the solution, and its test function, as symbols in the formulas of
/// forms (solvers/form.hpp): fields that have any derivative but no values.
///
///     const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);
///     const Field weak = dot(gradient(u, 2), gradient(v, 2)) - f * v;
Field unknown_symbol(int component, int dimension);
Field test_symbol(int component, int dimension);
/// A formula with its unknowns held: they have the values of the solution, but tangents do not
/// count their changes. Of weights that depend on the solution and matter less than what they
/// weigh, as the penalty of values enforced weakly.
Field held(const Field& formula, int dimension);

enum class SymbolRole { unknown, test, held };

/// A derivative of an unknown or of a test function that occurs in a formula, and the further
/// coordinate that stands for it.
struct SymbolSlot {
  Slot slot;
  SymbolRole role = SymbolRole::unknown;
  int coordinate = 4;
  Field field() const;
};

/// Formulas with symbols as functions of position and slots: derivatives of expressions are carried
/// out down to the symbols, and each derivative of a symbol becomes a further coordinate.
class SlotNumbering {
 public:
  Field replaced(const Field& formula);
  const std::vector<SymbolSlot>& slots() const { return slots_; }

 private:
  Field of_symbol(const Field& leaf);
  std::vector<SymbolSlot> slots_;
};

/// Whether symbols occur in a formula.
bool has_symbols(const Field& formula);
/// Whether test functions occur in it.
bool has_test_symbols(const Field& formula);
/// A formula with the components of a solution in the place of unknowns (and nothing in that of
/// test functions, which must not occur).
Field with_solution(const Field& formula, std::span<const Field> components);

}  // namespace rfm
