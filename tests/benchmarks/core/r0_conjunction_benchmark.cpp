// The interpreted tape against the same function written by hand: value, gradient and Hessian of an
// R₀-conjunction of six primitives in space. `per_point` is CPU time, `of_peak` the part of the
// rate of multiply-adds that rfm_reference_benchmark's kernel reaches, measured here once.
#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "core/primitives.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "tests/benchmarks/core/hand_fused.hpp"
#include "tests/benchmarks/core/measured_points.hpp"

namespace rfm::benchmarks {
namespace {

using Batch = std::experimental::native_simd<double>;

Field six_primitives() {
  std::vector<Field> fields;
  for (const HandPrimitive& p : hand_primitives) {
    const auto& n = p.n;
    const Point foot{p.d * n[0], p.d * n[1], p.d * n[2]};
    const Region region = p.sphere ? sphere(n, p.d) : half_space(foot, Point{-n[0], -n[1], -n[2]});
    const Field function = region.primitives()[0]->function;
    fields.push_back(p.sphere ? -function : function);
  }
  Field all = fields[0];
  for (std::size_t k = 1; k < fields.size(); ++k) all = conjunction(all, fields[k]);
  return all;
}

void interpreted_tape(benchmark::State& state) {
  measure_tape(state, Tape({six_primitives()}, {2}, 3), hand_operations);
}
BENCHMARK(interpreted_tape);

// Read at run time, as the tape reads its numbers.
static std::array<HandPrimitive, 6> primitives = hand_primitives;

template <bool fused, class T>
HandJet<T> omega(const T& x, const T& y, const T& z) {
  HandJet<T> jet = primitive(primitives[0], x, y, z);
  for (int k = 1; k < 6; ++k) {
    const HandJet<T> next = primitive(primitives[k], x, y, z);
    jet = fused ? fused_conjunction(jet, next) : naive_conjunction(jet, next);
  }
  return jet;
}

// All points of a block through a template.
template <class T, bool fused>
void by_hand(benchmark::State& state) {
  constexpr int width = sizeof(T) / sizeof(double);
  const MeasuredPoints points(3);
  alignas(64) static std::array<std::array<double, Tape::block_size>, 10> results;
  const auto load = [](const double* from) {
    if constexpr (width == 1)
      return *from;
    else
      return T(from, std::experimental::element_aligned);
  };
  const auto store = [](const T& from, double* to) {
    if constexpr (width == 1)
      *to = from;
    else
      from.copy_to(to, std::experimental::element_aligned);
  };
  for (auto _ : state) {
    for (int block = 0; block < MeasuredPoints::blocks; ++block) {
      benchmark::ClobberMemory();
      const PointBlock& at = points.block(block);
      const auto& [x, y, z] = at.coordinates;
      for (int i = 0; i < Tape::block_size; i += width) {
        const HandJet<T> jet = omega<fused, T>(load(x + i), load(y + i), load(z + i));
        int row = 0;
        for (const T& part :
             {jet.v, jet.x, jet.y, jet.z, jet.xx, jet.xy, jet.xz, jet.yy, jet.yz, jet.zz})
          store(part, &results[row++][i]);
      }
      benchmark::DoNotOptimize(results);
    }
  }
  report(state, hand_operations);
}
BENCHMARK(by_hand<Batch, true>)->Name("hand_fused_simd_template");
BENCHMARK(by_hand<Batch, false>)->Name("generic_simd_template");
BENCHMARK(by_hand<double, true>)->Name("hand_fused_scalar_template");
BENCHMARK(by_hand<double, false>)->Name("naive_dual_number_template");

}  // namespace
}  // namespace rfm::benchmarks
