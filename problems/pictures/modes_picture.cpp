#include "problems/pictures/modes_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "problems/pictures/solution_picture.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

constexpr std::size_t most_shown = 12;

int column_count(std::size_t modes) {
  if (modes < 3) return static_cast<int>(modes);
  return modes == 4 ? 2 : modes < 10 ? 3 : 4;
}

void copy(const Image& from, int left, int top, Image& to) {
  for (int y = 0; y < from.height(); ++y)
    for (int x = 0; x < from.width(); ++x)
      if (to.contains(left + x, top + y)) to.set_pixel(left + x, top + y, from.pixel(x, y));
}

// A vector of the plane or space is drawn as one; of unknowns of any meaning the largest.
ShownField shown_mode(const ScalarSolution& solution, std::size_t number) {
  const std::vector<Field>& mode = solution.eigen->modes[number];
  const std::vector<std::string> parts = mode_parts(solution.results, number);
  std::size_t largest = 0;
  std::vector<double> sizes;
  for (std::size_t c = 0; c < mode.size(); ++c) {
    sizes.push_back(maximum(mode[c], solution.rule));
    if (sizes[c] > sizes[largest]) largest = c;
  }
  ShownField shown;
  shown.size = sizes[largest];
  shown.components = parts.size() == 1 ? mode : std::vector{mode[largest]};
  shown.name = parts.size() > 1    ? parts[largest]
               : shown.is_vector() ? "|" + parts[0] + "|"
                                   : parts[0];
  return shown;
}

}  // namespace

Image draw_modes(const ScalarProblem& problem, const ScalarSolution& solution,
                 const Picture& picture, std::vector<std::string>& remarks) {
  const EigenResult& eigen = *solution.eigen;
  const std::size_t count = std::min(eigen.modes.size(), most_shown);
  const int columns = column_count(count);
  Picture tile = picture;
  tile.range.reset();
  tile.width = std::max(400, 2 * picture.width / columns);
  std::vector<Image> images;
  for (std::size_t i = 0; i < count; ++i) {
    ShownField shown = shown_mode(solution, i);
    shown.title = fmt::format("{}: {:.8g}", i + 1, eigen.values[i]);
    tile.colours = shown.is_vector() ? Picture::Colours::uniform : Picture::Colours::diverging;
    images.push_back(draw_shown(problem, shown, tile, remarks));
  }
  int width = 0, height = 0;  // of the largest: numbers of colour bars differ
  for (const Image& image : images) {
    width = std::max(width, image.width());
    height = std::max(height, image.height());
  }
  const int rows = (static_cast<int>(count) + columns - 1) / columns;
  Image sheet(width * columns, height * rows);
  for (int i = 0; i < static_cast<int>(count); ++i)
    copy(images[i], i % columns * width, i / columns * height, sheet);
  return sheet;
}

}  // namespace rfm
