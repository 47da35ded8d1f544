#include "problems/pictures/space_picture.hpp"
#include "problems/pictures/missing_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/output/picture_layout.hpp"
#include "problems/output/ticks.hpp"
#include "problems/pictures/axes_triad.hpp"
#include "problems/pictures/panel_arrangement.hpp"
#include "problems/pictures/scene_painter.hpp"
#include "problems/pictures/scene_panel.hpp"
#include "problems/pictures/scene_values.hpp"

namespace rfm {
namespace {

struct Panel {
  std::string caption;
  ScenePanel scene;
};

std::vector<Panel> make_panels(const ScalarProblem& problem, const Picture& picture) {
  const Region& region = problem.region().region();
  const Box& bounds = problem.bounds();
  const View view = View::at(bounds, picture.view);
  std::vector<Panel> panels;
  panels.push_back({"", ScenePanel(region, bounds, {}, view)});
  if (!picture.with_cut) return panels;
  CutPlane cut = CutPlane::facing(bounds, picture.view);
  cut.point = picture.cut_point.value_or(cut.point);
  cut.normal = picture.cut_normal.value_or(cut.normal);
  panels.push_back({"cut at " + cut.equation(), ScenePanel(region, bounds, cut, view)});
  return panels;
}

ViewWindow common_window(const std::vector<Panel>& panels) {
  ViewWindow window = panels[0].scene.window();
  for (const Panel& panel : panels) {
    const ViewWindow other = panel.scene.window();
    window.include({other.left, other.low});
    window.include({other.right, other.high});
  }
  return window;
}

ValueRange evaluate_all(std::vector<Panel>& panels, const ShownField& shown, const Box& bounds) {
  ValueRange all{INFINITY, -INFINITY};
  for (Panel& panel : panels) {
    const ValueRange range = evaluate_on(panel.scene.samples(), shown.components, bounds);
    all = {std::min(all.low, range.low), std::max(all.high, range.high)};
  }
  return all.low <= all.high ? all : ValueRange{0, 1};
}

void note_missing_values(const std::vector<Panel>& panels, const ShownField& shown,
                         std::vector<std::string>& remarks) {
  MissingValues missing;
  for (const Panel& panel : panels)
    for (const SceneSample& sample : panel.scene.samples().centres)
      if (sample.is_surface() && !std::isfinite(sample.value)) missing.add(sample.point);
  if (missing.count > 0)
    remarks.push_back(missing_values_text(
        fmt::format("the picture is grey at {} pixels", missing.count), missing, shown, 3));
}

}  // namespace

Image draw_space(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                 std::vector<std::string>& remarks) {
  std::vector<Panel> panels = make_panels(problem, picture);
  const ViewWindow window = common_window(panels);
  const PanelArrangement arrangement =
      PanelArrangement::of(window, static_cast<int>(panels.size()));
  const auto make_scale = [&](const ValueRange& data) {
    const ValueRange range = shown_range(picture, data, shown.size);
    return ColourScale(
        picture.colours == Picture::Colours::diverging ? ColourMap::diverging : ColourMap::uniform,
        range.low, range.high);
  };
  PictureRequest request;
  request.width = picture.width;
  request.title = shown.title;
  request.aspect = arrangement.aspect;
  request.bar.title = shown.name;
  // A coarse picture tells the range, and that the room that the numbers of the colour bar need.
  constexpr int coarse = 60;
  for (Panel& panel : panels) panel.scene.sample(window, coarse, coarse);
  request.scale = make_scale(evaluate_all(panels, shown, problem.bounds()));
  const PictureLayout layout = picture_layout(request);
  const auto place = [&](std::size_t panel) {
    return arrangement.place(static_cast<int>(panel), layout.shown, layout.font_size);
  };
  for (std::size_t i = 0; i < panels.size(); ++i)
    panels[i].scene.sample(window, static_cast<int>(place(i).width),
                           static_cast<int>(place(i).height));
  request.scale = make_scale(evaluate_all(panels, shown, problem.bounds()));
  note_missing_values(panels, shown, remarks);

  SceneStyle style;
  style.colour = [&](const SceneSample& sample) { return (*request.scale)(sample.value); };
  style.contour_width = 0.07 * layout.font_size;
  if (picture.contours > 0) {
    const Ticks levels = nice_ticks(request.scale->low(), request.scale->high(), picture.contours);
    style.contour_step = levels.step;
    request.bar.levels = levels.values;
  }
  Canvas canvas(layout.width, layout.height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const ScenePanel& scene = panels[i].scene;
    style.flat_primitive = scene.cut_primitive();
    paint_scene(canvas, static_cast<int>(place(i).left), static_cast<int>(place(i).top),
                scene.samples(), scene.camera(), style);
    canvas.text(panels[i].caption,
                {place(i).left + 0.5 * place(i).width, place(i).top - 0.9 * layout.font_size},
                {.size = layout.font_size, .horizontal = Align::centre});
  }
  const double font = layout.font_size;
  draw_axes_triad(canvas, {layout.shown.left + 2.2 * font, layout.shown.bottom() - 2 * font},
                  2.2 * font, font, panels[0].scene.view());
  draw_frame(canvas, layout, request);
  return canvas.image();
}

}  // namespace rfm
