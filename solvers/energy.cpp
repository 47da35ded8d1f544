#include "solvers/energy.hpp"

#include "core/error.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// d_s as a field.
Field slot_field(const Slot& slot, std::span<const Field> components) {
  if (slot.component < 0 || slot.component >= static_cast<int>(components.size()))
    throw InvalidArgument("an energy uses a component that the solution does not have");
  return partial(components[slot.component], slot.derivative);
}

}  // namespace

double energy(const Contribution& contribution, std::span<const Field> components,
              const DomainRule& rule, const FieldArguments& arguments) {
  const QuadraticEnergy& energy = contribution.energy;
  std::vector<Field> slots;
  for (const Slot& slot : energy.slots()) slots.push_back(slot_field(slot, components));
  Coefficient density;
  for (const auto& [row, column, coefficient] : energy.stiffness())
    density = density + (row == column ? 0.5 : 1.0) * coefficient * (slots[row] * slots[column]);
  for (const auto& [slot, coefficient] : energy.load())
    density = density - coefficient * slots[slot];
  if (contribution.where) {
    Coefficient restricted;
    for (const auto& [normal, field] : density.terms()) {
      Coefficient power = select(step(*contribution.where), field, 0.0);
      for (int axis = 0; axis < 3; ++axis)
        for (int n = 0; n < normal[axis]; ++n) power = power * Coefficient::normal(axis);
      restricted = restricted + power;
    }
    density = restricted;
  }
  if (density.is_zero()) return 0;
  return integrate(density, rule, {contribution.place, contribution.numbers}, arguments);
}

}  // namespace rfm
