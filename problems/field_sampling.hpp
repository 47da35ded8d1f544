#pragma once

#include <string>
#include <vector>

#include "problems/output/field_mesh.hpp"
#include "quadrature/tessellation.hpp"

namespace rfm {

/// A scalar or vector field with a name, as it goes into a file.
struct NamedField {
  std::string name;
  std::vector<Field> components;
};

/// Samples fields at points. Where a field has no value at a point itself its value at the point of
/// `inside` with the same number is taken. Throws `ComputationError` where there is none either.
std::vector<FieldMesh::PointData> sample_at(const std::vector<Point>& points,
                                            const std::vector<Point>& inside,
                                            const std::vector<NamedField>& fields, int dimension);

/// Samples fields at the vertices of a tessellation; vertices with equal coordinates become one.
/// Where a field has no value at a vertex itself (transfinite data at a corner where they disagree,
/// 0/0), its value 10⁻⁶ of an element further inside is taken. Throws `ComputationError` where
/// there is none either.
FieldMesh sample(const Tessellation& tessellation, const std::vector<NamedField>& fields,
                 int dimension);

}  // namespace rfm
