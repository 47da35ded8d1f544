#include "quadrature/compression.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <random>

#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;
using testing::ElementsAre;

namespace {

double moment(const VolumePoints& points, int begin, int end, const std::array<int, 3>& powers,
              const Point& center, double scale) {
  double sum = 0;
  for (int i = begin; i < end; ++i) {
    double term = points.weights[i];
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < powers[axis]; ++k)
        term *= (points.coordinates[axis][i] - center[axis]) / scale;
    sum += term;
  }
  return sum;
}

// Largest difference of the moments of one total degree, relative to the sum of the weights.
double moment_difference(const VolumePoints& a, PointRange in_a, const VolumePoints& b,
                         PointRange in_b, int dimension, int degree, const Box& cell) {
  const Point center = cell.center();
  const double scale = 0.5 * cell.longest_side();
  const double mass = moment(a, in_a.begin, in_a.end, {0, 0, 0}, center, scale);
  double largest = 0;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      const int k = degree - i - j;
      if (dimension == 2 && k > 0) continue;
      const std::array<int, 3> powers{i, j, k};
      largest =
          std::max(largest, std::fabs(moment(a, in_a.begin, in_a.end, powers, center, scale) -
                                      moment(b, in_b.begin, in_b.end, powers, center, scale)));
    }
  return largest / mass;
}

