#include "solvers/periodic_splines.hpp"

#include <map>

#include "core/error.hpp"

namespace rfm {

SplineExtraction periodic_splines(std::span<const TensorProductSpace> spaces,
                                  const std::array<bool, 3>& axes) {
  SplineExtraction result;
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  Eigen::Index rows = 0, columns = 0;
  for (const TensorProductSpace& space : spaces) {
    if (!space.grid().is_uniform()) throw InvalidArgument("periodic splines need equal cells");
    for (int axis = 0; axis < space.dimension(); ++axis)
      if (axes[axis] && space.grid().cells(axis) < space.degree())
        throw InvalidArgument("periodic splines need as many cells along the axis as their degree");
    std::map<int, Eigen::Index> classes;  // by the first spline
    for (int function = 0; function < space.size(); ++function) {
      std::array<int, 3> place = space.place(space.spline_of_function(function));
      for (int axis = 0; axis < space.dimension(); ++axis)
        if (axes[axis]) place[axis] %= space.grid().cells(axis);
      const auto [known, is_new] = classes.try_emplace(space.spline(place), columns);
      if (is_new) {
        result.inner.push_back(rows);
        ++columns;
      }
      entries.emplace_back(rows++, known->second, 1.0);
    }
    result.first.push_back(columns);
  }
  result.matrix.resize(rows, columns);
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace rfm
