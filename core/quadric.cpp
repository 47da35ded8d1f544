#include "core/quadric.hpp"

#include <algorithm>
#include <cmath>
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

namespace {

// c + b·t + tᵀAt with mixed terms as a sum of squares: each axis in turn is completed together with
// its mixed terms, a (t_i + (b/2 + Σ_j a_j t_j)/a)² − (b/2 + Σ_j a_j t_j)²/a. A thin turned ellipse
// is then bounded as well as one along the axes. Coefficients are intervals, for they are rounded.
Interval completed_bounds(const Quadric& quadric, const Box& box) {
  const int dimension = box.dimension;
  Interval constant(quadric.constant), linear[3], square[3][3], t[3];
  for (int i = 0; i < dimension; ++i) {
    t[i] = box.interval(i) - Interval(quadric.origin[i]);
    linear[i] = quadric.linear[i];
    for (int j = 0; j < dimension; ++j) square[i][j] = quadric.square[square_index(i, j)];
  }
  double residue = 0;
  for (const double a : quadric.square) residue = std::max(residue, 0x1p-46 * std::fabs(a));
  Interval sum;
  std::array<bool, 3> done{};
  // In a face of a box its coordinate is a number: completed with it, the others would not cancel.
  for (int i = 0; i < dimension; ++i) {
    if (box.low[i] != box.high[i]) continue;
    done[i] = true;
    constant = constant + (linear[i] + square[i][i] * t[i]) * t[i];
    for (int j = 0; j < dimension; ++j)
      if (!done[j]) linear[j] = linear[j] + Interval(2) * square[i][j] * t[i];
  }
  for (int step = 0; step < dimension; ++step) {
    int axis = -1;
    for (int i = 0; i < dimension; ++i)
      if (!done[i] && (axis < 0 || square[i][i].mignitude() > square[axis][axis].mignitude()))
        axis = i;
    if (axis < 0) break;
    const Interval a = square[axis][axis];
    // What rounding left of zero is no square to complete: the axis would be shifted by 1/residue.
    if (a.mignitude() <= residue) break;
    done[axis] = true;
    Interval shift = linear[axis] / (Interval(2) * a);
    for (int j = 0; j < dimension; ++j)
      if (!done[j]) shift = shift + square[axis][j] / a * t[j];
    sum = sum + a * rfm::square(t[axis] + shift);
    constant = constant - rfm::square(linear[axis]) / (Interval(4) * a);
    for (int j = 0; j < dimension; ++j) {
      if (done[j]) continue;
      linear[j] = linear[j] - square[axis][j] * linear[axis] / a;
      for (int k = 0; k < dimension; ++k)
        if (!done[k] && k != j) square[j][k] = square[j][k] - square[axis][j] * square[axis][k] / a;
      square[j][j] = square[j][j] - rfm::square(square[axis][j]) / a;
    }
  }
  sum = sum + constant;
  for (int i = 0; i < dimension; ++i) {
    if (done[i]) continue;
    sum = sum + linear[i] * t[i] + square[i][i] * rfm::square(t[i]);
    for (int j = i + 1; j < dimension; ++j)
      if (!done[j]) sum = sum + Interval(2) * square[i][j] * t[i] * t[j];
  }
  return sum;
}

}  // namespace

Interval Quadric::value_bounds(const Box& box) const {
  // With the square of each axis completed the range is exact, but for mixed terms.
  bool mixed = false;
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
    for (int j = i + 1; j < box.dimension; ++j) {
      const double a_ij = square[square_index(i, j)];
      if (a_ij == 0) continue;
      mixed = true;
      sum = sum + Interval(2 * a_ij) * t * (box.interval(j) - Interval(origin[j]));
    }
  }
  return mixed && !sum.excludes_zero() ? intersection(sum, completed_bounds(*this, box)) : sum;
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
      slope = slope +
              Interval(2 * square[square_index(i, j)]) * (box.interval(j) - Interval(origin[j]));
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

// The point where the gradient b + 2At vanishes, relative to the origin of `quadric`: by
// elimination with complete pivoting. Directions in which A is zero up to rounding (the axis of a
// parabola or a cylinder) are left alone.
Point offset_of_center(const Quadric& quadric, int dimension) {
  double matrix[3][4];
  double largest = 0;
  for (int i = 0; i < dimension; ++i) {
    for (int j = 0; j < dimension; ++j) {
      matrix[i][j] = 2 * quadric.square[square_index(i, j)];
      largest = std::max(largest, std::fabs(matrix[i][j]));
    }
    matrix[i][3] = -quadric.linear[i];
  }
  std::array<bool, 3> used_row{};
  std::array<int, 3> row_of{-1, -1, -1};
  for (int step = 0; step < dimension; ++step) {
    int row = -1, column = -1;
    for (int i = 0; i < dimension; ++i)
      for (int j = 0; j < dimension; ++j)
        if (!used_row[i] && row_of[j] < 0 &&
            (row < 0 || std::fabs(matrix[i][j]) > std::fabs(matrix[row][column])))
          row = i, column = j;
    if (!(std::fabs(matrix[row][column]) > 1e-14 * largest)) break;
    used_row[row] = true;
    row_of[column] = row;
    for (int i = 0; i < dimension; ++i) {
      if (i == row) continue;
      const double factor = matrix[i][column] / matrix[row][column];
      for (int j = 0; j < 4; ++j) matrix[i][j] -= factor * matrix[row][j];
    }
  }
  Point offset{};
  for (int axis = 0; axis < dimension; ++axis)
    if (row_of[axis] >= 0) offset[axis] = matrix[row_of[axis]][3] / matrix[row_of[axis]][axis];
  return offset;
}

}  // namespace

std::optional<Quadric> as_quadric(const Field& field, int dimension) {
  const auto program = compile({field}, {0}, dimension);
  const std::optional<Quadric> first = expanded_about(Point{}, *program);
  if (!first || first->is_affine()) return first;
  // Twice, because far from the coordinate origin the first expansion has lost digits.
  Quadric centered = *first;
  for (int repeat = 0; repeat < 2; ++repeat) {
    const Point offset = offset_of_center(centered, dimension);
    Point origin = centered.origin;
    for (int axis = 0; axis < dimension; ++axis) origin[axis] += offset[axis];
    centered = *expanded_about(origin, *program);
  }
  // The centre of what is nearly a plane is so far away that digits would be lost there.
  const bool farther = std::fabs(centered.constant) > 1e4 * std::fabs(first->constant);
  return farther ? first : centered;
}

}  // namespace rfm
