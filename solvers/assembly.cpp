#include "solvers/assembly.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>

#include "core/error.hpp"
#include "quadrature/compensated_sum.hpp"
#include "solvers/cell_kernel.hpp"
#include "solvers/cell_points.hpp"
#include "solvers/cell_tiles.hpp"
#include "solvers/nested_dissection.hpp"
#include "solvers/stencil_matrix.hpp"

namespace rfm {
namespace {

constexpr int batch_points = 512;  // coefficients are evaluated for so many points at once
constexpr int cell_points = 128;   // cells with more points are done in parts

using Place = Contribution::Place;

/// Everything that is known before the first point.
struct Plan {
  std::span<const TensorProductSpace> spaces;
  const DomainRule& rule;
  const FieldArguments& arguments;
  std::vector<CompiledIntegrand> integrands;
  /// Basis functions at the points of a cell inside, per integrand.
  std::vector<BasisValues> inside_values;
  std::vector<bool> coupled;
  CellPointIndex index;
};

Plan make_plan(std::span<const Structure> structures, std::span<const TensorProductSpace> spaces,
               std::span<const Contribution> contributions, const DomainRule& rule,
               const FieldArguments& arguments) {
  const std::size_t unknowns = spaces.size();
  Plan plan{spaces, rule, arguments, {}, {}, std::vector<bool>(unknowns * unknowns, false),
            CellPointIndex(rule)};
  plan.integrands.reserve(contributions.size());  // basis values refer to them
  for (const Contribution& contribution : contributions) {
    const CompiledIntegrand& integrand =
        plan.integrands.emplace_back(contribution, structures, rule.dimension());
    const CellKernel kernel(integrand, spaces);
    for (const auto& [row, column, slots] : kernel.pairings())
      plan.coupled[row * unknowns + column] = true;
    plan.inside_values.emplace_back(spaces, integrand.basis_derivatives());
    if (contribution.place == Place::volume)
      plan.inside_values.back().evaluate_reference(rule.inside_rule().nodes);
  }
  return plan;
}

/// What grows: the matrix, the right-hand side, and the constant of every tile.
struct Sums {
  StencilMatrix matrix;
  Eigen::VectorXd right_hand_side;
  std::vector<CompensatedSum> constants;
};

/// One integrand on the cells of one tile, on one thread.
class TileIntegrator {
 public:
  TileIntegrator(const Plan& plan, int number)
      : plan_(plan),
        number_(number),
        capacity_(std::max(batch_points, plan.inside_values[number].points())),
        values_(plan.integrands[number], capacity_),
        kernel_(plan.integrands[number], plan.spaces),
        basis_(plan.spaces, plan.integrands[number].basis_derivatives()) {}

  void integrate(const CellTiles& tiles, int tile, Sums& sums) {
    const Contribution& contribution = plan_.integrands[number_].contribution();
    tiles.visit_cells(tile, [&](int cell) {
      if (contribution.place == Place::volume)
        add_volume(cell, sums, tile);
      else
        add_surface(cell, contribution, sums, tile);
    });
    flush(sums, tile);
  }

 private:
  struct Item {
    int cell = 0, first = 0, last = 0;
    bool inside = false;
  };

  void add_volume(int cell, Sums& sums, int tile) {
    const CellState state = plan_.rule.state(cell);
    if (state == CellState::outside) return;
    if (state == CellState::inside) {
      const int count = plan_.inside_values[number_].points();
      if (points_.size() + count > capacity_) flush(sums, tile);
      const int first = points_.size();
      plan_.index.add_inside(cell, points_);
      items_.push_back({cell, first, points_.size(), true});
      return;
    }
    const PointRange range = plan_.index.cut_range(cell);
    for (int begin = range.begin; begin < range.end; begin += cell_points) {
      const PointRange part{begin, std::min(begin + cell_points, range.end)};
      if (points_.size() + part.size() > capacity_) flush(sums, tile);
      const int first = points_.size();
      plan_.index.add_cut(part, points_);
      items_.push_back({cell, first, points_.size(), false});
    }
  }

