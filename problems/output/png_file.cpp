#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <fstream>

#include "core/error.hpp"
#include "problems/output/image.hpp"

namespace rfm {

void write_png(const Image& image, const std::string& path) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width(), image.height(), 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row = 3 * static_cast<std::size_t>(image.width());
  for (int y = 0; y < image.height(); ++y)  // VTK counts rows from below
    std::copy_n(&image.bytes()[row * static_cast<std::size_t>(y)], row,
                static_cast<std::uint8_t*>(data->GetScalarPointer(0, image.height() - 1 - y, 0)));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->WriteToMemoryOn();  // VTK would report a bad path on the terminal
  writer->Write();
  vtkUnsignedCharArray* encoded = writer->GetResult();
  std::ofstream file(path, std::ios::binary);
  if (encoded)
    file.write(reinterpret_cast<const char*>(encoded->GetPointer(0)), encoded->GetNumberOfValues());
  file.close();
  if (!encoded || !file) throw ComputationError("cannot write " + path);
}

}  // namespace rfm
