#include "solvers/supernodal_ldlt.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <random>
#include <set>

namespace rfm {
namespace {

// Entries of the factor by elimination, gathered into supernodes: neighbouring columns of which
// each has the rows of the one before it, less one.
SupernodalStructure structure_of(const SparseMatrix& lower,
                                 const std::vector<std::int64_t>& permutation) {
  const int size = static_cast<int>(permutation.size());
  std::vector<int> step(size);
  for (int i = 0; i < size; ++i) step[permutation[i]] = i;
  std::vector<std::set<int>> columns(size);  // rows from the diagonal on
  for (int column = 0; column < size; ++column)
    for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
      const int a = step[entry.row()], b = step[column];
      columns[std::min(a, b)].insert(std::max(a, b));
    }
  for (std::set<int>& column : columns)
    if (column.size() > 1) {
      const int parent = *std::next(column.begin());
      columns[parent].insert(std::next(column.begin()), column.end());
    }
  SupernodalStructure structure{permutation, {}, {}, {}};
  for (int column = 0; column < size; ++column) {
    const bool joins = column > 0 && columns[column - 1].size() == columns[column].size() + 1 &&
                       columns[column - 1].count(column) == 1;
    if (joins) continue;
    structure.first_column.push_back(column);
    structure.row_begin.push_back(static_cast<std::int64_t>(structure.rows.size()));
    structure.rows.insert(structure.rows.end(), columns[column].begin(), columns[column].end());
  }
  structure.first_column.push_back(size);
  structure.row_begin.push_back(static_cast<std::int64_t>(structure.rows.size()));
  return structure;
}

// A band matrix with some entries left out, of both signs on the diagonal.
SparseMatrix sample_matrix(int size, int band, bool indefinite) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (int i = 0; i < size; ++i) {
    const double diagonal = 2.0 + 0.6 * band;
    entries.emplace_back(i, i, indefinite && i % 3 == 1 ? -diagonal : diagonal);
    for (int j = i + 1; j < std::min(size, i + band); ++j)
      if ((i + j) % 4 != 0) entries.emplace_back(j, i, uniform(generator));
  }
  SparseMatrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

class EverySize : public testing::TestWithParam<std::tuple<int, int, bool>> {};
INSTANTIATE_TEST_SUITE_P(SupernodalLdlt, EverySize,
                         testing::Combine(testing::Values(1, 7, 150), testing::Values(2, 12, 130),
                                          testing::Bool()));

TEST_P(EverySize, SolvesAndHasThePivotsOfEliminationInTheGivenOrder) {
  const auto [size, band, indefinite] = GetParam();
  const SparseMatrix lower = sample_matrix(size, band, indefinite);
  std::vector<std::int64_t> permutation(size);
  for (int i = 0; i < size; ++i) permutation[i] = (i * 11 + 3) % size;

  const SupernodalLdlt factors(lower, structure_of(lower, permutation));

  const Eigen::MatrixXd full =
      Eigen::MatrixXd(Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>());
  Eigen::MatrixXd rest(size, size);  // Gaussian elimination, step by step
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) rest(i, j) = full(permutation[i], permutation[j]);
  for (int k = 0; k < size; ++k) {
    EXPECT_NEAR(factors.pivots()[k], rest(k, k), 1e-11 * std::abs(rest(k, k)));
    const Eigen::VectorXd column = rest.col(k);
    rest.bottomRightCorner(size - k - 1, size - k - 1) -=
        column.tail(size - k - 1) * column.tail(size - k - 1).transpose() / column[k];
  }

  Eigen::VectorXd exact(size);
  for (int i = 0; i < size; ++i) exact[i] = std::cos(i);
  EXPECT_LT((factors.solve(full * exact) - exact).norm(), 1e-11 * exact.norm());
}

}  // namespace
}  // namespace rfm