  void add_surface(int cell, const Contribution& contribution, Sums& sums, int tile) {
    const PointRange range = plan_.index.surface_range(contribution.place, cell);
    for (int begin = range.begin; begin < range.end; begin += cell_points) {
      const PointRange part{begin, std::min(begin + cell_points, range.end)};
      if (points_.size() + part.size() > capacity_) flush(sums, tile);
      const int first = points_.size();
      plan_.index.add_surface(contribution.place, part, contribution.numbers, points_);
      if (points_.size() > first) items_.push_back({cell, first, points_.size(), false});
    }
  }

  void flush(Sums& sums, int tile) {
    if (items_.empty()) return;
    values_.evaluate(points_, plan_.arguments.time, plan_.arguments.parameters);
    for (const Item& item : items_) {
      if (!item.inside) basis_.evaluate(item.cell, points_, item.first, item.last);
      kernel_.compute(values_, item.first, item.inside ? plan_.inside_values[number_] : basis_);
      for (std::size_t i = 0; i < kernel_.pairings().size(); ++i) {
        const auto& [row, column, slots] = kernel_.pairings()[i];
        sums.matrix.add(item.cell, row, column, kernel_.matrix(int(i)), kernel_.stride(int(i)));
      }
      if (values_.has_load()) add_load(item.cell, sums);
      sums.constants[tile].add(values_.constant(item.first, item.last));
    }
    points_.clear();
    items_.clear();
  }

  void add_load(int cell, Sums& sums) {
    for (std::size_t i = 0; i < kernel_.loaded().size(); ++i) {
      const int unknown = kernel_.loaded()[i];
      const TensorProductSpace& space = plan_.spaces[unknown];
      functions_.resize(space.functions_per_cell());
      space.cell_functions(cell, functions_);
      const int offset = sums.matrix.offsets()[unknown];
      const double* load = kernel_.load(int(i));
      for (std::size_t f = 0; f < functions_.size(); ++f)
        if (functions_[f] >= 0) sums.right_hand_side[offset + functions_[f]] += load[f];
    }
  }

  const Plan& plan_;
  int number_;
  int capacity_;
  IntegrandValues values_;
  CellKernel kernel_;
  BasisValues basis_;
  IntegrandPoints points_;
  std::vector<Item> items_;
  std::vector<int> functions_;
};

void require_consistent(std::span<const TensorProductSpace> spaces, const DomainRule& rule) {
  if (spaces.empty()) throw InvalidArgument("assembly needs a space for every undetermined function");
  for (const TensorProductSpace& space : spaces)
    if (!same_grid(space.grid(), rule.grid()))
      throw InvalidArgument("spaces and the rule of quadrature must share one background grid");
}

}  // namespace

std::vector<std::uint8_t> cells_in_region(const DomainRule& rule) {
  std::vector<std::uint8_t> cells(rule.grid().cell_count());
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    cells[cell] = rule.state(static_cast<int>(cell)) != CellState::outside;
  return cells;
}

LinearSystem assemble(std::span<const Structure> structures,
                      std::span<const TensorProductSpace> spaces,
                      std::span<const Contribution> contributions, const DomainRule& rule,
                      const FieldArguments& arguments) {
  require_consistent(spaces, rule);
  const Plan plan = make_plan(structures, spaces, contributions, rule, arguments);
  int degree = 0;
  for (const TensorProductSpace& space : spaces) degree = std::max(degree, space.degree());
  const CellTiles tiles(rule.grid(), degree);
  Sums sums{StencilMatrix(spaces, plan.coupled), {}, std::vector<CompensatedSum>(tiles.count())};
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
  system.elimination_order = nested_dissection(spaces);
  CompensatedSum constant;
  for (const CompensatedSum& tile : sums.constants) constant.add(tile.value());
  system.constant = constant.value();
  return system;
}

}  // namespace rfm
