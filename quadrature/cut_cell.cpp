#include "quadrature/cut_cell.hpp"

#include <algorithm>
#include <cmath>

#include "quadrature/box_sides.hpp"
#include "quadrature/order_comparison.hpp"

namespace rfm {
namespace {

// In steps of `work_done`: mostly the time to touch new memory.
constexpr int work_of_point = 4;

// Where a surface is as steep as a cube root at its zero there is a direction beside it.
Point surface_gradient(const Surface& surface, const Point& point, int height) {
  constexpr double beside = 1e-9;
  Point gradient{};
  surface.value_and_gradient(point, gradient);
  const auto is_known = [&] {
    const double size = std::fabs(gradient[0]) + std::fabs(gradient[1]) + std::fabs(gradient[2]);
    return size > 0 && std::isfinite(size);
  };
  for (const double step : {beside, -beside}) {
    if (is_known()) break;
    Point near = point;
    near[height] += step * std::max(1e-3, std::fabs(point[height]));
    surface.value_and_gradient(near, gradient);
  }
  return gradient;
}

// Makes points and weights.
struct PointSink {
  int dimension;
  CellRule& rule;
  MomentSums sums;
  const Frame* frame = nullptr;
  double steepest = SurfaceStretch::steepest_graph;
  /// Some points of the part could not be made.
  bool misses_points = false;

  Point world(const Point& point) const { return frame ? frame->to_world(point) : point; }

  void volume_point(const Point& point, double weight) {
    rule.volume.add(dimension, world(point), weight);
  }

  void line_part(const LineSegment& line, double from, double length, double weight,
                 const GaussRule& gauss) {
    work_done += work_of_point * gauss.size();
    if (!std::isfinite(from) || !std::isfinite(length * weight)) {
      misses_points = true;
      return;
    }
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
    Point gradient = surface_gradient(*active.surfaces[surface], point, height);
    const SurfaceStretch at(gradient, dimension, height, steepest);
    if (!(at.stretch > 0) || !std::isfinite(point[height] + weight)) {
      misses_points = true;
      return;
    }
    const double scale = (inside_is_positive ? -1 : 1) / at.length;
    Point normal{};
    for (int axis = 0; axis < dimension; ++axis) normal[axis] = scale * gradient[axis];
    SurfacePoints& points = active.is_interface(surface) ? rule.interfaces : rule.boundary;
    points.add(dimension, world(point), frame ? frame->rotate(normal) : normal, weight * at.stretch,
               active.numbers[surface]);
    sums.add(active.is_interface(surface) ? &CellMeasure::interfaces : &CellMeasure::boundary,
             world(point), weight * at.stretch);
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
        points_(options.points, sink_, rule.intervals),
        compare_(options.compare_orders),
        others_(cell, rule.other_moments, options.points, options.points > 2, rule.intervals) {}

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
    points_.add_line(active, 0, line, 1);
    if (compare_) others_.add_line(active, line);
  }
  void reduced(const Reduction2D& reduction) override {
    begin_part(reduction.frame());
    add(
        reduction.active(), [&](auto& rule) { rule.add_plane(reduction, 1); },
        [&](auto& others, const LineRecord* record) { others.add_plane(reduction, record); });
    end_part(reduction.plane().box);
  }
  void reduced(Reduction3D& reduction) override {
    begin_part(nullptr);
    add(
        reduction.active(), [&](auto& rule) { rule.add_space(reduction); },
        [&](auto& others, const LineRecord* record) { others.add_space(reduction, record); });
    end_part(reduction.box());
  }
  void not_certified(double missing) override {
    rule_.uncertified.boundary +=
        std::max(missing, rule_.moments.measure.boundary - boundary_before_);
  }

  void begin(const PartQuality& quality) override { quality_ = quality; }

 private:
  // By the rules of both orders, or by others with fewer points.
  template <class Add, class Compare>
  void add(const ActiveSet& active, Add&& add_to, Compare&& compare) {
    if (quality_.most_points < points_.points()) {
      IteratedRule<PointSink> fewer(quality_.most_points, sink_, rule_.intervals);
      add_to(fewer);
      if (!compare_) return;
      OrderComparison others(cell_, rule_.other_moments, quality_.most_points,
                             sink_.sums.with_first(), rule_.intervals);
      others.set_frame(sink_.frame);
      others.set_steepest(sink_.steepest);
      compare(others, nullptr);
      return;
    }
    LineRecord* const record = compare_ && is_followed(active) ? &rule_.lines : nullptr;
    if (record) record->clear();
    points_.set_record(record);
    add_to(points_);
    if (!compare_) return;
    others_.set_frame(sink_.frame);
    compare(others_, record);
  }

  // Only where structure is proven do the lines of one rule tell where to look for those of the
  // other; on quadrics roots in closed form are no dearer.
  bool is_followed(const ActiveSet& active) const {
    bool all_closed = true;
    for (int i = 0; i < active.count; ++i) all_closed &= active.surfaces[i]->quadric() != nullptr;
    return quality_.proven && !all_closed;
  }

  void begin_part(const Frame* frame) {
    sink_.frame = frame;
    boundary_before_ = rule_.moments.measure.boundary;
    sink_.misses_points = false;
    sink_.steepest =
        quality_.proven ? SurfaceStretch::steepest_graph : SurfaceStretch::steepest_guess;
    others_.set_steepest(sink_.steepest);
  }

  // Points that are no numbers are left out.
  void end_part(const Box& box) {
    if (!sink_.misses_points) return;
    ++rule_.uncertified.boxes;
    rule_.uncertified.measure += box.measure();
    rule_.uncertified.boundary += measure_of_sides(box);
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
  PartQuality quality_;
  IteratedRule<PointSink> points_;
  bool compare_;
  OrderComparison others_;
};

// Where errors fall by a quarter or more with each point, the difference to the rule of one fewer
// is at least a third of the error of the better one.
constexpr double errors_in_a_difference = 3;

// The largest of measure and first moments.
double difference(double CellMeasure::*part, const CellRule& rule) {
  double largest = std::fabs(rule.moments.measure.*part - rule.other_moments.measure.*part);
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max(
        largest, std::fabs(rule.moments.first[axis].*part - rule.other_moments.first[axis].*part));
  return errors_in_a_difference * largest;
}

}  // namespace

void add_cell_rule(const Box& box, const ActiveSet& active, const CellRuleOptions& options,
                   Subdivision& subdivision, CellRule& rule) {
  rule.moments = rule.other_moments = {};
  RuleBuilder builder(box, options, rule);
  // The budget is for six points along an axis: more are asked for to be exact, and paid extra.
  constexpr double usual_points = 6;
  const double extra = options.points > usual_points
                           ? std::pow(options.points / usual_points, box.dimension - 1)
                           : 1;
  rule.uncertified += subdivision.run(box, active, builder, extra * options.share);
  if (!options.compare_orders) return;
  rule.order_difference.volume += difference(&CellMeasure::volume, rule);
  rule.order_difference.boundary += difference(&CellMeasure::boundary, rule);
  rule.order_difference.interfaces += difference(&CellMeasure::interfaces, rule);
}

}  // namespace rfm
