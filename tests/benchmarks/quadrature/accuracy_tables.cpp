// Errors, points and CPU time of rules on standard bodies, as tables: for each number of Gauss
// points q and each grid of n cells a side, the relative errors of measure, boundary and ∫x⁴y²,
// volume and boundary points per cut cell, and microseconds of one thread per cut cell. In brackets
// the errors of measure and boundary of the prototype by which the method was chosen, where it was
// measured (0: rounding), with * where they are more than three times smaller; for its bodies lay
// elsewhere on the grid, the smallest and the largest errors at 12 positions follow.
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

struct Reference {
  const char* name;
  int cells, points;
  double measure, boundary;
};

// Errors of 1e-15 stand for "rounding".
constexpr double rounding = 1e-15;
constexpr Reference references[] = {
    {"disk", 8, 2, 1e-4, 5e-4},
    {"disk", 32, 2, 5e-7, 2e-6},
    {"disk", 8, 4, 2e-7, 2e-6},
    {"disk", 32, 4, 2e-12, 3e-11},
    {"disk", 8, 8, 2e-12, 6e-11},
    {"disk", 32, 8, 0, 0},
    {"ellipse", 8, 2, 3e-4, 2e-3},
    {"ellipse", 32, 2, 2e-6, 6e-6},
    {"ellipse", 8, 4, 1e-6, 3e-5},
    {"ellipse", 32, 4, 4e-11, 4e-10},
    {"ellipse", 8, 8, 2e-10, 1e-8},
    {"ellipse", 32, 8, 0, 0},
    {"disk-disk", 8, 2, 4e-5, 1e-3},
    {"disk-disk", 32, 2, 2e-8, 4e-6},
    {"disk-disk", 8, 4, 9e-7, 1e-5},
    {"disk-disk", 32, 4, 2e-11, 6e-10},
    {"disk-disk", 8, 8, 2e-10, 4e-9},
    {"disk-disk", 32, 8, 0, 0},
    {"square", 8, 2, 0, 0},
    {"square", 32, 2, 0, 0},
    {"square", 8, 4, 0, 0},
    {"square", 32, 4, 0, 0},
    {"square", 8, 8, 0, 0},
    {"square", 32, 8, 0, 0},
    {"star", 8, 2, 0, 0},
    {"star", 32, 2, 0, 0},
    {"star", 8, 4, 0, 0},
    {"star", 32, 4, 0, 0},
    {"star", 8, 8, 0, 0},
    {"star", 32, 8, 0, 0},
    {"sector", 8, 2, 3e-5, 9e-5},
    {"sector", 32, 2, 1e-7, 3e-7},
    {"sector", 8, 4, 2e-8, 1e-7},
    {"sector", 32, 4, 8e-13, 1e-12},
    {"sector", 8, 8, 0, 6e-13},
    {"sector", 32, 8, 0, 0},
    {"flag", 8, 2, 1e-6, 1e-5},
    {"flag", 32, 2, 1e-8, 1e-7},
    {"flag", 8, 4, 3e-12, 2e-8},
    {"flag", 32, 4, 0, 6e-13},
    {"flag", 8, 8, 0, 0},
    {"flag", 32, 8, 0, 0},
    {"ball", 8, 2, 1e-4, 7e-4},
    {"ball", 8, 4, 6e-7, 6e-6},
    {"ball", 8, 8, 4e-11, 9e-10},
    {"ball", 16, 4, 2e-9, 1e-8},
    {"ball", 32, 4, 6e-12, 5e-11},
    {"ball", 32, 8, 0, 0},
    {"torus", 8, 2, 2e-4, 6e-4},
    {"torus", 8, 4, 4e-7, 5e-6},
    {"torus", 8, 8, 5e-11, 1e-9},
    {"torus", 16, 4, 7e-7, 7e-6},
    {"torus", 32, 4, 3e-9, 4e-8},
    {"torus", 32, 8, 0, 1e-13},
    {"quartic torus", 8, 2, 3e-4, 2e-3},
    {"quartic torus", 8, 4, 7e-6, 9e-5},
    {"quartic torus", 8, 8, 3e-8, 9e-7},
    {"quartic torus", 16, 4, 4e-7, 5e-6},
    {"quartic torus", 32, 4, 5e-9, 7e-8},
    {"quartic torus", 32, 8, 6e-15, 3e-13},
    {"cube-ball", 8, 2, 8e-4, 6e-4},
    {"cube-ball", 8, 4, 1e-6, 3e-6},
    {"cube-ball", 8, 8, 1e-10, 7e-10},
    {"cube-ball", 16, 4, 2e-9, 4e-9},
    {"cube-ball", 32, 4, 1e-11, 2e-11},
    {"rotated cube", 8, 2, 0, 0},
    {"rotated cube", 8, 4, 0, 0},
    {"rotated cube", 8, 8, 0, 0},
    {"rotated cube", 16, 4, 0, 0},
    {"rotated cube", 32, 4, 0, 0},
    {"rotated cube", 32, 8, 0, 0},
    {"pawn", 8, 2, 3e-5, 1e-4},
    {"pawn", 8, 4, 6e-8, 1e-6},
    {"pawn", 8, 8, 2e-10, 6e-9},
    {"pawn", 16, 4, 2e-7, 4e-6},
    {"pawn", 32, 4, 3e-8, 7e-7},
    {"gyroid", 8, 2, 3e-5, 2e-4},
    {"gyroid", 8, 4, 9e-8, 2e-6},
    {"gyroid", 8, 8, 2e-11, 4e-10},
    {"gyroid", 16, 4, 1e-10, 5e-8},
    {"gyroid", 32, 4, 1e-11, 1e-9},
};

