#include "core/box.hpp"

#include <algorithm>

namespace rfm {

double Box::longest_side() const { return length(longest_axis()); }

int Box::longest_axis() const {
  int longest = 0;
  for (int axis = 1; axis < dimension; ++axis)
    if (length(axis) > length(longest)) longest = axis;
  return longest;
}

double Box::measure() const {
  double product = 1;
  for (int axis = 0; axis < dimension; ++axis) product *= length(axis);
  return product;
}

Point Box::center() const {
  Point middle{};
  for (int axis = 0; axis < dimension; ++axis) middle[axis] = 0.5 * (low[axis] + high[axis]);
  return middle;
}

bool Box::contains(const Point& point) const {
  for (int axis = 0; axis < dimension; ++axis)
    if (!(low[axis] <= point[axis] && point[axis] <= high[axis])) return false;
  return true;
}

std::array<Box, 2> bisect(const Box& box, int axis) {
  std::array<Box, 2> halves{box, box};
  const double middle = 0.5 * (box.low[axis] + box.high[axis]);
  halves[0].high[axis] = middle;
  halves[1].low[axis] = middle;
  return halves;
}

}  // namespace rfm
