#include "core/tape_polynomial.hpp"

#include <cmath>
#include <utility>

#include "core/tape_program.hpp"

namespace rfm {
namespace {

constexpr auto square_index = Polynomial::square_index;
using Sum = Polynomial::Sum;

bool is_constant(const Polynomial& p) {
  return p.is_affine() && p.linear == std::array<double, 3>{};
}

Polynomial constant_polynomial(double value) {
  Polynomial p;
  p.constant = p.sum.first = value;
  p.summable = true;
  return p;
}

// Whether the sum is ±(x − origin) and nothing else.
bool is_distance(const Polynomial& p) {
  const Sum& sum = p.sum;
  return p.summable && sum.count == 1 && !sum.squared[0] && sum.first == 0 && sum.last == 0 &&
         sum.scale == 1 && std::abs(sum.factor[0]) == 1;
}

bool is_coordinate(const Polynomial& p) {
  return is_distance(p) && p.origin[p.sum.axis[0]] == 0 && p.constant == 0;
}

// The same polynomial about another origin on axes where the two differ.
Polynomial moved(Polynomial p, const std::array<double, 3>& origin) {
  for (int i = 0; i < 3; ++i) {
    const double step = origin[i] - p.origin[i];
    p.origin[i] = origin[i];
    if (step == 0) continue;
    const double along = p.square[square_index(i, i)];
    p.constant += step * (p.linear[i] + step * along);
    for (int j = 0; j < 3; ++j) p.linear[j] += 2 * step * p.square[square_index(i, j)];
  }
  return p;
}

// Brings both to one origin: on each axis that of the one which depends on it, and where both do,
// that from which the other can be moved away: `may_move(p, q, axis)` tells whether the gradient of
// the result has no larger terms if p is brought to the origin of q than it has anyhow. False if
// neither can be moved: digits would be lost that the expression does not lose.
bool meet(Polynomial& a, Polynomial& b, const auto& may_move) {
  std::array<double, 3> origin;
  for (int i = 0; i < 3; ++i) {
    const bool both = a.depends_on(i) && b.depends_on(i) && a.origin[i] != b.origin[i];
    if (both && !may_move(a, b, i) && !may_move(b, a, i)) return false;
    origin[i] = a.depends_on(i) && (!both || may_move(b, a, i)) ? a.origin[i] : b.origin[i];
  }
  for (Polynomial* p : {&a, &b}) {
    for (int i = 0; i < 3; ++i)
      if (!p->depends_on(i)) p->origin[i] = origin[i];
    *p = moved(*p, origin);
  }
  return true;
}

// Moving p by s along an axis adds 2 s Aⱼ to slope j. At its own origin, s away, q has slopes
// bⱼ + 2 s Aⱼ of its own: as large, if A of q is. Of linear functions it adds s p_axis to the
// constant, which in a product is a slope; wherever the point is, one of p and q is s / 2 away
// from its origin, and has a term as large, if the slope of q is.
bool may_move_in_sum(const Polynomial& p, const Polynomial& q, int axis) {
  const double step = std::abs(p.origin[axis] - q.origin[axis]);
  if (p.is_affine() && q.is_affine()) {
    const double added = step * std::abs(p.linear[axis]);
    const double present =
        step * std::abs(q.linear[axis]) + std::abs(p.constant) + std::abs(q.constant);
    return added <= 4 * present;
  }
  for (int j = 0; j < 3; ++j) {
    const double added = 2 * step * std::abs(p.square[square_index(axis, j)]);
    const double present = 2 * step * std::abs(q.square[square_index(axis, j)]) +
                           std::abs(p.linear[j]) + std::abs(q.linear[j]);
    if (added > 4 * present) return false;
  }
  return true;
}

// Of a product p q of linear functions slope j is p qⱼ + q pⱼ. Moving p by s along an axis makes
// terms of s p_axis qⱼ; at the origin of p, s away from that of q, the other term has s q_axis pⱼ.
bool may_move_in_product(const Polynomial& p, const Polynomial& q, int axis) {
  const double step = std::abs(p.origin[axis] - q.origin[axis]);
  for (int j = 0; j < 3; ++j) {
    const double added = step * std::abs(p.linear[axis] * q.linear[j]);
    const double present = step * std::abs(q.linear[axis] * p.linear[j]) +
                           std::abs(p.constant * q.linear[j]) + std::abs(q.constant * p.linear[j]);
    if (added > 4 * present) return false;
  }
  return true;
}

Polynomial scaled(double factor, Polynomial p) {
  p.constant *= factor;
  for (double& b : p.linear) b *= factor;
  for (double& a : p.square) a *= factor;
  Sum& sum = p.sum;
  if (sum.count == 1 && sum.first == 0 && sum.last == 0 && sum.scale == 1) {
    // One product more, unless the factor was ±1: then it is the product.
    p.summable = p.summable && (std::abs(sum.factor[0]) == 1 || std::abs(factor) == 1);
    sum.factor[0] *= factor;
  } else if (std::abs(sum.scale) == 1 || std::abs(factor) == 1) {
    sum.scale *= factor;
  } else {
    p.summable = false;
  }
  return p;
}

// Whether the sum is nothing but its terms, so that more can be added in order.
bool is_open(const Sum& sum) { return sum.scale == 1 && sum.last == 0; }

// A sum with scale −1 is the sum of the opposite terms: rounding is symmetric.
Polynomial without_sign(Polynomial p) {
  Sum& sum = p.sum;
  if (sum.scale != -1) return p;
  sum.scale = 1;
  sum.first = -sum.first;
  sum.last = -sum.last;
  for (int k = 0; k < sum.count; ++k) sum.factor[k] = -sum.factor[k];
  return p;
}

// a + b as one sum, where that keeps the order of additions (of two terms the order is free).
bool join(Sum& a, const Sum& b) {
  if (!is_open(a) || !is_open(b)) return false;
  if (b.count == 0) {
    if (a.count == 0) return a.first += b.first, true;
    if (a.first != 0) return false;
    return (a.count == 1 ? a.first : a.last) = b.first, true;
  }
  if (a.count == 0) {
    if (b.first != 0) return false;
    const double constant = a.first;
    a = b;
    return (b.count == 1 ? a.first : a.last) = constant, true;
  }
  if (b.count == 1 && b.first == 0) {
    for (int k = 0; k < a.count; ++k)
      if (a.axis[k] == b.axis[0]) return false;
    a.axis[a.count] = b.axis[0];
    a.factor[a.count] = b.factor[0];
    a.squared[a.count] = b.squared[0];
    return ++a.count, true;
  }
  return false;
}

// x − 3 and 3 − x have origin 3.
Polynomial offset_by(double number, Polynomial p) {
  p.origin[p.sum.axis[0]] = -number / p.sum.factor[0];
  return p;
}

std::optional<Polynomial> sum_of(Polynomial a, Polynomial b) {
  if (is_coordinate(a) && is_constant(b)) return offset_by(b.constant, a);
  if (is_coordinate(b) && is_constant(a)) return offset_by(a.constant, b);
  a = without_sign(a);
  b = without_sign(b);
  const bool b_is_term = b.sum.count == 1 && b.sum.first == 0;
  if (!b_is_term && b.sum.count > 0) std::swap(a, b);
  if (!meet(a, b, may_move_in_sum)) return {};
  const bool was_affine = a.is_affine() && b.is_affine();
  a.summable = a.summable && b.summable && join(a.sum, b.sum);
  a.constant += b.constant;
  for (int i = 0; i < 3; ++i) a.linear[i] += b.linear[i];
  for (int i = 0; i < 6; ++i) a.square[i] += b.square[i];
  // Constants of quadratic functions do not count, since these are no factors of others; that of a
  // linear one is a slope of its products, and here only a difference of large numbers.
  if (a.is_affine() && !was_affine) return {};
  return a;
}

std::optional<Polynomial> product_of(Polynomial a, Polynomial b) {
  if (!a.is_affine() || !b.is_affine()) return {};
  if (!meet(a, b, may_move_in_product)) return {};
  Polynomial product;
  product.origin = a.origin;
  product.constant = a.constant * b.constant;
  for (int i = 0; i < 3; ++i) {
    product.linear[i] = a.constant * b.linear[i] + b.constant * a.linear[i];
    for (int j = i; j < 3; ++j)
      product.square[square_index(i, j)] =
          0.5 * (a.linear[i] * b.linear[j] + a.linear[j] * b.linear[i]);
  }
  return product;
}

std::optional<Polynomial> square_of(const Polynomial& p) {
  auto square = product_of(p, p);
  // The square of anything else is rounded otherwise.
  if (square && is_distance(p)) {
    square->summable = true;
    square->sum.count = 1;
    square->sum.axis[0] = p.sum.axis[0];
    square->sum.squared[0] = true;
    square->sum.factor[0] = 1;
  }
  return square;
}

// ∂p/∂x_axis: its terms are added in the order of the axes.
Polynomial slope_of(const Polynomial& p, int axis) {
  Polynomial slope;
  slope.origin = p.origin;
  slope.constant = slope.sum.first = p.linear[axis];
  slope.summable = true;
  for (int i = 0; i < 3; ++i) {
    const double factor = slope.linear[i] = 2 * p.square[square_index(axis, i)];
    if (factor == 0) continue;
    slope.sum.axis[slope.sum.count] = i;
    slope.sum.factor[slope.sum.count++] = factor;
  }
  return slope;
}

std::optional<Polynomial> of_instruction(const Instruction& instruction,
                                         const std::vector<const Polynomial*>& known) {
  std::array<const Polynomial*, 2> operands{};
  for (int k = 0; k < 2; ++k) {
    if (instruction.operands[k] < 0) continue;
    operands[k] = known[instruction.operands[k]];
    if (!operands[k]) return {};
  }
  const auto [a, b] = operands;
  switch (instruction.operation) {
    case Operation::constant:
      return constant_polynomial(instruction.number);
    case Operation::coordinate: {
      if (instruction.variable < 0) return {};
      Polynomial p;
      p.linear[instruction.variable] = p.sum.factor[0] = 1;
      p.sum.count = 1;
      p.sum.axis[0] = instruction.variable;
      p.summable = true;
      return p;
    }
    case Operation::add:
      return sum_of(*a, *b);
    case Operation::subtract:
      return sum_of(*a, scaled(-1, *b));
    case Operation::negate:
      return scaled(-1, *a);
    case Operation::scale:
      return scaled(instruction.number, *a);
    case Operation::offset:
      return sum_of(*a, constant_polynomial(instruction.number));
    case Operation::multiply:
      return product_of(*a, *b);
    case Operation::divide: {
      if (!is_constant(*b) || b->constant == 0) return {};
      Polynomial quotient = scaled(1 / b->constant, *a);
      quotient.summable = false;  // a product with the reciprocal is rounded otherwise
      return quotient;
    }
    case Operation::integer_power:
      if (instruction.index != 2) return {};
      return square_of(*a);
    case Operation::partial:
      return slope_of(*a, instruction.index);
    default:
      return {};
  }
}

bool is_finite(const Polynomial& p) {
  double sum = p.constant;
  for (const double o : p.origin) sum += o;
  for (const double b : p.linear) sum += b;
  for (const double a : p.square) sum += a;
  return std::isfinite(sum);
}

}  // namespace

bool Polynomial::depends_on(int axis) const {
  if (linear[axis] != 0) return true;
  for (int i = 0; i < 3; ++i)
    if (square[square_index(axis, i)] != 0) return true;
  return false;
}

std::optional<Polynomial> recognise(const Instruction& instruction,
                                    const std::vector<const Polynomial*>& known) {
  std::optional<Polynomial> p = of_instruction(instruction, known);
  if (p && !is_finite(*p)) p.reset();
  return p;
}

}  // namespace rfm
