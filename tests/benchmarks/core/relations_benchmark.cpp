// Collision queries of random pairs of Boolean combinations of shapes: the time per query.
#include "core/relations.hpp"

#include <benchmark/benchmark.h>

#include <vector>

#include "core/bounding_box.hpp"
#include "core/primitives.hpp"
#include "tests/quadrature/random_pairs.hpp"

namespace rfm {
namespace {

void collisions_of_random_pairs(benchmark::State& state) {
  const int dimension = static_cast<int>(state.range(0)), count = 100;
  std::vector<test::RandomPair> pairs;
  for (int seed = 0; seed < count; ++seed) pairs.push_back(test::random_pair(seed, dimension));
  RelationOptions options;
  options.resolution = 1e-4;
  options.most_boxes = 50000;
  long boxes = 0, meeting = 0, open = 0;
  for (auto _ : state) {
    boxes = meeting = open = 0;
    for (const test::RandomPair& pair : pairs) {
      const Relation relation = intersects(pair.first, pair.second, pair.bounds, options);
      boxes += relation.boxes;
      meeting += relation.answer == Truth::yes;
      open += relation.answer == Truth::unknown;
    }
  }
  state.counters["s_per_query"] = benchmark::Counter(
      count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["boxes_per_query"] = double(boxes) / count;
  state.counters["meeting"] = double(meeting);
  state.counters["open"] = double(open);
}
BENCHMARK(collisions_of_random_pairs)->Arg(2)->Arg(3)->Unit(benchmark::kMillisecond);

void distance_of_bodies(benchmark::State& state) {
  const RegionEvaluator a(sphere({0, 0, 0}, 1) - sphere({0.5, 0, 0}, 0.8)),
      b(box({1.5, 1.5, 1}, {3, 3, 3}, 3));
  const Box bounds_a = bounding_box(a), bounds_b = bounding_box(b);
  for (auto _ : state) benchmark::DoNotOptimize(distance_between(a, bounds_a, b, bounds_b, 1e-3));
}
BENCHMARK(distance_of_bodies)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm
