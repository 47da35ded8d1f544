// What it takes to make a polygon ready for use: expression, bounding box, weight. The star has
// corners of both kinds all around, so that its tree of chains is as deep as they come.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/polygon.hpp"
#include "core/regularity.hpp"
#include "core/weight.hpp"

namespace rfm::benchmarks {
namespace {

std::vector<Point> star(std::int64_t edges) {
  std::vector<Point> points;
  for (std::int64_t k = 0; k < edges; ++k) {
    const double radius = k % 2 == 0 ? 1 : 0.6;
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(edges);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

void building_a_polygon(benchmark::State& state) {
  const std::vector<Point> points = star(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(polygon(points));
}
BENCHMARK(building_a_polygon)->Arg(1000)->Unit(benchmark::kMillisecond);

void bounding_box_of_a_polygon(benchmark::State& state) {
  const RegionEvaluator region(polygon(star(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(bounding_box(region));
}
BENCHMARK(bounding_box_of_a_polygon)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

void weight_of_a_polygon(benchmark::State& state) {
  const RegionEvaluator region(polygon(star(state.range(0))));
  const Box bounds{2, {-1, -1}, {1, 1}};
  for (auto _ : state) benchmark::DoNotOptimize(weight(region, bounds));
}
BENCHMARK(weight_of_a_polygon)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

void irregularities_of_a_polygon(benchmark::State& state) {
  const RegionEvaluator region(polygon(star(state.range(0))));
  const Box bounds{2, {-1, -1}, {1, 1}};
  for (auto _ : state) benchmark::DoNotOptimize(irregularities(region, bounds));
}
BENCHMARK(irregularities_of_a_polygon)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm::benchmarks
