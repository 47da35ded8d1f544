#pragma once

#include "quadrature/breakpoints.hpp"
#include "quadrature/cell_classification.hpp"
#include "quadrature/cell_measure.hpp"
#include "quadrature/gauss_legendre.hpp"
#include "quadrature/grading.hpp"
#include "quadrature/quadrature_points.hpp"
#include "quadrature/subdivision_options.hpp"

namespace rfm {

struct QuadratureOptions {
  /// Gauss points per axis in cells inside: p + 1 for splines of degree p, exact for products of
  /// two of them.
  int inside_points = 4;
  /// Gauss points per one-dimensional piece in cut cells and on boundaries: p + 3.
  int cut_points = 6;
  /// Whether the report says how far volume and boundary are from those of a rule of lower order:
  /// an upper bound of their errors in practice, at a fifth to a half of their cost again.
  bool compare_orders = true;
  /// Whether cut cells keep at most cut_points^d of their points, with weights that are exact for
  /// polynomials of total degree `compressed_degree` (see `compress`). Cells that interfaces,
  /// breakpoints or gradings split keep all. Off: it costs more than assembly gains
  /// (docs/quadrature.md).
  bool compress_cut_cells = false;
  /// Where integrands are not smooth, beside the breakpoints of the primitives themselves.
  Breakpoints breakpoints;
  /// Points and segments where integrands are singular: rules are graded towards them.
  std::vector<Grading> gradings;
  SubdivisionOptions subdivision;
};

/// Positions begin ≤ i < end in arrays of points.
struct PointRange {
  int begin = 0;
  int end = 0;
  int size() const { return end - begin; }
};

/// Points on boundaries or interfaces, those of a cell side by side, cells ascending. A point on a
/// side shared by cells belongs to the cell on the inner side of the boundary.
struct SurfaceRule {
  SurfacePoints points;
  /// The cells with points; the points of cells[i] are `range(i)`.
  std::vector<int> cells;
  std::vector<int> begin{0};

  PointRange range(int i) const { return {begin[i], begin[i + 1]}; }
  /// Sum of the weights: length, area or number of points; of one primitive or interface.
  double measure() const;
  double measure(int number) const;
};

/// What a rule says of one cell.
struct CellReport {
  int cell = 0;
  Uncertified uncertified;
  CellMeasure order_difference;
};

struct QuadratureReport {
  int inside_cells = 0;
  int cut_cells = 0;
  /// The smallest part of a cut cell that lies inside; 1 without cut cells.
  double smallest_cut_fraction = 1;
  /// Boxes whose rule is a best effort: the order is lost in at most this measure.
  Uncertified uncertified;
  /// Sum over cut cells of three times how far volume and boundary are from those by a rule of one
  /// Gauss point fewer (of one point, one more); 0 if this was not asked for.
  CellMeasure order_difference;
  /// |∮ n·x ds / d − volume|: the divergence theorem for the field x/d, an independent check of
  /// volume rule, boundary rule and normals together.
  double divergence_defect = 0;
  /// Where: every cell that bounds left undecided or that was split, ascending. Uncertified
  /// measures and differences of orders add up to those above; see also `divergence_defects`.
  std::vector<CellReport> cells;
};

/// Quadrature over a region and over its boundary, sorted by the cells of a grid: what assembly
/// needs. Cells inside share one tensor-product Gauss rule; cut cells have points of their own. All
/// weights are positive, and the result does not depend on the number of threads.
class DomainRule {
 public:
  const Grid& grid() const { return grid_; }
  int dimension() const { return grid_.dimension(); }
  /// `cut` says that the cell has points of its own: it meets the boundary or an interface, or is
  /// split at breakpoints or graded. Cells that the boundary only touches are inside or outside.
  CellState state(int cell) const { return states_[cell]; }

  const std::vector<int>& inside_cells() const { return inside_cells_; }
  /// The rule along each axis of a cell inside, on [0, 1].
  const GaussRule& inside_rule() const { return gauss_legendre(inside_points_); }
  /// Points of cell `cell`, inside, x running fastest, appended to `points`.
  void add_inside_points(int cell, VolumePoints& points) const;

  const std::vector<int>& cut_cells() const { return cut_cells_; }
  const VolumePoints& cut_points() const { return cut_points_; }
  /// The points of cut_cells()[i].
  PointRange cut_range(int i) const { return {cut_begin_[i], cut_begin_[i + 1]}; }

  const SurfaceRule& boundary() const { return boundary_; }
  /// Interfaces where they are inside the region.
  const SurfaceRule& interfaces() const { return interfaces_; }

  const QuadratureReport& report() const { return report_; }
  /// Length, area or volume of the region.
  double measure() const;
  double boundary_measure() const { return boundary_.measure(); }
  double boundary_measure(int primitive) const { return boundary_.measure(primitive); }

 private:
  friend class DomainRuleBuilder;
  explicit DomainRule(const Grid& grid) : grid_(grid) {}

  Grid grid_;
  int inside_points_ = 1;
  std::vector<CellState> states_;
  std::vector<int> inside_cells_, cut_cells_, cut_begin_{0};
  VolumePoints cut_points_;
  SurfaceRule boundary_, interfaces_;
  QuadratureReport report_;
};

/// The rule for `region`, which must lie within the box of `grid`. `interfaces` are curves
/// (surfaces) across which integrands jump: every volume point of a cut cell lies clearly on one
/// side, and pieces of the boundary are split there too; where parts of the boundary end these
/// alone are. Parallel over cut cells. The error is
/// O(h^(2·cut_points)) in cut cells where primitives are smooth (see `add_cell_rule`). Throws
/// `InvalidArgument` when region and grid differ in dimension or an option is out of range.
DomainRule make_domain_rule(const RegionEvaluator& region, const Grid& grid,
                            const QuadratureOptions& options = {},
                            const Interfaces& interfaces = {});

}  // namespace rfm
