#pragma once

#include <benchmark/benchmark.h>

#include <ctime>
#include <experimental/simd>
#include <random>
#include <vector>

#include "core/tape.hpp"

namespace rfm::benchmarks {

/// Random points of [−1, 1]ᵈ in blocks, few enough to stay in the cache.
class MeasuredPoints {
 public:
  static constexpr int blocks = 16;
  explicit MeasuredPoints(int dimension) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int axis = 0; axis < dimension; ++axis) {
      coordinates_[axis].resize(blocks * Tape::block_size);
      for (double& x : coordinates_[axis]) x = uniform(generator);
    }
    for (int b = 0; b < blocks; ++b) {
      blocks_[b].count = Tape::block_size;
      for (int axis = 0; axis < dimension; ++axis)
        blocks_[b].coordinates[axis] = &coordinates_[axis][b * Tape::block_size];
    }
  }
  const PointBlock& block(int number) const { return blocks_[number]; }

 private:
  std::array<std::vector<double>, 3> coordinates_;
  std::array<PointBlock, blocks> blocks_;
};

/// Multiply-adds per second on registers, two operations each: the best of several short runs.
inline double peak_rate() {
  using Batch = std::experimental::native_simd<double>;
  static const double rate = [] {
    constexpr int chains = 12, rounds = 100000;
    std::array<Batch, chains> sums;
    for (int i = 0; i < chains; ++i) sums[i] = 1.0 + 0.01 * i;
    Batch factor = 0.999999, term = 1e-6;
    double best = 1;
    for (int repeat = 0; repeat < 10; ++repeat) {
      const std::clock_t start = std::clock();
      benchmark::DoNotOptimize(factor);
      for (int round = 0; round < rounds; ++round)
        for (Batch& sum : sums) sum = sum * factor + term;
      benchmark::DoNotOptimize(sums);
      best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return 2.0 * chains * rounds * Batch::size() / best;
  }();
  return rate;
}

/// CPU time per point, and the part of the peak rate at `operations` per point.
inline void report(benchmark::State& state, double operations = 0) {
  const double points = MeasuredPoints::blocks * Tape::block_size;
  using benchmark::Counter;
  state.counters["per_point"] =
      Counter(points, Counter::kIsIterationInvariantRate | Counter::kInvert);
  if (operations > 0)
    state.counters["of_peak"] =
        Counter(points * operations / peak_rate(), Counter::kIsIterationInvariantRate);
}

/// Evaluates a tape at the points.
inline void measure_tape(benchmark::State& state, const Tape& tape, double operations = 0) {
  const MeasuredPoints points(tape.dimension());
  Tape::Workspace workspace(tape);
  for (auto _ : state) {
    for (int block = 0; block < MeasuredPoints::blocks; ++block) {
      tape.evaluate(points.block(block), workspace);
      benchmark::DoNotOptimize(workspace.coefficient(0));
      benchmark::ClobberMemory();
    }
  }
  report(state, operations);
}

}  // namespace rfm::benchmarks
