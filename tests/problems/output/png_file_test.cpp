#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <filesystem>

#include "core/error.hpp"
#include "problems/output/image.hpp"

namespace rfm {
namespace {

TEST(PngFile, ReadsBackPixelByPixel) {
  Image image(37, 21);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      image.set_pixel(x, y, {x / 36.0, y / 20.0, ((x * 7 + y * 13) % 256) / 255.0});
  const std::string path = testing::TempDir() + "rfm_png_file_test.png";
  write_png(image, path);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const vtkImageData* constant = reader->GetOutput();
  vtkImageData* read = const_cast<vtkImageData*>(constant);
  int dimensions[3];
  read->GetDimensions(dimensions);
  ASSERT_EQ(dimensions[0], 37);
  ASSERT_EQ(dimensions[1], 21);
  ASSERT_EQ(read->GetNumberOfScalarComponents(), 3);
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 37; ++x) {
      const auto* bytes = static_cast<unsigned char*>(read->GetScalarPointer(x, 20 - y, 0));
      for (int part = 0; part < 3; ++part)
        EXPECT_EQ(bytes[part], image.bytes()[3 * (std::size_t(y) * 37 + x) + part]);
    }
  std::filesystem::remove(path);
}

TEST(PngFile, CannotBeWrittenWhereThereIsNoFolder) {
  EXPECT_THROW(write_png(Image(3, 3), testing::TempDir() + "no/such/folder/picture.png"),
               ComputationError);
}

}  // namespace
}  // namespace rfm
