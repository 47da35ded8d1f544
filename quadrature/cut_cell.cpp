#include "quadrature/cut_cell.hpp"

#include <cmath>

namespace rfm {
namespace {

class RuleBuilder : public PartVisitor {
 public:
  RuleBuilder(const Box& cell, int points, CellRule& rule)
      : cell_(cell), dimension_(cell.dimension), gauss_(gauss_legendre(points)), rule_(rule) {}

  void full(const Box& box, const Frame* frame) override;
  void reduced(const ActiveSet& active, const LineSegment& line) override;
  void reduced(const Reduction2D& reduction) override;
  void reduced(Reduction3D& reduction) override;

 private:
  void add_volume(const Point& point, double weight);
  void add_surface(const ActiveSet& active, int surface, bool inside_is_positive,
                   const Point& point, int height, double weight);
  void add_line(const ActiveSet& active, SurfaceSigns parallel, const LineSegment& line,
                double weight);
  void add_plane(const Reduction2D& reduction, double weight);
  void add_wall(const Reduction2D& reduction, const Wall& wall, double weight);
  void add_wall(Reduction3D& reduction, const Wall& wall);

  const Box& cell_;
  int dimension_;
  const GaussRule& gauss_;
  CellRule& rule_;
  const Frame* frame_ = nullptr;
};

void RuleBuilder::add_volume(const Point& point, double weight) {
  rule_.volume.add(dimension_, frame_ ? frame_->to_world(point) : point, weight);
}

// `weight` is that of the point's shadow in the plane across the axis `height`.
void RuleBuilder::add_surface(const ActiveSet& active, int surface, bool inside_is_positive,
                              const Point& point, int height, double weight) {
  if (active.numbers[surface] == ActiveSet::no_piece) return;
  // Steeper than any certified graph; only best efforts are cut off.
  constexpr double steepest = 1e4;
  Point normal{};
  active.surfaces[surface]->value_and_gradient(point, normal);
  double length = 0;
  for (int axis = 0; axis < dimension_; ++axis) length += normal[axis] * normal[axis];
  length = std::sqrt(length);
  double stretch = length / std::fabs(normal[height]);
  if (!(stretch < steepest)) stretch = steepest;
  const double scale = length > 0 ? (inside_is_positive ? -1 : 1) / length : 0.0;
  for (double& component : normal) component *= scale;
  SurfacePoints& points = active.is_interface(surface) ? rule_.interfaces : rule_.boundary;
  points.add(dimension_, frame_ ? frame_->to_world(point) : point,
             frame_ ? frame_->rotate(normal) : normal, weight * stretch, active.numbers[surface]);
}

void RuleBuilder::full(const Box& box, const Frame* frame) {
  rule_.is_full = !frame && box.low == cell_.low && box.high == cell_.high;
  frame_ = frame;
  add_tensor_rule(box, gauss_,
                  [&](const Point& point, double weight) { add_volume(point, weight); });
}

void RuleBuilder::add_line(const ActiveSet& active, SurfaceSigns parallel, const LineSegment& line,
                           double weight) {
  const LineRoots roots = find_line_roots(active, parallel, line);
  walk_line(
      active, roots, line,
      [&](const LineEnd& from, const LineEnd& to) {
        const double length = to.position - from.position;
        for (int i = 0; i < gauss_.size(); ++i)
          add_volume(line.at(from.position + length * gauss_.nodes[i]),
                     weight * length * gauss_.weights[i]);
      },
      [&](const LineCrossing& crossing) {
        add_surface(active, crossing.surface, crossing.inside_is_positive,
                    line.at(crossing.position), line.axis, weight);
      });
}

void RuleBuilder::reduced(const ActiveSet& active, const LineSegment& line) {
  frame_ = nullptr;
  add_line(active, 0, line, 1);
}

void RuleBuilder::reduced(const Reduction2D& reduction) {
  frame_ = reduction.frame();
  add_plane(reduction, 1);
}

void RuleBuilder::add_plane(const Reduction2D& reduction, double weight) {
  const auto& breakpoints = reduction.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i].position;
    const double width = breakpoints[i + 1].position - from;
    if (width <= reduction.negligible_width()) continue;
    for (int k = 0; k < gauss_.size(); ++k)
      add_line(reduction.active(), reduction.vertical(),
               reduction.line(from + width * gauss_.nodes[k]), weight * width * gauss_.weights[k]);
  }
  for (const auto& wall : reduction.walls()) add_wall(reduction, wall, weight);
}

void RuleBuilder::add_wall(const Reduction2D& reduction, const Wall& wall, double weight) {
  const ActiveSet& active = reduction.active();
  const LineSegment line = reduction.line(wall.position);
  const LineRoots roots = find_line_roots(active, reduction.vertical(), line);
  walk_wall(active, roots, reduction.vertical(), line, wall.left, wall.right,
            [&](const WallPart& part) {
              for (int i = 0; i < gauss_.size(); ++i)
                add_surface(active, part.surface, part.inside_is_positive,
                            line.at(part.from.position + part.length() * gauss_.nodes[i]),
                            reduction.base(), weight * part.length() * gauss_.weights[i]);
            });
}

void RuleBuilder::reduced(Reduction3D& reduction) {
  frame_ = nullptr;
  const auto& breakpoints = reduction.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i], width = breakpoints[i + 1] - from;
    if (width <= reduction.negligible_width()) continue;
    for (int k = 0; k < gauss_.size(); ++k)
      add_plane(reduction.section(from + width * gauss_.nodes[k]), width * gauss_.weights[k]);
  }
  for (const auto& wall : reduction.walls()) add_wall(reduction, wall);
}

// A surface across the outer axis: the section there is a piece of the boundary where the states on
// both sides differ.
void RuleBuilder::add_wall(Reduction3D& reduction, const Wall& wall) {
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
                    add_surface(active, part.surface, part.inside_is_positive,
                                line.at(part.from.position + part.length() * gauss_.nodes[j]),
                                reduction.outer(),
                                width * gauss_.weights[k] * part.length() * gauss_.weights[j]);
                });
    }
  }
}

}  // namespace

void add_cell_rule(const Box& box, const ActiveSet& active, int points, Subdivision& subdivision,
                   CellRule& rule) {
  RuleBuilder builder(box, points, rule);
  rule.uncertified += subdivision.run(box, active, builder);
}

}  // namespace rfm
