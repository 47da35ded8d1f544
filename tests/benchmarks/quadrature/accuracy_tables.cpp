// Errors, points and CPU time of rules on standard bodies, as tables: for each number of Gauss
// points q and each grid of n cells a side, the relative errors of measure, boundary and ∫x⁴y²,
// volume and boundary points per cut cell, and microseconds of one thread per cut cell.
//
//     rfm_quadrature_tables [name]...
#include <tbb/global_control.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "quadrature/domain_rule.hpp"
#include "quadrature/integrate.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

struct Sample {
  double measure, boundary, moment;
  double volume_points, boundary_points, seconds;
  QuadratureReport report;
};

Sample sample(const StandardRegion& body, int n, int q) {
  const RegionEvaluator region(body.region);
  const Grid grid(body.box, {n, n, n});
  QuadratureOptions options;
  options.inside_points = options.cut_points = q;
  const std::clock_t start = std::clock();
  const DomainRule rule = make_domain_rule(region, grid, options);
  const std::clock_t stop = std::clock();
  const double cells = rule.report().cut_cells;
  const double moment = integrate(rule, [](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k)
      values[k] =
          std::pow(block.coordinates[0][k], 4) * block.coordinates[1][k] * block.coordinates[1][k];
  });
  return {rule.measure(),
          rule.boundary_measure(),
          moment,
          rule.cut_points().size() / cells,
          rule.boundary().points.size() / cells,
          static_cast<double>(stop - start) / CLOCKS_PER_SEC / cells,
          rule.report()};
}

void print_tables(const StandardRegion& body) {
  const bool plane = body.region.dimension() == 2;
  const Sample best = plane ? sample(body, 64, 14) : sample(body, 32, 8);
  const double measure = std::isnan(body.measure) ? best.measure : body.measure;
  const double boundary = std::isnan(body.boundary) ? best.boundary : body.boundary;
  std::printf("%s%s\n", body.name, std::isnan(body.measure) ? " (against the finest rule)" : "");
  for (const int q : {2, 4, 8})
    for (const int n : plane ? std::vector{4, 8, 16, 32, 128} : std::vector{4, 8, 16, 32}) {
      if (!plane && q == 8 && n == 32) continue;
      const Sample s = sample(body, n, q);
      std::printf("  q %-2d n %-4d %7.0e %7.0e %7.0e  points %5.0f %4.0f  %7.2f us", q, n,
                  std::fabs(s.measure / measure - 1), std::fabs(s.boundary / boundary - 1),
                  std::fabs(s.moment / best.moment - 1), s.volume_points, s.boundary_points,
                  1e6 * s.seconds);
      if (s.report.uncertified.boxes > 0)
        std::printf("  uncertified %d (%.0e)", s.report.uncertified.boxes,
                    s.report.uncertified.measure);
      std::printf("\n");
    }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (const auto& regions : {standard_regions_2d(), standard_regions_3d()})
    for (const StandardRegion& body : regions) {
      bool wanted = argc == 1;
      for (int i = 1; i < argc; ++i) wanted |= std::strcmp(argv[i], body.name) == 0;
      if (wanted) print_tables(body);
    }
}
