#include "core/second_derivatives.hpp"

#include "core/source_breakpoints.hpp"

namespace rfm {

SecondDerivatives::SecondDerivatives(const RegionEvaluator& region)
    : region_(region), slopes_(region.primitive_count()) {
  for (const auto& primitive : region.region().primitives())
    exist_.push_back(sources_of(primitive->level).empty());
}

Hessian<double> SecondDerivatives::at(int primitive, const Point& point) {
  Hessian<double> hessian{};
  const int dimension = region_.dimension();
  if (const QuadricEvaluator* quadric = region_.level(primitive).quadric()) {
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j)
        hessian[i][j] = 2 * quadric->square[Quadric::square_index(i, j)];
    return hessian;
  }
  for (int i = 0; i < dimension; ++i) slopes(primitive)[i].value_and_gradient(point, hessian[i]);
  return hessian;
}

std::optional<Hessian<Interval>> SecondDerivatives::bounds(int primitive, const Box& box) {
  Hessian<Interval> hessian{};
  const int dimension = region_.dimension();
  if (region_.level(primitive).quadric()) {
    const Hessian<double> constant = at(primitive, {});
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j) hessian[i][j] = constant[i][j];
    return hessian;
  }
  for (int i = 0; i < dimension; ++i) {
    const FunctionBounds row = slopes(primitive)[i].bounds(box);
    if (!row.smooth) return std::nullopt;
    for (int j = 0; j < dimension; ++j) hessian[i][j] = row.gradient[j];
  }
  return hessian;
}

const std::vector<LevelFunction>& SecondDerivatives::slopes(int primitive) {
  std::vector<LevelFunction>& list = slopes_[primitive];
  const Field& level = region_.region().primitives()[primitive]->level;
  if (list.empty())
    for (int axis = 0; axis < region_.dimension(); ++axis)
      list.emplace_back(partial(level, axis), region_.dimension());
  return list;
}

}  // namespace rfm
