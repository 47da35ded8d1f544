#include "problems/pictures/convergence_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/output/picture_layout.hpp"
#include "problems/output/plot.hpp"

namespace rfm {
namespace {

struct ErrorCurve {
  std::string name;
  int colour;
  std::vector<PlotPoint> points;  // cells, error; zeros, which have no logarithm, left out
};

std::vector<ErrorCurve> error_curves(const std::vector<ConvergenceRow>& rows) {
  ErrorCurve l2{"L2", 0, {}}, h1{"H1", 1, {}}, change{"change in L2", 0, {}},
      eigenvalues{"eigenvalues", 2, {}};
  const auto add = [](ErrorCurve& curve, int cells, double error) {
    if (error > 0 && std::isfinite(error)) curve.points.push_back({double(cells), error});
  };
  for (const ConvergenceRow& row : rows) {
    if (row.errors) add(l2, row.cells, row.errors->l2);
    if (row.errors) add(h1, row.cells, row.errors->h1);
    if (row.change) add(change, row.cells, *row.change);
    if (row.eigenvalue_error) add(eigenvalues, row.cells, *row.eigenvalue_error);
  }
  std::vector<ErrorCurve> curves{l2, h1, change, eigenvalues};
  std::erase_if(curves, [](const ErrorCurve& curve) { return curve.points.size() < 2; });
  return curves;
}

Axis cells_axis(const std::vector<ConvergenceRow>& rows) {
  Axis axis;
  axis.logarithmic = true;
  axis.low = rows.front().cells / 1.12;
  axis.high = rows.back().cells * 1.12;
  axis.title = "cells along the longest side";
  for (const ConvergenceRow& row : rows) {
    axis.ticks.values.push_back(row.cells);
    axis.ticks.labels.push_back(std::to_string(row.cells));
  }
  return axis;
}

double last_order(const ErrorCurve& curve) {
  const PlotPoint &coarse = curve.points[curve.points.size() - 2], &fine = curve.points.back();
  return observed_order(coarse.y, fine.y, static_cast<int>(coarse.x), static_cast<int>(fine.x));
}

// Below the last piece of a curve, as steep as the whole order nearest to what was observed.
std::optional<PlotTriangle> order_triangle(const ErrorCurve& curve, double order) {
  const int whole = static_cast<int>(std::lround(order));
  if (whole < 1) return std::nullopt;
  const PlotPoint &coarse = curve.points[curve.points.size() - 2], &fine = curve.points.back();
  const double ratio = fine.x / coarse.x;
  const double left = coarse.x * std::pow(ratio, 0.3), right = coarse.x * std::pow(ratio, 0.8);
  const double at_right = coarse.y * std::pow(right / coarse.x, -order) / 2.0;
  return PlotTriangle{{left, at_right},
                      {right, at_right},
                      {left, at_right * std::pow(right / left, whole)},
                      std::to_string(whole)};
}

}  // namespace

std::optional<Image> draw_convergence(const std::vector<ConvergenceRow>& rows,
                                      const std::string& title, int width) {
  const std::vector<ErrorCurve> curves = error_curves(rows);
  if (curves.empty()) return std::nullopt;
  Plot plot;
  plot.title = title;
  plot.width = width;
  plot.x = cells_axis(rows);
  double low = INFINITY, high = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const double order = last_order(curves[i]);
    PlotCurve curve{{curves[i].points}, distinct_colour(curves[i].colour), 2, true, ""};
    curve.label = fmt::format("{}: order {:.2f}", curves[i].name, order);
    const double font = label_size(width);
    plot.right_margin =
        std::max(plot.right_margin, text_extent(curve.label, font).width + 0.8 * font);
    for (const PlotPoint& point : curves[i].points) {
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
    if (const auto triangle = order_triangle(curves[i], order)) {
      low = std::min(low, triangle->corner.y);
      plot.triangles.push_back(*triangle);
    }
    plot.curves.push_back(std::move(curve));
  }
  plot.y = Axis::decades(low / 2, high * 2);
  plot.y.title = rows.back().errors ? "error" : "relative change of u";
  return draw_plot(plot);
}

}  // namespace rfm
