#pragma once

#include "problems/output/field_mesh.hpp"

class vtkPointSet;
class vtkXMLWriter;

namespace rfm {

/// Gives a VTK data set the points of a mesh and their data; the first of the data are active.
void set_points(const FieldMesh& mesh, vtkPointSet* set);

/// Writes a data set as binary, compressed by LZ4. Throws `ComputationError` if it cannot be
/// written.
void write_compressed(vtkXMLWriter* writer, vtkPointSet* set, const std::string& path);

}  // namespace rfm
