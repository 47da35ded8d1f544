// What compressed rules of cut cells cost and what assembly gains, on one thread.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "solvers/assembly.hpp"
#include "tests/benchmarks/solvers/systems.hpp"

namespace rfm::benchmarks {
namespace {

DomainRule ball_rule(const benchmark::State& state) {
  const int dimension = static_cast<int>(state.range(0)), degree = static_cast<int>(state.range(1));
  QuadratureOptions options;
  options.inside_points = degree + 1;
  options.cut_points = degree + 3;
  options.compress_cut_cells = state.range(3) != 0;
  return make_domain_rule(RegionEvaluator(unit_ball(dimension)),
                          ball_grid(dimension, static_cast<int>(state.range(2))), options);
}

void add_cases(benchmark::internal::Benchmark* cases) {
  cases->ArgNames({"dimension", "degree", "cells", "compressed"})->Unit(benchmark::kMillisecond);
  for (const std::array<int, 3>& size : {std::array{2, 3, 64}, std::array{3, 2, 16}})
    for (const int compressed : {0, 1}) cases->Args({size[0], size[1], size[2], compressed});
}

void rule_of_cut_cells(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (auto _ : state) benchmark::DoNotOptimize(ball_rule(state).cut_points().size());
  const DomainRule rule = ball_rule(state);
  state.counters["points_per_cut_cell"] =
      double(rule.cut_points().size()) / double(rule.cut_cells().size());
}
BENCHMARK(rule_of_cut_cells)->Apply(add_cases);

void assembly_with_cut_cells(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const int dimension = static_cast<int>(state.range(0)), degree = static_cast<int>(state.range(1));
  Discretization problem = by_structure(dimension, degree, static_cast<int>(state.range(2)));
  problem.rule = ball_rule(state);
  for (auto _ : state) benchmark::DoNotOptimize(problem.system().constant);
}
BENCHMARK(assembly_with_cut_cells)->Apply(add_cases);

}  // namespace
}  // namespace rfm::benchmarks
