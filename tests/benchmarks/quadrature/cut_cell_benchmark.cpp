// What one cut cell costs, apart from classifying the grid and gathering the points, and what one
// cell costs to classify. "expression" is the same body as a power that is no quadric: values and
// bounds go through programs and tapes instead of closed forms.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "quadrature/cell_surfaces.hpp"
#include "quadrature/cut_cell.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

namespace rfm {
namespace {

using namespace rfm::test;

Field radius_in_plane() { return square(x() - 0.1) + square(y() + 0.07); }
Field radius_in_space() { return radius_in_plane() + square(z() - 0.03); }

Region disk_as_quadric() { return region_of(1 - radius_in_plane(), 2); }
Region disk_as_expression() { return region_of(1 - square(radius_in_plane()), 2); }
Region ball_as_quadric() { return solid(1 - radius_in_space()); }
Region ball_as_expression() { return solid(1 - square(radius_in_space())); }
Region five_lines() { return star(0.45, 0.21); }
Region six_planes() { return rotated_cube(0.85); }

const auto inverse_rate =
    benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert;

template <class MakeRegion>
void cut_cells(benchmark::State& state, MakeRegion&& make_region) {
  const RegionEvaluator region(make_region());
  const Grid cells = grid(1.7, static_cast<int>(state.range(0)), region.dimension());
  const CellRuleOptions options{static_cast<int>(state.range(1)), state.range(2) != 0};
  const CellClassification classification = classify_cells(region, cells);
  const CellSurfaces surfaces(region, {});
  const Breakpoints breakpoints = surfaces.breakpoints({});
  const int count = static_cast<int>(classification.cut_cells.size());
  CellRule rule;
  for (auto _ : state) {
    Subdivision subdivision{SubdivisionOptions{}};
    for (int c = 0; c < count; ++c) {
      rule.volume.clear();
      rule.boundary.clear();
      const Box box = quadrature_cell(cells, cells.position(classification.cut_cells[c]));
      surfaces.visit_cut_cell(classification, c, box, breakpoints,
                              [&](const Box& part, const ActiveSet& active) {
                                add_cell_rule(part, active, options, subdivision, rule);
                              });
      benchmark::DoNotOptimize(rule.volume.weights.data());
    }
  }
  state.counters["s_per_cut_cell"] = benchmark::Counter(count, inverse_rate);
}
// Arguments: cells a side, Gauss points, and whether a second order is compared.
#define RFM_CUT_CELLS(region, cells) \
  BENCHMARK_CAPTURE(cut_cells, region, region)->Args({cells, 4, 0})->Args({cells, 4, 1})
RFM_CUT_CELLS(disk_as_quadric, 32);
RFM_CUT_CELLS(disk_as_expression, 32);
RFM_CUT_CELLS(five_lines, 32);
RFM_CUT_CELLS(ball_as_quadric, 16);
RFM_CUT_CELLS(ball_as_expression, 16);
RFM_CUT_CELLS(six_planes, 16);
#undef RFM_CUT_CELLS

template <class MakeRegion>
void classification(benchmark::State& state, MakeRegion&& make_region) {
  const RegionEvaluator region(make_region());
  const Grid cells = grid(1.7, static_cast<int>(state.range(0)), region.dimension());
  for (auto _ : state) benchmark::DoNotOptimize(classify_cells(region, cells).cut_cells.data());
  state.counters["s_per_cell"] = benchmark::Counter(cells.cell_count(), inverse_rate);
}
BENCHMARK_CAPTURE(classification, disk_as_quadric, disk_as_quadric)
    ->Arg(1024)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(classification, disk_as_expression, disk_as_expression)
    ->Arg(1024)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(classification, five_lines, five_lines)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(classification, ball_as_quadric, ball_as_quadric)
    ->Arg(128)
    ->Unit(benchmark::kMillisecond);

// Real times tell the speed-up, processor times of all threads what is lost to threads.
#define RFM_BY_THREADS(name)                                                     \
  BENCHMARK(name)->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime()->Unit( \
      benchmark::kMillisecond)

// A chain of roots and quotients that touches no memory, cut into as many tasks as a rule: what two
// threads gain on this machine at best. A virtual machine may have two halves of one core, or share
// its cores with others.
double chain(int length) {
  double a = 1.1, b = 0.7, c = 0.3;
  for (int i = 0; i < length; ++i) {
    a = std::sqrt(a * b + 1);
    b = 0.999 * b + 0.01 * a;
    c = c / (a + 1.5) + b;
  }
  return a + b + c;
}
void kernel_by_threads(benchmark::State& state) {
  tbb::global_control threads(tbb::global_control::max_allowed_parallelism, state.range(0));
  for (auto _ : state)
    tbb::parallel_for(0, 128, [](int) { benchmark::DoNotOptimize(chain(10'000)); });
}

// A whole rule by one thread and by two: the quotient of the times is the speed-up, to be compared
// with that of the kernel.
void rule_by_threads(benchmark::State& state) {
  tbb::global_control threads(tbb::global_control::max_allowed_parallelism, state.range(0));
  const RegionEvaluator region(six_planes());
  const Grid cells = grid(1.7, 24, 3);
  for (auto _ : state)
    benchmark::DoNotOptimize(make_domain_rule(region, cells).cut_points().weights.data());
}
RFM_BY_THREADS(kernel_by_threads);
RFM_BY_THREADS(rule_by_threads);
#undef RFM_BY_THREADS

}  // namespace
}  // namespace rfm
