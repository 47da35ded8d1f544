#include "solvers/space_field.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/jet_shape.hpp"

namespace rfm {

SpaceField::SpaceField(std::shared_ptr<const GlobalSpace> space, std::vector<double> coefficients)
    : space_(std::move(space)), coefficients_(std::move(coefficients)) {
  if (!space_ || coefficients_.size() != std::size_t(space_->size()))
    throw InvalidArgument("a space of functions cannot take " +
                          std::to_string(coefficients_.size()) + " coefficients");
}

void SpaceField::evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                          int order, double* jets, int stride) const {
  const JetShape& shape = JetShape::get(variables, order);
  const std::size_t functions = coefficients_.size();
  std::vector<double> values(functions * std::size_t(count));
  for (int c = 0; c < shape.size(); ++c) {
    const MultiIndex& alpha = shape.exponent(c);
    space_->evaluate(coordinates, count, alpha, values.data());
    for (int q = 0; q < count; ++q) {
      const double* own = values.data() + std::size_t(q) * functions;
      double sum = 0;
      for (std::size_t f = 0; f < functions; ++f) sum += coefficients_[f] * own[f];
      jets[std::ptrdiff_t(c) * stride + q] = sum / factorial(alpha);
    }
  }
  const Box box = space_->valid();
  for (int q = 0; q < count; ++q)
    for (int axis = 0; axis < box.dimension; ++axis) {
      const double x = coordinates[axis][q], tolerance = 1e-9 * box.length(axis);
      if (!(x >= box.low[axis] - tolerance && x <= box.high[axis] + tolerance))
        for (int c = 0; c < shape.size(); ++c)
          jets[std::ptrdiff_t(c) * stride + q] = std::numeric_limits<double>::quiet_NaN();
    }
}

FunctionBounds SpaceField::bounds(const Box& box) const {
  const Box valid = space_->valid();
  for (int axis = 0; axis < valid.dimension; ++axis) {
    const double tolerance = 1e-9 * valid.length(axis);
    if (box.low[axis] >= valid.low[axis] - tolerance &&
        box.high[axis] <= valid.high[axis] + tolerance)
      continue;
    FunctionBounds nothing;  // outside there are no numbers
    nothing.value = Interval::entire();
    nothing.gradient.fill(Interval::entire());
    nothing.smooth = false;
    return nothing;
  }
  return space_->bounds(coefficients_, box);
}

std::vector<double> SpaceField::breakpoints(int) const { return {}; }

}  // namespace rfm
