#include "solution_structures/plate_conditions.hpp"

namespace rfm {

ConditionPart clamped_part(const Field& omega, const Field& deflection, const Field& rotation,
                           int dimension) {
  return {normalized(deflection, omega, dimension) - product_or_nothing(omega, rotation), omega, 2};
}

Structure clamped(const Field& omega, const Field& deflection, const Field& rotation, int dimension,
                  const Structure& psi) {
  return mixed({clamped_part(omega, deflection, rotation, dimension)}, psi);
}

Structure second_normal_derivative(const Structure& u, const Field& omega, int dimension) {
  Structure sum;
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j)
      sum = sum + product_or_nothing(i == j ? 1.0 : 2.0,
                                     product_or_nothing(partial(omega, i), partial(omega, j))) *
                      partial(partial(u, i), j);
  return sum;
}

Field second_normal_derivative(const Field& u, const Field& omega, int dimension) {
  return second_normal_derivative(Structure(u), omega, dimension).inhomogeneous();
}

Structure normal_moment(const Structure& w, const Field& omega, const Field& poisson_ratio,
                        int dimension) {
  const Structure bending = second_normal_derivative(w, omega, dimension);
  Structure laplacian;
  for (int axis = 0; axis < dimension; ++axis)
    laplacian = laplacian + partial(partial(w, axis), axis);
  return -(bending + poisson_ratio * (laplacian - bending));
}

Field normal_moment(const Field& w, const Field& omega, const Field& poisson_ratio, int dimension) {
  return normal_moment(Structure(w), omega, poisson_ratio, dimension).inhomogeneous();
}

ConditionPart second_derivative_part(const Structure& value, const Field& omega,
                                     const Field& curvature, int dimension) {
  const Structure excess = second_normal_derivative(value, omega, dimension) - curvature;
  return {value - (0.5 * pow(omega, 2)) * excess, omega, 3};
}

ConditionPart simply_supported_part(const Field& omega, const SupportData& data, int dimension,
                                    const Structure& psi) {
  const Structure value = data.deflection + omega * psi;
  const Structure lack = normal_moment(value, omega, data.poisson_ratio, dimension) - data.moment;
  return {value + (data.cutoff * (0.5 * pow(omega, 2))) * lack, omega, 3};
}

Structure simply_supported(const Field& omega, const SupportData& data, int dimension) {
  return mixed({simply_supported_part(omega, data, dimension)}, Structure::undetermined(1),
               data.cutoff * pow(omega, 3));
}

}  // namespace rfm
