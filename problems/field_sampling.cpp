#include "problems/field_sampling.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <memory_resource>
#include <unordered_map>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

struct PointHash {
  std::size_t operator()(const Point& point) const {
    std::size_t hash = 0;
    for (const double coordinate : point) {
      const double plain = coordinate + 0.0;  // −0 and 0 are equal and must hash alike
      std::uint64_t bits;
      std::memcpy(&bits, &plain, sizeof bits);
      hash ^= bits + 0x9e3779b97f4a7c15ull + (hash << 6) + (hash >> 2);
    }
    return hash;
  }
};

// The mesh without data, and for every point a place slightly inside an element next to it.
struct MergedMesh {
  FieldMesh mesh;
  std::vector<Point> inside;
};

MergedMesh merge_vertices(const Tessellation& tessellation) {
  MergedMesh merged;
  FieldMesh& mesh = merged.mesh;
  std::pmr::monotonic_buffer_resource pool;  // no allocation per vertex
  std::pmr::unordered_map<Point, int, PointHash> known(tessellation.vertices.size(), &pool);
  std::vector<int> number(tessellation.vertices.size());
  for (std::size_t i = 0; i < number.size(); ++i) {
    const auto [place, inserted] =
        known.try_emplace(tessellation.vertices[i], static_cast<int>(mesh.points.size()));
    number[i] = place->second;
    if (inserted) mesh.points.push_back(tessellation.vertices[i]);
  }
  merged.inside = mesh.points;
  std::vector<bool> has_inside(mesh.points.size(), false);
  const ElementList& elements = tessellation.elements;
  for (int e = 0; e < elements.size(); ++e) {
    Point center{};
    for (const int vertex : elements.vertices(e))
      for (int axis = 0; axis < 3; ++axis)
        center[axis] +=
            tessellation.vertices[vertex][axis] / static_cast<double>(elements.vertices(e).size());
    for (const int vertex : elements.vertices(e)) {
      const int point = number[vertex];
      mesh.corners.push_back(point);
      if (has_inside[point]) continue;
      has_inside[point] = true;
      for (int axis = 0; axis < 3; ++axis)
        merged.inside[point][axis] += 1e-6 * (center[axis] - merged.inside[point][axis]);
    }
    mesh.cell_begin.push_back(static_cast<int>(mesh.corners.size()));
    mesh.cell_types.push_back(static_cast<unsigned char>(elements.shapes[e]));
  }
  return merged;
}

}  // namespace

std::vector<FieldMesh::PointData> sample_at(const std::vector<Point>& points,
                                            const std::vector<Point>& inside,
                                            const std::vector<NamedField>& fields, int dimension) {
  std::vector<FieldMesh::PointData> all;
  const int count = static_cast<int>(points.size());
  std::vector<Field> roots;
  struct Target {
    int data, component;
  };
  std::vector<Target> targets;
  for (const NamedField& field : fields) {
    const int components = static_cast<int>(field.components.size());
    for (int c = 0; c < components; ++c) {
      roots.push_back(field.components[c]);
      targets.push_back({static_cast<int>(all.size()), c});
    }
    // ParaView draws vectors of three components.
    const int stored = components == 2 ? 3 : components;
    all.push_back({field.name, stored, std::vector<double>(std::size_t(count) * stored)});
  }
  const Tape tape(roots, {0}, dimension);
  constexpr int block = Tape::block_size;
  tbb::parallel_for(
      tbb::blocked_range<int>(0, (count + block - 1) / block), [&](const auto& blocks) {
        Tape::Workspace workspace(tape);
        std::array<std::array<double, block>, 3> coordinates;
        for (int b = blocks.begin(); b < blocks.end(); ++b) {
          const int begin = b * block, size = std::min(block, count - begin);
          for (int i = 0; i < size; ++i)
            for (int axis = 0; axis < 3; ++axis) coordinates[axis][i] = points[begin + i][axis];
          tape.evaluate(
              {{coordinates[0].data(), coordinates[1].data(), coordinates[2].data()}, size},
              workspace);
          for (std::size_t r = 0; r < roots.size(); ++r) {
            FieldMesh::PointData& data = all[targets[r].data];
            for (int i = 0; i < size; ++i) {
              double value = workspace.coefficient(static_cast<int>(r))[i];
              if (!std::isfinite(value)) value = tape.value(inside[begin + i], static_cast<int>(r));
              if (!std::isfinite(value))
                throw ComputationError("'" + data.name + "' is not a finite number at the point " +
                                       point_text(points[begin + i], dimension) +
                                       diagnosis_suffix(roots[r], inside[begin + i], dimension));
              data.values[std::size_t(begin + i) * data.components + targets[r].component] = value;
            }
          }
        }
      });
  return all;
}

FieldMesh sample(const Tessellation& tessellation, const std::vector<NamedField>& fields,
                 int dimension) {
  MergedMesh merged = merge_vertices(tessellation);
  merged.mesh.data = sample_at(merged.mesh.points, merged.inside, fields, dimension);
  return std::move(merged.mesh);
}

}  // namespace rfm
