// What this machine can do at best, measured in the same run as everything else: times of kernels
// compare across machines as parts of these two numbers.
#include <benchmark/benchmark.h>

#include <array>
#include <experimental/simd>
#include <vector>

namespace {

using Batch = std::experimental::native_simd<double>;

// Multiply-adds on registers: twelve independent chains hide the latency of four cycles on two
// units.
void peak_multiply_add(benchmark::State& state) {
  constexpr int chains = 12, rounds = 4096;
  std::array<Batch, chains> sums;
  for (int i = 0; i < chains; ++i) sums[i] = 1.0 + 0.01 * i;
  Batch factor = 0.999999, term = 1e-6;
  for (auto _ : state) {
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(term);
    for (int round = 0; round < rounds; ++round)
      for (Batch& sum : sums) sum = sum * factor + term;
    benchmark::DoNotOptimize(sums);
  }
  state.counters["flop"] = benchmark::Counter(2.0 * chains * rounds * Batch::size(),
                                              benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(peak_multiply_add);

// a = b + s c on arrays well beyond the caches: two read, one written.
void memory_bandwidth(benchmark::State& state) {
  constexpr std::size_t size = std::size_t{1} << 23;
  std::vector<double> a(size), b(size, 1.0), c(size, 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 0.5 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(
      static_cast<std::int64_t>(state.iterations() * 3 * size * sizeof(double)));
}
BENCHMARK(memory_bandwidth)->Unit(benchmark::kMillisecond);

}  // namespace
