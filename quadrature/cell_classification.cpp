#include "quadrature/cell_classification.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/error.hpp"
#include "quadrature/surface_candidates.hpp"

namespace rfm {
namespace {

double quadrature_line(const Grid& grid, int axis, int index) {
  const Box& box = grid.box();
  const double margin = 0x1p-40 * box.longest_side() + 0x1p-50 * box.interval(axis).magnitude();
  const double line = grid.line(axis, index);
  return index == 0 ? line - margin : index == grid.cells(axis) ? line + margin : line;
}

// The cells begin[axis] ≤ index < end[axis].
struct Block {
  std::array<int, 3> begin{0, 0, 0};
  std::array<int, 3> end{1, 1, 1};

  bool is_cell() const {
    return end[0] - begin[0] == 1 && end[1] - begin[1] == 1 && end[2] - begin[2] == 1;
  }
  // Both halves of the axis along which the block has most cells.
  std::array<Block, 2> halves() const {
    int axis = 0;
    for (int other = 1; other < 3; ++other)
      if (end[other] - begin[other] > end[axis] - begin[axis]) axis = other;
    std::array<Block, 2> result{*this, *this};
    result[0].end[axis] = result[1].begin[axis] = (begin[axis] + end[axis]) / 2;
    return result;
  }
};

Box block_box(const Grid& grid, const Block& block) {
  Box box;
  box.dimension = grid.dimension();
  for (int axis = 0; axis < box.dimension; ++axis) {
    box.low[axis] = quadrature_line(grid, axis, block.begin[axis]);
    box.high[axis] = quadrature_line(grid, axis, block.end[axis]);
  }
  return box;
}

}  // namespace

Box quadrature_cell(const Grid& grid, const std::array<int, 3>& position) {
  Block block;
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    block.begin[axis] = position[axis];
    block.end[axis] = position[axis] + 1;
  }
  return block_box(grid, block);
}

class CellClassifier {
 public:
  CellClassifier(const RegionEvaluator& region, const Grid& grid, const Interfaces& interfaces,
                 Classification classification)
      : region_(region),
        grid_(grid),
        interfaces_(interfaces),
        is_tight_(classification == Classification::tight) {}

  CellClassification run() {
    states_.assign(grid_.cell_count(), CellState::outside);
    Block all;
    for (int axis = 0; axis < grid_.dimension(); ++axis) all.end[axis] = grid_.cells(axis);
    // Some tens of blocks for all threads; small grids are done before threads have started.
    constexpr int fewest_cells = 4096, depth = 6;
    std::vector<Waiting> waiting;
    std::vector<CellClassification> found(1);
    visit(all, SurfaceCandidates(region_, interfaces_), found[0],
          grid_.cell_count() < fewest_cells ? nullptr : &waiting, depth);
    found.resize(1 + waiting.size());
    tbb::parallel_for(std::size_t{0}, waiting.size(), [&](std::size_t i) {
      for (const Block& half : waiting[i].block.halves())
        visit(half, waiting[i].candidates, found[i + 1], nullptr, 0);
    });
    return sorted(found);
  }

 private:
  // Undecided.
  struct Waiting {
    Block block;
    SurfaceCandidates candidates;
  };

  // Splits `block` until every part is decided or a single cell, or, where others wait, `depth`
  // times. Cut cells go to `found`.
  void visit(const Block& block, SurfaceCandidates candidates, CellClassification& found,
             std::vector<Waiting>* waiting, int depth) {
    const Box box = block_box(grid_, block);
    Truth inside = candidates.narrow(box, false, region_, interfaces_);
    const auto is_decided = [&] {
      return inside == Truth::no || (inside == Truth::yes && candidates.interfaces.empty());
    };
    if (is_tight_ && block.is_cell() && !is_decided())
      inside = candidates.narrow(box, true, region_, interfaces_);
    if (is_decided()) return inside == Truth::yes ? fill(block) : void();
    if (block.is_cell()) return add_cut_cell(block, candidates, found);
    if (waiting && depth == 0) return waiting->push_back({block, std::move(candidates)});
    const auto halves = block.halves();
    visit(halves[0], candidates, found, waiting, depth - 1);
    visit(halves[1], std::move(candidates), found, waiting, depth - 1);
  }

  void fill(const Block& block) {
    for (int k = block.begin[2]; k < block.end[2]; ++k)
      for (int j = block.begin[1]; j < block.end[1]; ++j)
        for (int i = block.begin[0]; i < block.end[0]; ++i)
          states_[grid_.number({i, j, k})] = CellState::inside;
  }

  void add_cut_cell(const Block& block, SurfaceCandidates& candidates, CellClassification& found) {
    TruthTable table(true);
    const bool few =
        candidates.primitives.size() <= static_cast<std::size_t>(TruthTable::max_variables);
    if (few) {
      table = candidates.make_table(region_.region().expression());
      // Bounds see signs one by one; the table knows that w | !w is always true.
      if (table.variable_count() == 0 && !table.value(0)) return;
      if (table.variable_count() == 0 && candidates.interfaces.empty()) return fill(block);
    }
    const int cell = grid_.number(block.begin);
    states_[cell] = CellState::cut;
    found.cut_cells.push_back(cell);
    append(found.primitives_, found.primitive_begin_, candidates.primitives);
    append(found.interfaces_, found.interface_begin_, candidates.interfaces);
    append(found.words_, found.word_begin_, few ? table.words() : std::span<const std::uint64_t>());
  }

  template <class Value, class Range>
  static void append(std::vector<Value>& values, std::vector<std::size_t>& begin,
                     const Range& more) {
    values.insert(values.end(), more.begin(), more.end());
    begin.push_back(values.size());
  }

  // The tree meets cells in its own order.
  CellClassification sorted(const std::vector<CellClassification>& found) {
    struct Place {
      int cell, part, index;
    };
    std::vector<Place> order;
    for (std::size_t part = 0; part < found.size(); ++part)
      for (std::size_t i = 0; i < found[part].cut_cells.size(); ++i)
        order.push_back({found[part].cut_cells[i], static_cast<int>(part), static_cast<int>(i)});
    std::ranges::sort(order, {}, &Place::cell);
    CellClassification result;
    result.states = std::move(states_);
    for (const Place& place : order) {
      const CellClassification& part = found[place.part];
      result.cut_cells.push_back(place.cell);
      append(result.primitives_, result.primitive_begin_, part.primitives(place.index));
      append(result.interfaces_, result.interface_begin_, part.interfaces(place.index));
      append(result.words_, result.word_begin_,
             CellClassification::range(part.words_, part.word_begin_, place.index));
    }
    return result;
  }

  const RegionEvaluator& region_;
  const Grid& grid_;
  Interfaces interfaces_;
  bool is_tight_;
  std::vector<CellState> states_;
};

CellClassification classify_cells(const RegionEvaluator& region, const Grid& grid,
                                  const Interfaces& interfaces, Classification classification) {
  if (region.dimension() != grid.dimension())
    throw InvalidArgument("region and grid differ in dimension");
  return CellClassifier(region, grid, interfaces, classification).run();
}

}  // namespace rfm
