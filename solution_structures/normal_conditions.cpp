#include "solution_structures/normal_conditions.hpp"

#include "core/error.hpp"

namespace rfm {

ConditionPart normal_derivative_part(const Structure& value, const Field& omega, const Field& slope,
                                     int dimension) {
  return {value - omega * D(omega, value, dimension) - product_or_nothing(omega, slope), omega, 2};
}

ConditionPart robin_part(const Structure& value, const Field& omega, const Field& a, const Field& b,
                         const Field& c, int dimension) {
  return {value - omega * D(omega, value, dimension) + omega * ((a * value - c) / b), omega, 2};
}

ConditionPart oblique_part(const Structure& value, const Field& omega,
                           const std::vector<Field>& direction, const Field& a, const Field& c,
                           double length) {
  if (!(length > 0)) throw InvalidArgument("the length of an oblique condition must be positive");
  Field along = 0.0, square = 0.0;
  Structure excess = a * value - c;
  for (std::size_t i = 0; i < direction.size(); ++i) {
    const int axis = static_cast<int>(i);
    along = along + product_or_nothing(direction[i], partial(omega, axis));
    square = square + direction[i] * direction[i];
    excess = excess + direction[i] * partial(value, axis);
  }
  const Field inverse = along / (pow(along, 2) + square * pow(omega / length, 2));
  return {value - omega * (inverse * excess), omega, 2};
}

Structure neumann(const Field& omega, const Field& slope, int dimension, const Structure& psi1,
                  const Structure& psi2) {
  return mixed({normal_derivative_part(psi1, omega, slope, dimension)}, psi2);
}

Structure robin(const Field& omega, const Field& a, const Field& b, const Field& c, int dimension,
                const Structure& psi1, const Structure& psi2) {
  return mixed({robin_part(psi1, omega, a, b, c, dimension)}, psi2);
}

}  // namespace rfm
