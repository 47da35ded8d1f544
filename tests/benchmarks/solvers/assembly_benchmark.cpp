// Assembly of −Δu = 1 with u = ω Ψ, on one thread: time per cell of the region.
#include "solvers/assembly.hpp"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "tests/benchmarks/solvers/systems.hpp"

namespace rfm::benchmarks {
namespace {

void assembly(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Discretization problem =
      by_structure(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                   static_cast<int>(state.range(2)));
  for (auto _ : state) benchmark::DoNotOptimize(problem.system().constant);
  state.counters["s_per_cell"] = benchmark::Counter(
      double(problem.rule.inside_cells().size() + problem.rule.cut_cells().size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["cut_part"] =
      double(problem.rule.cut_cells().size()) /
      double(problem.rule.inside_cells().size() + problem.rule.cut_cells().size());
}
BENCHMARK(assembly)
    ->ArgNames({"dimension", "degree", "cells"})
    ->Args({2, 3, 128})
    ->Args({2, 5, 64})
    ->Args({3, 2, 20})
    ->Args({3, 3, 12})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm::benchmarks
