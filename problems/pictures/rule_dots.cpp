#include "problems/pictures/rule_dots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

constexpr Colour inner_colour{0.35, 0.35, 0.4}, boundary_colour{0.05, 0.05, 0.1};
constexpr double smallest = 0.5, largest = 3;  // radii in pixels

void paint_dot(Canvas& canvas, const PixelPosition& at, double radius, const Colour& colour,
               double opacity) {
  constexpr int corners = 8;
  std::array<PixelPosition, corners> outline;
  for (int k = 0; k < corners; ++k) {
    const double t = 2 * M_PI * k / corners;
    outline[k] = {at.x + radius * std::cos(t), at.y + radius * std::sin(t)};
  }
  canvas.fill(outline, colour, opacity);
}

// So that the dots of a cell, `along_axis` in each direction, remain apart.
double dot_radius(const DomainRule& rule, double pixel_size, double along_axis) {
  const double cell = rule.grid().spacing(0) / pixel_size;
  return std::clamp(0.15 * cell / along_axis, smallest, largest);
}

}  // namespace

void paint_rule_dots(Canvas& canvas, double left, double top, const PixelWindow& window,
                     const DomainRule& rule) {
  const double radius = dot_radius(rule, window.pixel_size, rule.inside_rule().size());
  const auto paint = [&](const Point& point, double size, const Colour& colour, double opacity) {
    const PixelPosition at = window.place(point);
    if (at.x < 0 || at.y < 0 || at.x > window.width || at.y > window.height) return;
    paint_dot(canvas, {left + at.x, top + at.y}, size, colour, opacity);
  };
  VolumePoints points;
  for (const int cell : rule.inside_cells()) rule.add_inside_points(cell, points);
  points.append(rule.cut_points());
  for (int i = 0; i < points.size(); ++i) paint(points.point(i), radius, inner_colour, 0.6);
  for (const SurfaceRule* surface : {&rule.boundary(), &rule.interfaces()})
    for (int i = 0; i < surface->points.size(); ++i)
      paint(surface->points.point(i), 1.4 * radius, boundary_colour, 0.9);
}

void paint_rule_dots(Canvas& canvas, double left, double top, const SceneSamples& scene,
                     const Camera& camera, const DomainRule& rule) {
  const SurfacePoints& points = rule.boundary().points;
  const double radius = dot_radius(rule, camera.pixel_size, 2.0 * rule.inside_rule().size());
  for (int i = 0; i < points.size(); ++i) {
    const Point point = points.point(i);
    const PixelPosition at = camera.place(point);
    if (!(at.x >= 0 && at.y >= 0 && at.x < scene.width && at.y < scene.height)) continue;
    const SceneSample& seen = scene.centre(static_cast<int>(at.x), static_cast<int>(at.y));
    // What is seen there is the point, but for the size of a pixel on a slanted surface.
    constexpr double pixels = 3;
    if (!seen.is_surface() || norm(along(point, -1, seen.point)) > pixels * camera.pixel_size)
      continue;
    paint_dot(canvas, {left + at.x, top + at.y}, radius, boundary_colour, 0.6);
  }
}

}  // namespace rfm
