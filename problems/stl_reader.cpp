#include "problems/stl_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace rfm {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t(256) << 20;
constexpr std::size_t header_size = 84, record_size = 50;

[[noreturn]] void refuse(const std::string& message, const std::string& name) {
  throw InputError(message, 0, name.size());
}

std::string content(const std::filesystem::path& path, const std::string& name) {
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  std::ifstream stream(path, std::ios::binary);
  if (failure || !stream)
    refuse("cannot read the file '" + name + "' beside the problem file", name);
  if (size > largest_file) refuse("the file '" + name + "' is larger than 256 MB", name);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Whether a binary file holds as many triangles as its header says. (It may begin with "solid".)
bool is_binary(const std::string& bytes) {
  if (bytes.size() < header_size) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_size - 4, 4);
  return bytes.size() == header_size + record_size * std::size_t(count);
}

std::vector<Triangle> binary_triangles(const std::string& bytes) {
  std::vector<Triangle> triangles;
  for (std::size_t at = header_size; at < bytes.size(); at += record_size) {
    float numbers[12];
    std::memcpy(numbers, bytes.data() + at, sizeof numbers);
    Triangle triangle;
    for (int i = 0; i < 9; ++i) triangle[i / 3][i % 3] = numbers[3 + i];
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<Triangle> text_triangles(const std::string& text, const std::string& name) {
  std::istringstream stream(text);
  std::vector<Point> corners;
  for (std::string word; stream >> word;) {
    if (word != "vertex") continue;
    Point point;
    if (!(stream >> point[0] >> point[1] >> point[2]))
      refuse("the file '" + name + "' has a vertex without three numbers", name);
    corners.push_back(point);
  }
  if (corners.size() % 3 != 0) refuse("the file '" + name + "' ends within a triangle", name);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return triangles;
}

}  // namespace

std::vector<Triangle> read_stl(const std::string& folder, const std::string& name) {
  const std::filesystem::path path(name);
  if (path.empty() || path.has_root_path() || std::ranges::find(path, "..") != path.end())
    refuse("the file '" + name + "' must lie in the folder of the problem file", name);
  const std::string bytes = content(std::filesystem::path(folder) / path, name);
  const std::vector<Triangle> triangles =
      is_binary(bytes) ? binary_triangles(bytes) : text_triangles(bytes, name);
  if (triangles.empty()) refuse("the file '" + name + "' holds no triangle", name);
  for (const Triangle& triangle : triangles)
    for (const Point& corner : triangle)
      for (const double coordinate : corner)
        if (!std::isfinite(coordinate))
          refuse("the file '" + name + "' holds a coordinate that is not finite", name);
  return triangles;
}

}  // namespace rfm
