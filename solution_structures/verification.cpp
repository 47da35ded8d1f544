#include "solution_structures/verification.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/tape.hpp"

namespace rfm {

Field random_function(int dimension, unsigned seed) {
  // The engine is the same everywhere, distributions of the standard library are not.
  std::mt19937 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine()) / 0x80000000u - 1; };
  constexpr int degree = 4;
  Field sum = 0.0, phase = 3 * uniform();
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= (dimension > 1 ? degree : i); ++j)
      for (int k = 0; i + j + k <= (dimension > 2 ? degree : i + j); ++k)
        sum =
            sum + uniform() * pow(coordinate(0), i) * pow(coordinate(1), j) * pow(coordinate(2), k);
  for (int axis = 0; axis < dimension; ++axis) phase = phase + 3 * uniform() * coordinate(axis);
  return sum + sin(phase);
}

std::vector<Field> random_solution(const std::vector<Structure>& structures, int dimension,
                                   unsigned seed) {
  std::vector<Field> functions, solution;
  for (const Structure& structure : structures) {
    while (static_cast<int>(functions.size()) < structure.unknown_count())
      functions.push_back(
          random_function(dimension, 1000 * seed + static_cast<unsigned>(functions.size())));
    Field u = structure.inhomogeneous();
    for (const Structure::Term& term : structure.terms())
      u = u + term.coefficient *
                  partial(functions[static_cast<std::size_t>(term.unknown)], term.derivative);
    solution.push_back(u);
  }
  return solution;
}

StructureDeviation largest_deviation(const std::vector<Structure>& structures,
                                     const BoundaryOperator& condition, const Field& data,
                                     std::span<const Point> points, const StructureTrials& trials) {
  if (points.empty())
    throw InvalidArgument("a structure is verified at points, and there are none");
  std::vector<Field> deviations;
  for (int trial = 0; trial < trials.count; ++trial)
    deviations.push_back(condition(random_solution(structures, trials.dimension,
                                                   trials.seed + static_cast<unsigned>(trial))) -
                         data);
  const Tape tape(deviations, {0}, trials.dimension);
  StructureDeviation worst;
  for (const Point& point : points)
    for (int trial = 0; trial < trials.count; ++trial) {
      const double deviation = std::fabs(tape.value(point, trial));
      if (deviation <= worst.largest) continue;
      worst = {deviation, point, trial};
      if (std::isnan(deviation)) return worst;
    }
  return worst;
}

}  // namespace rfm
