#include "solvers/integrand_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis.hpp"
#include "core/error.hpp"

namespace rfm {

void IntegrandPoints::clear() {
  for (int axis = 0; axis < 3; ++axis) {
    coordinates[axis].clear();
    normals[axis].clear();
  }
  weights.clear();
}

IntegrandValues::IntegrandValues(const CompiledIntegrand& integrand, int capacity)
    : integrand_(integrand),
      capacity_(capacity),
      workspace_(integrand.tape()),
      scalars_(integrand.scalars().size() * capacity),
      stiffness_(integrand.stiffness().size() * capacity),
      load_(integrand.basis_derivatives().size() * capacity),
      slot_load_(std::size_t(integrand.slot_count()) * capacity),
      constant_(capacity) {
  for (std::size_t i = 0; i < integrand.scalars().size(); ++i)
    std::fill_n(scalars_.begin() + i * capacity, capacity, integrand.scalars()[i].constant);
  const auto given = [](int scalar) { return scalar >= 0; };
  has_load_ = !integrand.load().empty() || std::any_of(integrand.inhomogeneous().begin(),
                                                       integrand.inhomogeneous().end(), given);
}

void IntegrandValues::evaluate(IntegrandPoints& points, double time,
                               std::span<const double> parameters) {
  const int count = points.size();
  for (int first = 0; first < count && integrand_.tape().root_count() > 0;
       first += Tape::block_size) {
    PointBlock block;
    block.count = std::min(Tape::block_size, count - first);
    for (int axis = 0; axis < integrand_.tape().dimension(); ++axis)
      block.coordinates[axis] = points.coordinates[axis].data() + first;
    block.time = time;
    block.parameters = parameters;
    integrand_.tape().evaluate(block, workspace_);
    for (std::size_t i = 0; i < integrand_.scalars().size(); ++i)
      if (const int root = integrand_.scalars()[i].root; root >= 0)
        std::copy_n(workspace_.coefficient(root), block.count, &scalars_[i * capacity_ + first]);
  }
  restrict_to_where(points);
  for (std::size_t i = 0; i < integrand_.scalars().size(); ++i)
    if (integrand_.scalars()[i].root >= 0)
      require_finite(points, static_cast<int>(i), time, parameters);

  for (std::size_t e = 0; e < integrand_.stiffness().size(); ++e)
    weigh(points, integrand_.stiffness()[e].terms, &stiffness_[e * capacity_]);
  if (!has_load_) return;

  // slot_load = w (b − C g), constant = w (½ gᵀ C g − bᵀ g).
  std::fill(slot_load_.begin(), slot_load_.end(), 0.0);
  std::fill_n(constant_.begin(), count, 0.0);
  const std::vector<int>& inhomogeneous = integrand_.inhomogeneous();
  for (const CompiledIntegrand::LoadEntry& entry : integrand_.load()) {
    double* load = &slot_load_[std::size_t(entry.slot) * capacity_];
    weigh(points, entry.terms, load);
    if (inhomogeneous[entry.slot] < 0) continue;
    const double* g = scalar(inhomogeneous[entry.slot]);
    for (int q = 0; q < count; ++q) constant_[q] -= load[q] * g[q];
  }
  for (std::size_t e = 0; e < integrand_.stiffness().size(); ++e) {
    const auto& [row, column, terms, mirrored] = integrand_.stiffness()[e];
    const auto add = [&](int s, int t) {
      if (inhomogeneous[t] < 0) return;
      const double* g = scalar(inhomogeneous[t]);
      double* load = &slot_load_[std::size_t(s) * capacity_];
      for (int q = 0; q < count; ++q) load[q] -= stiffness(int(e))[q] * g[q];
      if (inhomogeneous[s] < 0 || !mirrored) return;
      const double* other = scalar(inhomogeneous[s]);
      for (int q = 0; q < count; ++q) constant_[q] += 0.5 * stiffness(int(e))[q] * g[q] * other[q];
    };
    add(row, column);
    if (row != column && mirrored) add(column, row);
  }
  std::fill(load_.begin(), load_.end(), 0.0);
  for (const CompiledIntegrand::MapEntry& entry : integrand_.map()) {
    const double* m = scalar(entry.scalar);
    const double* from = &slot_load_[std::size_t(entry.slot) * capacity_];
    double* to = &load_[std::size_t(entry.basis_derivative) * capacity_];
    for (int q = 0; q < count; ++q) to[q] += m[q] * from[q];
  }
}

// Where a contribution does not count its coefficients may be anything, even undefined.
void IntegrandValues::restrict_to_where(IntegrandPoints& points) {
  if (integrand_.where() < 0) return;
  const double* where = scalar(integrand_.where());
  for (int q = 0; q < points.size(); ++q) {
    if (where[q] >= 0) continue;
    points.weights[q] = 0;
    for (std::size_t i = 0; i < integrand_.scalars().size(); ++i)
      if (integrand_.scalars()[i].root >= 0) scalars_[i * capacity_ + q] = 0;
  }
}

void IntegrandValues::require_finite(const IntegrandPoints& points, int number, double time,
                                     std::span<const double> parameters) const {
  const double* values = scalar(number);
  double sum = 0;  // 0 · x is NaN for every x that is not finite
  for (int q = 0; q < points.size(); ++q) sum += 0 * values[q];
  if (sum == 0) return;
  int q = 0;
  while (std::isfinite(values[q])) ++q;
  Point point{};
  const int dimension = integrand_.tape().dimension();
  for (int axis = 0; axis < dimension; ++axis) point[axis] = points.coordinates[axis][q];
  const auto& failing = integrand_.scalars()[number];
  std::string cause;
  if (failing.root >= 0)
    cause = diagnosis_suffix(integrand_.tape().roots()[failing.root], point, dimension, time,
                             parameters);
  throw ComputationError(fmt::format("{} is {} at the point {}{}", failing.name,
                                     std::isnan(values[q]) ? "not a number" : "infinite",
                                     point_text(point, dimension), cause));
}

// w Σ n^α f_α.
void IntegrandValues::weigh(const IntegrandPoints& points,
                            const std::vector<CompiledIntegrand::NormalTerm>& terms,
                            double* result) const {
  const int count = points.size();
  std::fill_n(result, count, 0.0);
  for (const auto& [normal, number] : terms) {
    const double* field = scalar(number);
    if (degree(normal) == 0) {
      for (int q = 0; q < count; ++q) result[q] += points.weights[q] * field[q];
      continue;
    }
    for (int q = 0; q < count; ++q) {
      double value = points.weights[q] * field[q];
      for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < normal[axis]; ++i) value *= points.normals[axis][q];
      result[q] += value;
    }
  }
}

double IntegrandValues::constant(int first, int last) const {
  double sum = 0;
  if (has_load_)
    for (int q = first; q < last; ++q) sum += constant_[q];
  return sum;
}

}  // namespace rfm
