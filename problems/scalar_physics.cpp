#include "problems/scalar_physics.hpp"

#include <algorithm>
#include <limits>

#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "solvers/form_symbols.hpp"

namespace rfm {
namespace {

// 1 inside the region, 0 outside.
Field indicator(const Region& region) { return step(implicit(region, RAlpha{1})); }

// The entries of coefficient `key`: the default, overridden where materials say so. A single number
// stands for a multiple of the unit matrix.
std::vector<Field> with_materials(const Problem& problem, const std::string& key, int size) {
  const auto expanded = [&](const PhysicalCoefficient& coefficient) {
    if (static_cast<int>(coefficient.entries.size()) == size) return coefficient.entries;
    std::vector<Field> entries(size, 0.0);
    for (int i = 0; i < problem.dimension; ++i)
      entries[i * problem.dimension + i] = coefficient.entries[0];
    return entries;
  };
  // Where nothing is given the coefficient is not a number, which assembly reports with the place.
  std::vector<Field> entries(size, std::numeric_limits<double>::quiet_NaN());
  const auto given = problem.physics.coefficients.find(key);
  if (given != problem.physics.coefficients.end()) entries = expanded(given->second);
  for (const Material& material : problem.physics.materials)
    if (!material.region && material.coefficients.contains(key))
      entries = expanded(material.coefficients.at(key));
  for (const Material& material : problem.physics.materials) {
    if (!material.region || !material.coefficients.contains(key)) continue;
    const std::vector<Field> inside = expanded(material.coefficients.at(key));
    const Field here = indicator(*material.region);
    for (int i = 0; i < size; ++i) entries[i] = select(here, inside[i], entries[i]);
  }
  return entries;
}

Contribution on_piece(QuadraticEnergy energy, const PieceCondition& condition) {
  return {std::move(energy), Contribution::Place::boundary, {condition.primitive}, condition.where};
}

// n·K n.
Coefficient normal_conductivity(const ScalarCoefficients& coefficients, int dimension) {
  Coefficient sum;
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      sum = sum + Coefficient::normal(i) * Coefficient::normal(j) *
                      Coefficient(coefficients.conductivity[i * dimension + j]);
  return sum;
}

}  // namespace

bool is_isotropic(const ScalarCoefficients& coefficients, int dimension) {
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      if (i != j && !coefficients.conductivity[i * dimension + j].is_constant(0)) return false;
  for (int i = 1; i < dimension; ++i)
    if (!same_expression(coefficients.conductivity[i * dimension + i],
                         coefficients.conductivity[0]))
      return false;
  return true;
}

ScalarCoefficients scalar_coefficients(const Problem& problem) {
  const int square = problem.dimension * problem.dimension;
  const auto scalar = [&](const char* key) { return with_materials(problem, key, 1)[0]; };
  ScalarCoefficients coefficients;
  switch (problem.physics.type) {
    case PhysicsType::poisson:
      coefficients.conductivity = with_materials(problem, "diffusivity", square);
      coefficients.reaction = scalar("reaction");
      coefficients.source = scalar("source");
      break;
    case PhysicsType::heat:
      coefficients.conductivity = with_materials(problem, "conductivity", square);
      coefficients.source = scalar("source");
      coefficients.mass = scalar("density") * scalar("heat_capacity");
      break;
    case PhysicsType::membrane:
      coefficients.conductivity = with_materials(problem, "tension", square);
      coefficients.source = scalar("load");
      coefficients.mass = scalar("density");
      break;
    case PhysicsType::torsion:
      coefficients.conductivity.assign(square, 0.0);
      for (int i = 0; i < problem.dimension; ++i)
        coefficients.conductivity[i * problem.dimension + i] = 1.0;
      coefficients.source = 2.0 * scalar("modulus") * scalar("twist");
      break;
    case PhysicsType::interpolation:
    case PhysicsType::custom:
      break;
  }
  coefficients.advection = problem.physics.advection;
  return coefficients;
}

bool depend_on_solution(const ScalarCoefficients& coefficients) {
  return has_symbols(coefficients.reaction) || has_symbols(coefficients.source) ||
         std::ranges::any_of(coefficients.conductivity, has_symbols) ||
         std::ranges::any_of(coefficients.advection, has_symbols);
}

std::vector<Field> conductive_flux(const ScalarCoefficients& coefficients, const Field& f,
                                   int dimension) {
  std::vector<Field> flux(dimension, 0.0);
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      flux[i] =
          flux[i] + product_or_nothing(coefficients.conductivity[i * dimension + j], partial(f, j));
  return flux;
}

Contribution volume_energy(const ScalarCoefficients& coefficients, int dimension) {
  QuadraticEnergy energy;
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j)
      energy.add_stiffness({0, unit_index(i)}, {0, unit_index(j)},
                           coefficients.conductivity[i * dimension + j]);
  energy.add_stiffness({0, {}}, {0, {}}, coefficients.reaction);
  energy.add_load({0, {}}, coefficients.source);
  return {energy};
}

Contribution mass_energy(const ScalarCoefficients& coefficients) {
  QuadraticEnergy energy;
  energy.add_stiffness({0, {}}, {0, {}}, coefficients.mass);
  return {energy};
}

std::vector<Contribution> natural_energy(const PieceCondition& condition,
                                         const ScalarCoefficients& coefficients) {
  QuadraticEnergy energy;
  const Slot u{0, {}};
  switch (condition.kind) {
    case Condition::Kind::flux:
      if (condition.data[0].is_constant(0)) return {};
      energy.add_load(u, condition.data[0]);
      break;
    case Condition::Kind::convection: {
      const auto& [coefficient, ambient] = std::tie(condition.data[0], condition.data[1]);
      energy.add_stiffness(u, u, coefficient);
      energy.add_load(u, coefficient * ambient);
      break;
    }
    case Condition::Kind::robin: {
      const Field& k = coefficients.conductivity[0];
      energy.add_stiffness(u, u, k * condition.data[0] / condition.data[1]);
      energy.add_load(u, k * condition.data[2] / condition.data[1]);
      break;
    }
    case Condition::Kind::value:
    case Condition::Kind::slope:
    case Condition::Kind::oblique:  // follows from no energy
      return {};
  }
  return {on_piece(std::move(energy), condition)};
}

Contribution nitsche_energy(const PieceCondition& condition, const ScalarCoefficients& coefficients,
                            int dimension, double penalty) {
  QuadraticEnergy energy;
  const Slot u{0, {}};
  const Coefficient g = condition.data[0];
  const Coefficient stiffness = Coefficient(penalty) * normal_conductivity(coefficients, dimension);
  energy.add_stiffness(u, u, stiffness);
  energy.add_load(u, stiffness * g);
  for (int j = 0; j < dimension; ++j) {
    Coefficient along;  // (Kn)_j, the coefficient of ∂u/∂x_j in n·K∇u
    for (int i = 0; i < dimension; ++i)
      along = along +
              Coefficient::normal(i) * Coefficient(coefficients.conductivity[i * dimension + j]);
    energy.add_stiffness(u, {0, unit_index(j)}, -along);
    energy.add_load({0, unit_index(j)}, -along * g);
  }
  return on_piece(std::move(energy), condition);
}

}  // namespace rfm
