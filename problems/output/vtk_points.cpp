#include "problems/output/vtk_points.hpp"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkXMLWriter.h>

#include <algorithm>

#include "core/error.hpp"

namespace rfm {

void set_points(const FieldMesh& mesh, vtkPointSet* set) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), mesh.points[i].data());
  set->SetPoints(points);
  for (const FieldMesh::PointData& data : mesh.data) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(data.name.c_str());
    array->SetNumberOfComponents(data.components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(mesh.points.size()));
    std::copy(data.values.begin(), data.values.end(), array->GetPointer(0));
    set->GetPointData()->AddArray(array);
  }
  if (!mesh.data.empty()) set->GetPointData()->SetActiveScalars(mesh.data[0].name.c_str());
}

void write_compressed(vtkXMLWriter* writer, vtkPointSet* set, const std::string& path) {
  writer->SetFileName(path.c_str());
  writer->SetInputDataObject(set);
  writer->SetDataModeToAppended();
  writer->SetEncodeAppendedData(false);
  writer->SetCompressorTypeToLZ4();
  // The result of Write alone is success even where the file could not be opened.
  if (!writer->Write() || writer->GetErrorCode() != 0)
    throw ComputationError("cannot write " + path);
}

}  // namespace rfm
