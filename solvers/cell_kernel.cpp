#include "solvers/cell_kernel.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace rfm {

CellKernel::CellKernel(const CompiledIntegrand& integrand,
                       std::span<const TensorProductSpace> spaces)
    : integrand_(integrand) {
  const int unknowns = static_cast<int>(spaces.size());
  for (const TensorProductSpace& space : spaces)
    padded_.push_back(padded(space.functions_per_cell()));
  std::vector<bool> stiff(integrand.slot_count(), false);
  for (const auto& entry : integrand.stiffness()) stiff[entry.row] = stiff[entry.column] = true;

  for (int e = 0; e < static_cast<int>(integrand.map().size()); ++e) {
    const auto& [slot, basis_derivative, scalar] = integrand.map()[e];
    const int unknown = integrand.basis_derivatives()[basis_derivative].unknown;
    if (unknown < 0 || unknown >= unknowns)
      throw InvalidArgument("a structure uses an undetermined function that has no space");
    if (!stiff[slot]) continue;
    auto left = std::find_if(left_.begin(), left_.end(), [&, s = slot](const Left& known) {
      return known.slot == s && known.unknown == unknown;
    });
    if (left == left_.end()) left = left_.insert(left_.end(), {slot, unknown, {}, {}});
    left->entries.push_back(e);
  }

  const auto add_right = [&](int slot, int entry, int left) {
    const int unknown = left_[left].unknown;
    auto right = std::find_if(right_.begin(), right_.end(), [&](const Right& known) {
      return known.slot == slot && known.unknown == unknown;
    });
    if (right == right_.end()) right = right_.insert(right_.end(), {slot, unknown, {}, {}});
    right->terms.emplace_back(entry, left);
  };
  for (int e = 0; e < static_cast<int>(integrand.stiffness().size()); ++e) {
    const int row = integrand.stiffness()[e].row, column = integrand.stiffness()[e].column;
    for (int left = 0; left < static_cast<int>(left_.size()); ++left) {
      if (left_[left].slot == column) add_right(row, e, left);
      if (left_[left].slot == row && row != column) add_right(column, e, left);
    }
  }

  for (int k = 0; k < unknowns; ++k)
    for (int l = 0; l <= k; ++l) {
      Pairing pairing{k, l, {}};
      for (int i = 0; i < static_cast<int>(left_.size()); ++i)
        for (int j = 0; j < static_cast<int>(right_.size()); ++j)
          if (left_[i].unknown == k && right_[j].unknown == l && left_[i].slot == right_[j].slot)
            pairing.slots.emplace_back(i, j);
      if (pairing.slots.empty()) continue;
      pairings_.push_back(pairing);
      matrices_.emplace_back(std::size_t(padded_[k]) * padded_[l], 0.0);
    }
  for (const auto& [unknown, derivative] : integrand.basis_derivatives())
    if (std::find(loaded_.begin(), loaded_.end(), unknown) == loaded_.end())
      loaded_.push_back(unknown);
  for (const int unknown : loaded_) loads_.emplace_back(padded_[unknown], 0.0);
}

void CellKernel::compute(const IntegrandValues& values, int first, const BasisValues& basis) {
  const int points = basis.points();
  for (Left& left : left_) compute_left(left, values, first, basis);
  for (Right& right : right_) compute_right(right, values, first, points);
  for (std::size_t i = 0; i < pairings_.size(); ++i) {
    const auto& [k, l, slots] = pairings_[i];
    pairs_.clear();
    for (const auto& [left, right] : slots)
      pairs_.push_back({left_[left].data.data(), right_[right].data.data()});
    outer_products(pairs_, points, padded_[k], padded_[l], k == l, matrices_[i].data());
  }
  if (!values.has_load()) return;
  for (std::vector<double>& load : loads_) std::fill(load.begin(), load.end(), 0.0);
  for (std::size_t m = 0; m < integrand_.basis_derivatives().size(); ++m) {
    const int unknown = integrand_.basis_derivatives()[m].unknown, size = padded_[unknown];
    const auto place = std::find(loaded_.begin(), loaded_.end(), unknown) - loaded_.begin();
    double* load = loads_[place].data();
    const double* weight = values.load(int(m)) + first;
    const double* basis_value = basis.values(int(m));
    for (int q = 0; q < points; ++q, basis_value += size)
      for (int i = 0; i < size; ++i) load[i] += weight[q] * basis_value[i];
  }
}

void CellKernel::compute_left(Left& left, const IntegrandValues& values, int first,
                              const BasisValues& basis) const {
  const int points = basis.points(), size = padded_[left.unknown];
  left.data.resize(std::max(left.data.size(), std::size_t(points) * size));
  for (std::size_t e = 0; e < left.entries.size(); ++e) {
    const double* factor = values.map(left.entries[e]) + first;
    const double* from = basis.values(integrand_.map()[left.entries[e]].basis_derivative);
    double* to = left.data.data();
    for (int q = 0; q < points; ++q, from += size, to += size)
      if (e == 0)
        for (int i = 0; i < size; ++i) to[i] = factor[q] * from[i];
      else
        for (int i = 0; i < size; ++i) to[i] += factor[q] * from[i];
  }
}

void CellKernel::compute_right(Right& right, const IntegrandValues& values, int first,
                               int points) const {
  const int size = padded_[right.unknown];
  right.data.resize(std::max(right.data.size(), std::size_t(points) * size));
  for (std::size_t e = 0; e < right.terms.size(); ++e) {
    const auto& [entry, left] = right.terms[e];
    const double* factor = values.stiffness(entry) + first;
    const double* from = left_[left].data.data();
    double* to = right.data.data();
    for (int q = 0; q < points; ++q, from += size, to += size)
      if (e == 0)
        for (int i = 0; i < size; ++i) to[i] = factor[q] * from[i];
      else
        for (int i = 0; i < size; ++i) to[i] += factor[q] * from[i];
  }
}

}  // namespace rfm
