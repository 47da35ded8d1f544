#pragma once

#include <array>
#include <vector>

#include "core/box.hpp"

namespace rfm {

/// Points with weights, one array per quantity; arrays beyond the dimension stay empty.
struct VolumePoints {
  std::array<std::vector<double>, 3> coordinates;
  std::vector<double> weights;

  int size() const { return static_cast<int>(weights.size()); }
  Point point(int i) const;
  void add(int dimension, const Point& point, double weight) {
    for (int axis = 0; axis < dimension; ++axis) coordinates[axis].push_back(point[axis]);
    weights.push_back(weight);
  }
  void append(const VolumePoints& other);
  void clear();
  void resize(int size);
  /// Drops the points from `begin` on for which `drop(i)`; the order stays.
  template <class Drop>
  void erase_if(int begin, Drop&& drop);
};

/// Points on pieces of the boundary or on interfaces.
struct SurfacePoints {
  std::array<std::vector<double>, 3> coordinates;
  /// Unit normals: outward on the boundary; at an interface out of its positive side.
  std::array<std::vector<double>, 3> normals;
  std::vector<double> weights;
  /// Number of the primitive (on the boundary) or of the interface.
  std::vector<int> numbers;

  int size() const { return static_cast<int>(weights.size()); }
  Point point(int i) const;
  Point normal(int i) const;
  void add(int dimension, const Point& point, const Point& normal, double weight, int number);
  void append(const SurfacePoints& other);
  void clear();
  void reserve(int dimension, int size);
  /// Drops the points from `begin` on for which `drop(i)`; the order stays.
  template <class Drop>
  void erase_if(int begin, Drop&& drop);
};

/// Drops positions from `begin` on of arrays side by side, of which some may be empty.
template <class Drop, class... Arrays>
void erase_positions_if(int begin, int size, Drop&& drop, Arrays&... arrays) {
  int kept = begin;
  for (int i = begin; i < size; ++i) {
    if (drop(i)) continue;
    const auto move = [&](auto& array) {
      if (!array.empty()) array[kept] = array[i];
    };
    (move(arrays), ...);
    ++kept;
  }
  const auto cut = [&](auto& array) {
    if (!array.empty()) array.resize(kept);
  };
  (cut(arrays), ...);
}

template <class Drop>
void VolumePoints::erase_if(int begin, Drop&& drop) {
  auto& [x, y, z] = coordinates;
  erase_positions_if(begin, size(), drop, x, y, z, weights);
}

template <class Drop>
void SurfacePoints::erase_if(int begin, Drop&& drop) {
  auto& [x, y, z] = coordinates;
  auto& [nx, ny, nz] = normals;
  erase_positions_if(begin, size(), drop, x, y, z, nx, ny, nz, weights, numbers);
}

}  // namespace rfm
