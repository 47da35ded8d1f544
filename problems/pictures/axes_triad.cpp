#include "problems/pictures/axes_triad.hpp"

#include <algorithm>

namespace rfm {

void draw_axes_triad(Canvas& canvas, const PixelPosition& origin, double size, double font_size,
                     const View& view) {
  constexpr std::array<Colour, 3> colours{{{0.75, 0.1, 0.1}, {0.05, 0.5, 0.1}, {0.1, 0.2, 0.8}}};
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, {}, [&](int axis) { return view.towards[axis]; });
  for (const int axis : order) {
    const double dx = view.right[axis], dy = -view.up[axis];
    const PixelPosition tip{origin.x + size * dx, origin.y + size * dy};
    canvas.arrow(origin, tip, 0.12 * font_size, colours[axis]);
    canvas.text(std::string(1, "xyz"[axis]),
                {tip.x + 0.6 * font_size * dx, tip.y + 0.6 * font_size * dy},
                {.size = font_size,
                 .colour = colours[axis],
                 .horizontal = Align::centre,
                 .halo = 0.15 * font_size});
  }
}

}  // namespace rfm
