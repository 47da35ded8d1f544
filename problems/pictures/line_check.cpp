#include "problems/pictures/line_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "problems/output/picture_layout.hpp"
#include "problems/output/plot.hpp"
#include "problems/pictures/line_picture.hpp"
#include "problems/pictures/plane_check.hpp"
#include "problems/pictures/shown_field.hpp"

namespace rfm {
namespace {

// The condition at an end of an interval: that of the primitive which is zero there.
int condition_at(const ScalarProblem& problem, double x) {
  int nearest = -1;
  double least = INFINITY;
  const auto& conditions = problem.conditions();
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const double level = std::abs(problem.region().level(conditions[i].primitive).value({x, 0, 0}));
    if (level < least) {
      least = level;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

}  // namespace

Image draw_line_check(const ScalarProblem& problem, const Grid& grid, int width) {
  const Tape omega({implicit(problem.region().region())}, {0}, 1);
  PlotCurve curve{{}, {0.25, 0.35, 0.5}, 2, false, ""};
  std::vector<PlotCurve> ends;
  double highest = 0;
  for (const Interval& interval : intervals_of(problem.region(), problem.bounds())) {
    std::vector<PlotPoint> points;
    for (int i = 0; i <= 2 * width; ++i) {
      const double x = interval.low + (interval.high - interval.low) * i / (2.0 * width);
      const double value = omega.value({x, 0, 0});
      if (std::isfinite(value)) points.push_back({x, value});
      if (std::isfinite(value)) highest = std::max(highest, value);
    }
    curve.parts.push_back(std::move(points));
    for (const double x : {interval.low, interval.high}) {
      const int number = condition_at(problem, x);
      if (number < 0) continue;
      ends.push_back({{{{x, 0}}},
                      distinct_colour(number),
                      2.5,
                      true,
                      description(problem.conditions()[number])});
      ends.back().label_side = x == interval.high ? Align::before : Align::after;
      ends.back().label_below = 1.6;
    }
  }
  if (highest == 0) highest = 1;
  int colour = static_cast<int>(problem.conditions().size());
  for (const auto& [name, set] : problem.problem().sets) {
    if (set.points.size() != 1) continue;
    ends.push_back(
        {{{{set.points[0][0], 0}}}, distinct_colour(colour++), 2.5, true, name + ": set"});
    ends.back().label_below = 3.2;
  }
  PlotCurve cells{{}, {0.55, 0.6, 0.68}, 1, false, ""};
  for (int i = 0; i <= grid.cells(0); ++i)
    cells.parts.push_back({{grid.line(0, i), 0}, {grid.line(0, i), -0.03 * highest}});

  Plot plot;
  plot.title = shown_title(problem.problem());
  plot.width = width;
  plot.aspect = 0.4;
  const double font = label_size(width), side = 0.03 * problem.bounds().length(0);
  plot.x = Axis::linear(problem.bounds().low[0] - side, problem.bounds().high[0] + side,
                        0.85 * width, 6 * font);
  plot.y = Axis::linear(-0.2 * highest, 1.05 * highest, 0.35 * width, 5 * font);
  plot.x.title = "x";
  plot.y.title = "ω";
  plot.curves = {cells, curve};
  plot.curves.insert(plot.curves.end(), ends.begin(), ends.end());
  return draw_plot(plot);
}

}  // namespace rfm
