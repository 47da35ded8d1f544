#include "core/quadric_pencil.hpp"

#include <cmath>

namespace rfm {
namespace {

// c + b·t + tᵀAt with t = x − m, all coefficients enclosed.
struct Expansion {
  Expansion(const Quadric& quadric, const Point& middle) {
    std::array<Interval, 3> t;
    for (int i = 0; i < 3; ++i) t[i] = Interval(middle[i]) - Interval(quadric.origin[i]);
    value = quadric.constant;
    for (int i = 0; i < 3; ++i) {
      Interval half = 0.0;  // of what the squares add to the slope
      for (int j = 0; j < 3; ++j)
        half = half + Interval(quadric.square[Quadric::square_index(i, j)]) * t[j];
      value = value + (Interval(quadric.linear[i]) + half) * t[i];
      slope[i] = Interval(quadric.linear[i]) + Interval(2) * half;
    }
    for (std::size_t k = 0; k < square.size(); ++k) square[k] = quadric.square[k];
  }
  void subtract(const Interval& factor, const Expansion& other) {
    value = value - factor * other.value;
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = slope[i] - factor * other.slope[i];
    for (std::size_t k = 0; k < square.size(); ++k)
      square[k] = square[k] - factor * other.square[k];
  }
  Interval range(const Box& box, const Point& middle) const {
    std::array<Interval, 3> t;
    for (int i = 0; i < box.dimension; ++i) t[i] = box.interval(i) - Interval(middle[i]);
    Interval sum = value;
    for (int i = 0; i < box.dimension; ++i) {
      sum = sum + slope[i] * t[i] + square[Quadric::square_index(i, i)] * rfm::square(t[i]);
      for (int j = 0; j < i; ++j)
        sum = sum + Interval(2) * square[Quadric::square_index(i, j)] * t[i] * t[j];
    }
    return sum;
  }

  Interval value;
  std::array<Interval, 3> slope;
  std::array<Interval, 6> square;
};

}  // namespace

std::optional<SignImplication> implied_signs(const Quadric* f, const Quadric* g, const Box& box) {
  if (!f || !g) return std::nullopt;
  const Point middle = box.center();
  double product = 0, square = 0;
  for (int axis = 0; axis < box.dimension; ++axis) {
    product += f->slope(middle, axis) * g->slope(middle, axis);
    square += f->slope(middle, axis) * f->slope(middle, axis);
  }
  const double factor = product / square;
  if (!std::isfinite(factor)) return std::nullopt;
  Expansion member(*g, middle);
  member.subtract(factor, Expansion(*f, middle));
  const Interval range = member.range(box, middle);
  if (!range.excludes_zero()) return std::nullopt;
  const bool positive = range.low > 0;
  return SignImplication{(factor >= 0) == positive, positive};
}

bool are_apart(const Quadric* f, const Quadric* g, const Box& box) {
  return implied_signs(f, g, box).has_value();
}

}  // namespace rfm
