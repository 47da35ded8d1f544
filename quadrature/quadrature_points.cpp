#include "quadrature/quadrature_points.hpp"

namespace rfm {
namespace {

template <class Value>
void append_to(std::vector<Value>& values, const std::vector<Value>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

Point gather(const std::array<std::vector<double>, 3>& arrays, int i) {
  Point point{};
  for (int axis = 0; axis < 3; ++axis)
    if (!arrays[axis].empty()) point[axis] = arrays[axis][i];
  return point;
}

}  // namespace

Point VolumePoints::point(int i) const { return gather(coordinates, i); }

void VolumePoints::append(const VolumePoints& other) {
  for (int axis = 0; axis < 3; ++axis) append_to(coordinates[axis], other.coordinates[axis]);
  append_to(weights, other.weights);
}

void VolumePoints::clear() { resize(0); }

void VolumePoints::resize(int size) {
  for (auto& values : coordinates)
    if (!values.empty()) values.resize(size);
  weights.resize(size);
}

Point SurfacePoints::point(int i) const { return gather(coordinates, i); }

Point SurfacePoints::normal(int i) const { return gather(normals, i); }

void SurfacePoints::add(int dimension, const Point& point, const Point& normal, double weight,
                        int number) {
  for (int axis = 0; axis < dimension; ++axis) {
    coordinates[axis].push_back(point[axis]);
    normals[axis].push_back(normal[axis]);
  }
  weights.push_back(weight);
  numbers.push_back(number);
}

void SurfacePoints::append(const SurfacePoints& other) {
  for (int axis = 0; axis < 3; ++axis) {
    append_to(coordinates[axis], other.coordinates[axis]);
    append_to(normals[axis], other.normals[axis]);
  }
  append_to(weights, other.weights);
  append_to(numbers, other.numbers);
}

void SurfacePoints::clear() {
  for (int axis = 0; axis < 3; ++axis) {
    coordinates[axis].clear();
    normals[axis].clear();
  }
  weights.clear();
  numbers.clear();
}

void SurfacePoints::reserve(int dimension, int size) {
  for (int axis = 0; axis < dimension; ++axis) {
    coordinates[axis].reserve(size);
    normals[axis].reserve(size);
  }
  weights.reserve(size);
  numbers.reserve(size);
}

}  // namespace rfm
