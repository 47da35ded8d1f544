// Random Boolean combinations of shapes: the divergence theorem holds, or the report says where it
// may not; no cell takes long.

#include "tests/quadrature/random_domains.hpp"

#include <gmock/gmock.h>

#include <ctime>

#include "core/freed_memory.hpp"
#include "quadrature/domain_rule.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

constexpr double enough = 1e-10;

Grid grid_of(const RandomDomain& domain, int cells) {
  Box box;
  box.dimension = domain.dimension;
  for (int axis = 0; axis < box.dimension; ++axis) {
    box.low[axis] = -RandomDomain::half_side;
    box.high[axis] = RandomDomain::half_side;
  }
  return Grid(box, {cells, cells, cells});
}

struct Setting {
  int cells;
  int points;
};

QuadratureReport report_for(const RandomDomain& domain, const Setting& setting) {
  QuadratureOptions options;
  options.inside_points = 2;
  options.cut_points = setting.points;
  const RegionEvaluator region(domain.region());
  return make_domain_rule(region, grid_of(domain, setting.cells), options).report();
}

// By how much the report lets the identity fail. Differences of orders are estimates, not bounds.
// The boundary in n boxes of d dimensions of total measure V is of the order n^(1/d) V^((d-1)/d).
double announced(const QuadratureReport& report, int dimension) {
  constexpr double safety = 7;
  const int boxes = report.uncertified.boxes + report.uncertified.contact_boxes;
  const double measure = report.uncertified.measure + report.uncertified.contact_measure;
  const double side = std::pow(measure / std::max(boxes, 1), 1.0 / dimension);
  return safety * (report.order_difference.volume + report.order_difference.boundary +
                   (side > 0 ? dimension * measure / side : 0.0));
}

bool breaks_the_theorem(const RandomDomain& domain, const Setting& setting) {
  const QuadratureReport report = report_for(domain, setting);
  return !(report.divergence_defect <= std::max(enough, announced(report, domain.dimension)));
}

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The dearest cut cell, in seconds, each cell taken as a grid of its own.
double dearest_cell(const RandomDomain& domain, const Setting& setting) {
  const Grid grid = grid_of(domain, setting.cells);
  const RegionEvaluator region(domain.region());
  QuadratureOptions options;
  options.cut_points = setting.points;
  double dearest = 0;
  for (const int cell : classify_cells(region, grid).cut_cells) {
    const Grid alone(grid.cell(grid.position(cell)), {1, 1, 1});
    double fastest = INFINITY;
    // Only what is slow is repeated: the machine may have been busy.
    for (int attempt = 0; attempt < 3 && fastest > 0.01; ++attempt) {
      const double start = cpu_seconds();
      make_domain_rule(region, alone, options);
      fastest = std::min(fastest, cpu_seconds() - start);
    }
    dearest = std::max(dearest, fastest);
  }
  return dearest;
}

// How many domains keep the identity to `enough`; the others must announce that they do not.
int domains_within(int dimension, int count, const Setting& setting) {
  int within = 0, announcing = 0, uncertified = 0;
  for (int seed = 0; seed < count; ++seed) {
    const RandomDomain domain = random_domain(seed, dimension);
    const QuadratureReport report = report_for(domain, setting);
    const double most = announced(report, dimension);
    uncertified += report.uncertified.boxes > 0;
    if (report.divergence_defect <= enough) {
      ++within;
    } else if (report.divergence_defect <= most) {
      ++announcing;
    } else {
      const RandomDomain smallest = shrunk(
          domain, [&](const RandomDomain& part) { return breaks_the_theorem(part, setting); });
      ADD_FAILURE() << "defect " << report.divergence_defect << ", announced " << most << "\n"
                    << smallest.text();
    }
  }
  std::printf("%d domains: %d within %g, %d announced, %d with uncertified boxes\n", count, within,
              enough, announcing, uncertified);
  return within;
}

void expect_cheap_cells(int dimension, int count, const Setting& setting) {
  constexpr double most = 0.05;
  double dearest = 0;
  for (int seed = 0; seed < count; ++seed) {
    const RandomDomain domain = random_domain(seed, dimension);
    const double seconds = dearest_cell(domain, setting);
    dearest = std::max(dearest, seconds);
    EXPECT_LE(seconds, most) << shrunk(domain, [&](const RandomDomain& part) {
                                  return dearest_cell(part, setting) > most;
                                }).text();
  }
  std::printf("the dearest cell takes %.1f ms\n", 1e3 * dearest);
}

constexpr Setting plane{24, 10}, space{8, 8};

TEST(RandomDomains, KeepTheDivergenceTheoremInThePlane) {
  EXPECT_GE(domains_within(2, 200, plane), 180);
}
TEST(RandomDomains, KeepTheDivergenceTheoremInSpace) { domains_within(3, 20, space); }

TEST(LongRandomDomains, KeepTheDivergenceTheoremInThePlane) {
  EXPECT_GE(domains_within(2, 10000, plane), 9400);
}
TEST(LongRandomDomains, KeepTheDivergenceTheoremInSpace) { domains_within(3, 2000, space); }
// In seconds of the processor, on coarse grids as well, whose cells are dearest.
TEST(LongRandomDomains, NoCellOfThePlaneTakesLong) {
  expect_cheap_cells(2, 5000, {4, 6});
  expect_cheap_cells(2, 5000, {24, 6});
}
TEST(LongRandomDomains, NoCellOfSpaceTakesLong) {
  keep_freed_memory();  // as rfm-solve does
  expect_cheap_cells(3, 1000, {3, 6});
  expect_cheap_cells(3, 1000, {8, 6});
}

}  // namespace
