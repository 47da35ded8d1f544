#include "problems/distance_quality.hpp"

#include <algorithm>
#include <cmath>

#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "quadrature/integrate.hpp"

namespace rfm {

std::vector<std::pair<std::string, double>> distance_quality(const ScalarProblem& problem,
                                                             const DomainRule& rule) {
  const auto* system = std::get_if<RSystem>(&problem.problem().combine.rule);
  const Region& region = problem.region().region();
  const Field omega = implicit(region, system ? *system : RSystem(RAlpha{0}));
  const int dimension = region.dimension();
  const Tape tape(gradient(omega, dimension), std::vector<int>(dimension, 0), dimension);
  Tape::Workspace workspace(tape);
  std::vector<double> deviations(region.primitives().size(), -1.0);
  const SurfaceBlocks blocks(rule.boundary());
  for (int number = 0; number < blocks.count(); ++number) {
    const QuadratureBlock block = blocks.block(number);
    tape.evaluate(PointBlock{block.coordinates, block.count, 0, {}}, workspace);
    for (int point = 0; point < block.count; ++point) {
      double square = 0;
      for (int axis = 0; axis < dimension; ++axis)
        square += std::pow(workspace.coefficient(axis)[point], 2);
      double& deviation = deviations[block.numbers[point]];
      deviation = std::max(deviation, std::fabs(std::sqrt(square) - 1));
    }
  }
  std::vector<std::pair<std::string, double>> result;
  for (const int k : problem.bounding_primitives())
    if (deviations[k] >= 0) result.emplace_back(region.primitives()[k]->name, deviations[k]);
  return result;
}

}  // namespace rfm
