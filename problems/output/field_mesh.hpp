#pragma once

#include <string>
#include <vector>

#include "core/box.hpp"

namespace rfm {

/// Fields sampled on a mesh of plain cells, for files and pictures. Types of cells and the order of
/// their corners are VTK's.
struct FieldMesh {
  std::vector<Point> points;
  std::vector<int> corners;        ///< cell after cell
  std::vector<int> cell_begin{0};  ///< cell i has corners cell_begin[i] … cell_begin[i + 1] − 1
  std::vector<unsigned char> cell_types;
  struct PointData {
    std::string name;
    int components = 1;
    std::vector<double> values;  ///< point after point
  };
  std::vector<PointData> data;

  int cell_count() const { return static_cast<int>(cell_types.size()); }
};

}  // namespace rfm
