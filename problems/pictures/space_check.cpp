#include "problems/pictures/space_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "core/tape.hpp"
#include "problems/output/picture_layout.hpp"
#include "problems/output/plot.hpp"
#include "problems/output/region_picture.hpp"
#include "problems/pictures/axes_triad.hpp"
#include "problems/pictures/grid_box.hpp"
#include "problems/pictures/panel_arrangement.hpp"
#include "problems/pictures/plane_check.hpp"
#include "problems/pictures/rule_dots.hpp"
#include "problems/pictures/scene_painter.hpp"
#include "problems/pictures/scene_panel.hpp"
#include "problems/pictures/scene_sets.hpp"
#include "problems/pictures/shown_field.hpp"
#include "problems/pictures/visible_places.hpp"

namespace rfm {
namespace {

constexpr Colour cut_colour{0.88, 0.88, 0.86}, unnamed_colour{0.7, 0.7, 0.7};
constexpr double paleness = 0.25;

// Which condition holds at a point of a piece: it may have several, each on a part.
class ConditionFinder {
 public:
  explicit ConditionFinder(const ScalarProblem& problem) {
    const auto& conditions = problem.conditions();
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      auto& list = candidates_[conditions[i].primitive];
      list.push_back({static_cast<int>(i), std::nullopt});
      if (conditions[i].where) list.back().where.emplace(Tape({*conditions[i].where}, {0}, 3));
    }
  }

  /// −1: none, as on a cut.
  int operator()(const SceneSample& sample) const {
    const auto found = candidates_.find(sample.primitive);
    if (found == candidates_.end()) return -1;
    for (const Candidate& candidate : found->second)
      if (!candidate.where || candidate.where->value(sample.point) >= 0) return candidate.number;
    return -1;
  }

 private:
  struct Candidate {
    int number;
    std::optional<Tape> where;
  };
  std::map<int, std::vector<Candidate>> candidates_;  // by primitive
};

struct Panel {
  const char* caption;
  ScenePanel scene;
};

std::vector<Panel> make_panels(const ScalarProblem& problem) {
  const Region& region = problem.region().region();
  const Box& bounds = problem.bounds();
  const Point front = Picture{}.view, behind{-front[0], -front[1], -front[2]};
  std::vector<Panel> panels;
  panels.push_back({"from the front", ScenePanel(region, bounds, {}, View::at(bounds, front))});
  panels.push_back(
      {"from behind and below", ScenePanel(region, bounds, {}, View::at(bounds, behind))});
  panels.push_back({"cut open", ScenePanel(region, bounds, CutPlane::facing(bounds, front),
                                           View::at(bounds, front))});
  return panels;
}

NumberedPixels numbered(const SceneSamples& scene, const ConditionFinder& condition_at) {
  NumberedPixels pixels{scene.width, scene.height, {}};
  for (const SceneSample& sample : scene.centres)
    pixels.number.push_back(sample.is_surface() ? condition_at(sample) : -1);
  return pixels;
}

bool overlaps_any(const PixelRectangle& rectangle, const std::vector<PixelRectangle>& taken) {
  return std::ranges::any_of(taken, [&](const PixelRectangle& other) {
    return rectangle.left < other.right() && other.left < rectangle.right() &&
           rectangle.top < other.bottom() && other.top < rectangle.bottom();
  });
}

// Each set is named once, in the view in which most of it is seen.
class SetNames {
 public:
  explicit SetNames(std::size_t count) : best_(count) {}

  void consider(std::size_t set, const PixelRectangle& room, const SetPlace& place) {
    std::optional<SetPlace>& best = best_[set];
    if (!best || place.seen_pixels > best->seen_pixels)
      best = SetPlace{{room.left + place.place.x, room.top + place.place.y}, place.seen_pixels};
  }

