#pragma once

#include <vector>

#include "core/grid.hpp"
#include "core/region.hpp"
#include "quadrature/active_set.hpp"
#include "quadrature/interfaces.hpp"

namespace rfm {

/// How a cell of the grid meets the region.
///
///     +-------+   inside:   every point is in the region, and no interface crosses the cell
///     | . . . |   outside:  no point is
///     +-------+   cut:      neither is proved, or a boundary or an interface may pass
///
/// A cell whose side lies exactly on a face of the region is inside on the one hand and cut on the
/// other, where the face itself belongs to the region (sign(0) = +).
enum class CellState : signed char { outside, inside, cut };

/// The cells of a grid sorted by bounds of the primitives: an octree over the grid is descended
/// with plain interval arithmetic, and children inherit the primitives that still matter; single
/// cells left over may get the tighter bounds of `LevelFunction::bounds`. Any numbers of cells per
/// axis.
struct CellClassification {
  /// Per cell of the grid, in its numbering.
  std::vector<CellState> states;
  /// The cut cells, ascending.
  std::vector<int> cut_cells;

  /// Primitives that matter in cut cell `i`, and the interfaces that may cross it.
  std::span<const int> primitives(int i) const { return range(primitives_, primitive_begin_, i); }
  std::span<const int> interfaces(int i) const { return range(interfaces_, interface_begin_, i); }
  /// Whether a truth table holds the primitives of cut cell `i`; if not there are too many and the
  /// cell has to be divided.
  bool has_table(int i) const {
    return primitives(i).size() <= static_cast<std::size_t>(TruthTable::max_variables);
  }
  TruthTable table(int i) const {
    return TruthTable(static_cast<int>(primitives(i).size()), range(words_, word_begin_, i));
  }

 private:
  friend class CellClassifier;
  template <class Value>
  static std::span<const Value> range(const std::vector<Value>& values,
                                      const std::vector<std::size_t>& begin, int i) {
    return std::span(values).subspan(begin[i], begin[i + 1] - begin[i]);
  }
  std::vector<int> primitives_, interfaces_;
  std::vector<std::uint64_t> words_;
  std::vector<std::size_t> primitive_begin_{0}, interface_begin_{0}, word_begin_{0};
};

/// The box of cell `position` as quadrature sees it: cells at the sides of the grid reach beyond it
/// by 2⁻⁴⁰ of its size, so that faces of the region on these sides lie within a cell.
Box quadrature_cell(const Grid& grid, const std::array<int, 3>& position);

/// How far to go with single cells that plain intervals do not decide.
enum class Classification {
  tight,  ///< the best bounds there are
  loose,  ///< left as cut: for those who look at every cut cell anyhow
};

/// Throws `InvalidArgument` when the dimensions of region and grid differ.
CellClassification classify_cells(const RegionEvaluator& region, const Grid& grid,
                                  const Interfaces& interfaces = {},
                                  Classification classification = Classification::tight);

}  // namespace rfm
