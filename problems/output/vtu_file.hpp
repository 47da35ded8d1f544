#pragma once

#include <string>

#include "problems/output/field_mesh.hpp"

namespace rfm {

/// Writes a mesh with its point data as a VTK unstructured grid (binary, LZ4), for ParaView. Throws
/// `ComputationError` if the file cannot be written.
void write_vtu(const FieldMesh& mesh, const std::string& path);

}  // namespace rfm