  // Above or below it; the rectangles of the names are added to `taken`.
  void write(Canvas& canvas, std::span<const RegionPicture::Piece> sets, double size,
             std::vector<PixelRectangle>& taken) const {
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (!best_[i]) continue;
      const double width = text_extent(sets[i].name, size).width;
      for (const double below : {-1.0, 1.0, -2.2, 2.2}) {
        const double x = best_[i]->place.x, y = best_[i]->place.y + below * size;
        const PixelRectangle rectangle{x - 0.5 * width, y - 0.5 * size, width, size};
        if (overlaps_any(rectangle, taken)) continue;
        taken.push_back(rectangle);
        canvas.text(sets[i].name, {x, y},
                    {.size = size,
                     .colour = mixed(sets[i].colour, black, 0.25),
                     .horizontal = Align::centre,
                     .halo = 0.15 * size});
        break;
      }
    }
  }

 private:
  std::vector<std::optional<SetPlace>> best_;
};

// Names stand where a piece has most room: in each view where they fit and hide no other name, at
// least in the best one.
void write_names(Canvas& canvas, std::span<const RegionPicture::Piece> pieces,
                 const std::vector<Panel>& panels, const ConditionFinder& condition_at,
                 const std::vector<PixelRectangle>& rooms, double font,
                 std::vector<PixelRectangle> taken) {
  const int count = static_cast<int>(pieces.size());
  std::vector<std::vector<std::optional<VisiblePlace>>> places;
  for (const Panel& panel : panels)
    places.push_back(visible_places(numbered(panel.scene.samples(), condition_at), count));
  const double size = 0.9 * font;
  const auto write = [&](std::size_t piece, std::size_t panel, bool must) {
    const auto& place = places[panel][piece];
    if (!place) return;
    const TextExtent text = text_extent(pieces[piece].name, size);
    const double x = rooms[panel].left + place->place.x, y = rooms[panel].top + place->place.y;
    const PixelRectangle rectangle{x - 0.5 * text.width, y - 0.5 * size, double(text.width), size};
    if (overlaps_any(rectangle, taken) || (!must && place->radius < 0.5 * text.width)) return;
    taken.push_back(rectangle);
    canvas.text(pieces[piece].name, {x, y},
                {.size = size, .horizontal = Align::centre, .halo = 0.15 * font});
  };
  std::vector<std::size_t> best(pieces.size(), 0);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    for (std::size_t panel = 1; panel < panels.size(); ++panel)
      if (places[panel][piece] &&
          (!places[best[piece]][piece] ||
           places[panel][piece]->radius > places[best[piece]][piece]->radius))
        best[piece] = panel;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) write(piece, best[piece], true);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    for (std::size_t panel = 0; panel < panels.size(); ++panel)
      if (panel != best[piece]) write(piece, panel, false);
}

// The pieces beside their colours, in as many columns as fit.
struct PieceList {
  PieceList(const std::vector<RegionPicture::Piece>& pieces, double width, double font)
      : font(font) {
    for (const auto& piece : pieces)
      column_width =
          std::max(column_width, text_extent(piece.description, font).width + 3.0 * font);
    columns = std::clamp(static_cast<int>(width / column_width), 1,
                         std::max(1, static_cast<int>(pieces.size())));
    column_width = std::min(column_width, width);
    rows = (static_cast<int>(pieces.size()) + columns - 1) / columns;
  }
  double height() const { return 1.5 * font * rows; }

  void draw(Canvas& canvas, const std::vector<RegionPicture::Piece>& pieces, double left,
            double top) const {
    const double side = 0.8 * font;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const int number = static_cast<int>(i);
      const double x = left + column_width * (number / rows);
      const double y = top + 1.5 * font * (number % rows + 0.5);
      canvas.fill({{x, y - 0.5 * side},
                   {x + side, y - 0.5 * side},
                   {x + side, y + 0.5 * side},
                   {x, y + 0.5 * side}},
                  mixed(pieces[i].colour, white, paleness));
      canvas.text(fitted(pieces[i].description, font, column_width - 2.5 * side),
                  {x + 1.5 * side, y}, {.size = font});
    }
  }

  double font;
  double column_width = 0;
  int columns = 1, rows = 0;
};

}  // namespace

