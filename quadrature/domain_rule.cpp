#include "quadrature/domain_rule.hpp"

#include "quadrature/compensated_sum.hpp"
#include "quadrature/cut_cell.hpp"

namespace rfm {
namespace {

template <class Include>
double sum_of_weights(const SurfacePoints& points, Include&& include) {
  CompensatedSum sum;
  for (int i = 0; i < points.size(); ++i)
    if (include(points.numbers[i])) sum.add(points.weights[i]);
  return sum.value();
}

}  // namespace

double SurfaceRule::measure() const {
  return sum_of_weights(points, [](int) { return true; });
}

double SurfaceRule::measure(int number) const {
  return sum_of_weights(points, [&](int other) { return other == number; });
}

double DomainRule::measure() const {
  CompensatedSum sum;
  if (grid_.is_uniform())
    sum.add(grid_.cell_measure(0) * static_cast<double>(inside_cells_.size()));
  else
    for (const int cell : inside_cells_) sum.add(grid_.cell_measure(cell));
  for (const double weight : cut_points_.weights) sum.add(weight);
  return sum.value();
}

void DomainRule::add_inside_points(int cell, VolumePoints& points) const {
  const Box box = grid_.cell(grid_.position(cell));
  add_tensor_rule(box, inside_rule(), [&](const Point& point, double weight) {
    points.add(dimension(), point, weight);
  });
}

}  // namespace rfm
