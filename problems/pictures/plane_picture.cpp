#include "problems/pictures/plane_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/tape.hpp"
#include "problems/output/axes.hpp"
#include "problems/output/picture_layout.hpp"
#include "problems/pictures/field_pixels.hpp"
#include "problems/pictures/missing_values.hpp"
#include "problems/pictures/region_pixels.hpp"

namespace rfm {
namespace {

FieldPicture sampled(const ScalarProblem& problem, const ShownField& shown,
                     const PixelWindow& window, bool with_slope) {
  return sample_field(shown.components, sample_region(problem.region(), window),
                      {window, problem.bounds(), with_slope});
}

// The range on a coarse picture, which decides how much room the numbers of the colour bar get.
ValueRange estimated_range(const ScalarProblem& problem, const ShownField& shown,
                           const Box& window_box) {
  constexpr int coarse = 100;
  const double side = window_box.longest_side();
  const auto pixels = [&](int axis) {
    return std::max(1, static_cast<int>(std::ceil(coarse * window_box.length(axis) / side)));
  };
  const PixelWindow window = PixelWindow::around(window_box, pixels(0), pixels(1));
  return range_of(sampled(problem, shown, window, false)).value_or(ValueRange{0, 1});
}

// Contour lines need one derivative more than the field itself, which may be more than there are.
bool has_slope(const ShownField& shown, std::vector<std::string>& remarks) {
  try {
    const Tape tape(shown.components, {1}, 2);
    return true;
  } catch (const InvalidArgument& error) {
    remarks.push_back(fmt::format("no contour lines of {}: {}", shown.name, error.what()));
    return false;
  }
}

void note_missing_values(const FieldPicture& picture, const ShownField& shown,
                         std::vector<std::string>& remarks) {
  MissingValues missing;
  for (std::size_t i = 0; i < picture.value.size(); ++i) {
    const int pixel = static_cast<int>(i), width = picture.window.width;
    if (picture.region.distance[i] >= 0 && !std::isfinite(picture.value[i]))
      missing.add(picture.window.centre(pixel % width, pixel / width));
  }
  if (missing.count > 0)
    remarks.push_back(missing_values_text(
        fmt::format("the picture is grey at {} pixels", missing.count), missing, shown, 2));
}

}  // namespace

Box with_margin(const Box& bounds) {
  Box box = bounds;
  for (int axis = 0; axis < 2; ++axis) {
    box.low[axis] -= 0.03 * bounds.longest_side();
    box.high[axis] += 0.03 * bounds.longest_side();
  }
  return box;
}

std::vector<RegionPixels> sample_materials(const Problem& problem, const PixelWindow& window) {
  std::vector<RegionPixels> materials;
  for (const Material& material : problem.physics.materials)
    if (material.region)
      materials.push_back(sample_region(RegionEvaluator(*material.region), window));
  return materials;
}

void show_window(Axis& x, Axis& y, const PixelWindow& window) {
  x.low = window.left;
  x.high = window.right();
  y.low = window.bottom();
  y.high = window.top;
}

Image draw_plane(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                 std::vector<std::string>& remarks) {
  const Box box = with_margin(problem.bounds());
  const auto make_scale = [&](const ValueRange& data) {
    const ValueRange range = shown_range(picture, data, shown.size);
    return ColourScale(
        picture.colours == Picture::Colours::diverging ? ColourMap::diverging : ColourMap::uniform,
        range.low, range.high);
  };
  const double font = label_size(picture.width);
  PictureRequest request;
  request.width = picture.width;
  request.title = shown.title;
  request.aspect = box.length(1) / box.length(0);
  request.scale = make_scale(estimated_range(problem, shown, box));
  request.bar.title = shown.name;
  Axis x = Axis::linear(box.low[0], box.high[0], 0.8 * picture.width, 6 * font),
       y = Axis::linear(box.low[1], box.high[1], 0.8 * picture.width * request.aspect, 4 * font);
  request.left_margin = left_margin(y, font);
  request.bottom_margin = bottom_margin(x, font);
  const PictureLayout layout = picture_layout(request);

  const PixelWindow window = PixelWindow::around(box, static_cast<int>(layout.shown.width),
                                                 static_cast<int>(layout.shown.height));
  const bool with_contours =
      picture.contours > 0 && !shown.is_vector() && has_slope(shown, remarks);
  FieldPicture field = sampled(problem, shown, window, with_contours);
  field.parts = sample_materials(problem.problem(), window);
  note_missing_values(field, shown, remarks);
  request.scale = make_scale(range_of(field).value_or(ValueRange{0, 1}));
  FieldStyle style{*request.scale};
  style.boundary_width = 0.12 * font;
  style.line_width = 0.075 * font;
  style.arrow_spacing = 2 * font;
  if (with_contours) {
    const Ticks levels = nice_ticks(request.scale->low(), request.scale->high(), picture.contours);
    style.level_step = levels.step;
    request.bar.levels = levels.values;
  }
  Canvas canvas(layout.width, layout.height);
  paint_field(canvas, static_cast<int>(layout.shown.left), static_cast<int>(layout.shown.top),
              field, style);
  show_window(x, y, window);
  Axes{layout.shown, x, y, font}.draw(canvas);
  draw_frame(canvas, layout, request);
  return canvas.image();
}

}  // namespace rfm
