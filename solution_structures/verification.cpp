#include "solution_structures/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/tape.hpp"

namespace rfm {

Field random_function(int dimension, unsigned seed, const Point& centre, double size) {
  // The engine is the same everywhere, distributions of the standard library are not.
  std::mt19937 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine()) / 0x80000000u - 1; };
  constexpr int degree = 4;
  std::array<Field, 3> x{0.0, 0.0, 0.0};
  for (int axis = 0; axis < 3; ++axis) x[axis] = (coordinate(axis) - centre[axis]) / size;
  Field sum = 0.0, phase = 3 * uniform();
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= (dimension > 1 ? degree : i); ++j)
      for (int k = 0; i + j + k <= (dimension > 2 ? degree : i + j); ++k)
        sum = sum + uniform() * pow(x[0], i) * pow(x[1], j) * pow(x[2], k);
  for (int axis = 0; axis < dimension; ++axis) phase = phase + 3 * uniform() * x[axis];
  return sum + sin(phase);
}

std::vector<Field> random_solution(const std::vector<Structure>& structures,
                                   const StructureTrials& trials, int trial) {
  const unsigned seed = trials.seed + static_cast<unsigned>(trial);
  std::vector<Field> functions, solution;
  for (const Structure& structure : structures) {
    while (static_cast<int>(functions.size()) < structure.unknown_count())
      functions.push_back(product_or_nothing(
          trials.amplitude,
          random_function(trials.dimension, 1000 * seed + static_cast<unsigned>(functions.size()),
                          trials.centre, trials.size)));
    Field u = structure.inhomogeneous();
    for (const Structure::Term& term : structure.terms())
      u = u + term.coefficient *
                  partial(functions[static_cast<std::size_t>(term.unknown)], term.derivative);
    solution.push_back(u);
  }
  return solution;
}

std::vector<Field> random_solution(const std::vector<Structure>& structures, int dimension,
                                   unsigned seed) {
  return random_solution(structures, {.dimension = dimension, .seed = seed});
}

StructureDeviation largest_deviation(const std::vector<Structure>& structures,
                                     const BoundaryOperator& condition, const Field& data,
                                     std::span<const Point> points, const StructureTrials& trials) {
  if (points.empty())
    throw InvalidArgument("a structure is verified at points, and there are none");
  std::vector<Field> deviations;
  for (int trial = 0; trial < trials.count; ++trial)
    deviations.push_back(condition(random_solution(structures, trials, trial)) - data);
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
