#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "core/dynamic_jet.hpp"
#include "core/field_node.hpp"
#include "core/taylor_bound.hpp"

namespace rfm {

// Jets of sampled fields at mapped points (`field_at`), by the chain rule: the Taylor polynomial of
// the source about the image of a point, with the increments of the map put in.

/// Σ_β t_β h^β, truncated at the order of `shape`: t the Taylor coefficients, in the source's own
/// coordinates, of ∂^α of the function whose jet is `outer` (of an order higher by |α|), and h the
/// increments of the jets `place`.
template <class T>
DynamicJet<T> compose_outer(const JetShape& shape, const DynamicJet<T>& outer,
                            const MultiIndex& alpha, std::span<const DynamicJet<T>> place) {
  const int axes = static_cast<int>(place.size());
  const JetShape& inner = JetShape::get(axes, shape.order());
  const auto taylor = [&](int i) {
    const MultiIndex raised = inner.exponent(i) + alpha;
    return T(factorial(raised) / factorial(inner.exponent(i))) * outer.c[jet_index(axes, raised)];
  };
  std::vector<DynamicJet<T>> increments(place.begin(), place.end());
  for (DynamicJet<T>& increment : increments) increment.c[0] = T(0.0);
  std::vector<DynamicJet<T>> monomials{DynamicJet<T>(1.0)};
  DynamicJet<T> sum(shape);
  sum.c[0] = taylor(0);
  for (int i = 1; i < inner.size(); ++i) {
    MultiIndex lower = inner.exponent(i);
    int axis = 0;
    while (lower[axis] == 0) ++axis;
    --lower[axis];
    monomials.push_back(monomials[jet_index(axes, lower)] * increments[axis]);
    sum = sum + scaled(taylor(i), monomials.back());
  }
  return sum;
}

/// The jet of a node made by `field_at` where the map has the jets `place`.
inline DynamicJet<double> number_jet_of_source(const FieldSource& source, int index,
                                               std::span<const DynamicJet<double>> place) {
  const MultiIndex alpha = source_derivative(index);
  const JetShape& shape = *place[0].shape;
  const int axes = static_cast<int>(place.size());
  DynamicJet<double> outer(JetShape::get(axes, shape.order() + degree(alpha)));
  std::array<const double*, 3> coordinates{};
  for (int axis = 0; axis < axes; ++axis) coordinates[axis] = &place[axis].c[0];
  source.evaluate(coordinates, 1, axes, outer.order(), &outer.c[0], 1);
  return compose_outer<double>(shape, outer, alpha, place);
}

inline Interval enclosed_range(const Interval& a) { return a; }
inline Interval enclosed_range(const TaylorBound& a) { return a.range; }
template <class T>
T bound_of_range(const Interval& range, bool smooth) {
  if constexpr (std::is_same_v<T, TaylorBound>)
    return TaylorBound::of_range(range, smooth);
  else
    return range;
}

/// Bounds where the map leads: value and first derivatives of s, value of a first derivative.
template <class T>
DynamicJet<T> bounds_of_source(const FieldSource& source, int index,
                               std::span<const DynamicJet<T>> place) {
  const MultiIndex alpha = source_derivative(index);
  DynamicJet<T> jet(*place[0].shape);
  for (T& c : jet.c) c = bound_of_range<T>(Interval::entire(), false);
  if (degree(alpha) > 1) return jet;
  Box image;
  image.dimension = static_cast<int>(place.size());
  bool smooth = true;
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    const Interval range = enclosed_range(place[axis].c[0]);
    image.low[axis] = range.low;
    image.high[axis] = range.high;
    if constexpr (std::is_same_v<T, TaylorBound>) smooth = smooth && place[axis].c[0].smooth;
  }
  const FunctionBounds known = source.bounds(image);
  smooth = smooth && known.smooth;
  for (std::size_t axis = 0; axis < place.size(); ++axis)
    if (alpha[axis] == 1) {
      jet.c[0] = bound_of_range<T>(known.gradient[axis], smooth);
      return jet;
    }
  jet.c[0] = bound_of_range<T>(known.value, smooth);
  for (int v = 1; v <= jet.shape->variables() && v < jet.size; ++v) {
    T slope(0.0);
    for (std::size_t axis = 0; axis < place.size(); ++axis)
      slope = slope + bound_of_range<T>(known.gradient[axis], smooth) * place[axis].c[v];
    jet.c[v] = slope;
  }
  return jet;
}

template <class T>
DynamicJet<T> jet_of_source(const FieldSource& source, int index,
                            std::span<const DynamicJet<T>> place) {
  if constexpr (std::is_same_v<T, double>)
    return number_jet_of_source(source, index, place);
  else
    return bounds_of_source<T>(source, index, place);
}

}  // namespace rfm
