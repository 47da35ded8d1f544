#include "problems/pictures/scene_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/point_algebra.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

class SetPainter {
 public:
  SetPainter(Canvas& canvas, double left, double top, const SceneSamples& scene,
             const Camera& camera, const Colour& colour, double line_width)
      : canvas_(canvas),
        left_(left),
        top_(top),
        scene_(scene),
        camera_(camera),
        colour_(colour),
        width_(line_width) {}

  void paint(const ThinSet& set) {
    for (const ThinSet& part : set.parts) paint(part);
    if (!set.parts.empty()) return;
    const std::vector<Point>& points = set.points;
    if (points.empty()) return paint_trace(set);
    if (points.size() == 1) return paint_point(points[0]);
    for (std::size_t i = 0; i + 1 < points.size() + (points.size() > 2 ? 1 : 0); ++i)
      paint_line(points[i], points[(i + 1) % points.size()]);
  }

  // Beside the pixel in the middle of those that are seen, or of all.
  std::optional<SetPlace> place() const {
    const std::vector<PixelPosition>& pixels = seen_.empty() ? hidden_ : seen_;
    if (pixels.empty()) return std::nullopt;
    return SetPlace{pixels[pixels.size() / 2], static_cast<int>(seen_.size())};
  }

 private:
  static constexpr double pale = 0.35;

  // Whether the body hides a point; nothing for one beyond the picture.
  std::optional<bool> is_hidden(const Point& point, const PixelPosition& at) const {
    if (!(at.x >= 0 && at.y >= 0 && at.x < scene_.width && at.y < scene_.height)) return {};
    const SceneSample& seen = scene_.centre(static_cast<int>(at.x), static_cast<int>(at.y));
    if (!seen.is_surface()) return false;
    const Point eye = camera_.view.eye();
    constexpr double pixels = 3;  // of a slanted surface
    return norm(along(point, -1, eye)) >
           norm(along(seen.point, -1, eye)) + pixels * camera_.pixel_size;
  }

  void note(const PixelPosition& at, bool hidden) { (hidden ? hidden_ : seen_).push_back(at); }

  void paint_point(const Point& point) {
    const PixelPosition at = camera_.place(point);
    const auto hidden = is_hidden(point, at);
    if (!hidden) return;
    constexpr int corners = 16;
    std::array<PixelPosition, corners> outline;
    for (int k = 0; k < corners; ++k) {
      const double t = 2 * M_PI * k / corners, radius = 1.6 * width_;
      outline[k] = {left_ + at.x + radius * std::cos(t), top_ + at.y + radius * std::sin(t)};
    }
    canvas_.fill(outline, colour_, *hidden ? pale : 1);
    note(at, *hidden);
  }

  // In pieces of about a pixel, joined as long as they are seen or hidden alike.
  void paint_line(const Point& from, const Point& to) {
    const PixelPosition a = camera_.place(from), b = camera_.place(to);
    constexpr double most = 4000;
    const int steps =
        std::max(1, static_cast<int>(std::min(most, std::hypot(b.x - a.x, b.y - a.y))));
    std::optional<bool> before;
    PixelPosition begin, last;
    const auto finish = [&] {
      if (before && (begin.x != last.x || begin.y != last.y))
        canvas_.line({{left_ + begin.x, top_ + begin.y}, {left_ + last.x, top_ + last.y}}, width_,
                     colour_, *before ? pale : 1);
    };
    for (int i = 0; i <= steps; ++i) {
      const double t = double(i) / steps;
      Point point;
      for (int axis = 0; axis < 3; ++axis) point[axis] = (1 - t) * from[axis] + t * to[axis];
      const PixelPosition at = camera_.place(point);
      const std::optional<bool> hidden = is_hidden(point, at);
      if (hidden) note(at, *hidden);
      if (hidden != before) {
        if (hidden && before) last = at;
        finish();
        begin = at;
      }
      last = at;
      before = hidden;
    }
    finish();
  }

  void paint_trace(const ThinSet& set) {
    const Tape function({set.function}, {0}, 3);
    for (int y = 0; y < scene_.height; ++y)
      for (int x = 0; x < scene_.width; ++x) {
        const SceneSample& seen = scene_.centre(x, y);
        if (!seen.is_surface()) continue;
        const double distance = function.value(seen.point) / camera_.pixel_size;
        const double covered = std::clamp(0.5 * (width_ + 1) - distance, 0.0, 1.0);
        if (!(covered > 0)) continue;
        canvas_.image().blend(static_cast<int>(left_) + x, static_cast<int>(top_) + y, colour_,
                              covered);
        if (covered == 1) note({x + 0.5, y + 0.5}, false);
      }
  }

  Canvas& canvas_;
  double left_, top_;
  const SceneSamples& scene_;
  const Camera& camera_;
  Colour colour_;
  double width_;
  std::vector<PixelPosition> seen_, hidden_;
};

}  // namespace

std::optional<SetPlace> paint_set(Canvas& canvas, double left, double top,
                                  const SceneSamples& scene, const Camera& camera,
                                  const ThinSet& set, const Colour& colour, double line_width) {
  SetPainter painter(canvas, left, top, scene, camera, colour, line_width);
  painter.paint(set);
  return painter.place();
}

}  // namespace rfm
