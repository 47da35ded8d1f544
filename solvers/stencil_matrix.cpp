#include "solvers/stencil_matrix.hpp"

#include <tbb/parallel_for.h>

#include "core/error.hpp"

namespace rfm {
StencilMatrix::StencilMatrix(std::span<const TensorProductSpace> spaces,
                             const std::vector<bool>& coupled, bool symmetric)
    : spaces_(spaces), symmetric_(symmetric), offsets_{0}, block_number_(coupled.size(), -1) {
  const int count = static_cast<int>(spaces.size());
  for (const TensorProductSpace& space : spaces) {
    if (!(space.grid() == spaces[0].grid()))
      throw InvalidArgument("all undetermined functions must share one background grid");
    offsets_.push_back(offsets_.back() + space.size());
  }
  for (int k = 0; k < count; ++k)
    for (int l = 0; l <= (symmetric ? k : count - 1); ++l) {
      if (!coupled[k * count + l] && k != l) continue;
      block_number_[k * count + l] = static_cast<int>(blocks_.size());
      Block& block = blocks_.emplace_back();
      block.row_unknown = k;
      block.column_unknown = l;
      for (int axis = 0; axis < spaces[k].dimension(); ++axis)
        block.width[axis] = spaces[k].degree() + spaces[l].degree() + 1;
      const int lines = block.width[1] * block.width[2];
      block.first_line = k == l && symmetric ? lines / 2 : 0;
      block.column_size = std::size_t(lines - block.first_line) * block.width[0];
      block.values.assign(block.column_size * spaces[l].size(), 0.0);
    }
}

void StencilMatrix::add(int cell, int row_unknown, int column_unknown, const double* local,
                        int stride) {
  const int count = static_cast<int>(spaces_.size());
  Block& block = blocks_[block_number_[row_unknown * count + column_unknown]];
  const TensorProductSpace& columns = spaces_[column_unknown];
  const int p = spaces_[row_unknown].degree(), q = columns.degree();
  const int dimension = columns.dimension();
  const std::array<int, 3> low = columns.grid().position(cell);
  const std::array<int, 3> row_last{p, dimension > 1 ? p : 0, dimension > 2 ? p : 0};
  const std::array<int, 3> column_last{q, dimension > 1 ? q : 0, dimension > 2 ? q : 0};
  for (int az = 0; az <= column_last[2]; ++az)
    for (int ay = 0; ay <= column_last[1]; ++ay) {
      const int first = columns.spline({low[0], low[1] + ay, low[2] + az});
      for (int ax = 0; ax <= q; ++ax, local += stride) {
        const int function = columns.function_of_spline(first + ax);
        if (function < 0) continue;
        const double* from = local;
        double* column = block.values.data() + std::size_t(function) * block.column_size;
        for (int bz = 0; bz <= row_last[2]; ++bz)
          for (int by = 0; by <= row_last[1]; ++by, from += p + 1) {
            const int line = by - ay + column_last[1] +
                             block.width[1] * (bz - az + column_last[2]) - block.first_line;
            if (line < 0) continue;
            double* run = column + line * block.width[0] + q - ax;
            for (int bx = 0; bx <= p; ++bx) run[bx] += from[bx];
          }
      }
    }
}

template <class Visit>
void StencilMatrix::visit_column(int unknown, int function, Visit&& visit) const {
  const int count = static_cast<int>(spaces_.size());
  const TensorProductSpace& columns = spaces_[unknown];
  const std::array<int, 3> place = columns.place(columns.spline_of_function(function));
  const int q = columns.degree(), dimension = columns.dimension();
  for (int k = symmetric_ ? unknown : 0; k < count; ++k) {
    const int number = block_number_[k * count + unknown];
    if (number < 0) continue;
    const Block& block = blocks_[number];
    const TensorProductSpace& rows = spaces_[k];
    const double* column = block.values.data() + function * block.column_size;
    const int lines = block.width[1] * block.width[2];
    for (int line = block.first_line; line < lines; ++line) {
      const int y = place[1] + line % block.width[1] - (dimension > 1 ? q : 0);
      const int z = place[2] + line / block.width[1] - (dimension > 2 ? q : 0);
      if (y < 0 || y >= rows.splines(1) || z < 0 || z >= rows.splines(2)) continue;
      // On the centre line of a diagonal block, entries before the centre are above the diagonal.
      const int begin = symmetric_ && k == unknown && line == block.first_line ? q : 0;
      const double* run = column + std::size_t(line - block.first_line) * block.width[0];
      for (int i = begin; i < block.width[0]; ++i) {
        const int x = place[0] + i - q;
        if (x < 0 || x >= rows.splines(0)) continue;
        const int row = rows.function_of_spline(rows.spline({x, y, z}));
        if (row >= 0) visit(offsets_[k] + row, run[i]);
      }
    }
  }
}

SparseMatrix StencilMatrix::compress() const {
  const int size = offsets_.back();
  SparseMatrix matrix(size, size);
  std::int64_t* begin = matrix.outerIndexPtr();
  const auto for_each_column = [&](auto&& action) {
    for (int unknown = 0; unknown < static_cast<int>(spaces_.size()); ++unknown)
      tbb::parallel_for(tbb::blocked_range<int>(0, spaces_[unknown].size(), 1024),
                        [&](const tbb::blocked_range<int>& functions) {
                          for (int f = functions.begin(); f < functions.end(); ++f)
                            action(unknown, f, offsets_[unknown] + f);
                        });
  };
  for_each_column([&](int unknown, int function, int column) {
    std::int64_t entries = 0;
    visit_column(unknown, function, [&](int, double) { ++entries; });
    begin[column + 1] = entries;
  });
  for (int column = 0; column < size; ++column) begin[column + 1] += begin[column];
  matrix.resizeNonZeros(begin[size]);
  for_each_column([&](int unknown, int function, int column) {
    std::int64_t place = begin[column];
    visit_column(unknown, function, [&](int row, double value) {
      matrix.innerIndexPtr()[place] = row;
      matrix.valuePtr()[place++] = value;
    });
  });
  return matrix;
}

}  // namespace rfm
