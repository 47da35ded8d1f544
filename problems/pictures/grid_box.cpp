#include "problems/pictures/grid_box.hpp"

#include <cmath>

namespace rfm {
namespace {

constexpr Colour face_colour{0.965, 0.97, 0.98}, line_colour{0.75, 0.78, 0.83},
    edge_colour{0.45, 0.48, 0.55};

// Every how many-th line is shown.
int stride(int cells, double pixels) {
  constexpr double nearest = 4;
  for (int step = 1;; step *= 10)
    for (const int factor : {1, 2, 5})
      if (pixels * step * factor >= nearest * cells || step * factor >= cells) return step * factor;
}

}  // namespace

void draw_grid_box(Canvas& canvas, double left, double top, const Camera& camera,
                   const Grid& grid) {
  const Box& box = grid.box();
  const Point eye = camera.view.eye();
  const auto place = [&](const Point& point) {
    const PixelPosition at = camera.place(point);
    return PixelPosition{left + at.x, top + at.y};
  };
  for (int axis = 0; axis < 3; ++axis) {
    // The face is seen from inside where the eye is on the inner side of its plane.
    const double middle = box.center()[axis];
    Point corner = box.low;
    corner[axis] = eye[axis] > middle ? box.low[axis] : box.high[axis];
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    const auto on_face = [&](double a, double b) {
      Point point = corner;
      point[first] = a;
      point[second] = b;
      return place(point);
    };
    const PixelPosition corners[5] = {
        on_face(box.low[first], box.low[second]), on_face(box.high[first], box.low[second]),
        on_face(box.high[first], box.high[second]), on_face(box.low[first], box.high[second]),
        on_face(box.low[first], box.low[second])};
    canvas.fill(std::span(corners, 4), face_colour);
    const auto lines = [&](int along, int across) {
      const PixelPosition &a = corners[0], &b = corners[along == first ? 1 : 3];
      const int step = stride(grid.cells(along), std::hypot(b.x - a.x, b.y - a.y));
      for (int i = step; i < grid.cells(along); i += step) {
        Point from = corner, to = corner;
        from[along] = to[along] = grid.line(along, i);
        from[across] = box.low[across];
        to[across] = box.high[across];
        canvas.line({place(from), place(to)}, 0.7, line_colour);
      }
    };
    lines(first, second);
    lines(second, first);
    canvas.line(std::span(corners, 5), 1.2, edge_colour);
  }
}

}  // namespace rfm
