#include "problems/distance_quality.hpp"

#include <algorithm>
#include <cmath>

#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "quadrature/integrate.hpp"

namespace rfm {
namespace {

// |∇ω| at the points of a block, `inwards` from the boundary.
class Slopes {
 public:
  Slopes(const Field& omega, int dimension)
      : dimension_(dimension),
        tape_(gradient(omega, dimension), std::vector<int>(dimension, 0), dimension),
        workspace_(tape_) {}

  std::vector<double> at(const QuadratureBlock& block, double inwards) {
    std::array<std::array<double, QuadratureBlock::max_size>, 3> moved{};
    PointBlock points{block.coordinates, block.count, 0, {}};
    for (int axis = 0; axis < dimension_; ++axis) {
      for (int i = 0; i < block.count; ++i)
        moved[axis][i] = block.coordinates[axis][i] - inwards * block.normals[axis][i];
      points.coordinates[axis] = moved[axis].data();
    }
    tape_.evaluate(points, workspace_);
    std::vector<double> slopes;
    for (int i = 0; i < block.count; ++i) {
      double square = 0;
      for (int axis = 0; axis < dimension_; ++axis)
        square += std::pow(workspace_.coefficient(axis)[i], 2);
      slopes.push_back(std::sqrt(square));
    }
    return slopes;
  }

 private:
  int dimension_;
  Tape tape_;
  Tape::Workspace workspace_;
};

}  // namespace

Field domain_function(const ScalarProblem& problem) {
  const auto* system = std::get_if<RSystem>(&problem.problem().combine.rule);
  return implicit(problem.region().region(), system ? *system : RSystem(RAlpha{0}));
}

std::vector<std::pair<std::string, double>> distance_quality(const Field& omega,
                                                             const ScalarProblem& problem,
                                                             const DomainRule& rule,
                                                             const std::vector<int>& pieces) {
  const Region& region = problem.region().region();
  Slopes slopes(omega, region.dimension());
  const double beside = 1e-7 * problem.bounds().longest_side();
  std::vector<double> deviations(region.primitives().size(), -1.0);
  const SurfaceBlocks blocks(rule.boundary());
  for (int number = 0; number < blocks.count(); ++number) {
    const QuadratureBlock block = blocks.block(number);
    const std::vector<double> on = slopes.at(block, 0), inside = slopes.at(block, beside);
    for (int point = 0; point < block.count; ++point) {
      // On the point, unless the slope there is that of a convention, as of an R-function of two
      // zeros; beside it, unless an edge is nearly as near as that. Elsewhere both are the same.
      const double here = std::fabs(on[point] - 1), near = std::fabs(inside[point] - 1);
      double& deviation = deviations[block.numbers[point]];
      deviation = std::max(deviation, std::fmin(here, near));
    }
  }
  std::vector<std::pair<std::string, double>> result;
  for (const int k : pieces)
    if (deviations[k] >= 0) result.emplace_back(region.primitives()[k]->name, deviations[k]);
  return result;
}

}  // namespace rfm
