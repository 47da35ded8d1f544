// Rules for cut cells, with the points that degree 3 takes: the time per cut cell is the figure.
#include "quadrature/domain_rule.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

#include "core/primitives.hpp"
#include "quadrature/tessellation.hpp"

namespace rfm {
namespace {

Region disk_minus_disk() { return circle({0, 0}, 1) - circle({0.2, 0.1}, 0.4); }
Region ball_minus_ball() { return sphere({0, 0, 0}, 1) - sphere({0.2, 0.1, 0}, 0.4); }
// Edges and corners inside cells.
Region rotated_cube() {
  const double c = std::cos(0.4), s = std::sin(0.4), d = std::cos(0.3), e = std::sin(0.3);
  const Point axes[3] = {{c * d, s * d, -e}, {-s, c, 0}, {c * e, s * e, d}};
  const auto side = [](const Point& normal, double sign) {
    return half_space({-0.6 * sign * normal[0], -0.6 * sign * normal[1], -0.6 * sign * normal[2]},
                      {sign * normal[0], sign * normal[1], sign * normal[2]});
  };
  Region cube = side(axes[0], 1) & side(axes[0], -1);
  for (int axis : {1, 2}) cube = cube & side(axes[axis], 1) & side(axes[axis], -1);
  return cube;
}
Region quartic_torus() { return torus({0, 0, 0}, {0, 0.3, 1}, 0.7, 0.25); }

Grid grid_of(int dimension, int cells) {
  return Grid({dimension, {-1.07, -1.09, -1.05}, {1.08, 1.06, 1.1}},
              {cells, cells, dimension > 2 ? cells : 1});
}

template <class MakeRegion>
void cut_cell_rules(benchmark::State& state, MakeRegion&& region_of) {
  const RegionEvaluator region(region_of());
  const Grid grid = grid_of(region.dimension(), static_cast<int>(state.range(0)));
  QuadratureOptions options;
  options.cut_points = static_cast<int>(state.range(1));
  int cut_cells = 0;
  std::size_t points = 0;
  for (auto _ : state) {
    const DomainRule rule = make_domain_rule(region, grid, options);
    cut_cells = rule.report().cut_cells;
    points = rule.cut_points().weights.size();
    benchmark::DoNotOptimize(points);
  }
  state.counters["cut_cells"] = cut_cells;
  state.counters["points_per_cut_cell"] = double(points) / cut_cells;
  state.counters["s_per_cut_cell"] = benchmark::Counter(
      cut_cells, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(cut_cell_rules, disk_minus_disk, disk_minus_disk)
    ->Args({64, 6})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cut_cell_rules, ball_minus_ball, ball_minus_ball)
    ->Args({16, 4})
    ->Args({16, 6})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cut_cell_rules, rotated_cube, rotated_cube)
    ->Args({8, 6})
    ->Args({16, 6})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cut_cell_rules, quartic_torus, quartic_torus)
    ->Args({16, 4})
    ->Unit(benchmark::kMillisecond);

template <class MakeRegion>
void elements_for_pictures(benchmark::State& state, MakeRegion&& region_of) {
  const RegionEvaluator region(region_of());
  const Grid grid = grid_of(region.dimension(), static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(tessellate(region, grid, {}).elements.size());
}
BENCHMARK_CAPTURE(elements_for_pictures, disk_minus_disk, disk_minus_disk)
    ->Arg(64)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(elements_for_pictures, ball_minus_ball, ball_minus_ball)
    ->Arg(16)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm
