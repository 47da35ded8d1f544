#include "core/point_fields.hpp"

namespace rfm {

Field square_distance(const Point& point, int dimension) {
  Field square = 0.0;
  for (int axis = 0; axis < dimension; ++axis)
    square = square + pow(coordinate(axis) - point[axis], 2.0);
  return square;
}

Field height_along(const Point& direction, const Point& from, int dimension) {
  Field result = 0.0;
  for (int axis = 0; axis < dimension; ++axis)
    result = result + direction[axis] * (coordinate(axis) - from[axis]);
  return result;
}

}  // namespace rfm
