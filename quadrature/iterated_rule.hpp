#pragma once

#include "quadrature/gauss_legendre.hpp"
#include "quadrature/line_record.hpp"

namespace rfm {

/// Iterated Gauss rules over reduced parts of a cell. `Sink` receives
///
///     line_part(line, from, length, weight, gauss)
///         a part of a line inside; `weight` is that of the line,
///     surface_point(active, surface, inside_is_positive, point, height, weight)
///         a point on a surface; `weight` is that of its shadow in the plane across axis `height`.
///
/// Slivers take as many points as any other part. Fewer would do for the integral over the cell,
/// but there are splines that vanish everywhere but on a sliver, to a high power of the distance
/// from its edge; systems are scaled by their diagonals, so that such a spline counts as much as
/// any other and its integrals must be right relative to themselves. (With fewer points the annulus
/// of degree 5 on 64 cells was solved ten times worse, its gradient forty times.)
template <class Sink>
class IteratedRule {
 public:
  /// `intervals` is memory, used again.
  IteratedRule(int points, Sink& sink, SmoothIntervals& intervals)
      : gauss_(gauss_legendre(points)), sink_(sink), intervals_(intervals) {}

  /// The crossings of the lines of planes are written to `record`, if there is one.
  void set_record(LineRecord* record) { record_ = record; }

  int points() const { return gauss_.size(); }
  void add_line(const ActiveSet& active, SurfaceSigns parallel, const LineSegment& line,
                double weight, LineRecord* record = nullptr);
  void add_plane(const Reduction2D& reduction, double weight) {
    add_intervals(reduction, intervals_.of_plane(reduction), weight);
  }
  /// A plane whose intervals were found last, by another rule.
  void add_plane_again(const Reduction2D& reduction) {
    add_intervals(reduction, intervals_.of_last_plane(), 1);
  }
  void add_space(Reduction3D& reduction);
  /// Of these, what stands along the lines and across the axes.
  void add_walls(const Reduction2D& reduction, double weight);
  void add_walls(Reduction3D& reduction);

 private:
  void add_intervals(const Reduction2D& reduction, const std::vector<SmoothInterval>& intervals,
                     double weight);
  void add_wall(const Reduction2D& reduction, const Wall& wall, double weight);
  void add_wall(Reduction3D& reduction, const Wall& wall);

  const GaussRule& gauss_;
  Sink& sink_;
  LineRecord* record_ = nullptr;
  SmoothIntervals& intervals_;
};

template <class Sink>
void IteratedRule<Sink>::add_line(const ActiveSet& active, SurfaceSigns parallel,
                                  const LineSegment& line, double weight, LineRecord* record) {
  const LineRoots roots = find_line_roots(active, parallel, line);
  walk_line(
      active, roots, line,
      [&](const LineEnd& from, const LineEnd& to) {
        const double length = to.position - from.position;
        sink_.line_part(line, from.position, length, weight, gauss_);
      },
      [&](const LineCrossing& crossing) {
        sink_.surface_point(active, crossing.surface, crossing.inside_is_positive,
                            line.at(crossing.position), line.axis, weight);
        if (record) record->add_crossing(crossing);
      });
  if (record) record->end_line(active.inside(roots.start));
}

template <class Sink>
void IteratedRule<Sink>::add_intervals(const Reduction2D& reduction,
                                       const std::vector<SmoothInterval>& intervals,
                                       double weight) {
  if (record_) record_->begin_section();
  for (const SmoothInterval& interval : intervals) {
    if (record_) record_->begin_strip(interval);
    for (int k = 0; k < gauss_.size(); ++k)
      add_line(reduction.active(), reduction.vertical(),
               reduction.line(interval.at(gauss_.nodes[k])),
               weight * interval.length() * gauss_.weights[k], record_);
  }
  add_walls(reduction, weight);
}

template <class Sink>
void IteratedRule<Sink>::add_walls(const Reduction2D& reduction, double weight) {
  for (const auto& wall : reduction.walls()) add_wall(reduction, wall, weight);
}

template <class Sink>
void IteratedRule<Sink>::add_wall(const Reduction2D& reduction, const Wall& wall, double weight) {
  const ActiveSet& active = reduction.active();
  const LineSegment line = reduction.line(wall.position);
  const LineRoots roots = find_line_roots(active, reduction.vertical(), line);
  walk_wall(active, roots, reduction.vertical(), line, wall.left, wall.right,
            [&](const WallPart& part) {
              for (int i = 0; i < gauss_.size(); ++i)
                sink_.surface_point(active, part.surface, part.inside_is_positive,
                                    line.at(part.from.position + part.length() * gauss_.nodes[i]),
                                    reduction.base(), weight * part.length() * gauss_.weights[i]);
            });
}

template <class Sink>
void IteratedRule<Sink>::add_space(Reduction3D& reduction) {
  for (const SmoothInterval& interval : intervals_.of_space(reduction)) {
    if (record_) record_->begin_block(interval);
    for (int k = 0; k < gauss_.size(); ++k)
      add_plane(reduction.section(interval.at(gauss_.nodes[k])),
                interval.length() * gauss_.weights[k]);
  }
  add_walls(reduction);
}

template <class Sink>
void IteratedRule<Sink>::add_walls(Reduction3D& reduction) {
  for (const auto& wall : reduction.walls()) add_wall(reduction, wall);
}

// A surface across the outer axis: the section there is a piece of the boundary where the states on
// both sides differ.
template <class Sink>
void IteratedRule<Sink>::add_wall(Reduction3D& reduction, const Wall& wall) {
  const ActiveSet& active = reduction.active();
  const Reduction2D& section = reduction.section(wall.position);
  const auto& breakpoints = section.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i].position;
    const double width = breakpoints[i + 1].position - from;
    if (width <= section.negligible_width()) continue;
    for (int k = 0; k < gauss_.size(); ++k) {
      const LineSegment line = section.line(from + width * gauss_.nodes[k]);
      const LineRoots roots = find_line_roots(active, section.vertical(), line);
      walk_wall(active, roots, reduction.outer_only(), line, wall.left, wall.right,
                [&](const WallPart& part) {
                  for (int j = 0; j < gauss_.size(); ++j)
                    sink_.surface_point(
                        active, part.surface, part.inside_is_positive,
                        line.at(part.from.position + part.length() * gauss_.nodes[j]),
                        reduction.outer(),
                        width * gauss_.weights[k] * part.length() * gauss_.weights[j]);
                });
    }
  }
}

}  // namespace rfm
