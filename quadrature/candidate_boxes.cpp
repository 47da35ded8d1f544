#include "quadrature/candidate_boxes.hpp"

#include <cmath>

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
    if (box.longest_side() <= 0x1p-10 * longest_) {
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
