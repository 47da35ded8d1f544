#include "problems/scalar_forms.hpp"

namespace rfm {
namespace {

Field dot(const std::vector<Field>& a, const std::vector<Field>& b) {
  Field sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + product_or_nothing(a[i], b[i]);
  return sum;
}

std::vector<Field> direction_of(const PieceCondition& condition) {
  return {condition.data.begin() + 1, condition.data.end()};
}

// l·∇u − c.
Field oblique_residual(const PieceCondition& condition, const Field& u) {
  const std::vector<Field> direction = direction_of(condition);
  return dot(direction, gradient(u, static_cast<int>(direction.size()))) - condition.data[0];
}

// q(u) of n·K∇u = q. Of an oblique derivative the part of n·K∇u that it leaves free, which has no
// derivative along n.
Field natural_flux(const PieceCondition& condition, const ScalarCoefficients& coefficients,
                   const std::vector<Field>& normal, const Field& u) {
  const std::vector<Field>& data = condition.data;
  switch (condition.kind) {
    case Condition::Kind::flux:
      return data[0];
    case Condition::Kind::convection:
      return data[0] * (data[1] - u);
    case Condition::Kind::robin:
      return coefficients.conductivity[0] * (data[2] - data[0] * u) / data[1];
    case Condition::Kind::oblique:
      return dot(conductive_flux(coefficients, u, static_cast<int>(normal.size())), normal) -
             normal_conductivity(coefficients, normal) / dot(direction_of(condition), normal) *
                 oblique_residual(condition, u);
    case Condition::Kind::value:
    case Condition::Kind::slope:
      break;
  }
  return 0.0;
}

// a·∇u + reaction u − source.
Field lower_terms(const ScalarCoefficients& coefficients, const Field& u, int dimension) {
  Field sum = product_or_nothing(coefficients.reaction, u) - coefficients.source;
  if (!coefficients.advection.empty())
    sum = sum + dot(coefficients.advection, gradient(u, dimension));
  return sum;
}

}  // namespace

FormPlace form_place(const PieceCondition& condition) {
  return {Contribution::Place::boundary, {condition.primitive}, condition.where};
}

Field natural_residual(const PieceCondition& condition, const ScalarCoefficients& coefficients,
                       const std::vector<Field>& normal, const Field& u) {
  if (condition.kind == Condition::Kind::oblique)
    return normal_conductivity(coefficients, normal) * oblique_residual(condition, u);
  return dot(conductive_flux(coefficients, u, static_cast<int>(normal.size())), normal) -
         natural_flux(condition, coefficients, normal, u);
}

Field normal_conductivity(const ScalarCoefficients& coefficients,
                          const std::vector<Field>& normal) {
  const std::size_t dimension = normal.size();
  Field k = 0.0;
  for (std::size_t i = 0; i < dimension; ++i)
    for (std::size_t j = 0; j < dimension; ++j)
      k = k +
          product_or_nothing(coefficients.conductivity[i * dimension + j], normal[i] * normal[j]);
  return k;
}

Form volume_form(const ScalarCoefficients& coefficients, int dimension, bool least_squares) {
  const Field u = unknown_symbol(0, dimension), v = test_symbol(0, dimension);
  const std::vector<Field> flux = conductive_flux(coefficients, u, dimension);
  const Field lower = lower_terms(coefficients, u, dimension);
  if (!least_squares)
    return Form::weak(dot(flux, gradient(v, dimension)) + product_or_nothing(lower, v));
  Field residual = lower;
  for (int axis = 0; axis < dimension; ++axis) residual = residual - partial(flux[axis], axis);
  return Form::least_squares({residual});
}

std::vector<Form> natural_forms(const PieceCondition& condition,
                                const ScalarCoefficients& coefficients,
                                const std::vector<Field>& normal, bool least_squares, double h) {
  if (condition.kind == Condition::Kind::value) return {};
  const int dimension = static_cast<int>(normal.size());
  const Field u = unknown_symbol(0, dimension);
  if (least_squares)
    return {Form::least_squares({natural_residual(condition, coefficients, normal, u)}, {1 / h},
                                form_place(condition))};
  const Field flux = natural_flux(condition, coefficients, normal, u);
  if (flux.is_constant(0)) return {};
  return {Form::weak(-flux * test_symbol(0, dimension), form_place(condition))};
}

Form value_residual(const PieceCondition& condition, const ScalarCoefficients& coefficients,
                    const std::vector<Field>& normal, double h) {
  const int dimension = static_cast<int>(normal.size());
  const Field u = unknown_symbol(0, dimension);
  // As large as what conduction, or where there is little of it the flow, makes of an error of the
  // value in the cells at the boundary.
  Field size = normal_conductivity(coefficients, normal);
  if (!coefficients.advection.empty()) {
    Field square = 0.0;
    for (const Field& component : coefficients.advection) square = square + component * component;
    size = size + h * held(sqrt(square), dimension);
  }
  return Form::least_squares({size * (u - condition.data[0])}, {1 / (h * h * h)},
                             form_place(condition));
}

}  // namespace rfm
