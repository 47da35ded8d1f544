#include "solution_structures/interface_conditions.hpp"

namespace rfm {

Structure kinked(const Field& omega, const Structure& psi1, const Structure& psi2) {
  return psi1 + abs(omega) * psi2;
}

Structure interface_structure(const Field& omega, const InterfaceData& data, int dimension,
                              const Structure& psi1, const Structure& psi2, const Structure& psi3) {
  const Field& plus = data.positive_coefficient;
  const Field& minus = data.negative_coefficient;
  const Structure slope =
      ((minus - plus) * D(omega, psi1, dimension) + data.flux_jump) / (plus + minus);
  Structure jump;
  if (!data.jump.is_constant(0)) jump = step(omega) * normalized(data.jump, omega, dimension);
  return psi1 + abs(omega) * slope + jump + pow(omega, 2) * psi2 + (omega * abs(omega)) * psi3;
}

}  // namespace rfm
