#pragma once

#include <algorithm>
#include <cmath>

#include "quadrature/gauss_legendre.hpp"
#include "quadrature/reduction_3d.hpp"

namespace rfm {

/// Iterated Gauss rules over reduced parts of a cell. `Sink` receives
///
///     line_part(line, from, length, weight, gauss)
///         a part of a line inside; `weight` is that of the line,
///     surface_point(active, surface, inside_is_positive, point, height, weight)
///         a point on a surface; `weight` is that of its shadow in the plane across axis `height`.
template <class Sink>
class IteratedRule {
 public:
  IteratedRule(int points, Sink& sink)
      : points_(points), gauss_(gauss_legendre(points)), sink_(sink) {}

  void add_line(const ActiveSet& active, SurfaceSigns parallel, const LineSegment& line,
                double weight);
  void add_plane(const Reduction2D& reduction, double weight);
  void add_space(Reduction3D& reduction);

 private:
  const GaussRule& rule_for(double length, double whole) const;
  void add_wall(const Reduction2D& reduction, const Wall& wall, double weight);
  void add_wall(Reduction3D& reduction, const Wall& wall);

  int points_;
  const GaussRule& gauss_;
  Sink& sink_;
};

/// Slivers take fewer points: where the integrand is resolved by `points_` points over the whole
/// box, k points over a fraction f of it have an error of f²ᵏ⁺¹, here below rounding. The order is
/// kept, and so is exactness for polynomials, up to rounding.
template <class Sink>
const GaussRule& IteratedRule<Sink>::rule_for(double length, double whole) const {
  constexpr double sliver = 0.06, rounding = 36.8;  // −log of 1e-16
  if (!(length < sliver * whole)) return gauss_;
  const int enough = static_cast<int>(std::ceil(rounding / (2 * std::log(whole / length))));
  return enough < points_ ? gauss_legendre(std::max(enough, 1)) : gauss_;
}

template <class Sink>
void IteratedRule<Sink>::add_line(const ActiveSet& active, SurfaceSigns parallel,
                                  const LineSegment& line, double weight) {
  const LineRoots roots = find_line_roots(active, parallel, line);
  walk_line(
      active, roots, line,
      [&](const LineEnd& from, const LineEnd& to) {
        const double length = to.position - from.position;
        sink_.line_part(line, from.position, length, weight,
                        rule_for(length, line.high - line.low));
      },
      [&](const LineCrossing& crossing) {
        sink_.surface_point(active, crossing.surface, crossing.inside_is_positive,
                            line.at(crossing.position), line.axis, weight);
      });
}

template <class Sink>
void IteratedRule<Sink>::add_plane(const Reduction2D& reduction, double weight) {
  const auto& breakpoints = reduction.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i].position;
    const double width = breakpoints[i + 1].position - from;
    if (width <= reduction.negligible_width()) continue;
    const GaussRule& gauss = rule_for(width, reduction.plane().base_length());
    for (int k = 0; k < gauss.size(); ++k)
      add_line(reduction.active(), reduction.vertical(),
               reduction.line(from + width * gauss.nodes[k]), weight * width * gauss.weights[k]);
  }
  for (const auto& wall : reduction.walls()) add_wall(reduction, wall, weight);
}

template <class Sink>
void IteratedRule<Sink>::add_wall(const Reduction2D& reduction, const Wall& wall, double weight) {
  const ActiveSet& active = reduction.active();
  const LineSegment line = reduction.line(wall.position);
  const LineRoots roots = find_line_roots(active, reduction.vertical(), line);
  walk_wall(active, roots, reduction.vertical(), line, wall.left, wall.right,
            [&](const WallPart& part) {
              const GaussRule& gauss = rule_for(part.length(), line.high - line.low);
              for (int i = 0; i < gauss.size(); ++i)
                sink_.surface_point(active, part.surface, part.inside_is_positive,
                                    line.at(part.from.position + part.length() * gauss.nodes[i]),
                                    reduction.base(), weight * part.length() * gauss.weights[i]);
            });
}

template <class Sink>
void IteratedRule<Sink>::add_space(Reduction3D& reduction) {
  const auto& breakpoints = reduction.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i], width = breakpoints[i + 1] - from;
    if (width <= reduction.negligible_width()) continue;
    const GaussRule& gauss = rule_for(width, reduction.box().length(reduction.outer()));
    for (int k = 0; k < gauss.size(); ++k)
      add_plane(reduction.section(from + width * gauss.nodes[k]), width * gauss.weights[k]);
  }
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
    const GaussRule& across = rule_for(width, section.plane().base_length());
    for (int k = 0; k < across.size(); ++k) {
      const LineSegment line = section.line(from + width * across.nodes[k]);
      const LineRoots roots = find_line_roots(active, section.vertical(), line);
      walk_wall(active, roots, reduction.outer_only(), line, wall.left, wall.right,
                [&](const WallPart& part) {
                  const GaussRule& along = rule_for(part.length(), line.high - line.low);
                  for (int j = 0; j < along.size(); ++j)
                    sink_.surface_point(
                        active, part.surface, part.inside_is_positive,
                        line.at(part.from.position + part.length() * along.nodes[j]),
                        reduction.outer(),
                        width * across.weights[k] * part.length() * along.weights[j]);
                });
    }
  }
}

}  // namespace rfm
