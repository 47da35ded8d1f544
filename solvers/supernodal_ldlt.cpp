#include "solvers/supernodal_ldlt.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <algorithm>

namespace rfm {
namespace {

constexpr Eigen::Index panel_width = 48;

// A = L D Lᵀ of a small dense block, lower triangle in place, column by column.
void factorize_panel(Eigen::Ref<Eigen::MatrixXd> a, Eigen::Ref<Eigen::VectorXd> pivots) {
  for (Eigen::Index j = 0; j < a.cols(); ++j) {
    const double pivot = pivots[j] = a(j, j);
    const Eigen::Index below = a.cols() - j - 1;
    for (Eigen::Index k = j + 1; k < a.cols(); ++k)
      a.col(k).tail(a.cols() - k) -= (a(k, j) / pivot) * a.col(j).tail(a.cols() - k);
    a.col(j).tail(below) /= pivot;
  }
}

// The same for a large block, panel by panel; rows below the square are carried along.
void factorize_block(Eigen::Ref<Eigen::MatrixXd> a, Eigen::Ref<Eigen::VectorXd> pivots) {
  const Eigen::Index size = a.cols(), rows = a.rows();
  for (Eigen::Index j = 0; j < size; j += panel_width) {
    const Eigen::Index width = std::min(panel_width, size - j), rest = rows - j - width;
    factorize_panel(a.block(j, j, width, width), pivots.segment(j, width));
    if (rest == 0) continue;
    auto below = a.block(j + width, j, rest, width);
    a.block(j, j, width, width)
        .triangularView<Eigen::UnitLower>()
        .transpose()
        .solveInPlace<Eigen::OnTheRight>(below);
    const Eigen::MatrixXd unscaled = below;
    below = unscaled * pivots.segment(j, width).cwiseInverse().asDiagonal();
    const Eigen::Index columns = size - j - width;
    a.block(j + width, j + width, columns, columns).triangularView<Eigen::Lower>() -=
        unscaled.topRows(columns) * below.topRows(columns).transpose();
    a.block(size, j + width, rows - size, columns).noalias() -=
        unscaled.bottomRows(rows - size) * below.topRows(columns).transpose();
  }
}

SparseMatrix permuted_lower(const SparseMatrix& lower,
                            const std::vector<std::int64_t>& permutation) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int64_t> to_new(lower.rows());
  for (std::size_t i = 0; i < permutation.size(); ++i)
    to_new.indices()[permutation[i]] = static_cast<std::int64_t>(i);
  SparseMatrix result(lower.rows(), lower.cols());
  result.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(to_new);
  return result;
}

}  // namespace

std::int64_t SupernodalLdlt::width(int supernode) const {
  return structure_.first_column[supernode + 1] - structure_.first_column[supernode];
}
std::int64_t SupernodalLdlt::height(int supernode) const {
  return structure_.row_begin[supernode + 1] - structure_.row_begin[supernode];
}
const std::int64_t* SupernodalLdlt::rows(int supernode) const {
  return structure_.rows.data() + structure_.row_begin[supernode];
}
SupernodalLdlt::Block SupernodalLdlt::block(int supernode) {
  return {values_.data() + begin_[supernode], height(supernode), width(supernode)};
}
SupernodalLdlt::ConstBlock SupernodalLdlt::block(int supernode) const {
  return {values_.data() + begin_[supernode], height(supernode), width(supernode)};
}