Image draw_space_check(const ScalarProblem& problem, const DomainRule& rule, int width) {
  std::vector<Panel> panels = make_panels(problem);
  const Grid& grid = rule.grid();
  ViewWindow window = ViewWindow::of(panels[0].scene.view(), grid.box());
  for (const Panel& panel : panels) {
    const ViewWindow other = ViewWindow::of(panel.scene.view(), grid.box());
    window.include({other.left, other.low});
    window.include({other.right, other.high});
  }
  const PanelArrangement arrangement =
      PanelArrangement::of(window, static_cast<int>(panels.size()));
  std::vector<RegionPicture::Piece> pieces;
  for (const PieceCondition& condition : problem.conditions())
    pieces.push_back(
        {condition.name, description(condition), distinct_colour(static_cast<int>(pieces.size()))});

  const std::size_t first_set = pieces.size();
  for (const auto& [name, set] : problem.problem().sets)
    pieces.push_back({name, name + ": set", distinct_colour(static_cast<int>(pieces.size()))});

  const double font = label_size(width);
  const PieceList list(pieces, width - 2 * font, font);
  PictureRequest request;
  request.width = width;
  request.title = shown_title(problem.problem());
  request.aspect = arrangement.aspect;
  request.bottom_margin = list.height() + font;
  const PictureLayout layout = picture_layout(request);

  const ConditionFinder condition_at(problem);
  SceneStyle style;
  Canvas canvas(layout.width, layout.height);
  std::vector<PixelRectangle> rooms;
  SetNames set_names(pieces.size() - first_set);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    ScenePanel& scene = panels[i].scene;
    const PixelRectangle room =
        arrangement.place(static_cast<int>(i), layout.shown, layout.font_size);
    rooms.push_back(room);
    scene.sample(window, static_cast<int>(room.width), static_cast<int>(room.height));
    style.flat_primitive = scene.cut_primitive();
    style.colour = [&](const SceneSample& sample) {
      if (sample.primitive == scene.cut_primitive()) return cut_colour;
      const int condition = condition_at(sample);
      return condition < 0
                 ? unnamed_colour
                 : mixed(pieces[static_cast<std::size_t>(condition)].colour, white, paleness);
    };
    draw_grid_box(canvas, room.left, room.top, scene.camera(), grid);
    paint_scene(canvas, static_cast<int>(room.left), static_cast<int>(room.top), scene.samples(),
                scene.camera(), style);
    if (problem.problem().outputs.rule)
      paint_rule_dots(canvas, room.left, room.top, scene.samples(), scene.camera(), rule);
    std::size_t number = 0;
    for (const auto& [name, set] : problem.problem().sets) {
      const RegionPicture::Piece& piece = pieces[first_set + number];
      const auto place = paint_set(canvas, room.left, room.top, scene.samples(), scene.camera(),
                                   set, piece.colour, 0.16 * font);
      if (place) set_names.consider(number, room, *place);
      ++number;
    }
    draw_axes_triad(canvas, {room.left + 2.2 * font, room.bottom() - 1.5 * font}, 1.6 * font,
                    0.8 * font, scene.view());
    canvas.text(panels[i].caption, {room.left + 0.5 * room.width, room.top - 0.9 * font},
                {.size = font, .horizontal = Align::centre});
  }
  const std::span all(pieces);
  std::vector<PixelRectangle> taken;
  set_names.write(canvas, all.subspan(first_set), 0.9 * font, taken);
  write_names(canvas, all.first(first_set), panels, condition_at, rooms, font, taken);
  draw_frame(canvas, layout, request);
  list.draw(canvas, pieces, font, canvas.height() - list.height() - font);
  return canvas.image();
}

}  // namespace rfm
