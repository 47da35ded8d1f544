#include "solvers/form_loads.hpp"

#include <vector>

#include "solvers/form.hpp"
#include "solvers/form_symbols.hpp"

namespace rfm {
namespace {

constexpr int dimension = 3;  // of the coordinates in a tangent, which is asked for zeros only

bool is_load(const Field& term) {
  if (!has_symbols(term)) return false;
  const Form form = Form::energy(term);
  for (const SymbolSlot& a : form.slots())
    for (const SymbolSlot& b : form.slots())
      if (!form.tangent(a.slot, b.slot, dimension).is_constant(0)) return false;
  return true;
}

}  // namespace

Field without_loads(const Field& density) {
  struct Term {
    Field field, factor;
  };
  Field stored = 0.0;
  std::vector<Term> open{{density, 1.0}};
  while (!open.empty()) {
    const auto [field, factor] = open.back();
    open.pop_back();
    const std::vector<Field>& arguments = field.node().arguments;
    switch (field.node().operation) {
      case Operation::add:
        open.push_back({arguments[1], factor});
        open.push_back({arguments[0], factor});
        continue;
      case Operation::subtract:
        open.push_back({arguments[1], -factor});
        open.push_back({arguments[0], factor});
        continue;
      case Operation::negate:
        open.push_back({arguments[0], -factor});
        continue;
      case Operation::multiply:
        if (!has_symbols(arguments[0])) {
          open.push_back({arguments[1], factor * arguments[0]});
          continue;
        }
        if (!has_symbols(arguments[1])) {
          open.push_back({arguments[0], factor * arguments[1]});
          continue;
        }
        break;
      case Operation::divide:
        if (has_symbols(arguments[1])) break;
        open.push_back({arguments[0], factor / arguments[1]});
        continue;
      default:
        break;
    }
    if (!is_load(field)) stored = stored + factor * field;
  }
  return stored;
}

}  // namespace rfm
