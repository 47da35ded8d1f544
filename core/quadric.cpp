#include "core/quadric.hpp"

#include <vector>

#include "core/tape_program.hpp"

namespace rfm {
namespace {

constexpr int square_index(int i, int j) {
  constexpr int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  return index[i][j];
}

bool is_constant(const Quadric& q) { return q.is_affine() && q.linear == std::array<double, 3>{}; }

Quadric combination(double p, const Quadric& a, double q, const Quadric& b) {
  Quadric sum;
  sum.constant = p * a.constant + q * b.constant;
  for (int i = 0; i < 3; ++i) sum.linear[i] = p * a.linear[i] + q * b.linear[i];
  for (int i = 0; i < 6; ++i) sum.square[i] = p * a.square[i] + q * b.square[i];
  return sum;
}

std::optional<Quadric> product(const Quadric& a, const Quadric& b) {
  if (is_constant(a)) return combination(a.constant, b, 0, b);
  if (is_constant(b)) return combination(b.constant, a, 0, a);
  if (!a.is_affine() || !b.is_affine()) return {};
  Quadric result = combination(a.constant, b, b.constant, a);
  result.constant = a.constant * b.constant;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      result.square[square_index(i, j)] =
          i == j ? a.linear[i] * b.linear[i]
                 : 0.5 * (a.linear[i] * b.linear[j] + a.linear[j] * b.linear[i]);
  return result;
}

std::optional<Quadric> of_instruction(const Instruction& instruction,
                                      const std::vector<std::optional<Quadric>>& known,
                                      const Point& origin) {
  const auto operand = [&](int k) -> const std::optional<Quadric>& {
    return known[instruction.operands[k]];
  };
  for (int k = 0; k < 3; ++k)
    if (instruction.operands[k] >= 0 && !operand(k)) return {};
  Quadric result;
  switch (instruction.operation) {
    case Operation::constant:
      result.constant = instruction.number;
      return result;
    case Operation::coordinate:
      if (instruction.index > 2) return {};
      result.constant = origin[instruction.index];
      result.linear[instruction.index] = 1;
      return result;
    case Operation::add:
      return combination(1, *operand(0), 1, *operand(1));
    case Operation::subtract:
      return combination(1, *operand(0), -1, *operand(1));
    case Operation::negate:
      return combination(-1, *operand(0), 0, *operand(0));
    case Operation::scale:
      return combination(instruction.number, *operand(0), 0, *operand(0));
    case Operation::offset:
      result = *operand(0);
      result.constant += instruction.number;
      return result;
    case Operation::multiply:
      return product(*operand(0), *operand(1));
    case Operation::divide:
      if (!is_constant(*operand(1)) || operand(1)->constant == 0) return {};
      return combination(1 / operand(1)->constant, *operand(0), 0, *operand(0));
    case Operation::integer_power:
      if (instruction.index != 2) return {};
      return product(*operand(0), *operand(0));
    default:
      return {};
  }
}

}  // namespace

bool Quadric::is_affine() const { return square == std::array<double, 6>{}; }

double Quadric::value(const Point& point) const {
  const double x = point[0] - origin[0], y = point[1] - origin[1], z = point[2] - origin[2];
  return constant + x * (linear[0] + square[0] * x + 2 * (square[1] * y + square[2] * z)) +
         y * (linear[1] + square[3] * y + 2 * square[4] * z) + z * (linear[2] + square[5] * z);
}

double Quadric::slope(const Point& point, int axis) const {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += square[square_index(axis, i)] * (point[i] - origin[i]);
  return linear[axis] + 2 * sum;
}

Point Quadric::gradient(const Point& x) const { return {slope(x, 0), slope(x, 1), slope(x, 2)}; }

Interval Quadric::value_bounds(const Box& box) const {
  // With the square of each axis completed the range is exact, but for mixed terms.
  Interval sum(constant);
  for (int i = 0; i < box.dimension; ++i) {
    const Interval t = box.interval(i) - Interval(origin[i]);
    const double a = square[square_index(i, i)], b = linear[i];
    if (a == 0) {
      sum = sum + Interval(b) * t;
    } else if (b == 0) {
      sum = sum + Interval(a) * rfm::square(t);
    } else {
      const Interval shift = Interval(b) / Interval(2 * a);
      sum = sum + Interval(a) * (rfm::square(t + shift) - rfm::square(shift));
    }
    for (int j = i + 1; j < box.dimension; ++j)
      sum = sum + Interval(2 * square[square_index(i, j)]) * t *
                      (box.interval(j) - Interval(origin[j]));
  }
  return sum;
}

FunctionBounds Quadric::bounds(const Box& box) const {
  FunctionBounds bounds;
  const Point center = box.center();
  Box point = box;
  point.low = point.high = center;
  Interval mean_value = value_bounds(point);
  for (int i = 0; i < box.dimension; ++i) {
    Interval slope(linear[i]);
    for (int j = 0; j < box.dimension; ++j)
      slope = slope + Interval(2 * square[square_index(i, j)]) *
                          (box.interval(j) - Interval(origin[j]));
    bounds.gradient[i] = slope;
    mean_value = mean_value + slope * (box.interval(i) - Interval(center[i]));
  }
  bounds.value = intersection(value_bounds(box), mean_value);
  return bounds;
}

namespace {

std::optional<Quadric> expanded_about(const Point& origin, const Tape::Program& program) {
  std::vector<std::optional<Quadric>> known;
  for (const Instruction& instruction : program.instructions)
    known.push_back(of_instruction(instruction, known, origin));
  std::optional<Quadric> quadric = known[program.root_instructions[0]];
  if (quadric) quadric->origin = origin;
  return quadric;
}

}  // namespace

std::optional<Quadric> as_quadric(const Field& field, int dimension) {
  const auto program = compile({field}, {0}, dimension);
  const std::optional<Quadric> first = expanded_about(Point{}, *program);
  if (!first || first->is_affine()) return first;
  // The centre, axis by axis: exact without mixed terms, and otherwise as good an origin as any.
  Point center{};
  for (int i = 0; i < dimension; ++i) {
    const double a = first->square[square_index(i, i)];
    if (a != 0) center[i] = -0.5 * first->linear[i] / a;
  }
  return expanded_about(center, *program);
}

}  // namespace rfm
