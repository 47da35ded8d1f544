#include "problems/output/region_picture.hpp"

#include <algorithm>
#include <cmath>

#include "problems/output/label_places.hpp"

namespace rfm {
namespace {

constexpr Colour inside_colour{0.87, 0.92, 0.97}, cut_colour{0.99, 0.90, 0.78};
constexpr Colour grid_colour{0.55, 0.6, 0.68}, level_colour{0.25, 0.35, 0.5};

std::size_t pixel_number(const RegionPicture& picture, int x, int y) {
  return static_cast<std::size_t>(y) * picture.window.width + x;
}

template <class Visit>  // visit(x, y, number)
void for_each_pixel(const RegionPicture& picture, const Visit& visit) {
  for (int y = 0; y < picture.window.height; ++y)
    for (int x = 0; x < picture.window.width; ++x) visit(x, y, pixel_number(picture, x, y));
}

void paint_cells(Canvas& canvas, int left, int top, const RegionPicture& picture) {
  for_each_pixel(picture, [&](int x, int y, std::size_t i) {
    canvas.image().blend(left + x, top + y, picture.in_cut_cell[i] ? cut_colour : inside_colour,
                         picture.region.covered(i));
  });
}

void paint_grid(Canvas& canvas, int left, int top, const RegionPicture& picture) {
  const PixelWindow& window = picture.window;
  const auto is_open = [&](const std::vector<double>& lines) {
    return lines.size() > 1 && (lines[1] - lines[0]) / window.pixel_size >= 4;
  };
  if (picture.grid_x.empty() || picture.grid_y.empty()) return;
  const auto at = [&](double x, double y) {
    const PixelPosition place = window.place({x, y, 0});
    return PixelPosition{std::clamp(left + place.x, double(left), double(left + window.width)),
                         std::clamp(top + place.y, double(top), double(top + window.height))};
  };
  if (is_open(picture.grid_x))
    for (const double x : picture.grid_x)
      canvas.line({at(x, picture.grid_y.front()), at(x, picture.grid_y.back())}, 1, grid_colour,
                  0.45);
  if (is_open(picture.grid_y))
    for (const double y : picture.grid_y)
      canvas.line({at(picture.grid_x.front(), y), at(picture.grid_x.back(), y)}, 1, grid_colour,
                  0.45);
}

void paint_levels(Canvas& canvas, int left, int top, const RegionPicture& picture) {
  if (picture.level_step <= 0 || picture.omega.empty()) return;
  for_each_pixel(picture, [&](int x, int y, std::size_t i) {
    if (picture.region.distance[i] < 0 || !std::isfinite(picture.omega[i]) ||
        !(picture.slope[i] > 1e-4 * picture.level_step))
      return;
    const double level = picture.level_step * std::round(picture.omega[i] / picture.level_step);
    if (level <= 0) return;  // the boundary has its own line
    const double distance = std::abs(picture.omega[i] - level) / picture.slope[i];
    canvas.image().blend(left + x, top + y, level_colour,
                         0.7 * std::clamp(1.1 - distance, 0.0, 1.0));
  });
}

void paint_parts(Canvas& canvas, int left, int top, const RegionPicture& picture) {
  for (const RegionPixels& part : picture.parts)
    for_each_pixel(picture, [&](int x, int y, std::size_t i) {
      canvas.image().blend(left + x, top + y, black,
                           0.6 * part.on_line(i, 1.5) * picture.region.covered(i));
    });
}

void paint_pieces(Canvas& canvas, int left, int top, const RegionPicture& picture, double width) {
  for_each_pixel(picture, [&](int x, int y, std::size_t i) {
    if (picture.piece[i] >= 0)
      canvas.image().blend(left + x, top + y, picture.pieces[picture.piece[i]].colour,
                           picture.region.on_line(i, width));
  });
}

double on_set(const RegionPicture::Set& set, std::size_t pixel) {
  return std::clamp(0.5 * (set.width + 1) - set.distance[pixel], 0.0, 1.0);
}

void paint_sets(Canvas& canvas, int left, int top, const RegionPicture& picture) {
  for (const RegionPicture::Set& set : picture.sets)
    for_each_pixel(picture, [&](int x, int y, std::size_t i) {
      canvas.image().blend(left + x, top + y, set.piece.colour, on_set(set, i));
    });
}

void write_names(Canvas& canvas, int left, int top, const RegionPicture& picture,
                 const RegionStyle& style) {
  LabelPlaces places(picture.window.width, picture.window.height);
  for_each_pixel(picture, [&](int x, int y, std::size_t i) {
    if (picture.piece[i] >= 0 && std::abs(picture.region.distance[i]) <= 0.75)
      places.add_curve_pixel(picture.piece[i], x, y);
    if (picture.region.distance[i] >= 0) places.add_painted_pixel(x, y);
    for (std::size_t s = 0; s < picture.sets.size(); ++s)
      if (on_set(picture.sets[s], i) == 1)
        places.add_curve_pixel(static_cast<int>(picture.pieces.size() + s), x, y);
  });
  for (std::size_t p = 0; p < picture.pieces.size() + picture.sets.size(); ++p) {
    const RegionPicture::Piece& piece = p < picture.pieces.size()
                                            ? picture.pieces[p]
                                            : picture.sets[p - picture.pieces.size()].piece;
    const TextExtent extent = text_extent(piece.name, style.font_size);
    if (const auto place = places.place(static_cast<int>(p), extent))
      canvas.text(piece.name, {left + place->x, top + place->y + 0.5 * extent.height},
                  {.size = style.font_size,
                   .colour = mixed(piece.colour, black, 0.25),
                   .halo = 0.12 * style.font_size});
  }
}

constexpr double swatch = 1.4, row = 1.5;  // of the font size

void draw_swatch(Canvas& canvas, const PixelPosition& at, double font_size, const Colour& colour,
                 double height) {
  const double right = at.x + swatch * font_size, half = 0.5 * height;
  canvas.fill(
      {{at.x, at.y - half}, {right, at.y - half}, {right, at.y + half}, {at.x, at.y + half}},
      colour);
}

}  // namespace

void paint_region(Canvas& canvas, int left, int top, const RegionPicture& picture,
                  const RegionStyle& style) {
  paint_cells(canvas, left, top, picture);
  paint_grid(canvas, left, top, picture);
  paint_levels(canvas, left, top, picture);
  paint_parts(canvas, left, top, picture);
  paint_pieces(canvas, left, top, picture, style.boundary_width);
  paint_sets(canvas, left, top, picture);
  write_names(canvas, left, top, picture, style);
}

double legend_width(const std::vector<RegionPicture::Piece>& pieces, double font_size) {
  double width = text_extent("cells inside", font_size).width;
  for (const RegionPicture::Piece& piece : pieces)
    width = std::max<double>(width, text_extent(piece.description, font_size).width);
  return width + (swatch + 1.5) * font_size;
}

void draw_legend(Canvas& canvas, const PixelRectangle& room,
                 const std::vector<RegionPicture::Piece>& pieces, double font_size) {
  const double text_left = room.left + (swatch + 0.5) * font_size;
  const int rows = std::max(1, static_cast<int>(room.height / (row * font_size)) - 3);
  double y = room.top + 0.5 * row * font_size;
  const auto next = [&](const std::string& text, const Colour& colour, double height) {
    if (height > 0) draw_swatch(canvas, {room.left, y}, font_size, colour, height);
    canvas.text(fitted(text, font_size, room.right() - text_left), {text_left, y},
                {.size = font_size});
    y += row * font_size;
  };
  const int count = static_cast<int>(pieces.size());
  const int shown = count <= rows ? count : rows - 1;
  for (int i = 0; i < shown; ++i) next(pieces[i].description, pieces[i].colour, 0.25 * font_size);
  if (shown < count) next("and " + std::to_string(count - shown) + " more", white, 0);
  y += 0.5 * row * font_size;
  next("cells inside", inside_colour, 0.9 * font_size);
  next("cut cells", cut_colour, 0.9 * font_size);
}

}  // namespace rfm
