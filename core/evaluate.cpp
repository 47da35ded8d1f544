#include "core/evaluate.hpp"

#include <string>

#include "core/error.hpp"
#include "core/tape.hpp"

namespace rfm {

double PointJet::derivative(int i, int j, int k) const {
  if (i < 0 || j < 0 || k < 0 || (j > 0 && dimension_ < 2) || (k > 0 && dimension_ < 3))
    throw InvalidArgument("a jet in " + std::to_string(dimension_) +
                          " variables has no derivative (" + std::to_string(i) + ", " +
                          std::to_string(j) + ", " + std::to_string(k) + ")");
  const MultiIndex alpha{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
                         static_cast<std::uint8_t>(k), 0};
  if (degree(alpha) > order_)
    throw InvalidArgument("a jet of order " + std::to_string(order_) +
                          " has no derivative of order " + std::to_string(degree(alpha)));
  return coefficients_[jet_index(dimension_, alpha)] * factorial(alpha);
}

double value_at(const Field& field, const Point& point, double time) {
  return Tape({field}, {0}, 3).value(point, 0, time);
}

PointJet evaluate(const Field& field, const Point& point, int order, int dimension) {
  const Tape tape({field}, {order}, dimension);
  Tape::Workspace workspace(tape);
  PointBlock block;
  for (int axis = 0; axis < 3; ++axis) block.coordinates[axis] = &point[axis];
  block.count = 1;
  tape.evaluate(block, workspace);
  std::vector<double> coefficients(jet_size(dimension, order));
  for (int i = 0; i < static_cast<int>(coefficients.size()); ++i)
    coefficients[i] = workspace.coefficient(0, i)[0];
  return PointJet(dimension, order, std::move(coefficients));
}

}  // namespace rfm
