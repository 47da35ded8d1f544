#pragma once

#include "quadrature/compensated_sum.hpp"
#include "quadrature/cut_cell.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

/// What a cell with points of its own contributes to a rule.
struct CellContribution {
  CellReport report;
  CellState state;
  int volume_points, boundary_points, interface_points;
  /// The part of the cell that lies inside.
  double fraction;
};

/// What a run of cells contributes to a rule: made by one thread, joined with others in the order
/// of the cells. Points keep to the box of the grid, although quadrature cells reach beyond it by
/// rounding.
struct RulePart {
  VolumePoints volume;
  SurfacePoints boundary, interfaces;
  std::vector<CellContribution> cells;
  /// Sums of the weights of `volume`, and of weights times n·(x − c) over `boundary`, c the centre
  /// of the grid.
  CompensatedSum measure, flux;

  /// Copies the points of `rule`, which were made in memory that is used again, and finds the flux.
  void take(const Box& grid_box, const CellRule& rule);
};

/// The points of all parts, which lose theirs. Parallel over arrays: it is mostly time to touch new
/// memory.
VolumePoints joined_volume(int dimension, std::span<RulePart> parts);

/// The points `points` of all parts, which lose theirs, sorted by the cell to which they belong.
/// `count` of a contribution is how many points were found in its cell; `states` are those of all
/// cells of the grid.
SurfaceRule joined_surface(const Grid& grid, const std::vector<CellState>& states,
                           std::span<RulePart> parts, SurfacePoints RulePart::*points,
                           int CellContribution::*count);

}  // namespace rfm
