#include "problems/pictures/scene_painter.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

class Painter {
 public:
  Painter(const SceneSamples& scene, const Camera& camera, const SceneStyle& style)
      : scene_(scene),
        style_(style),
        key_(lamp(camera.view, -0.5, 0.7, 0.8)),
        fill_(lamp(camera.view, 0.8, -0.1, 0.6)) {}

  // The colour of a pixel over that of the background.
  Colour pixel(int x, int y, const Colour& background) const {
    const double slope = style_.contour_step > 0 ? slope_at(x, y) : 0;
    const int block = scene_.block[scene_.index(x, y)];
    if (block < 0) return surface(scene_.centre(x, y), slope, background);
    constexpr int side = SceneSamples::side;
    Colour sum{0, 0, 0};
    for (int i = 0; i < SceneSamples::per_block; ++i) {
      const int u = x * side + i % side, v = y * side + i / side;
      const Colour colour = surface(scene_.fine(u, v), slope, background);
      const Colour lined = mixed(colour, line_colour, line_opacity(u, v));
      sum = {sum.red + lined.red, sum.green + lined.green, sum.blue + lined.blue};
    }
    constexpr double share = 1.0 / SceneSamples::per_block;
    return {share * sum.red, share * sum.green, share * sum.blue};
  }

 private:
  static constexpr Colour line_colour{0.08, 0.08, 0.1};

  static Point lamp(const View& view, double right, double up, double towards) {
    const double scale = 1 / std::hypot(right, up, towards);
    Point direction{};
    for (int axis = 0; axis < 3; ++axis)
      direction[axis] =
          scale * (right * view.right[axis] + up * view.up[axis] + towards * view.towards[axis]);
    return direction;
  }

  Colour surface(const SceneSample& sample, double slope, const Colour& background) const {
    if (!sample.is_surface()) return background;
    Colour colour = style_.colour(sample);
    if (sample.primitive != style_.flat_primitive) {
      constexpr double ambient = 0.5, key = 0.47, fill = 0.2;
      const double light = ambient + key * std::max(0.0, dot(sample.normal, key_)) +
                           fill * std::max(0.0, dot(sample.normal, fill_));
      colour = {light * colour.red, light * colour.green, light * colour.blue};
    }
    return mixed(colour, black, contour_opacity(sample.value, slope));
  }

  double contour_opacity(double value, double slope) const {
    if (!(slope > 0) || !std::isfinite(value)) return 0;
    const double step = style_.contour_step, spacing = step / slope;
    // Nothing where the field is level up to rounding; lines that crowd fade.
    constexpr double level = 1e5, crowded = 4, strength = 0.6;
    if (spacing > level) return 0;
    const double distance = std::fabs(value - step * std::round(value / step)) / slope;
    const double width = style_.contour_width;
    return strength * std::clamp(spacing / crowded - 0.5, 0.0, 1.0) *
           std::clamp(0.5 * (width + 1) - distance, 0.0, std::min(1.0, width));
  }

  // Change of the value per pixel, from neighbours on the same surface.
  double slope_at(int x, int y) const {
    const SceneSample& middle = scene_.centre(x, y);
    const auto along = [&](int dx, int dy) {
      double sum = 0;
      int count = 0;
      for (const int direction : {-1, 1}) {
        const int u = x + direction * dx, v = y + direction * dy;
        if (u < 0 || v < 0 || u >= scene_.width || v >= scene_.height) continue;
        const SceneSample& other = scene_.centre(u, v);
        if (!std::isfinite(other.value) ||
            step_between(middle, other, scene_.pixel_size) != Step::none)
          continue;
        sum += direction * (other.value - middle.value);
        ++count;
      }
      return count > 0 ? sum / count : 0;
    };
    return std::hypot(along(1, 0), along(0, 1));
  }

  // Of the line through a fine sample: samples within two thirds of a pixel are looked at.
  double line_opacity(int u, int v) const {
    constexpr int reach = 2;
    constexpr double jump = 0.8, crease = 0.45;
    const SceneSample& middle = scene_.fine(u, v);
    Step strongest = Step::none;
    for (int dv = -reach; dv <= reach; ++dv)
      for (int du = -reach; du <= reach; ++du) {
        if (du * du + dv * dv > reach * reach) continue;
        const SceneSample& other = scene_.fine(u + du, v + dv);
        strongest = std::max(strongest, step_between(middle, other, scene_.pixel_size));
      }
    return strongest == Step::jump ? jump : strongest == Step::crease ? crease : 0;
  }

  const SceneSamples& scene_;
  const SceneStyle& style_;
  Point key_, fill_;
};

}  // namespace

void paint_scene(Canvas& canvas, int left, int top, const SceneSamples& scene, const Camera& camera,
                 const SceneStyle& style) {
  const Painter painter(scene, camera, style);
  Image& image = canvas.image();
  tbb::parallel_for(0, scene.height, [&](int y) {
    for (int x = 0; x < scene.width; ++x)
      if (image.contains(left + x, top + y))
        image.set_pixel(left + x, top + y, painter.pixel(x, y, image.pixel(left + x, top + y)));
  });
}

}  // namespace rfm
