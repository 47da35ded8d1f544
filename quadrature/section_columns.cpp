#include "quadrature/section_columns.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

using Breakpoint = Reduction2D::Breakpoint;

// The n-th breakpoint with a cause.
const Breakpoint* find_breakpoint(const std::vector<Breakpoint>& breakpoints, int cause, int n) {
  for (const Breakpoint& breakpoint : breakpoints)
    if (breakpoint.cause == cause && n-- == 0) return &breakpoint;
  return nullptr;
}

}  // namespace

SectionColumns::SectionColumns(Reduction3D& reduction, double from, double to, int steps)
    : middle(0.5 * (from + to)) {
  const Reduction2D& section = reduction.section(middle);
  at_middle = section.breakpoints();
  walls = section.walls();
  for (int i = 0; i <= steps; ++i)
    columns.push_back(i == steps ? to : from + (to - from) * i / steps);
  for (int i = 0; i <= steps; ++i) {
    // At the ends of an interval a curve may be missing by rounding: follow it from inside, along
    // its tangent.
    const double inwards = i == 0 ? 1 : i == steps ? -1 : 0;
    const double nudge = 1e-6 * inwards * (to - from);
    const auto here = reduction.section(columns[i]).breakpoints();
    auto near = here, far = here;
    if (inwards != 0) {
      near = reduction.section(columns[i] + nudge).breakpoints();
      far = reduction.section(columns[i] + 2 * nudge).breakpoints();
    }
    positions.push_back(column_positions(reduction, here, near, far));
  }
  fill_gaps();
}

double SectionColumns::widest(int strip) const {
  double width = 0;
  for (const auto& column : positions) width = std::max(width, column[strip + 1] - column[strip]);
  return width;
}

std::vector<double> SectionColumns::column_positions(const Reduction3D& reduction,
                                                     const std::vector<Breakpoint>& here,
                                                     const std::vector<Breakpoint>& near,
                                                     const std::vector<Breakpoint>& far) const {
  const double low = reduction.box().low[reduction.inner()];
  const double high = reduction.box().high[reduction.inner()];
  std::vector<double> result;
  for (std::size_t b = 0; b < at_middle.size(); ++b) {
    const int cause = at_middle[b].cause;
    const int n =
        static_cast<int>(std::count_if(at_middle.begin(), at_middle.begin() + b,
                                       [&](const Breakpoint& o) { return o.cause == cause; }));
    const Breakpoint *const p = find_breakpoint(here, cause, n),
                            *const q = find_breakpoint(near, cause, n),
                            *const r = find_breakpoint(far, cause, n);
    double position = std::nan("");
    if (p)
      position = p->position;
    else if (q && r)
      position = std::clamp(2 * q->position - r->position, low, high);
    result.push_back(position);
  }
  return result;
}

// What is not known in a column is taken from the nearest that knows it.
void SectionColumns::fill_gaps() {
  const int count = static_cast<int>(positions.size());
  for (std::size_t b = 0; b < at_middle.size(); ++b)
    for (int i = 0; i < count; ++i)
      for (int step = 1; std::isnan(positions[i][b]) && step <= count; ++step) {
        for (const int other : {i - step, i + step})
          if (other >= 0 && other < count && std::isnan(positions[i][b]))
            positions[i][b] = positions[other][b];
        if (step == count) positions[i][b] = at_middle[b].position;
      }
  for (auto& column : positions)
    for (std::size_t b = 1; b < column.size(); ++b) column[b] = std::max(column[b], column[b - 1]);
}

}  // namespace rfm
