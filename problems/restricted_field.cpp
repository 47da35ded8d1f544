#include "problems/restricted_field.hpp"

#include <algorithm>
#include <limits>

#include "core/multi_index.hpp"
#include "core/source_breakpoints.hpp"

namespace rfm {

RestrictedField::RestrictedField(Field field, const Region& region, const Box& box,
                                 std::string name)
    : field_(std::move(field)), region_(region), box_(box), name_(std::move(name)) {}

std::string RestrictedField::outside_text() const {
  return name_ + " outside the domain of that problem";
}

const Tape& RestrictedField::tape(int variables, int order) const {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<const Tape>& known = tapes_[{variables, order}];
  if (!known)
    known = std::make_unique<const Tape>(std::vector<Field>{field_}, std::vector<int>{order},
                                         variables);
  return *known;
}

void RestrictedField::evaluate(const std::array<const double*, 3>& coordinates, int count,
                               int variables, int order, double* jets, int stride) const {
  const int dimension = region_.dimension();
  const Tape& own = tape(dimension, order);
  Tape::Workspace workspace(own);
  const int size = jet_size(variables, order);
  for (int c = 0; c < size; ++c) std::fill_n(jets + std::ptrdiff_t(c) * stride, count, 0.0);
  for (int first = 0; first < count; first += Tape::block_size) {
    PointBlock block;
    block.count = std::min(Tape::block_size, count - first);
    for (int axis = 0; axis < dimension; ++axis)
      block.coordinates[axis] = coordinates[axis] + first;
    own.evaluate(block, workspace);
    // Derivatives along further variables are zero; those of fewer variables are a part.
    for (int k = 0; k <= (std::min(dimension, variables) > 2 ? order : 0); ++k)
      for (int j = 0; j <= (std::min(dimension, variables) > 1 ? order - k : 0); ++j)
        for (int i = 0; i <= order - k - j; ++i) {
          const MultiIndex alpha{std::uint8_t(i), std::uint8_t(j), std::uint8_t(k)};
          std::copy_n(workspace.coefficient(0, jet_index(dimension, alpha)), block.count,
                      jets + std::ptrdiff_t(jet_index(variables, alpha)) * stride + first);
        }
  }
  const double rounding = 1e-9 * box_.longest_side();
  for (int q = 0; q < count; ++q) {
    Point point{};
    for (int axis = 0; axis < dimension; ++axis) point[axis] = coordinates[axis][q];
    if (region_.contains(point, rounding)) continue;
    for (int c = 0; c < size; ++c)
      jets[std::ptrdiff_t(c) * stride + q] = std::numeric_limits<double>::quiet_NaN();
  }
}

FunctionBounds RestrictedField::bounds(const Box& box) const {
  Box part = box;
  bool is_whole = true;
  for (int axis = 0; axis < box_.dimension; ++axis) {
    part.low[axis] = std::clamp(box.low[axis], box_.low[axis], box_.high[axis]);
    part.high[axis] = std::clamp(box.high[axis], box_.low[axis], box_.high[axis]);
    is_whole = is_whole && part.low[axis] == box.low[axis] && part.high[axis] == box.high[axis];
  }
  FunctionBounds bounds = tape(region_.dimension(), 1).bounds(part);
  if (!is_whole) bounds.smooth = false;  // where it does not exist it is not differentiable
  return bounds;
}

std::vector<double> RestrictedField::breakpoints(int axis) const {
  return source_breakpoints(field_, region_.dimension())[axis];
}

}  // namespace rfm
