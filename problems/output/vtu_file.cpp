#include "problems/output/vtu_file.hpp"

#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>

#include "problems/output/vtk_points.hpp"

namespace rfm {

void write_vtu(const FieldMesh& mesh, const std::string& path) {
  vtkNew<vtkUnstructuredGrid> grid;
  set_points(mesh, grid);
  grid->AllocateExact(mesh.cell_count(), static_cast<vtkIdType>(mesh.corners.size()));
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const int begin = mesh.cell_begin[cell], count = mesh.cell_begin[cell + 1] - begin;
    vtkIdType corners[8];
    std::copy_n(mesh.corners.begin() + begin, count, corners);
    grid->InsertNextCell(mesh.cell_types[cell], count, corners);
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  write_compressed(writer, grid, path);
}

}  // namespace rfm
