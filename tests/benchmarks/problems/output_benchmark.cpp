// From a solution to a file: tessellation, sampling, writing.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "core/primitives.hpp"
#include "problems/field_sampling.hpp"
#include "problems/output/vtu_file.hpp"

namespace rfm {
namespace {

Tessellation disk_elements(int cells) {
  return tessellate(RegionEvaluator(circle({0, 0}, 1)),
                    Grid({2, {-1.03, -1.04}, {1.05, 1.03}}, {cells, cells, 1}), {});
}
std::vector<NamedField> fields() {
  const Field u = sin(2.0 * x_coordinate()) * exp(y_coordinate());
  return {{"u", {u}}, {"gradient", gradient(u, 2)}};
}

void sampling(benchmark::State& state) {
  const Tessellation elements = disk_elements(static_cast<int>(state.range(0)));
  std::size_t points = 0;
  for (auto _ : state) points = sample(elements, fields(), 2).points.size();
  state.counters["points"] = double(points);
}
BENCHMARK(sampling)->Arg(64)->Unit(benchmark::kMillisecond);

void writing(benchmark::State& state) {
  const FieldMesh mesh = sample(disk_elements(static_cast<int>(state.range(0))), fields(), 2);
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "rfm_output_benchmark.vtu";
  for (auto _ : state) write_vtu(mesh, path.string());
  state.counters["bytes"] = double(std::filesystem::file_size(path));
  std::filesystem::remove(path);
}
BENCHMARK(writing)->Arg(8)->Arg(64)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rfm