const Reference* reference(const StandardRegion& body, int cells, int points) {
  for (const Reference& candidate : references)
    if (std::strcmp(candidate.name, body.name) == 0 && candidate.cells == cells &&
        candidate.points == points)
      return &candidate;
  return nullptr;
}

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

struct Range {
  double low = INFINITY, high = 0;
  void add(double error) {
    low = std::min(low, error);
    high = std::max(high, error);
  }
};

// Errors with the grid moved by parts of a cell.
void print_positions(const StandardRegion& body, int n, int q, double measure, double boundary) {
  Range volume, surface;
  for (int k = 0; k < 12; ++k) {
    StandardRegion moved = body;
    // One cell more, so that all positions hold the body.
    for (int axis = 0; axis < body.box.dimension; ++axis) {
      const double side = body.box.length(axis) / n;
      const double shift = side * std::fmod((k + 0.5) * (axis + 1) * 0.6180339887, 1.0);
      moved.box.low[axis] -= shift;
      moved.box.high[axis] += side - shift;
    }
    const Sample s = sample(moved, n + 1, q);
    volume.add(std::fabs(s.measure / measure - 1));
    surface.add(std::fabs(s.boundary / boundary - 1));
  }
  std::printf("  %.0e..%.0e %.0e..%.0e", volume.low, volume.high, surface.low, surface.high);
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
      const double error = std::fabs(s.measure / measure - 1);
      const double on_boundary = std::fabs(s.boundary / boundary - 1);
      std::printf("  q %-2d n %-4d %7.0e %7.0e %7.0e  points %5.0f %4.0f  %7.2f us", q, n, error,
                  on_boundary, std::fabs(s.moment / best.moment - 1), s.volume_points,
                  s.boundary_points, 1e6 * s.seconds);
      if (const Reference* other = reference(body, n, q)) {
        const auto mark = [](double ours, double theirs) {
          return ours > 3 * std::max(theirs, rounding) ? "*" : "";
        };
        std::printf("  [%.0e%s %.0e%s]", other->measure, mark(error, other->measure),
                    other->boundary, mark(on_boundary, other->boundary));
        print_positions(body, n, q, measure, boundary);
      }
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
