#include "problems/output/vtp_file.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "problems/output/vtk_points.hpp"

namespace rfm {

void write_vtp(const FieldMesh& mesh, const std::string& path) {
  vtkNew<vtkPolyData> cloud;
  set_points(mesh, cloud);
  vtkNew<vtkCellArray> dots;
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(mesh.points.size()); ++i)
    dots->InsertNextCell(1, &i);
  cloud->SetVerts(dots);
  vtkNew<vtkXMLPolyDataWriter> writer;
  write_compressed(writer, cloud, path);
}

}  // namespace rfm
