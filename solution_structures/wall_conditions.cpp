#include "solution_structures/wall_conditions.hpp"

namespace rfm {

std::vector<Structure> displacement(const Field& omega,
                                    const std::vector<std::optional<Field>>& values,
                                    int first_unknown) {
  std::vector<Structure> u;
  for (const std::optional<Field>& value : values) {
    const Structure psi = Structure::undetermined(first_unknown++);
    u.push_back(value ? *value + omega * psi : psi);
  }
  return u;
}

std::vector<Structure> normal_displacement(const Field& omega, const Field& value, int dimension,
                                           const Field& cutoff, int first_unknown) {
  const std::vector<Structure> psi = undetermined_vector(dimension, first_unknown);
  const Structure phi = Structure::undetermined(first_unknown + dimension);
  const std::vector<Field> normal = gradient(omega, dimension);
  return psi - normal * (cutoff * (dot(normal, psi) + value)) + normal * ((cutoff * omega) * phi);
}

std::vector<Structure> symmetry(const Field& omega, int dimension, int first_unknown) {
  const std::vector<Structure> psi = undetermined_vector(dimension, first_unknown);
  const Structure chi = Structure::undetermined(first_unknown + dimension);
  const std::vector<Structure> phi = undetermined_vector(dimension, first_unknown + dimension + 1);
  const std::vector<Field> normal = gradient(omega, dimension);
  const auto tangential = [&](const std::vector<Structure>& v) {
    return v - normal * dot(normal, v);
  };
  const std::vector<Structure> along = tangential(psi);
  return along - omega * tangential(D(omega, along, dimension)) + normal * (omega * chi) +
         pow(omega, 2) * phi;
}

}  // namespace rfm
