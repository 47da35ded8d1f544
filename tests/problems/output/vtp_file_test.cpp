#include "problems/output/vtp_file.hpp"

#include <gmock/gmock.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>

#include "core/error.hpp"

using namespace rfm;

namespace {

TEST(VtpFile, IsReadBackByVtkWithADotPerPoint) {
  FieldMesh mesh;
  mesh.points = {{0, 1, 2}, {0.1, -3, 1e-300}};
  mesh.data = {{"weight", 1, {0.25, 1.0 / 3}}, {"normal", 3, {1, 0, 0, 0, 0, -1}}};
  const std::string path = testing::TempDir() + "dots.vtp";
  write_vtp(mesh, path);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* dots = reader->GetOutput();
  ASSERT_EQ(dots->GetNumberOfPoints(), 2);
  EXPECT_EQ(dots->GetNumberOfVerts(), 2);
  EXPECT_EQ(dots->GetNumberOfCells(), 2);
  for (int i = 0; i < 2; ++i)
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(dots->GetPoint(i)[axis], mesh.points[i][axis]);
  vtkDataArray* weights = dots->GetPointData()->GetArray("weight");
  vtkDataArray* normals = dots->GetPointData()->GetArray("normal");
  ASSERT_TRUE(weights && normals);
  EXPECT_EQ(weights->GetTuple1(1), 1.0 / 3);
  EXPECT_EQ(normals->GetNumberOfComponents(), 3);
  EXPECT_EQ(normals->GetTuple3(1)[2], -1);
  std::filesystem::remove(path);
}

TEST(VtpFile, AFileThatCannotBeWrittenIsAnError) {
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_THROW(write_vtp({}, testing::TempDir() + "no/such/folder/dots.vtp"), ComputationError);
}

}  // namespace
