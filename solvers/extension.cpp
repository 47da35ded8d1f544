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
    first.push_back(columns);
  }
  matrix.resize(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace rfm