DomainRule rule_for(const Region& region, const Grid& grid, int points, bool compressed) {
  QuadratureOptions options;
  options.cut_points = points;
  options.compress_cut_cells = compressed;
  options.compare_orders = false;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

TEST(Compression, DegreesAreThoseWhosePolynomialsAreFewEnough) {
  const auto degrees = [](int dimension) {
    std::vector<int> result;
    for (int points = 1; points <= 6; ++points)
      result.push_back(compressed_degree(points, dimension));
    return result;
  };
  EXPECT_THAT(degrees(1), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(degrees(2), ElementsAre(0, 1, 2, 4, 5, 7));
  EXPECT_THAT(degrees(3), ElementsAre(0, 1, 3, 5, 7, 8));
}

// Of every cut cell: moments kept to the degree, not beyond; few points; positive weights.
void expect_compressed(const StandardRegion& body, int cells, int points) {
  const int dimension = body.region.dimension();
  const Grid grid(body.box, {cells, cells, cells});
  const DomainRule full = rule_for(body.region, grid, points, false);
  const DomainRule few = rule_for(body.region, grid, points, true);
  ASSERT_EQ(full.cut_cells(), few.cut_cells());
  const int degree = compressed_degree(points, dimension);
  const int most = static_cast<int>(std::lround(std::pow(points, dimension)));
  double beyond = 0;
  int reduced = 0;
  for (std::size_t c = 0; c < full.cut_cells().size(); ++c) {
    const PointRange in_full = full.cut_range(c), in_few = few.cut_range(c);
    ASSERT_LE(in_few.size(), most) << body.name;
    reduced += in_few.size() < in_full.size();
    for (int i = in_few.begin; i < in_few.end; ++i) ASSERT_GT(few.cut_points().weights[i], 0);
    const Box cell = grid.cell(grid.position(full.cut_cells()[c]));
    const auto difference = [&](int of_degree) {
      return moment_difference(full.cut_points(), in_full, few.cut_points(), in_few, dimension,
                               of_degree, cell);
    };
    for (int k = 0; k <= degree; ++k)
      ASSERT_LE(difference(k), 2e-13) << body.name << " degree " << k << " cell " << c;
    beyond = std::max(beyond, difference(degree + 1));
  }
  EXPECT_GT(reduced, 0) << body.name;
  EXPECT_GT(beyond, 1e-6) << body.name;
}

TEST(Compression, KeepsMomentsToItsDegreeAndNotBeyondInThePlane) {
  for (const StandardRegion& body : standard_regions_2d())
    for (const int points : {2, 4, 6}) expect_compressed(body, 8, points);
}

TEST(Compression, KeepsMomentsToItsDegreeAndNotBeyondInSpace) {
  for (const StandardRegion& body : standard_regions_3d())
    if (!std::isnan(body.measure))
      for (const int points : {2, 3}) expect_compressed(body, 5, points);
  expect_compressed(standard_regions_3d()[0], 5, 4);
}

TEST(Compression, KeepsAreasAndTheirOrder) {
  // Of a smooth integrand, exp(x + y) on the disk: 2π I₁(√2) / √2.
  const double exact = 2 * pi * std::cyl_bessel_i(1, std::sqrt(2)) / std::sqrt(2);
  const auto error = [&](int cells) {
    const DomainRule rule = rule_for(disk(0, 0, 1), grid(1.13, cells), 4, true);
    double sum = 0;
    VolumePoints points = rule.cut_points();
    for (const int cell : rule.inside_cells()) rule.add_inside_points(cell, points);
    for (int i = 0; i < points.size(); ++i)
      sum += points.weights[i] * std::exp(points.coordinates[0][i] + points.coordinates[1][i]);
    EXPECT_NEAR(rule.measure(), pi, 2e-5 * std::pow(8.0 / cells, 8));
    return std::fabs(sum - exact);
  };
  // Degree 4 in a layer of cells: at least h⁵ times their measure, which is O(h).
  double coarse = 0, fine = 0;
  for (int k = 0; k < 6; ++k) {
    coarse += error(8 + k);
    fine += error(32 + 4 * k);
  }
  const double order = std::log2(coarse / fine) / 2;
  EXPECT_GT(order, 5.5);
  EXPECT_LT(order, 8);
}

TEST(Compression, SliversStayExactRelativeToThemselves) {
  // (y − 1/2)⁴ over the strip [0, 1] × [1/2, 1/2 + w].
  for (const double w : {1e-2, 1e-5}) {
    const Region region = half_plane(1, 0, 0) & half_plane(-1, 0, 1) & half_plane(0, 1, 0) &
                          half_plane(0, -1, 0.5 + w);
    const DomainRule rule = rule_for(region, Grid({2, {0, 0}, {1, 1}}, {4, 4}), 6, true);
    const VolumePoints& points = rule.cut_points();
    double sum = 0;
    for (int i = 0; i < points.size(); ++i)
      if (const double y = points.coordinates[1][i] - 0.5; y > 0)
        sum += points.weights[i] * std::pow(y, 4);
    EXPECT_NEAR(sum / (std::pow(w, 5) / 5), 1, 1e-13 + 2e-15 / w) << w;
  }
}

TEST(Compression, DoesNotDependOnTheNumberOfThreads) {
  const StandardRegion body = standard_regions_3d()[0];
  const auto points = [&](int threads) {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return rule_for(body.region, Grid(body.box, {5, 5, 5}), 3, true).cut_points();
  };
  const VolumePoints one = points(1), two = points(2);
  EXPECT_EQ(one.weights, two.weights);
  EXPECT_EQ(one.coordinates, two.coordinates);
}

TEST(Compression, FewPointsStayAsTheyAre) {
  VolumePoints points;
  points.add(2, {0, 0, 0}, 1);
  points.add(2, {1, 0, 0}, 2);
  compress(2, 1, 0, points);
  EXPECT_THAT(points.weights, ElementsAre(1, 2));
}

TEST(Compression, PointsOnALineKeepTheirMoments) {
  // The rank of the moments is that of one dimension; the sums are kept all the same.
  VolumePoints points;
  for (int i = 0; i < 20; ++i) points.add(2, {0.1 * i, 0, 0}, 1 + 0.01 * i);
  const VolumePoints before = points;
  compress(2, 3, 0, points);
  EXPECT_LE(points.size(), 10);
  for (int k = 0; k <= 3; ++k)
    EXPECT_LE(
        moment_difference(before, {0, 20}, points, {0, points.size()}, 2, k, {2, {0, -1}, {2, 1}}),
        1e-13);
}

}  // namespace
