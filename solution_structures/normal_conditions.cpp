#include "solution_structures/normal_conditions.hpp"

#include "core/error.hpp"

namespace rfm {
namespace {

ConditionPart part_with(const Structure& value, const Field& omega, const Structure& excess) {
  return {value - omega * excess, omega, 2};
}

}  // namespace

Structure normal_derivative_excess(const Structure& value, const Field& omega, const Field& slope,
                                   int dimension) {
  return D(omega, value, dimension) + slope;
}

Structure robin_excess(const Structure& value, const Field& omega, const RobinData& data,
                       int dimension) {
  return D(omega, value, dimension) - (data.a * value - data.c) / data.b;
}

Structure oblique_excess(const Structure& value, const Field& omega, const ObliqueData& data) {
  if (!(data.length > 0))
    throw InvalidArgument("the length of an oblique condition must be positive");
  Field along = 0.0, square = 0.0;
  Structure excess = data.a * value - data.c;
  for (std::size_t i = 0; i < data.direction.size(); ++i) {
    const int axis = static_cast<int>(i);
    along = along + product_or_nothing(data.direction[i], partial(omega, axis));
    square = square + data.direction[i] * data.direction[i];
    excess = excess + data.direction[i] * partial(value, axis);
  }
  return (along / (pow(along, 2) + square * pow(omega / data.length, 2))) * excess;
}

ConditionPart normal_derivative_part(const Structure& value, const Field& omega, const Field& slope,
                                     int dimension) {
  return part_with(value, omega, normal_derivative_excess(value, omega, slope, dimension));
}

ConditionPart robin_part(const Structure& value, const Field& omega, const RobinData& data,
                         int dimension) {
  return part_with(value, omega, robin_excess(value, omega, data, dimension));
}

ConditionPart oblique_part(const Structure& value, const Field& omega, const ObliqueData& data) {
  return part_with(value, omega, oblique_excess(value, omega, data));
}

Structure neumann(const Field& omega, const Field& slope, int dimension, const Field& cutoff) {
  const Structure psi1 = Structure::undetermined(0), psi2 = Structure::undetermined(1);
  return corrected(psi1, {{normal_derivative_excess(psi1, omega, slope, dimension), omega, cutoff}},
                   psi2);
}

Structure robin(const Field& omega, const RobinData& data, int dimension, const Field& cutoff) {
  const Structure psi1 = Structure::undetermined(0), psi2 = Structure::undetermined(1);
  return corrected(psi1, {{robin_excess(psi1, omega, data, dimension), omega, cutoff}}, psi2);
}

}  // namespace rfm
