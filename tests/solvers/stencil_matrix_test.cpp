#include "solvers/stencil_matrix.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <random>

#include "core/error.hpp"

namespace rfm {
namespace {

struct Sample {
  int dimension;
  int first_degree, second_degree;
};
class EveryStencil : public testing::TestWithParam<Sample> {};
INSTANTIATE_TEST_SUITE_P(StencilMatrix, EveryStencil,
                         testing::Values(Sample{1, 1, 3}, Sample{1, 2, 2}, Sample{2, 1, 1},
                                         Sample{2, 3, 2}, Sample{2, 1, 4}, Sample{3, 1, 2},
                                         Sample{3, 2, 1}));

Grid sample_grid(int dimension) { return Grid({dimension, {0, 0, 0}, {1, 1, 1}}, {5, 4, 3}); }

TEST_P(EveryStencil, IsTheSumOfItsCellMatrices) {
  const auto [dimension, first_degree, second_degree] = GetParam();
  const Grid grid = sample_grid(dimension);
  std::vector<std::uint8_t> cells(grid.cell_count());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) cells[cell] = cell % 4 != 1;
  const std::vector<TensorProductSpace> spaces{{grid, first_degree, cells},
                                               {grid, second_degree, cells}};
  StencilMatrix stencil(spaces, {true, false, true, true});
  ASSERT_THAT(stencil.offsets(),
              testing::ElementsAre(0, spaces[0].size(), spaces[0].size() + spaces[1].size()));
  const int size = stencil.offsets().back();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  std::mt19937 generator(4);
  std::uniform_int_distribution<int> digit(-99, 99);
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    if (cells[cell] == 0) continue;
    for (int k = 0; k < 2; ++k)
      for (int l = 0; l <= k; ++l) {
        std::vector<int> rows(spaces[k].functions_per_cell());
        std::vector<int> columns(spaces[l].functions_per_cell());
        spaces[k].cell_functions(cell, rows);
        spaces[l].cell_functions(cell, columns);
        const int stride = static_cast<int>(rows.size()) + 3;
        std::vector<double> local(stride * columns.size());
        for (double& number : local) number = digit(generator);
        stencil.add(cell, k, l, local.data(), stride);
        for (std::size_t a = 0; a < columns.size(); ++a)
          for (std::size_t b = k == l ? a : 0; b < rows.size(); ++b)
            dense(stencil.offsets()[k] + rows[b], stencil.offsets()[l] + columns[a]) +=
                local[b + a * stride];
      }
  }
  const SparseMatrix matrix = stencil.compress();
  EXPECT_TRUE(matrix.isCompressed());
  EXPECT_EQ((Eigen::MatrixXd(matrix) - dense).cwiseAbs().maxCoeff(), 0);
  for (Eigen::Index column = 0; column < size; ++column) {
    Eigen::Index previous = column - 1;  // rows ascend from the diagonal on
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
      EXPECT_GT(entry.row(), previous);
      if (previous < column) {
        EXPECT_EQ(entry.row(), column);
      }
      previous = entry.row();
    }
  }
}

TEST(StencilMatrix, HasNoEntriesBetweenFunctionsThatAreNotCoupled) {
  const Grid grid = sample_grid(2);
  const std::vector<TensorProductSpace> spaces{{grid, 2}, {grid, 2}};
  const SparseMatrix apart = StencilMatrix(spaces, {true, false, false, true}).compress();
  const SparseMatrix coupled = StencilMatrix(spaces, {true, false, true, true}).compress();
  EXPECT_LT(apart.nonZeros(), coupled.nonZeros());
  for (SparseMatrix::InnerIterator entry(apart, 0); entry; ++entry)
    EXPECT_LT(entry.row(), spaces[0].size());
}

TEST(StencilMatrix, SpacesOnDifferentGridsAreRefused) {
  const std::vector<TensorProductSpace> spaces{{sample_grid(2), 2},
                                               {Grid({2, {0, 0}, {1, 1}}, {5, 5, 1}), 2}};
  EXPECT_THROW(StencilMatrix(spaces, {true, false, false, true}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
