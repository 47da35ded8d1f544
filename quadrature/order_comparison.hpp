#pragma once

#include "quadrature/cell_moments.hpp"
#include "quadrature/iterated_rule.hpp"
#include "quadrature/line_record.hpp"

namespace rfm {

/// Adds up what a rule says of volume and boundary, and makes no points.
struct MomentSink {
  int dimension;
  MomentSums sums;
  const Frame* frame = nullptr;
  double steepest = SurfaceStretch::steepest_graph;

  Point world(const Point& point) const { return frame ? frame->to_world(point) : point; }
  void line_part(const LineSegment& line, double from, double length, double weight,
                 const GaussRule&) {
    if (!std::isfinite(from + length * weight)) return;
    sums.add(&CellMeasure::volume, world(line.at(from + 0.5 * length)), weight * length);
  }
  void surface_point(const ActiveSet& active, int surface, bool, const Point& point, int height,
                     double weight);
  /// The same where the gradient is known.
  void surface_point(const ActiveSet& active, int surface, const Point& point,
                     const Point& gradient, int height, double weight);
};

/// Volume and boundary by the Gauss rule of another order than the one of which points are kept:
/// one point fewer (of one, one more). All nodes are different, but the structure is
/// the same, and where the record of the first rule shows that lines meet the same surfaces all
/// along an interval, their crossings are found by Newton's method from the polynomial through the
/// recorded ones, instead of from both ends of the line: two evaluations instead of five. What does
/// not converge to a crossing on the line, in order, is found as usual.
class OrderComparison {
 public:
  /// `points` is that of the recorded rule, `intervals` those that it used last.
  OrderComparison(const Box& cell, CellMoments& moments, int points, bool with_first,
                  SmoothIntervals& intervals);

  void set_frame(const Frame* frame) { sink_.frame = frame; }
  /// See `SurfaceStretch`.
  void set_steepest(double steepest) { sink_.steepest = steepest; }
  void add_line(const ActiveSet& active, const LineSegment& line) {
    rule_.add_line(active, 0, line, 1);
  }
  /// `record` is that of the other rule on this part; null where structure is not proven.
  void add_plane(const Reduction2D& reduction, const LineRecord* record);
  void add_space(Reduction3D& reduction, const LineRecord* record);

 private:
  void add_strip(const Reduction2D& section, const SmoothInterval& interval,
                 const LineRecord& record, const LineRecord::Strip& strip, double weight);
  bool follow(const ActiveSet& active, const LineSegment& line,
              std::span<const LineCrossing> crossings);
  void add_followed(const ActiveSet& active, const LineSegment& line,
                    std::span<const LineCrossing> crossings, bool starts_inside, double weight);
  bool find_intervals(const Reduction2D& section, const LineRecord& record,
                      const LineRecord::Block& block, int node);
  void add_section(const Reduction2D& section, const LineRecord& record,
                   const LineRecord::Block& block, int node, double weight);

  const GaussRule& gauss_;
  std::span<const double> transfer_;
  int from_;
  MomentSink sink_;
  IteratedRule<MomentSink> rule_;
  /// Of a strip: crossing by crossing, at the nodes of the recorded rule in a section.
  std::array<double, max_gauss_points * ActiveSet::capacity> recorded_;
  std::vector<SmoothInterval> intervals_;
  /// Of a line.
  std::array<double, ActiveSet::capacity> positions_;
  std::array<Point, ActiveSet::capacity> gradients_;
};

}  // namespace rfm
