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
  // Slopes of the flux are held: where d(u) is far from the data yet, their changes would make
  // the tangent indefinite, and where they are not, they are as small as the error of the solution.
  Field flux = 0.0, stiffness = 0.0, change_of_test = 0.0, change = 0.0;
  for (int i = 0; i < dimension; ++i) {
    const Slot slope{component, unit_index(i)};
    flux = flux + product_or_nothing(volume.residual(slope, dimension), normal[i]);
    for (int j = 0; j < dimension; ++j)
      stiffness = stiffness +
                  product_or_nothing(
                      held(volume.tangent(slope, {component, unit_index(j)}, dimension), dimension),
                      normal[i] * normal[j]);
    for (const SymbolSlot& trial : volume.slots()) {
      if (trial.role != SymbolRole::unknown) continue;
      const Field coefficient = product_or_nothing(
          held(volume.tangent(slope, trial.slot, dimension), dimension), normal[i]);
      const auto derivative = [&](const Field& symbol) {
        return partial(symbol, trial.slot.derivative);
      };
      const Field unknown = derivative(unknown_symbol(trial.slot.component, dimension));
      change = change + coefficient * (unknown - held(unknown, dimension));
      change_of_test =
          change_of_test + coefficient * derivative(test_symbol(trial.slot.component, dimension));
    }
  }
  if (stiffness.is_constant(0))
    throw InvalidArgument(
        "an unknown whose derivatives are not in the equation cannot have values on the boundary");
  if (volume.kind() == Form::Kind::energy) {
    const Field model = volume.is_linear() ? flux : held(flux, dimension) + change;
    return Form::energy(0.5 * penalty * stiffness * difference * difference - model * difference,
                        std::move(place));
  }
  const Field test = test_symbol(component, dimension);
  // Where the flow enters, values are carried in by it, and hold however little is conducted.
  Field transport = 0.0;
  for (int i = 0; i < dimension; ++i)
    transport =
        transport +
        product_or_nothing(
            held(volume.tangent({component, {}}, {component, unit_index(i)}, dimension), dimension),
            normal[i]);
  const Field inflow =
      transport.is_constant(0) ? Field(0.0) : max(-1.0 * transport, Field(0.0)) * difference * test;
  return Form::weak(
      inflow + penalty * stiffness * difference * test - flux * test - change_of_test * difference,
      std::move(place));
}

}  // namespace rfm
