// Cells of a grid of 256 × 256 sorted by bounds of one expression with a thousand branches: by
// classify_cells, which leaves out branches on its way down, and by a descent of the same tree with
// the expression as a whole. The two expressions at the ends of what can be left out: circles that
// lie apart, and functions so alike that nothing is ever decided.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "quadrature/cell_classification.hpp"

namespace rfm::benchmarks {
namespace {

constexpr int side = 256;
const Field x = x_coordinate(), y = y_coordinate();

Field union_of_circles() {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> unit(0, 1);
  Field all;
  for (int k = 0; k < 1000; ++k) {
    const Field u = x - unit(generator), v = y - unit(generator);
    const Field circle = 1e-4 - u * u - v * v;
    all = k == 0 ? circle : max(all, circle);
  }
  return all;
}

Field alike_functions() {
  Field all;
  for (int k = 0; k < 50; ++k) {
    const Field one = 0.1 - pow(x - 0.5, 2) - pow(y - 0.5, 2) + 1e-9 * sin(k + 3 * x) * cos(k * y);
    all = k == 0 ? one : max(all, one);
  }
  return all;
}

Region region_of(const Field& field) { return Region(Primitive{"", field, field}, 2); }

void count_cells(benchmark::State& state) {
  state.counters["per_cell"] = benchmark::Counter(
      side * side, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void leaving_out_branches(benchmark::State& state, const Field& field) {
  const RegionEvaluator region(region_of(field));
  const Grid grid({2, {0, 0}, {1, 1}}, {side, side});
  std::size_t cut = 0;
  for (auto _ : state)
    cut = classify_cells(region, grid, {}, Classification::loose).cut_cells.size();
  state.counters["cut_cells"] = static_cast<double>(cut);
  count_cells(state);
}
BENCHMARK_CAPTURE(leaving_out_branches, circles, union_of_circles())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(leaving_out_branches, alike, alike_functions())->Unit(benchmark::kMillisecond);

std::size_t undecided(const LevelFunction& level, std::array<int, 2> begin,
                      std::array<int, 2> end) {
  constexpr double h = 1.0 / side;
  const Interval range =
      level.value_bounds({2, {begin[0] * h, begin[1] * h}, {end[0] * h, end[1] * h}});
  if (range.low >= 0 || range.high < 0) return 0;
  const int axis = end[1] - begin[1] > end[0] - begin[0];
  if (end[axis] - begin[axis] == 1) return 1;
  auto middle_end = end, middle_begin = begin;
  middle_end[axis] = middle_begin[axis] = (begin[axis] + end[axis]) / 2;
  return undecided(level, begin, middle_end) + undecided(level, middle_begin, end);
}

void as_a_whole(benchmark::State& state, const Field& field) {
  const LevelFunction level(field, 2);
  std::size_t cut = 0;
  for (auto _ : state) cut = undecided(level, {0, 0}, {side, side});
  state.counters["cut_cells"] = static_cast<double>(cut);
  count_cells(state);
}
BENCHMARK_CAPTURE(as_a_whole, circles, union_of_circles())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(as_a_whole, alike, alike_functions())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm::benchmarks
