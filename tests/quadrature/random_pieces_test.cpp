// The pieces that primitives contribute to the boundary (Boolean derivatives) are what bounds
// random Boolean combinations of shapes: their points lie on it, and together they are all of it.

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "core/boundary_piece.hpp"
#include "core/tape.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/random_domains.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

Box frame(int dimension) {
  Box box;
  box.dimension = dimension;
  for (int axis = 0; axis < dimension; ++axis) {
    box.low[axis] = -RandomDomain::half_side;
    box.high[axis] = RandomDomain::half_side;
  }
  return box;
}

Point moved(const Point& point, const Point& direction, double by) {
  return {point[0] + by * direction[0], point[1] + by * direction[1], point[2] + by * direction[2]};
}

struct Tally {
  int domains = 0, refined = 0, pieces = 0, trimmed = 0, points = 0, near_edges = 0, astray = 0,
      within = 0;
  double astray_weight = 0, uncertified = 0;
};

// ∮ n_i x_i ds is the volume for every axis: a piece that is missing or counted twice shows in one
// of them at least.
double largest_defect(const DomainRule& rule) {
  const int dimension = rule.dimension();
  std::array<double, 3> flux{};
  const SurfacePoints& points = rule.boundary().points;
  for (int i = 0; i < points.size(); ++i)
    for (int axis = 0; axis < dimension; ++axis)
      flux[axis] += points.weights[i] * points.normal(i)[axis] * points.point(i)[axis];
  double largest = 0;
  for (int axis = 0; axis < dimension; ++axis)
    largest = std::max(largest, std::fabs(flux[axis] - rule.measure()));
  return largest;
}

constexpr double enough = 1e-6;

bool expect_cover(const DomainRule& rule, const RandomDomain& domain) {
  // Where quadrature announces that it is less exact, to what it announces: how far orders differ,
  // and all of the boundary in boxes that are not certified (defects are a hundredth of that).
  const QuadratureReport& report = rule.report();
  const double announced = report.order_difference.volume + report.order_difference.boundary +
                           report.uncertified.boundary;
  const double defect = largest_defect(rule);
  EXPECT_LE(defect, std::max(enough, announced)) << domain.text();
  return defect <= enough;
}

// Points of the boundary that are not where they should be, by their weights.
class Astray {
 public:
  void add(int point, double weight) {
    if (seen_.insert(point).second) weight_ += weight;
  }
  int count() const { return static_cast<int>(seen_.size()); }
  double weight() const { return weight_; }

 private:
  std::set<int> seen_;
  double weight_ = 0;
};

void examine_places(const DomainRule& rule, const RegionEvaluator& region,
                    const RandomDomain& domain, Tally& tally, Astray& astray) {
  const SurfacePoints& points = rule.boundary().points;
  const int stride = std::max(1, points.size() / 200);
  for (int i = 0; i < points.size(); i += stride) {
    const Point at = points.point(i), normal = points.normal(i);
    Point gradient;
    const double value = region.level(points.numbers[i]).value_and_gradient(at, gradient);
    const double slope = std::hypot(gradient[0], gradient[1], gradient[2]);
    ++tally.points;
    EXPECT_LE(std::fabs(value), 1e-9 * slope + 1e-12) << domain.text();
    // Other surfaces within a small distance decide there, too: edges.
    constexpr double step = 1e-6;
    bool near_edge = slope < 1e-3;
    for (int k = 0; k < region.primitive_count(); ++k) {
      Point other;
      const double away = region.level(k).value_and_gradient(at, other);
      near_edge =
          near_edge || (k != points.numbers[i] &&
                        std::fabs(away) <= 3 * step * std::hypot(other[0], other[1], other[2]));
    }
    if (near_edge) {
      ++tally.near_edges;
      continue;
    }
    const bool bounds =
        !region.contains(moved(at, normal, step)) && region.contains(moved(at, normal, -step));
    if (!bounds) astray.add(i, points.weights[i]);
  }
}

