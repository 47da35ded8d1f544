#include "quadrature/candidate_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "core/least_side.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

// Somewhere the value depends on i, and on j, with the other variables the same.
bool depends_on_both(const TruthTable& table, int i, int j) {
  const unsigned bit_i = 1u << i, bit_j = 1u << j, count = 1u << table.variable_count();
  for (unsigned a = 0; a < count; ++a) {
    if (a & (bit_i | bit_j)) continue;
    const bool v00 = table.value(a), v10 = table.value(a | bit_i), v01 = table.value(a | bit_j),
               v11 = table.value(a | bit_i | bit_j);
    if ((v00 != v10 || v01 != v11) && (v00 != v01 || v10 != v11)) return true;
  }
  return false;
}

// Coefficients of a quadric in coordinates −1 … 1 over `box`, of unit length.
std::array<double, 10> normalised(const Quadric& quadric, const Box& box) {
  const Point center = box.center();
  const Point gradient = quadric.gradient(center);
  const double scale = 0.5 * box.longest_side();
  std::array<double, 10> c{quadric.value(center)};
  for (int i = 0; i < 3; ++i) c[1 + i] = scale * gradient[i];
  for (int i = 0; i < 6; ++i) c[4 + i] = scale * scale * quadric.square[i];
  double sum = 0;
  for (const double x : c) sum += x * x;
  for (double& x : c) x /= std::sqrt(sum);
  return c;
}

// The nearest zero of a function by Newton's method along its gradient; false if there is none
// near.
bool lands_on_zero(const LevelFunction& f, double reach, Point& point, Point& gradient) {
  const Point start = point;
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const double value = f.value_and_gradient(point, gradient);
    double square = 0, away = 0;
    for (const double slope : gradient) square += slope * slope;
    if (!(square > 0)) return false;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] -= value * gradient[axis] / square;
      away = std::max(away, std::fabs(point[axis] - start[axis]));
    }
    if (!(away <= reach)) return false;
    if (std::fabs(value) <= 1e-15 * reach * std::sqrt(square)) return true;
  }
  return true;
}

// Whether two primitives vanish on the same curve or surface in a small box, as far as some points
// of it show: sin(pi x) and x + 4 do next to x = -4. Their common zeros are no corners, and could
// not be isolated.
bool coincide_within(const LevelFunction& f, const LevelFunction& g, const Box& box) {
  constexpr double places[] = {0.08, 0.31, 0.5, 0.73, 0.94};
  const double size = box.longest_side();
  int found = 0;
  for (int i = 0; i < 5; ++i) {
    Point point{}, across{}, other{};
    for (int axis = 0; axis < box.dimension; ++axis)
      point[axis] = box.low[axis] + places[(i + 2 * axis) % 5] * box.length(axis);
    if (!lands_on_zero(f, size, point, across)) continue;
    const double value = g.value_and_gradient(point, other);
    double square = 0, along = 0, square_across = 0;
    for (int axis = 0; axis < 3; ++axis) {
      square += other[axis] * other[axis];
      along += other[axis] * across[axis];
      square_across += across[axis] * across[axis];
    }
    constexpr double rounding = 1e-12;
    if (!(std::fabs(value) <= rounding * size * std::sqrt(square))) return false;
    if (!(along * along >= (1 - rounding) * square * square_across)) return false;
    ++found;
  }
  return found >= 3;
}

class CandidateSearch {
 public:
  CandidateSearch(const RegionEvaluator& region, const Box& box, double longest,
                  const std::function<void(const CandidateBox&)>& visit)
      : region_(region), longest_(longest), visit_(visit), surface_(region.primitive_count()) {
    const auto& primitives = region.region().primitives();
    for (int k = 0; k < region.primitive_count(); ++k) {
      surface_[k] = k;
      for (int i = 0; i < k && surface_[k] == k; ++i)
        if (is_same_surface(region.level(i), region.level(k), primitives[i]->level,
                            primitives[k]->level, box))
          surface_[k] = surface_[i];
    }
  }

  int run(const Box& box) {
    Box whole = box;
    for (int axis = 0; axis < box.dimension; ++axis) {
      const double margin = box.length(axis) + 0.1 * box.longest_side();
      whole.low[axis] -= (0.0137 + 0.0031 * axis) * margin;
      whole.high[axis] += (0.0219 - 0.0043 * axis) * margin;
    }
    visit(whole, SurfaceCandidates(region_, {}));
    return crowded_;
  }

 private:
  void visit(const Box& box, SurfaceCandidates candidates) {
    const bool small = box.longest_side() <= longest_;
    candidates.narrow(box, small, region_, {});
    if (candidates.primitives.size() < 2) return;
    const bool few =
        candidates.primitives.size() <= static_cast<std::size_t>(TruthTable::max_variables);
    if (small && few) return visit_small(box, candidates);
    if (box.longest_side() <= std::max(0x1p-10 * longest_, least_side(box))) {
      ++crowded_;
      return;
    }
    for (const Box& half : bisect(box, box.longest_axis())) visit(half, candidates);
  }

  void visit_small(const Box& box, SurfaceCandidates& candidates) {
    CandidateBox found{box, candidates.make_table(region_.region().expression()), {}, {}, {}};
    found.primitives = candidates.primitives;
    const int count = found.table.variable_count();
    for (const int k : found.primitives) found.surfaces.push_back(surface_[k]);
    std::vector<PrimitivePair> known;
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j) {
        const int a = found.surfaces[i], b = found.surfaces[j];
        if (a == b || !depends_on_both(found.table, i, j)) continue;
        bool is_new = true;
        for (const PrimitivePair& other : known)
          if ((other.first == a && other.second == b) || (other.first == b && other.second == a))
            is_new = false;
        if (!is_new) continue;
        known.push_back({a, b});
        if (coincide_within(region_.level(a), region_.level(b), box)) continue;
        found.pairs.push_back({i, j});
      }
    if (!found.pairs.empty()) visit_(found);
  }

  const RegionEvaluator& region_;
  double longest_;
  const std::function<void(const CandidateBox&)>& visit_;
  // The first primitive with the same zero set.
  std::vector<int> surface_;
  int crowded_ = 0;
};

}  // namespace

bool is_same_surface(const LevelFunction& a, const LevelFunction& b, const Field& field_a,
                     const Field& field_b, const Box& box) {
  if (a.is_quadric() && b.is_quadric()) {
    const auto p = normalised(*a.quadric(), box), q = normalised(*b.quadric(), box);
    double sum = 0, difference = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      sum = std::max(sum, std::fabs(p[i] + q[i]));
      difference = std::max(difference, std::fabs(p[i] - q[i]));
    }
    constexpr double rounding = 1e-13;
    return std::min(sum, difference) <= rounding;
  }
  return same_expression(field_a, field_b) || same_expression(field_a, -field_b) ||
         same_expression(-field_a, field_b);
}

int visit_candidate_boxes(const RegionEvaluator& region, const Box& box, double longest,
                          const std::function<void(const CandidateBox&)>& visit) {
  return CandidateSearch(region, box, longest, visit).run(box);
}

}  // namespace rfm
