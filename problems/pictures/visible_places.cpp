#include "problems/pictures/visible_places.hpp"

#include <algorithm>

namespace rfm {

std::vector<std::optional<VisiblePlace>> visible_places(const NumberedPixels& pixels, int count) {
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * pixels.width + x; };
  // City-block distances from the nearest pixel of another number, by two sweeps.
  std::vector<int> distance(pixels.number.size(), 0);
  const auto relax = [&](int x, int y, int dx, int dy) {
    const int u = x + dx, v = y + dy;
    const bool is_same = u >= 0 && v >= 0 && u < pixels.width && v < pixels.height &&
                         pixels.number[at(u, v)] == pixels.number[at(x, y)];
    return is_same ? distance[at(u, v)] + 1 : 1;
  };
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x)
      distance[at(x, y)] = std::min(relax(x, y, -1, 0), relax(x, y, 0, -1));
  std::vector<std::optional<VisiblePlace>> places(static_cast<std::size_t>(count));
  for (int y = pixels.height - 1; y >= 0; --y)
    for (int x = pixels.width - 1; x >= 0; --x)
      distance[at(x, y)] = std::min({distance[at(x, y)], relax(x, y, 1, 0), relax(x, y, 0, 1)});
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x) {
      const int number = pixels.number[at(x, y)];
      if (number < 0 || number >= count) continue;
      auto& place = places[static_cast<std::size_t>(number)];
      if (!place || distance[at(x, y)] > place->radius)
        place = {{x + 0.5, y + 0.5}, static_cast<double>(distance[at(x, y)])};
    }
  return places;
}

}  // namespace rfm
