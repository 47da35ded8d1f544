#pragma once

#include <string>
#include <vector>

#include "core/mesh_distance.hpp"

namespace rfm {

/// The triangles of an STL file, text or binary, beside the problem file in `folder`. Normals are
/// not read. Throws `InputError` at offset 0 if the file cannot be read, leaves the folder, is
/// damaged, holds no triangle, or is larger than 256 MB.
std::vector<Triangle> read_stl(const std::string& folder, const std::string& name);

}  // namespace rfm
