#include "core/quadric.hpp"

namespace rfm {

LinePolynomial Quadric::along(const Line& line) const {
  const Point slope = gradient(line.origin);
  LinePolynomial polynomial{value(line.origin), 0, 0};
  for (int i = 0; i < 3; ++i) {
    polynomial.linear += slope[i] * line.direction[i];
    for (int j = 0; j < 3; ++j)
      polynomial.square += square[square_index(i, j)] * line.direction[i] * line.direction[j];
  }
  return polynomial;
}

LineBounds Quadric::bounds(const Line& line, const Interval& range) const {
  // c + t (b + a t) about the middle of the range.
  Box middle;
  middle.dimension = 3;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval coordinate = line.coordinate(axis, Interval(range.middle()));
    middle.low[axis] = coordinate.low;
    middle.high[axis] = coordinate.high;
  }
  const FunctionBounds at_middle = bounds(middle);
  const Interval t = range - Interval(range.middle());
  Interval b, a;
  for (int i = 0; i < 3; ++i) {
    b = b + at_middle.gradient[i] * Interval(line.direction[i]);
    for (int j = 0; j < 3; ++j)
      a = a + Interval(square[square_index(i, j)]) * Interval(line.direction[i]) *
                  Interval(line.direction[j]);
  }
  return {at_middle.value + t * (b + a * t), b + Interval(2) * a * t, true};
}

}  // namespace rfm