// Functions of pieces vanish on their own piece and are at least the distance from the surface
// elsewhere on the boundary.
void examine_functions(const DomainRule& rule, const RegionEvaluator& region, Tally& tally,
                       Astray& astray) {
  const SurfacePoints& points = rule.boundary().points;
  const int stride = std::max(1, points.size() / 100);
  for (int k = 0; k < region.primitive_count(); ++k) {
    if (!(rule.boundary_measure(k) > 1e-6)) continue;
    const BoundaryPiece piece = boundary_piece(k, region, frame(rule.dimension()));
    ++tally.pieces;
    tally.trimmed += !piece.whole;
    const Tape own({region.region().primitives()[k]->function}, {0}, rule.dimension());
    const Tape function({piece.function}, {0}, rule.dimension());
    for (int i = 0; i < points.size(); i += stride) {
      const double value = function.value(points.point(i));
      const bool right = points.numbers[i] == k
                             ? std::fabs(value) <= 1e-8
                             : value >= std::fabs(own.value(points.point(i))) - 1e-8;
      if (!right) astray.add(i, points.weights[i]);
    }
  }
}

void check(int dimension, int first, int count, std::vector<int> grids, int points, double share) {
  Tally tally;
  for (int seed = first; seed < first + count; ++seed) {
    const RandomDomain domain = random_domain(seed, dimension);
    const RegionEvaluator region(domain.region());
    QuadratureOptions options;
    options.inside_points = 2;
    options.cut_points = points;
    // On a finer grid where the rule announces more on this one.
    std::optional<DomainRule> found;
    bool within = false;
    for (const int cells : grids) {
      found = make_domain_rule(region, Grid(frame(dimension), {cells, cells, cells}), options);
      within = !(found->measure() > 0) || expect_cover(*found, domain);
      if (within) break;
      ++tally.refined;
    }
    const DomainRule& rule = *found;
    if (!(rule.measure() > 0)) continue;
    ++tally.domains;
    tally.within += within;
    if (!within) std::printf("seed %d: %.1e\n", seed, largest_defect(rule));
    Astray astray;
    examine_places(rule, region, domain, tally, astray);
    examine_functions(rule, region, tally, astray);
    // Where nothing is certified, points may be on the wrong side of an edge; nowhere else.
    EXPECT_LE(astray.weight(), rule.report().uncertified.boundary) << domain.text();
    tally.astray += astray.count();
    tally.astray_weight += astray.weight();
    tally.uncertified += rule.report().uncertified.boundary;
  }
  std::printf(
      "%d domains (%d covered to 1e-6 after %d finer grids, the others as announced), "
      "%d pieces (%d trimmed), "
      "%d points (%d near edges; %d astray, of weight %.1e, where %.1e is not certified)\n",
      tally.domains, tally.within, tally.refined, tally.pieces, tally.trimmed, tally.points,
      tally.near_edges, tally.astray, tally.astray_weight, tally.uncertified);
  EXPECT_LE(tally.astray, tally.points / 10000);
  EXPECT_LE(tally.astray_weight, 1e-6);
  EXPECT_GE(tally.within, share * tally.domains);
  EXPECT_GT(tally.points, 100 * tally.domains / 2);
  EXPECT_LT(tally.near_edges, tally.points / 20);
}

TEST(RandomPieces, BoundRandomDomainsOfThePlane) { check(2, 20000, 40, {20}, 10, 1); }
TEST(RandomPieces, BoundRandomDomainsOfSpace) { check(3, 20000, 6, {8, 13, 21}, 10, 1); }
TEST(LongRandomPieces, BoundRandomDomainsOfThePlane) { check(2, 30000, 1500, {20}, 10, 1); }
TEST(LongRandomPieces, BoundRandomDomainsOfSpace) {
  check(3, 30000, 500, {8, 13, 21, 34}, 10, 0.97);
}

}  // namespace
