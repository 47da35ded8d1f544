#include "quadrature/cut_cell.hpp"

#include <algorithm>
#include <cmath>

#include "quadrature/iterated_rule.hpp"

namespace rfm {
namespace {

// In steps of `work_done`: mostly the time to touch new memory.
constexpr int work_of_point = 4;

// A gradient at a surface, and by how much the surface is larger than its shadow across `height`.
struct SurfaceNormal {
  SurfaceNormal(const Surface& surface, const Point& point, int dimension, int height) {
    surface.value_and_gradient(point, gradient);
    for (int axis = 0; axis < dimension; ++axis) length += gradient[axis] * gradient[axis];
    length = std::sqrt(length);
    // Steeper than any certified graph; only best efforts are cut off.
    constexpr double steepest = 1e4;
    stretch = length / std::fabs(gradient[height]);
    if (!(stretch < steepest)) stretch = steepest;
  }
  Point gradient{};
  double length = 0;
  double stretch = 0;
};

// Adds up what a rule says of the cell, in the coordinates of the cell.
struct MomentSums {
  const Box& cell;
  CellMoments& moments;
  bool with_first;

  void add(double CellMeasure::*part, const Point& point, double weight) {
    moments.measure.*part += weight;
    if (!with_first) return;
    for (int axis = 0; axis < cell.dimension; ++axis)
      moments.first[axis].*part +=
          weight * (2 * (point[axis] - cell.low[axis]) / cell.length(axis) - 1);
  }
};

// Makes points and weights.
struct PointSink {
  int dimension;
  CellRule& rule;
  MomentSums sums;
  const Frame* frame = nullptr;

  Point world(const Point& point) const { return frame ? frame->to_world(point) : point; }

  void volume_point(const Point& point, double weight) {
    rule.volume.add(dimension, world(point), weight);
  }

  void line_part(const LineSegment& line, double from, double length, double weight,
                 const GaussRule& gauss) {
    work_done += work_of_point * gauss.size();
    Point point = line.through;
    for (int i = 0; i < gauss.size(); ++i) {
      point[line.axis] = from + length * gauss.nodes[i];
      volume_point(point, weight * length * gauss.weights[i]);
    }
    sums.add(&CellMeasure::volume, world(line.at(from + 0.5 * length)), weight * length);
  }

  void surface_point(const ActiveSet& active, int surface, bool inside_is_positive,
                     const Point& point, int height, double weight) {
    if (active.numbers[surface] == ActiveSet::no_piece) return;
    work_done += active.surfaces[surface]->cost().crossing;
    const SurfaceNormal at(*active.surfaces[surface], point, dimension, height);
    const double scale = at.length > 0 ? (inside_is_positive ? -1 : 1) / at.length : 0.0;
    Point normal{};
    for (int axis = 0; axis < dimension; ++axis) normal[axis] = scale * at.gradient[axis];
    SurfacePoints& points = active.is_interface(surface) ? rule.interfaces : rule.boundary;
    points.add(dimension, world(point), frame ? frame->rotate(normal) : normal, weight * at.stretch,
               active.numbers[surface]);
    if (!active.is_interface(surface))
      sums.add(&CellMeasure::boundary, world(point), weight * at.stretch);
  }
};

// Only adds up what the rule of another order says of volume and boundary.
struct MomentSink {
  int dimension;
  MomentSums sums;
  const Frame* frame = nullptr;

  Point world(const Point& point) const { return frame ? frame->to_world(point) : point; }

