#pragma once

#include <functional>

#include "quadrature/breakpoints.hpp"
#include "quadrature/cell_classification.hpp"
#include "quadrature/subdivision.hpp"
#include "quadrature/surface_candidates.hpp"

namespace rfm {

/// The surfaces of a region and its interfaces, ready to be put into active sets cell by cell.
class CellSurfaces {
 public:
  /// Refers to the region and the level functions of the interfaces.
  CellSurfaces(const RegionEvaluator& region, const Interfaces& interfaces);

  /// `others` together with the breakpoints of the surfaces, ascending.
  Breakpoints breakpoints(const Breakpoints& others) const;

  using BoxVisitor = std::function<void(const Box&, const ActiveSet&)>;

  /// Calls `visit` for the parts of a cell between `breakpoints`, each with the surfaces that
  /// matter there. `cut_cell` counts the cut cells of `classification`; `box` is the cell. A cell
  /// with more primitives than a truth table holds is bisected until there are few enough; what
  /// remains crowded after that is taken to be as its centre is, and returned as uncertified.
  Uncertified visit_cut_cell(const CellClassification& classification, int cut_cell, const Box& box,
                             const Breakpoints& breakpoints, const BoxVisitor& visit) const;
  /// The same for a cell inside.
  void visit_inside_cell(const Box& box, const Breakpoints& breakpoints,
                         const BoxVisitor& visit) const;

 private:
  Uncertified visit_crowded(const Box& box, SurfaceCandidates candidates, int depth,
                            const BoxVisitor& visit) const;
  ActiveSet active_set(const TruthTable& table, std::span<const int> primitives,
                       std::span<const int> interfaces) const;

  const RegionEvaluator& region_;
  Interfaces all_interfaces_;
  std::vector<Surface> primitives_, interfaces_;
};

/// Whether a breakpoint lies strictly within the box.
bool is_split(const Box& box, const Breakpoints& breakpoints);

}  // namespace rfm
