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
};

}  // namespace rfm
