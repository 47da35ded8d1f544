#include "problems/output/vtu_file.hpp"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>

#include "core/error.hpp"

namespace rfm {

void write_vtu(const FieldMesh& mesh, const std::string& path) {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), mesh.points[i].data());
  grid->SetPoints(points);
  grid->AllocateExact(mesh.cell_count(), static_cast<vtkIdType>(mesh.corners.size()));
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const int begin = mesh.cell_begin[cell], count = mesh.cell_begin[cell + 1] - begin;
    vtkIdType corners[8];
    std::copy_n(mesh.corners.begin() + begin, count, corners);
    grid->InsertNextCell(mesh.cell_types[cell], count, corners);
  }
  for (const FieldMesh::PointData& data : mesh.data) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(data.name.c_str());
    array->SetNumberOfComponents(data.components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(mesh.points.size()));
    std::copy(data.values.begin(), data.values.end(), array->GetPointer(0));
    grid->GetPointData()->AddArray(array);
  }
  if (!mesh.data.empty()) grid->GetPointData()->SetActiveScalars(mesh.data[0].name.c_str());

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->SetEncodeAppendedData(false);
  writer->SetCompressorTypeToLZ4();
  if (!writer->Write()) throw ComputationError("cannot write " + path);
}

}  // namespace rfm
