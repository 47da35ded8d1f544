#include "solvers/tile_integrator.hpp"

#include <algorithm>

namespace rfm {
namespace {

constexpr int batch_points = 512;  // coefficients are evaluated for so many points at once
constexpr int part_points = 128;   // cut cells with more points are done in parts

using Place = Contribution::Place;

}  // namespace

AssemblyPlan::AssemblyPlan(std::span<const Structure> structures,
                           std::span<const TensorProductSpace> spaces,
                           std::span<const Contribution> contributions, const DomainRule& rule,
                           const FieldArguments& arguments)
    : spaces(spaces),
      arguments(arguments),
      rule(rule),
      index(rule),
      symmetric(std::all_of(contributions.begin(), contributions.end(),
                            [](const Contribution& part) { return part.couplings.empty(); })),
      coupled(spaces.size() * spaces.size(), false) {
  integrands.reserve(contributions.size());  // basis values refer to them
  for (const Contribution& contribution : contributions) {
    const CompiledIntegrand& integrand =
        integrands.emplace_back(contribution, structures, rule.dimension());
    const CellKernel kernel(integrand, spaces, symmetric);
    for (const auto& [row, column, slots] : kernel.pairings())
      coupled[row * spaces.size() + column] = true;
    inside_values.emplace_back(spaces, integrand.basis_derivatives());
    if (contribution.place == Place::volume)
      inside_values.back().evaluate_reference(rule.inside_rule().nodes);
  }
}

TileIntegrator::TileIntegrator(const AssemblyPlan& plan, int integrand)
    : plan_(plan),
      contribution_(plan.integrands[integrand].contribution()),
      inside_values_(plan.inside_values[integrand]),
      capacity_(std::max(batch_points, inside_values_.points())),
      values_(plan.integrands[integrand], capacity_),
      kernel_(plan.integrands[integrand], plan.spaces, plan.symmetric),
      basis_(plan.spaces, plan.integrands[integrand].basis_derivatives()) {}

void TileIntegrator::integrate(const CellTiles& tiles, int tile, AssemblySums& sums) {
  sums_ = &sums;
  tile_ = tile;
  tiles.visit_cells(tile, [&](int cell) {
    if (contribution_.place == Place::volume)
      add_volume(cell);
    else
      add_surface(cell);
  });
  flush();
}

void TileIntegrator::add_volume(int cell) {
  const CellState state = plan_.rule.state(cell);
  if (state == CellState::inside) {
    make_room(inside_values_.points());
    const int first = points_.size();
    plan_.index.add_inside(cell, points_);
    items_.push_back({cell, first, points_.size(), plan_.rule.grid().is_uniform()});
  } else if (state == CellState::cut) {
    add_in_parts(cell, plan_.index.cut_range(cell),
                 [&](PointRange part) { plan_.index.add_cut(part, points_); });
  }
}

void TileIntegrator::add_surface(int cell) {
  const Place place = contribution_.place;
  add_in_parts(cell, plan_.index.surface_range(place, cell), [&](PointRange part) {
    plan_.index.add_surface(place, part, contribution_.numbers, points_);
  });
}

template <class Append>
void TileIntegrator::add_in_parts(int cell, PointRange range, Append&& append) {
  for (int begin = range.begin; begin < range.end; begin += part_points) {
    const PointRange part{begin, std::min(begin + part_points, range.end)};
    make_room(part.size());
    const int first = points_.size();
    append(part);
    if (points_.size() > first) items_.push_back({cell, first, points_.size(), false});
  }
}

void TileIntegrator::make_room(int points) {
  if (points_.size() + points > capacity_) flush();
}

void TileIntegrator::flush() {
  if (items_.empty()) return;
  values_.evaluate(points_, plan_.arguments.time, plan_.arguments.parameters);
  for (const Item& item : items_) {
    if (!item.tabulated) basis_.evaluate(item.cell, points_, item.first, item.last);
    kernel_.compute(values_, item.first, item.tabulated ? inside_values_ : basis_);
    for (int i = 0; i < static_cast<int>(kernel_.pairings().size()); ++i) {
      const auto& [row, column, slots] = kernel_.pairings()[i];
      sums_->matrix.add(item.cell, row, column, kernel_.matrix(i), kernel_.stride(i));
    }
    add_load(item.cell);
    sums_->constants[tile_].add(values_.constant(item.first, item.last));
  }
  points_.clear();
  items_.clear();
}

void TileIntegrator::add_load(int cell) {
  for (int i = 0; i < static_cast<int>(kernel_.loaded().size()); ++i) {
    const int unknown = kernel_.loaded()[i];
    const TensorProductSpace& space = plan_.spaces[unknown];
    functions_.resize(space.functions_per_cell());
    space.cell_functions(cell, functions_);
    const int offset = sums_->matrix.offsets()[unknown];
    for (std::size_t f = 0; f < functions_.size(); ++f)
      if (functions_[f] >= 0) sums_->right_hand_side[offset + functions_[f]] += kernel_.load(i)[f];
  }
}

}  // namespace rfm
