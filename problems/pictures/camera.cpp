#include "problems/pictures/camera.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/point_algebra.hpp"

namespace rfm {
namespace {

Point sum(const Point& a, double factor, const Point& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

}  // namespace

View View::at(const Box& box, const Point& towards_viewer) {
  View view;
  view.target = box.center();
  view.towards = unit(towards_viewer);
  if (!std::isfinite(dot(view.towards, view.towards)))
    throw InvalidArgument("the direction towards the viewer needs a length");
  const bool from_above = std::hypot(view.towards[0], view.towards[1]) < 1e-6;
  view.right =
      unit(cross(from_above ? Point{0, view.towards[2], 0} : Point{0, 0, 1}, view.towards));
  view.up = cross(view.towards, view.right);
  constexpr double diagonals_away = 3.5;
  view.distance = diagonals_away * std::hypot(box.length(0), box.length(1), box.length(2));
  return view;
}

Point View::eye() const { return sum(target, distance, towards); }

std::array<double, 2> View::project(const Point& point) const {
  const Point from_eye = sum(point, -1, eye());
  const double scale = -distance / dot(from_eye, towards);
  return {scale * dot(from_eye, right), scale * dot(from_eye, up)};
}

void ViewWindow::include(const std::array<double, 2>& place) {
  left = std::min(left, place[0]);
  right = std::max(right, place[0]);
  low = std::min(low, place[1]);
  high = std::max(high, place[1]);
}

ViewWindow ViewWindow::of(const View& view, const Box& box) {
  const auto [x, y] = view.project(box.low);
  ViewWindow window{x, x, y, y};
  for (int corner = 1; corner < 8; ++corner)
    window.include(
        view.project({corner & 1 ? box.high[0] : box.low[0], corner & 2 ? box.high[1] : box.low[1],
                      corner & 4 ? box.high[2] : box.low[2]}));
  return window;
}

Camera Camera::around(const View& view, const ViewWindow& window, int width, int height) {
  Camera camera{view, width, height, 1, 0, 0};
  camera.pixel_size = std::max(window.width() / width, window.height() / height);
  camera.middle_x = 0.5 * width - 0.5 * (window.left + window.right) / camera.pixel_size;
  camera.middle_y = 0.5 * height + 0.5 * (window.low + window.high) / camera.pixel_size;
  return camera;
}

Line Camera::ray(double x, double y) const {
  const Point eye = view.eye();
  Point through = sum(view.target, (x - middle_x) * pixel_size, view.right);
  through = sum(through, (middle_y - y) * pixel_size, view.up);
  return {eye, unit(sum(through, -1, eye))};
}

PixelPosition Camera::place(const Point& point) const {
  const auto [x, y] = view.project(point);
  return {middle_x + x / pixel_size, middle_y - y / pixel_size};
}

}  // namespace rfm
