#include "solvers/assembly.hpp"

#include <numeric>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.hpp"
#include "solvers/nested_dissection.hpp"
#include "solvers/tile_integrator.hpp"

namespace rfm {
namespace {

void require_consistent(std::span<const TensorProductSpace> spaces, const DomainRule& rule) {
  if (spaces.empty())
    throw InvalidArgument("assembly needs a space for every undetermined function");
  for (const TensorProductSpace& space : spaces)
    if (!(space.grid() == rule.grid()))
      throw InvalidArgument("spaces and the rule of quadrature must share one background grid");
}

// The part of a cell on which splines have a negligible energy.
double part_of_a_touch(int dimension, int degree) {
  if (dimension == 1) return 0;
  const double energy = dimension == 2 ? 1e-24 : 1e-17;
  return std::pow(energy, 1 / (1 + 4.0 * (degree - 1) / (dimension + 1)));
}

}  // namespace

std::vector<std::uint8_t> cells_in_region(const DomainRule& rule, int degree) {
  std::vector<std::uint8_t> cells(rule.grid().cell_count());
  for (const int cell : rule.inside_cells()) cells[cell] = 1;
  std::vector<double> parts(rule.cut_cells().size());
  double largest_part = rule.inside_cells().empty() ? 0 : 1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PointRange range = rule.cut_range(static_cast<int>(i));
    const auto first = rule.cut_points().weights.begin();
    parts[i] = std::accumulate(first + range.begin, first + range.end, 0.0) /
               rule.grid().cell_measure(rule.cut_cells()[i]);
    largest_part = std::max(largest_part, parts[i]);
  }
  const double smallest_part = part_of_a_touch(rule.dimension(), degree) * largest_part;
  for (std::size_t i = 0; i < parts.size(); ++i)
    cells[rule.cut_cells()[i]] = parts[i] > smallest_part;
  return cells;
}

LinearSystem assemble(std::span<const Structure> structures,
                      std::span<const TensorProductSpace> spaces,
                      std::span<const Contribution> contributions, const DomainRule& rule,
                      const FieldArguments& arguments) {
  require_consistent(spaces, rule);
  const AssemblyPlan plan(structures, spaces, contributions, rule, arguments);
  int degree = 0;
  for (const TensorProductSpace& space : spaces) degree = std::max(degree, space.degree());
  const CellTiles tiles(rule.grid(), degree);
  AssemblySums sums{StencilMatrix(spaces, plan.coupled, plan.symmetric),
                    {},
                    std::vector<CompensatedSum>(tiles.count())};
  sums.right_hand_side = Eigen::VectorXd::Zero(sums.matrix.offsets().back());

  using Integrators = std::vector<std::unique_ptr<TileIntegrator>>;
  tbb::enumerable_thread_specific<Integrators> integrators([&] {
    Integrators own;
    for (std::size_t i = 0; i < plan.integrands.size(); ++i)
      own.push_back(std::make_unique<TileIntegrator>(plan, static_cast<int>(i)));
    return own;
  });
  for (const std::vector<int>& colour : tiles.colours())
    tbb::parallel_for_each(colour, [&](int tile) {
      for (const auto& integrator : integrators.local()) integrator->integrate(tiles, tile, sums);
    });

  LinearSystem system;
  system.matrix = sums.matrix.compress();
  system.right_hand_side = std::move(sums.right_hand_side);
  system.symmetric = plan.symmetric;
  if (plan.symmetric) system.elimination_order = nested_dissection(spaces);
  CompensatedSum constant;
  for (const CompensatedSum& tile : sums.constants) constant.add(tile.value());
  system.constant = constant.value();
  return system;
}

}  // namespace rfm
