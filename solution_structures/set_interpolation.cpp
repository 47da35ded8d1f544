#include "solution_structures/set_interpolation.hpp"

#include "core/derivative_fields.hpp"
#include "core/error.hpp"
#include "core/function_shaping.hpp"
#include "solution_structures/condition_part.hpp"
#include "solution_structures/normal_conditions.hpp"
#include "solution_structures/taylor_polynomial.hpp"

namespace rfm {
namespace {

void check(const SetData& set) {
  const auto order = static_cast<int>(set.derivatives.size());
  if (order > 0 && !set.side) throw InvalidArgument("a set without a normal has no derivatives");
  if (order > 4) throw InvalidArgument("normal derivatives are prescribed up to the fourth");
  if (!set.value && order != 1)
    throw InvalidArgument("without a value a set has a first normal derivative and no other");
  if (set.exponent != 0 && set.exponent <= order)
    throw InvalidArgument("an exponent of " + std::to_string(set.exponent) +
                          " loses the derivative of order " + std::to_string(order) +
                          ": it must be larger");
}

// Zero on the set and on those that are one with it, at most 1, without dimension.
Field whole_distance(const SetData& set, double length) {
  Field distance = level_off(set.distance, length) / length;
  for (const Field& further : set.further_distances)
    distance = distance * (level_off(further, length) / length);
  return distance;
}

// ω as Taylor polynomials of this order need it. The corrections of higher orders are good near the
// set; beyond the length of their normalisation they level off, before they grow.
Field levelled(const Field& side, int order, double length, int dimension) {
  const Field omega = level_off(side, length);
  return order < 2 ? omega : normalize(omega, dimension, order, length / 8);
}

ConditionPart part_with_value(const SetData& set, double length, int dimension) {
  const Field distance = whole_distance(set, length);
  const auto order = static_cast<int>(set.derivatives.size());
  const int exponent = set.exponent == 0 ? order + 1 : set.exponent;
  if (order == 0) return {*set.value, distance, exponent};
  std::vector<Field> inward{*set.value};
  double sign = -1;
  for (const Field& derivative : set.derivatives) {
    inward.push_back(sign * derivative);
    sign = -sign;
  }
  const Field omega = levelled(*set.side, order, length, dimension);
  return {taylor_part(inward, omega, dimension).polynomial, distance, exponent};
}

}  // namespace

Structure interpolated(const std::vector<SetData>& sets, double length, int dimension) {
  std::vector<ConditionPart> parts;
  for (const SetData& set : sets) {
    check(set);
    if (set.value) parts.push_back(part_with_value(set, length, dimension));
  }
  if (parts.empty()) throw InvalidArgument("no set has a value that could be interpolated");
  const Structure values = transfinite(parts);
  for (const SetData& set : sets) {
    if (set.value) continue;
    const Field omega = levelled(*set.side, 1, length, dimension);
    const ConditionPart part = normal_derivative_part(values, omega, set.derivatives[0], dimension);
    parts.push_back({part.polynomial, whole_distance(set, length),
                     set.exponent == 0 ? part.exponent : set.exponent});
  }
  return transfinite(parts);
}

}  // namespace rfm
