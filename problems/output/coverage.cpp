#include "problems/output/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

// An empty coverage over the pixels that [low − margin, high + margin] touches.
Coverage around(std::span<const PixelPosition> points, double margin, int image_width,
                int image_height) {
  double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
  for (const PixelPosition& point : points) {
    low_x = std::min(low_x, point.x);
    high_x = std::max(high_x, point.x);
    low_y = std::min(low_y, point.y);
    high_y = std::max(high_y, point.y);
  }
  const auto pixel = [](double position, int size) {
    return static_cast<int>(std::clamp(position, 0.0, double(size)));
  };
  Coverage coverage;
  if (points.empty()) return coverage;
  coverage.left = pixel(std::floor(low_x - margin), image_width);
  coverage.top = pixel(std::floor(low_y - margin), image_height);
  coverage.width = std::max(0, pixel(std::ceil(high_x + margin), image_width) - coverage.left);
  coverage.height = std::max(0, pixel(std::ceil(high_y + margin), image_height) - coverage.top);
  coverage.amount.assign(static_cast<std::size_t>(coverage.width) * coverage.height, 0.0f);
  return coverage;
}

// Adds to `row` (one entry more than pixels), as differences along x, the signed area to the right
// of the segment within one row of pixels: y from `y0` to `y1`, x measured from the left of the
// row.
void add_to_row(std::span<double> row, double x0, double x1, double height) {
  const double last = static_cast<double>(row.size()) - 1;
  const auto add = [&](int i, double area) {
    if (i < static_cast<int>(row.size())) row[i] += area;
  };
  // Parts left of the row cover it wholly, parts right of it do not matter: a segment that leaves
  // the row is moved to its sides, piece by piece.
  if (x0 > x1) std::swap(x0, x1);
  if (x1 <= 0 || x1 - x0 < 1e-12) {
    const double x = std::clamp(x0, 0.0, last);
    const int i = static_cast<int>(x);
    add(i, height * (1 - (x - i)));
    add(i + 1, height * (x - i));
    return;
  }
  const double per_x = height / (x1 - x0);
  if (x0 < 0) {
    add(0, -x0 * per_x);
    x0 = 0;
  }
  if (x0 >= last) return;
  x1 = std::min(x1, last);
  for (double from = x0; from < x1;) {
    const int i = static_cast<int>(from);
    const double to = std::min(i + 1.0, x1);
    const double part = per_x * (to - from), middle = 0.5 * (from + to) - i;
    add(i, part * (1 - middle));
    add(i + 1, part * middle);
    from = to;
  }
}

}  // namespace

Coverage polygon_coverage(std::span<const PixelPosition> corners, int image_width,
                          int image_height) {
  Coverage coverage = around(corners, 0, image_width, image_height);
  if (coverage.width == 0 || coverage.height == 0) return coverage;
  const std::size_t stride = static_cast<std::size_t>(coverage.width) + 1;
  std::vector<double> differences(stride * coverage.height, 0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    PixelPosition a = corners[i], b = corners[(i + 1) % corners.size()];
    if (a.y == b.y) continue;
    const double sign = a.y < b.y ? 1 : -1;
    if (a.y > b.y) std::swap(a, b);
    const double slope = (b.x - a.x) / (b.y - a.y);
    const double low = std::max(a.y - coverage.top, 0.0),
                 high = std::min(b.y - coverage.top, double(coverage.height));
    for (double from = low; from < high;) {
      const int row = static_cast<int>(from);
      const double to = std::min(row + 1.0, high);
      const double x0 = a.x + slope * (from + coverage.top - a.y) - coverage.left;
      add_to_row(std::span(differences).subspan(row * stride, stride), x0, x0 + slope * (to - from),
                 sign * (to - from));
      from = to;
    }
  }
  for (int row = 0; row < coverage.height; ++row) {
    double area = 0;
    for (int x = 0; x < coverage.width; ++x) {
      area += differences[row * stride + x];
      coverage.amount[static_cast<std::size_t>(row) * coverage.width + x] =
          static_cast<float>(std::min(1.0, std::abs(area)));
    }
  }
  return coverage;
}

Coverage line_coverage(std::span<const PixelPosition> points, double line_width, int image_width,
                       int image_height) {
  const double reach = 0.5 * (line_width + 1), most = std::min(line_width, 1.0);
  Coverage coverage = around(points, reach, image_width, image_height);
  for (std::size_t i = 0; i + 1 < points.size() || i == 0; ++i) {
    if (points.empty()) break;
    const PixelPosition a = points[i], b = points[std::min(i + 1, points.size() - 1)];
    const PixelPosition ends[2] = {a, b};
    const Coverage part = around(ends, reach, image_width, image_height);
    const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
    const double length = std::sqrt(squared);
    for (int y = part.top; y < part.top + part.height; ++y) {
      // Only pixels whose distance to the carrier line is within reach.
      int first = part.left, end = part.left + part.width;
      if (std::abs(dy) > 0.1 * length) {
        const double x = a.x + dx / dy * (y + 0.5 - a.y), half = reach * length / std::abs(dy);
        first = std::max(first, static_cast<int>(std::floor(x - half)) - 1);
        end = std::min(end, static_cast<int>(std::ceil(x + half)) + 1);
      }
      for (int x = first; x < end; ++x) {
        const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
        const double t = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
        const double distance = std::hypot(px - t * dx, py - t * dy);
        const float amount = static_cast<float>(std::clamp(reach - distance, 0.0, most));
        float& kept = coverage.amount[static_cast<std::size_t>(y - coverage.top) * coverage.width +
                                      (x - coverage.left)];
        kept = std::max(kept, amount);
      }
    }
  }
  return coverage;
}

}  // namespace rfm
