#include "problems/pictures/plane_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "problems/output/axes.hpp"
#include "problems/output/picture_layout.hpp"
#include "problems/output/plot.hpp"
#include "problems/output/region_picture.hpp"
#include "problems/pictures/field_pixels.hpp"
#include "problems/pictures/plane_picture.hpp"
#include "problems/pictures/region_pixels.hpp"
#include "problems/pictures/rule_dots.hpp"
#include "problems/pictures/set_pixels.hpp"
#include "problems/pictures/shown_field.hpp"

namespace rfm {
namespace {

std::vector<RegionPicture::Piece> legend(const ScalarProblem& problem) {
  std::vector<RegionPicture::Piece> pieces;
  for (const PieceCondition& condition : problem.conditions())
    pieces.push_back(
        {condition.name, description(condition), distinct_colour(static_cast<int>(pieces.size()))});
  for (const auto& [name, set] : problem.problem().sets)
    pieces.push_back({name, name + ": set", distinct_colour(static_cast<int>(pieces.size()))});
  return pieces;
}

// The condition that holds at each pixel of the boundary: a piece may have several, each on a part.
std::vector<int> conditions_at(const ScalarProblem& problem, const RegionPixels& region,
                               const PixelWindow& window) {
  struct Candidate {
    int number;
    std::optional<Tape> where;
  };
  std::map<int, std::vector<Candidate>> candidates;  // by primitive
  const auto& conditions = problem.conditions();
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    std::vector<Candidate>& list = candidates[conditions[i].primitive];
    list.push_back({static_cast<int>(i), std::nullopt});
    if (conditions[i].where) list.back().where.emplace(Tape({*conditions[i].where}, {0}, 2));
  }
  std::vector<int> result(region.primitive.size(), -1);
  for (std::size_t pixel = 0; pixel < result.size(); ++pixel) {
    const auto found = candidates.find(region.primitive[pixel]);
    if (region.primitive[pixel] < 0 || found == candidates.end()) continue;
    const int number = static_cast<int>(pixel);
    const Point centre = window.centre(number % window.width, number / window.width);
    for (const Candidate& candidate : found->second)
      if (result[pixel] < 0 && (!candidate.where || candidate.where->value(centre) >= 0))
        result[pixel] = candidate.number;
  }
  return result;
}

std::vector<char> cut_cells(const DomainRule& rule, const PixelWindow& window) {
  const Grid& grid = rule.grid();
  std::vector<int> column(window.width), row(window.height);
  for (int x = 0; x < window.width; ++x) column[x] = grid.locate(0, window.centre(x, 0)[0]);
  for (int y = 0; y < window.height; ++y) row[y] = grid.locate(1, window.centre(0, y)[1]);
  std::vector<char> is_cut(static_cast<std::size_t>(window.pixel_count()));
  for (int y = 0; y < window.height; ++y)
    for (int x = 0; x < window.width; ++x)
      is_cut[static_cast<std::size_t>(y) * window.width + x] =
          rule.state(grid.number({column[x], row[y], 0})) == CellState::cut;
  return is_cut;
}

std::vector<double> grid_lines(const Grid& grid, int axis) {
  std::vector<double> lines;
  for (int i = 0; i <= grid.cells(axis); ++i) lines.push_back(grid.line(axis, i));
  return lines;
}

}  // namespace

std::string description(const PieceCondition& condition) {
  static constexpr const char* kinds[] = {"value", "flux", "convection", "robin"};
  const std::string unknown = condition.unknown.empty() ? "" : condition.unknown + " ";
  return condition.name + ": " + unknown + kinds[static_cast<int>(condition.kind)] +
         (condition.where ? " on a part" : "");
}

Image draw_plane_check(const ScalarProblem& problem, const DomainRule& rule, int width) {
  const double font = label_size(width);
  Box box = with_margin(problem.bounds());
  for (int axis = 0; axis < 2; ++axis) {  // room for names outside
    box.low[axis] -= 0.06 * problem.bounds().longest_side();
    box.high[axis] += 0.06 * problem.bounds().longest_side();
  }
  RegionPicture picture;
  const std::vector<RegionPicture::Piece> entries = legend(problem);
  const auto first_set = entries.begin() + static_cast<std::ptrdiff_t>(problem.conditions().size());
  picture.pieces = {entries.begin(), first_set};
  Axis x = Axis::linear(box.low[0], box.high[0], 0.7 * width, 6 * font),
       y = Axis::linear(box.low[1], box.high[1], 0.7 * width * box.length(1) / box.length(0),
                        4 * font);
  const double legend_room = std::min(0.35 * width, legend_width(entries, font));
  PictureRequest request;
  request.width = width;
  request.title = shown_title(problem.problem());
  request.aspect = box.length(1) / box.length(0);
  request.left_margin = left_margin(y, font);
  request.bottom_margin = bottom_margin(x, font);
  request.right_margin = legend_room + font;
  constexpr int most_rows = 30;  // of the legend, where the domain is flat
  request.least_height = 1.5 * font * (std::min(most_rows, static_cast<int>(entries.size())) + 3);
  const PictureLayout layout = picture_layout(request);
  picture.window = PixelWindow::around(box, static_cast<int>(layout.shown.width),
                                       static_cast<int>(layout.shown.height));

  const Field omega = implicit(problem.region().region());
  FieldPicture sampled = sample_field({omega}, sample_region(problem.region(), picture.window),
                                      {picture.window, problem.bounds(), true});
  const ValueRange range = range_of(sampled).value_or(ValueRange{0, 1});
  picture.level_step = range.high > 0 ? nice_ticks(0, range.high, 8).step : 0;
  picture.region = std::move(sampled.region);
  picture.omega = std::move(sampled.value);
  picture.slope = std::move(sampled.slope);
  picture.parts = sample_materials(problem.problem(), picture.window);
  picture.in_cut_cell = cut_cells(rule, picture.window);
  picture.piece = conditions_at(problem, picture.region, picture.window);
  auto entry = first_set;
  for (const auto& [name, set] : problem.problem().sets) {
    const double set_width = set.points.size() == 1 ? 0.8 * font : 0.2 * font;
    picture.sets.push_back({*entry++, distances_from(set, picture.window, set_width), set_width});
  }
  picture.grid_x = grid_lines(rule.grid(), 0);
  picture.grid_y = grid_lines(rule.grid(), 1);

  Canvas canvas(layout.width, layout.height);
  paint_region(canvas, static_cast<int>(layout.shown.left), static_cast<int>(layout.shown.top),
               picture, {font, 0.2 * font});
  if (problem.problem().outputs.rule)
    paint_rule_dots(canvas, layout.shown.left, layout.shown.top, picture.window, rule);
  show_window(x, y, picture.window);
  Axes{layout.shown, x, y, font}.draw(canvas);
  draw_frame(canvas, layout, request);
  draw_legend(canvas,
              {layout.shown.right() + 1.2 * font, layout.shown.top, legend_room,
               canvas.height() - layout.shown.top - font},
              entries, font);
  return canvas.image();
}

}  // namespace rfm
