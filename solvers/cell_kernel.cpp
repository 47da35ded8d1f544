#include "solvers/cell_kernel.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace rfm {

CellKernel::CellKernel(const CompiledIntegrand& integrand,
                       std::span<const TensorProductSpace> spaces, bool symmetric)
    : integrand_(integrand), symmetric_(symmetric) {
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
    const auto& [row, column, terms, mirrored] = integrand.stiffness()[e];
    for (int left = 0; left < static_cast<int>(left_.size()); ++left) {
      if (left_[left].slot == column) add_right(row, e, left);
      if (left_[left].slot == row && row != column && mirrored) add_right(column, e, left);
    }
  }

  for (int k = 0; k < unknowns; ++k)
    for (int l = 0; l <= (symmetric ? k : unknowns - 1); ++l) {
      Pairing pairing{k, l, {}};
      for (int i = 0; i < static_cast<int>(left_.size()); ++i)
        for (int j = 0; j < static_cast<int>(right_.size()); ++j)
          if (left_[i].unknown == k && right_[j].unknown == l && left_[i].slot == right_[j].slot)
            pairing.slots.emplace_back(i, j);
      if (pairing.slots.empty()) continue;
      pairings_.push_back(pairing);
      matrices_.emplace_back(std::size_t(padded_[k]) * padded_[l], 0.0);
    }
  add_loads();
}

// Derivatives of basis functions that carry a load: those of the slots that meet a load, or an
// inhomogeneous part through the stiffness.
void CellKernel::add_loads() {
  std::vector<bool> loaded(integrand_.slot_count(), false);
  for (const auto& entry : integrand_.load()) loaded[entry.slot] = true;
  for (const auto& entry : integrand_.stiffness()) {
    if (integrand_.inhomogeneous()[entry.column] >= 0) loaded[entry.row] = true;
    if (entry.mirrored && integrand_.inhomogeneous()[entry.row] >= 0) loaded[entry.column] = true;
  }
  const auto add_unique = [](std::vector<int>& list, int number) {
    const auto place = std::find(list.begin(), list.end(), number);
    if (place != list.end()) return static_cast<int>(place - list.begin());
    list.push_back(number);
    return static_cast<int>(list.size()) - 1;
  };
  std::vector<int> derivatives;
  for (const auto& entry : integrand_.map())
    if (loaded[entry.slot]) add_unique(derivatives, entry.basis_derivative);
  for (const int derivative : derivatives) {
    const int unknown = integrand_.basis_derivatives()[derivative].unknown;
    load_terms_.emplace_back(derivative, add_unique(loaded_, unknown));
  }
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
    outer_products(pairs_, points, padded_[k], padded_[l], symmetric_ && k == l,
                   matrices_[i].data());
  }
  for (std::vector<double>& load : loads_) std::fill(load.begin(), load.end(), 0.0);
  for (const auto& [derivative, place] : load_terms_)
    add_weighted_sum({values.load(derivative) + first, basis.values(derivative)}, points,
                     static_cast<int>(loads_[place].size()), loads_[place].data());
}

void CellKernel::compute_left(Left& left, const IntegrandValues& values, int first,
                              const BasisValues& basis) {
  terms_.clear();
  for (const int entry : left.entries)
    terms_.push_back(
        {values.map(entry) + first, basis.values(integrand_.map()[entry].basis_derivative)});
  combine(left.data, basis.points(), padded_[left.unknown]);
}

void CellKernel::compute_right(Right& right, const IntegrandValues& values, int first, int points) {
  terms_.clear();
  for (const auto& [entry, left] : right.terms)
    terms_.push_back({values.stiffness(entry) + first, left_[left].data.data()});
  combine(right.data, points, padded_[right.unknown]);
}

void CellKernel::combine(std::vector<double>& result, int points, int length) const {
  result.resize(std::max(result.size(), static_cast<std::size_t>(points) * length));
  linear_combinations(terms_, points, length, result.data());
}

}  // namespace rfm
