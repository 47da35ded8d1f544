// Signs of the cells of a 256 × 256 grid over the union by max of 1,000 circles: by bounds of the
// whole tape in every cell, and by tapes that are specialised on the way down a quadtree.
#include <benchmark/benchmark.h>

#include <random>

#include "core/tape.hpp"

namespace rfm::benchmarks {
namespace {

constexpr int side = 256;

Field circles(int count) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> unit(0, 1);
  Field all;
  for (int k = 0; k < count; ++k) {
    const Field u = x_coordinate() - unit(generator), v = y_coordinate() - unit(generator);
    const Field circle = 1e-4 - u * u - v * v;
    all = k == 0 ? circle : max(all, circle);
  }
  return all;
}

Box cells(int i, int j, int size) {
  constexpr double h = 1.0 / side;
  return {2, {i * h, j * h}, {(i + size) * h, (j + size) * h}};
}

// One cell in 64, to be multiplied.
void bounds_of_the_general_tape(benchmark::State& state) {
  const Tape tape({circles(1000)}, {0}, 2);
  for (auto _ : state)
    for (int i = 0; i < side; i += 8)
      for (int j = 0; j < side; j += 8) benchmark::DoNotOptimize(tape.value_bounds(cells(i, j, 1)));
  state.counters["per_cell"] =
      benchmark::Counter(side * side / 64, benchmark::Counter::kIsIterationInvariantRate |
                                               benchmark::Counter::kInvert);
}
BENCHMARK(bounds_of_the_general_tape)->Unit(benchmark::kMillisecond);

int undecided(const Tape& tape, int i, int j, int size) {
  if (size == 1) return !tape.value_bounds(cells(i, j, 1)).excludes_zero();
  const Tape special = tape.specialised(cells(i, j, size));
  const int half = size / 2;
  int count = 0;
  for (const int p : {i, i + half})
    for (const int q : {j, j + half}) count += undecided(special, p, q, half);
  return count;
}

void bounds_of_specialised_tapes(benchmark::State& state) {
  const Tape tape({circles(1000)}, {0}, 2);
  int count = 0;
  for (auto _ : state) count = undecided(tape, 0, 0, side);
  state.counters["undecided"] = count;
  state.counters["per_cell"] = benchmark::Counter(
      side * side, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(bounds_of_specialised_tapes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm::benchmarks
