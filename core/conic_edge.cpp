#include "core/conic_edge.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rfm {
namespace {

using Quartic = std::array<double, 5>;  // Bernstein coefficients

constexpr int most_halvings = 52;

int sign_changes(const Quartic& b) {
  int changes = 0;
  double last = 0;
  for (const double c : b) {
    if (c == 0) continue;
    if (last != 0 && (c > 0) != (last > 0)) ++changes;
    last = c;
  }
  return changes;
}

// De Casteljau's algorithm at ½.
std::array<Quartic, 2> halves(Quartic b) {
  Quartic left{}, right{};
  for (int level = 0; level < 5; ++level) {
    left[level] = b[0];
    right[4 - level] = b[4 - level];
    for (int i = 0; i + level < 4; ++i) b[i] = (b[i] + b[i + 1]) / 2;
  }
  return {left, right};
}

// Zeros, each within 2⁻⁵² of [0, 1]; of several closer than that, one.
void find_zeros(const Quartic& b, double low, double width, int depth, std::vector<double>& zeros) {
  const int changes = sign_changes(b);
  if (changes == 0 && b[0] != 0 && b[4] != 0) return;
  if (depth == most_halvings) {
    if (changes > 0 || b[0] == 0) zeros.push_back(low + width / 2);
    return;
  }
  const auto [left, right] = halves(b);
  find_zeros(left, low, width / 2, depth + 1, zeros);
  find_zeros(right, low + width / 2, width / 2, depth + 1, zeros);
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }

}  // namespace

std::array<Point, 3> ConicEdge::tangent_points() const {
  const Point &p = piece_.from, &r = piece_.to, &q = piece_.weighted_control;
  const double w = piece_.weight;
  return {Point{q[0] - w * p[0], q[1] - w * p[1]}, Point{(r[0] - p[0]) / 2, (r[1] - p[1]) / 2},
          Point{w * r[0] - q[0], w * r[1] - q[1]}};
}

ConicEdge::Foot ConicEdge::foot(const Point& point) const {
  const double w = piece_.weight;
  const auto q = tangent_points();
  std::array<Point, 3> r;
  for (int axis = 0; axis < 2; ++axis) {
    r[0][axis] = piece_.from[axis] - point[axis];
    r[1][axis] = piece_.weighted_control[axis] - w * point[axis];
    r[2][axis] = piece_.to[axis] - point[axis];
  }
  const Quartic quartic{dot(r[0], q[0]), (dot(r[0], q[1]) + dot(r[1], q[0])) / 2,
                        (dot(r[0], q[2]) + 4 * dot(r[1], q[1]) + dot(r[2], q[0])) / 6,
                        (dot(r[1], q[2]) + dot(r[2], q[1])) / 2, dot(r[2], q[2])};
  Foot best{0, std::hypot(r[0][0], r[0][1]), true};
  const double from_end = std::hypot(r[2][0], r[2][1]);
  if (from_end < best.distance) best = {1, from_end, true};
  std::vector<double> zeros;
  find_zeros(quartic, 0, 1, 0, zeros);
  for (double t : zeros) {
    const double polished = t - step(point[0], point[1], t);
    if (polished >= 0 && polished <= 1 && std::fabs(polished - t) < 1e-10) t = polished;
    const auto away = offset(point[0], point[1], t);
    const double distance = std::hypot(away[0], away[1]) / denominator(t);
    // At the ends themselves an edge and its neighbour are equally right.
    if (distance <= best.distance) best = {t, distance, false};
  }
  return best;
}

}  // namespace rfm
