#include "solvers/solution.hpp"

#include <memory>
#include <string>

#include "core/error.hpp"
#include "core/spline_field.hpp"

namespace rfm {

std::vector<Field> undetermined_functions(std::span<const TensorProductSpace> spaces,
                                          const Eigen::VectorXd& coefficients) {
  Eigen::Index expected = 0;
  for (const TensorProductSpace& space : spaces) expected += space.size();
  if (coefficients.size() != expected)
    throw InvalidArgument("spaces with " + std::to_string(expected) + " functions cannot take " +
                          std::to_string(coefficients.size()) + " coefficients");
  std::vector<Field> functions;
  const double* own = coefficients.data();
  for (const TensorProductSpace& space : spaces) {
    functions.push_back(field(std::make_shared<SplineField>(
        space.grid(), space.degree(),
        space.expand({own, static_cast<std::size_t>(space.size())}))));
    own += space.size();
  }
  return functions;
}

Field solution_field(const Structure& structure, std::span<const Field> functions) {
  Field solution = structure.inhomogeneous();
  for (const Structure::Term& term : structure.terms()) {
    if (term.unknown < 0 || term.unknown >= static_cast<int>(functions.size()))
      throw InvalidArgument("a structure uses an undetermined function that is not given");
    solution = solution + term.coefficient * partial(functions[term.unknown], term.derivative);
  }
  return solution;
}

std::vector<Field> solution_fields(std::span<const Structure> structures,
                                   std::span<const TensorProductSpace> spaces,
                                   const Eigen::VectorXd& coefficients) {
  const std::vector<Field> functions = undetermined_functions(spaces, coefficients);
  std::vector<Field> solutions;
  for (const Structure& structure : structures)
    solutions.push_back(solution_field(structure, functions));
  return solutions;
}

}  // namespace rfm
