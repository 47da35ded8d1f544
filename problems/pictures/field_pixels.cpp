#include "problems/pictures/field_pixels.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

#include "core/tape.hpp"

namespace rfm {
namespace {

// The pixels to evaluate: those that meet the region.
std::vector<int> shown_pixels(const RegionPixels& region) {
  std::vector<int> shown;
  for (std::size_t i = 0; i < region.distance.size(); ++i)
    if (region.covered(i) > 0) shown.push_back(static_cast<int>(i));
  return shown;
}

// A value of the nearest neighbours whose centres are inside, or NaN.
double neighbour(const std::vector<double>& values, const FieldPicture& picture, int pixel) {
  const int x = pixel % picture.window.width, y = pixel / picture.window.width;
  for (const int diagonal : {0, 1})
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int nx = x + dx, ny = y + dy;
        if (std::abs(dx) + std::abs(dy) != 1 + diagonal || nx < 0 || ny < 0 ||
            nx >= picture.window.width || ny >= picture.window.height)
          continue;
        const std::size_t other = static_cast<std::size_t>(ny) * picture.window.width + nx;
        if (picture.region.distance[other] >= 0 && std::isfinite(values[other]))
          return values[other];
      }
  return std::numeric_limits<double>::quiet_NaN();
}

void mend_boundary(FieldPicture& picture, const std::vector<int>& shown) {
  for (const int pixel : shown) {
    if (picture.region.distance[pixel] >= 0) continue;
    for (auto* values : {&picture.value, &picture.vector_x, &picture.vector_y})
      if (!values->empty() && !std::isfinite((*values)[pixel]))
        (*values)[pixel] = neighbour(*values, picture, pixel);
  }
}

}  // namespace

FieldPicture sample_field(const std::vector<Field>& components, RegionPixels region,
                          const FieldSampling& sampling) {
  FieldPicture picture;
  picture.window = sampling.window;
  picture.region = std::move(region);
  const bool is_vector = components.size() > 1;
  std::vector<Field> roots = components;
  if (is_vector) {
    Field square = 0.0;
    for (const Field& component : components) square = square + component * component;
    roots.insert(roots.begin(), sqrt(square));
  }
  std::vector<int> orders(roots.size(), 0);
  if (sampling.with_slope) orders[0] = 1;
  const Tape tape(roots, orders, 2);

  const std::size_t count = picture.region.distance.size();
  const auto nothing = std::numeric_limits<double>::quiet_NaN();
  picture.value.assign(count, nothing);
  if (sampling.with_slope) picture.slope.assign(count, 0.0);
  if (is_vector) {
    picture.vector_x.assign(count, nothing);
    picture.vector_y.assign(count, nothing);
  }
  const std::vector<int> shown = shown_pixels(picture.region);
  constexpr int block = Tape::block_size;
  const int blocks = (static_cast<int>(shown.size()) + block - 1) / block;
  tbb::parallel_for(tbb::blocked_range<int>(0, blocks, 16), [&](const auto& range) {
    Tape::Workspace workspace(tape);
    std::array<double, block> x, y;
    for (int b = range.begin(); b < range.end(); ++b) {
      const int begin = b * block, size = std::min(block, static_cast<int>(shown.size()) - begin);
      for (int i = 0; i < size; ++i) {
        const int pixel = shown[begin + i];
        const Point centre =
            sampling.window.centre(pixel % sampling.window.width, pixel / sampling.window.width);
        x[i] = std::clamp(centre[0], sampling.bounds.low[0], sampling.bounds.high[0]);
        y[i] = std::clamp(centre[1], sampling.bounds.low[1], sampling.bounds.high[1]);
      }
      tape.evaluate({{x.data(), y.data(), nullptr}, size}, workspace);
      for (int i = 0; i < size; ++i) {
        const int pixel = shown[begin + i];
        picture.value[pixel] = workspace.coefficient(0)[i];
        if (sampling.with_slope)
          picture.slope[pixel] =
              sampling.window.pixel_size *
              std::hypot(workspace.coefficient(0, 1)[i], workspace.coefficient(0, 2)[i]);
        if (is_vector) {
          picture.vector_x[pixel] = workspace.coefficient(1)[i];
          picture.vector_y[pixel] = workspace.coefficient(2)[i];
        }
      }
    }
  });
  mend_boundary(picture, shown);
  return picture;
}

}  // namespace rfm
