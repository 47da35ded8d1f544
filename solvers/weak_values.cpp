#include "solvers/weak_values.hpp"

#include "core/error.hpp"

namespace rfm {

Form weak_values(const Form& volume, int component, const Field& g,
                 const std::vector<Field>& normal, double penalty, FormPlace place) {
  if (volume.kind() == Form::Kind::least_squares)
    throw InvalidArgument("least squares take values as residuals");
  if (volume.derivative_order() > 1)
    throw InvalidArgument(
        "values are enforced weakly in equations with first derivatives only; where there are "
        "higher ones they need a structure");
  const int dimension = static_cast<int>(normal.size());
  const Field difference = unknown_symbol(component, dimension) - g;
  Field flux = 0.0, stiffness = 0.0, change = 0.0;
  for (int i = 0; i < dimension; ++i) {
    const Slot slope{component, unit_index(i)};
    flux = flux + product_or_nothing(volume.residual(slope, dimension), normal[i]);
    for (int j = 0; j < dimension; ++j)
      stiffness = stiffness +
                  product_or_nothing(volume.tangent(slope, {component, unit_index(j)}, dimension),
                                     normal[i] * normal[j]);
    for (const SymbolSlot& trial : volume.slots())
      if (!trial.is_test)
        change = change +
                 product_or_nothing(volume.tangent(slope, trial.slot, dimension), normal[i]) *
                     partial(test_symbol(trial.slot.component, dimension), trial.slot.derivative);
  }
  if (stiffness.is_constant(0))
    throw InvalidArgument(
        "an unknown whose derivatives are not in the equation cannot have values on the boundary");
  if (volume.kind() == Form::Kind::energy)
    return Form::energy(0.5 * penalty * stiffness * difference * difference - flux * difference,
                        std::move(place));
  const Field test = test_symbol(component, dimension);
  return Form::weak(penalty * stiffness * difference * test - flux * test - change * difference,
                    std::move(place));
}

}  // namespace rfm