SupernodalLdlt::SupernodalLdlt(const SparseMatrix& lower, SupernodalStructure structure)
    : structure_(std::move(structure)), begin_{0}, pivots_(lower.rows()) {
  const int count = structure_.count();
  std::vector<int> owner(lower.rows());  // the supernode of a column
  for (int s = 0; s < count; ++s) {
    begin_.push_back(begin_.back() + static_cast<std::size_t>(height(s) * width(s)));
    std::fill(owner.begin() + structure_.first_column[s],
              owner.begin() + structure_.first_column[s + 1], s);
  }
  values_.assign(begin_.back(), 0.0);

  const SparseMatrix matrix = permuted_lower(lower, structure_.permutation);
  std::vector<std::int64_t> place(lower.rows(), 0);  // of a row in the current supernode
  // The descendants that update a supernode next, as linked lists; `done[d]` of the rows of
  // descendant d have been used.
  std::vector<int> head(count, -1), next(count, -1);
  std::vector<std::int64_t> done(count, 0);
  for (int s = 0; s < count; ++s) {
    for (std::int64_t i = 0; i < height(s); ++i) place[rows(s)[i]] = i;
    Block own = block(s);
    for (std::int64_t j = 0; j < width(s); ++j)
      for (SparseMatrix::InnerIterator entry(matrix, structure_.first_column[s] + j); entry;
           ++entry)
        own(place[entry.row()], j) += entry.value();

    const auto enqueue = [&](int d) {
      if (done[d] == height(d)) return;
      const int target = owner[rows(d)[done[d]]];
      next[d] = head[target];
      head[target] = d;
    };
    for (int d = head[s]; d >= 0;) {
      const int following = next[d];
      const std::int64_t first = done[d];
      while (done[d] < height(d) && owner[rows(d)[done[d]]] == s) ++done[d];
      subtract_descendant(d, first, done[d], s, place);
      enqueue(d);
      d = following;
    }
    eliminate(s);
    done[s] = width(s);
    enqueue(s);
  }
}

// Subtracts L_d D_d L_dᵀ, from row `first` of descendant d on, in the columns of its rows
// first … last − 1, which belong to `supernode`.
void SupernodalLdlt::subtract_descendant(int descendant, std::int64_t first, std::int64_t last,
                                         int supernode, const std::vector<std::int64_t>& place) {
  const Block from = block(descendant);
  const std::int64_t columns = last - first, count = height(descendant) - first;
  scaled_ = from.middleRows(first, columns) *
            pivots_.segment(structure_.first_column[descendant], width(descendant)).asDiagonal();
  update_.noalias() = from.bottomRows(count) * scaled_.transpose();
  Block to = block(supernode);
  const std::int64_t* row = rows(descendant) + first;
  for (std::int64_t j = 0; j < columns; ++j) {
    double* column = &to(0, place[row[j]]);
    for (std::int64_t i = j; i < count; ++i) column[place[row[i]]] -= update_(i, j);
  }
}

void SupernodalLdlt::eliminate(int supernode) {
  factorize_block(block(supernode),
                  pivots_.segment(structure_.first_column[supernode], width(supernode)));
}

Eigen::VectorXd SupernodalLdlt::solve(const Eigen::VectorXd& right_hand_side) const {
  Eigen::VectorXd x(right_hand_side.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = right_hand_side[structure_.permutation[i]];
  Eigen::VectorXd below;
  for (int s = 0; s < structure_.count(); ++s) {
    const ConstBlock own = block(s);
    const Eigen::Index columns = width(s), rest = height(s) - columns;
    auto segment = x.segment(structure_.first_column[s], columns);
    own.topRows(columns).triangularView<Eigen::UnitLower>().solveInPlace(segment);
    below.noalias() = own.bottomRows(rest) * segment;
    for (Eigen::Index i = 0; i < rest; ++i) x[rows(s)[columns + i]] -= below[i];
  }
  x = x.cwiseQuotient(pivots_);
  for (int s = structure_.count() - 1; s >= 0; --s) {
    const ConstBlock own = block(s);
    const Eigen::Index columns = width(s), rest = height(s) - columns;
    below.resize(rest);
    for (Eigen::Index i = 0; i < rest; ++i) below[i] = x[rows(s)[columns + i]];
    auto segment = x.segment(structure_.first_column[s], columns);
    segment.noalias() -= own.bottomRows(rest).transpose() * below;
    own.topRows(columns).transpose().triangularView<Eigen::UnitUpper>().solveInPlace(segment);
  }
  Eigen::VectorXd solution(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) solution[structure_.permutation[i]] = x[i];
  return solution;
}

}  // namespace rfm