  void line_part(const LineSegment& line, double from, double length, double weight,
                 const GaussRule&) {
    sums.add(&CellMeasure::volume, world(line.at(from + 0.5 * length)), weight * length);
  }
  void surface_point(const ActiveSet& active, int surface, bool, const Point& point, int height,
                     double weight) {
    if (active.numbers[surface] == ActiveSet::no_piece || active.is_interface(surface)) return;
    const SurfaceNormal at(*active.surfaces[surface], point, dimension, height);
    sums.add(&CellMeasure::boundary, world(point), weight * at.stretch);
  }
};

class RuleBuilder : public PartVisitor {
 public:
  RuleBuilder(const Box& cell, const CellRuleOptions& options, CellRule& rule)
      : cell_(cell),
        inside_gauss_(gauss_legendre(options.inside_points)),
        inside_count_(power(options.inside_points, cell.dimension)),
        rule_(rule),
        sink_{cell.dimension,
              rule,
              {cell, rule.moments, options.compare_orders && options.points > 2}},
        points_(options.points, sink_),
        compare_(options.compare_orders),
        other_sink_{cell.dimension, {cell, rule.other_moments, options.points > 2}},
        others_(other_points(options.points), other_sink_) {}

  void full(const Box& box, const Frame* frame) override {
    rule_.is_full = !frame && box.low == cell_.low && box.high == cell_.high;
    sink_.frame = frame;
    work_done += work_of_point * inside_count_;
    add_tensor_rule(box, inside_gauss_,
                    [&](const Point& point, double weight) { sink_.volume_point(point, weight); });
    boundary_before_ = rule_.moments.measure.boundary;
  }
  void reduced(const ActiveSet& active, const LineSegment& line) override {
    begin_part(nullptr);
    add([&](auto& rule) { rule.add_line(active, 0, line, 1); });
  }
  void reduced(const Reduction2D& reduction) override {
    begin_part(reduction.frame());
    add([&](auto& rule) { rule.add_plane(reduction, 1); });
  }
  void reduced(Reduction3D& reduction) override {
    begin_part(nullptr);
    add([&](auto& rule) { rule.add_space(reduction); });
  }
  void not_certified() override {
    rule_.uncertified.boundary += rule_.moments.measure.boundary - boundary_before_;
  }

  void limit_points(int most) override { most_points_ = most; }

 private:
  static int other_points(int points) { return points > 1 ? points - 1 : 2; }

  // By the rules of both orders, or by others with fewer points.
  template <class Add>
  void add(Add&& add_to) {
    if (most_points_ >= points_.points()) {
      add_to(points_);
      if (compare_) add_to(others_);
      return;
    }
    IteratedRule<PointSink> fewer(most_points_, sink_);
    add_to(fewer);
    if (!compare_) return;
    IteratedRule<MomentSink> others(other_points(most_points_), other_sink_);
    add_to(others);
  }

  void begin_part(const Frame* frame) {
    sink_.frame = other_sink_.frame = frame;
    boundary_before_ = rule_.moments.measure.boundary;
  }

  static std::int64_t power(int base, int exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
  }

  const Box& cell_;
  const GaussRule& inside_gauss_;
  std::int64_t inside_count_;
  CellRule& rule_;
  PointSink sink_;
  double boundary_before_ = 0;  // of the part that is being made
  int most_points_ = unlimited;
  IteratedRule<PointSink> points_;
  bool compare_;
  MomentSink other_sink_;
  IteratedRule<MomentSink> others_;
};

// The largest of measure and first moments.
double difference(double CellMeasure::*part, const CellRule& rule) {
  double largest = std::fabs(rule.moments.measure.*part - rule.other_moments.measure.*part);
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max(
        largest, std::fabs(rule.moments.first[axis].*part - rule.other_moments.first[axis].*part));
  return largest;
}

}  // namespace

void add_cell_rule(const Box& box, const ActiveSet& active, const CellRuleOptions& options,
                   Subdivision& subdivision, CellRule& rule) {
  rule.moments = rule.other_moments = {};
  RuleBuilder builder(box, options, rule);
  // The budget is for six points along an axis: more are asked for to be exact, and paid extra.
  constexpr double usual_points = 6;
  const double extra = std::max(1.0, std::pow(options.points / usual_points, box.dimension - 1));
  rule.uncertified += subdivision.run(box, active, builder, extra * options.share);
  if (!options.compare_orders) return;
  rule.order_difference.volume += difference(&CellMeasure::volume, rule);
  rule.order_difference.boundary += difference(&CellMeasure::boundary, rule);
}

}  // namespace rfm
