#include "problems/pictures/line_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/tape.hpp"
#include "problems/output/picture_layout.hpp"
#include "problems/output/plot.hpp"
#include "problems/pictures/missing_values.hpp"

namespace rfm {
namespace {

std::vector<PlotPoint> sampled(const Tape& tape, const Interval& interval, int count) {
  std::vector<PlotPoint> points;
  for (int i = 0; i <= count; ++i) {
    const double x = interval.low + (interval.high - interval.low) * i / count;
    points.push_back({x, tape.value({x, 0, 0})});
  }
  return points;
}

}  // namespace

std::vector<Interval> intervals_of(const RegionEvaluator& region, const Box& bounds) {
  constexpr int steps = 4000;
  const auto inside = [&](double x) { return region.contains(Point{x, 0, 0}); };
  const auto at = [&](int i) { return bounds.low[0] + bounds.length(0) * i / steps; };
  // The place between an inner and an outer point where membership changes.
  const auto end_between = [&](double in, double out) {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (in + out);
      (inside(middle) ? in : out) = middle;
    }
    return in;
  };
  std::vector<Interval> intervals;
  bool was_inside = false;
  for (int i = 0; i <= steps; ++i) {
    const bool is_inside = inside(at(i));
    if (is_inside && !was_inside)
      intervals.push_back(Interval(i == 0 ? at(0) : end_between(at(i), at(i - 1)), at(i)));
    if (is_inside) intervals.back().high = at(i);
    if (!is_inside && was_inside) intervals.back().high = end_between(at(i - 1), at(i));
    was_inside = is_inside;
  }
  std::erase_if(intervals,
                [](const Interval& interval) { return !(interval.low < interval.high); });
  return intervals;
}

Image draw_line(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                std::vector<std::string>& remarks) {
  const Tape tape({shown.components[0]}, {0}, 1);
  Plot plot;
  plot.title = shown.title;
  plot.width = picture.width;
  PlotCurve curve{{}, distinct_colour(0), 2, false, ""};
  ValueRange data{INFINITY, -INFINITY};
  MissingValues missing;
  for (const Interval& interval : intervals_of(problem.region(), problem.bounds())) {
    curve.parts.emplace_back();
    for (const PlotPoint& point : sampled(tape, interval, 2 * picture.width)) {
      if (!std::isfinite(point.y)) {
        missing.add({point.x, 0, 0});
        if (!curve.parts.back().empty()) curve.parts.emplace_back();
        continue;
      }
      data = {std::min(data.low, point.y), std::max(data.high, point.y)};
      curve.parts.back().push_back(point);
    }
  }
  if (missing.count > 0)
    remarks.push_back(missing_values_text(
        fmt::format("the plot has gaps at {} points", missing.count), missing, shown, 1));
  if (data.low > data.high) data = {0, 1};
  const ValueRange range = shown_range(picture, data, shown.size);
  // The scale widens a range that is empty.
  const ColourScale spread(ColourMap::uniform, range.low, range.high);
  const double margin = picture.range ? 0 : 0.05 * (spread.high() - spread.low());
  const double font = label_size(picture.width), side = 0.03 * problem.bounds().length(0);
  plot.x = Axis::linear(problem.bounds().low[0] - side, problem.bounds().high[0] + side,
                        0.85 * picture.width, 6 * font);
  plot.y =
      Axis::linear(spread.low() - margin, spread.high() + margin, 0.55 * picture.width, 4 * font);
  plot.x.title = "x";
  plot.y.title = shown.name;
  plot.curves.push_back(std::move(curve));
  return draw_plot(plot);
}

}  // namespace rfm
