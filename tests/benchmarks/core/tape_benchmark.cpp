// Tapes of everyday shapes: CPU time per point, and the time to compile.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <unordered_set>
#include <vector>

#include "core/polygon.hpp"
#include "core/primitives.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "tests/benchmarks/core/measured_points.hpp"

namespace rfm::benchmarks {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

// A. Pasko's chess pawn, eq. (3) of Shapiro's primer: a head, a collar, a body that is the
// revolution of an arc, and two discs, joined by R₀-functions.
Field pawn() {
  const Field r2 = x * x + y * y, r = sqrt(r2);
  const Field slab = conjunction(z, 7 - z);
  const Field body = conjunction(pow(4 - 8 * z / 7 + r2 / 4, 2) - 4 * r2, slab);
  const Field head = 4 - r2 - pow(z - 8, 2);
  const Field collar = 1 - pow(r - 1.5, 2) - 9 * pow(z - 6.5, 2);
  const Field base = 12 - r2 - 4 * pow(z, 2);
  return disjunction(disjunction(disjunction(body, head), collar), base);
}

// The R₀-function of a star-shaped polygon: half of its corners are not convex.
Field star(int edges) {
  std::vector<Point> points;
  for (int k = 0; k < edges; ++k) {
    const double angle = 2 * std::numbers::pi * k / edges, radius = k % 2 == 0 ? 1 : 0.9;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return implicit(rfm::polygon(points));
}

// Conjunctions of the edges of a convex polygon, one by one.
Field polygon(int edges) {
  Field all;
  for (int k = 0; k < edges; ++k) {
    const double angle = 2 * std::numbers::pi * k / edges;
    const Region side =
        half_plane({std::cos(angle), std::sin(angle)}, {-std::cos(angle), -std::sin(angle)});
    const Field edge = side.primitives()[0]->function;
    all = k == 0 ? edge : conjunction(all, edge);
  }
  return all;
}

Field spheres(int count) {
  Field all;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.4 * k, height = 2.0 * k / count - 1, radius = std::sqrt(k / 1e4);
    const Region ball = sphere({radius * std::cos(angle), radius * std::sin(angle), height}, 0.02);
    const Field function = ball.primitives()[0]->function;
    all = k == 0 ? function : disjunction(all, function);
  }
  return all;
}

void pawn_value_and_gradient(benchmark::State& state) {
  measure_tape(state, Tape({pawn()}, {1}, 3));
}
BENCHMARK(pawn_value_and_gradient);

void polygon_of_1000_edges_value_and_gradient(benchmark::State& state) {
  measure_tape(state, Tape({polygon(1000)}, {1}, 2));
}
BENCHMARK(polygon_of_1000_edges_value_and_gradient)->Unit(benchmark::kMillisecond);

void star_of_1000_edges_value_and_gradient(benchmark::State& state) {
  measure_tape(state, Tape({star(1000)}, {1}, 2));
}
BENCHMARK(star_of_1000_edges_value_and_gradient)->Unit(benchmark::kMillisecond);

void third_order_in_the_plane(benchmark::State& state) {
  const Field f = sin(x * y) * exp(-(x * x) - y * y) / (2 + x) + sqrt(1 + x * x * y * y);
  measure_tape(state, Tape({f}, {3}, 2));
}
BENCHMARK(third_order_in_the_plane);

void six_primitives_third_order_in_the_plane(benchmark::State& state) {
  measure_tape(state, Tape({polygon(6)}, {3}, 2));
}
BENCHMARK(six_primitives_third_order_in_the_plane);

void union_of_10000_spheres_value_and_gradient(benchmark::State& state) {
  measure_tape(state, Tape({spheres(10000)}, {1}, 3));
}
BENCHMARK(union_of_10000_spheres_value_and_gradient)->Unit(benchmark::kMillisecond);

int node_count(const Field& root) {
  std::unordered_set<const Field::Node*> seen;
  std::vector<const Field::Node*> pending{&root.node()};
  while (!pending.empty()) {
    const Field::Node* node = pending.back();
    pending.pop_back();
    if (!seen.insert(node).second) continue;
    for (const Field& argument : node->arguments) pending.push_back(&argument.node());
  }
  return static_cast<int>(seen.size());
}

void compile(benchmark::State& state, const Field& field, int order) {
  int instructions = 0;
  for (auto _ : state) {
    const Tape tape({field}, {order}, 3);
    instructions = tape.instruction_count();
    benchmark::DoNotOptimize(tape.step_count());
  }
  state.counters["nodes"] = node_count(field);
  state.counters["instructions"] = instructions;
}

void compiling_the_union_of_360_spheres(benchmark::State& state) {
  compile(state, spheres(360), 1);
}
BENCHMARK(compiling_the_union_of_360_spheres)->Unit(benchmark::kMillisecond);

void compiling_a_chain(benchmark::State& state) {
  Field chain = x;
  for (int k = 0; k < 2500; ++k) chain = sin(chain) + (0.5 + k) * y;
  compile(state, chain, 2);
}
BENCHMARK(compiling_a_chain)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm::benchmarks
