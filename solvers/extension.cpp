#include "solvers/extension.hpp"

#include "basis/web_extension.hpp"

namespace rfm {

SplineExtension::SplineExtension(std::span<const TensorProductSpace> spaces,
                                 const DomainRule& rule) {
  std::vector<std::uint8_t> inside(rule.grid().cell_count());
  for (int cell = 0; cell < rule.grid().cell_count(); ++cell)
    inside[cell] = rule.state(cell) == CellState::inside;
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  Eigen::Index rows = 0, columns = 0;
  for (const TensorProductSpace& space : spaces) {
    const WebExtension web(space, inside);
    for (const WebExtension::Entry& entry : web.entries())
      entries.emplace_back(rows + entry.function, columns + entry.inner, entry.weight);
    for (const int function : web.inner()) inner.push_back(rows + function);
    rows += space.size();
    columns += web.size();
  }
  matrix.resize(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
}

Eigen::MatrixXd SplineExtension::reduced(const Eigen::MatrixXd& coefficients) const {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(inner.size()), coefficients.cols());
  for (std::size_t i = 0; i < inner.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = coefficients.row(inner[i]);
  return rows;
}

LinearSystem SplineExtension::extended(const LinearSystem& system) const {
  LinearSystem result;
  result.symmetric = system.symmetric;
  result.constant = system.constant;
  const SparseMatrix transposed = matrix.transpose();
  result.right_hand_side = transposed * system.right_hand_side;
  const SparseMatrix whole = system.symmetric
                                 ? SparseMatrix(system.matrix.selfadjointView<Eigen::Lower>())
                                 : system.matrix;
  const SparseMatrix product = transposed * SparseMatrix(whole * matrix);
  result.matrix = system.symmetric ? SparseMatrix(product.triangularView<Eigen::Lower>()) : product;
  return result;
}

}  // namespace rfm
