#pragma once

#include <string>

#include "problems/output/field_mesh.hpp"

namespace rfm {

/// Writes the points of a mesh with their data, without its cells, as VTK poly data (binary, LZ4):
/// ParaView shows a dot at each. Throws `ComputationError` if the file cannot be written.
void write_vtp(const FieldMesh& mesh, const std::string& path);

}  // namespace rfm
