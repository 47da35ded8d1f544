#include "quadrature/order_comparison.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

int compared_points(int points) { return points > 1 ? points - 1 : 2; }

// transfer[i · points + k] is the k-th Lagrange polynomial of the rule of `points` points at node i
// of the rule it is compared with.
std::span<const double> transfer_from(int points) {
  static const auto transfers = [] {
    std::array<std::vector<double>, max_gauss_points + 1> all;
    for (int from_points = 1; from_points <= max_gauss_points; ++from_points) {
      const std::span<const double> from = gauss_legendre(from_points).nodes;
      for (const double x : gauss_legendre(compared_points(from_points)).nodes)
        for (const double node : from) {
          double value = 1;
          for (const double other : from)
            if (other != node) value *= (x - other) / (node - other);
          all[from_points].push_back(value);
        }
    }
    return all;
  }();
  return transfers[points];
}

}  // namespace

void MomentSink::surface_point(const ActiveSet& active, int surface, bool, const Point& point,
                               int height, double weight) {
  if (active.numbers[surface] == ActiveSet::no_piece) return;
  Point gradient{};
  active.surfaces[surface]->value_and_gradient(point, gradient);
  surface_point(active, surface, point, gradient, height, weight);
}

void MomentSink::surface_point(const ActiveSet& active, int surface, const Point& point,
                               const Point& gradient, int height, double weight) {
  if (active.numbers[surface] == ActiveSet::no_piece) return;
  const double measure = weight * SurfaceStretch(gradient, dimension, height, steepest).stretch;
  if (std::isfinite(measure + point[height]))
    sums.add(active.is_interface(surface) ? &CellMeasure::interfaces : &CellMeasure::boundary,
             world(point), measure);
}

OrderComparison::OrderComparison(const Box& cell, CellMoments& moments, int points, bool with_first,
                                 SmoothIntervals& intervals)
    : gauss_(gauss_legendre(compared_points(points))),
      transfer_(transfer_from(points)),
      from_(points),
      sink_{cell.dimension, {cell, moments, with_first}},
      rule_(compared_points(points), sink_, intervals) {}

void OrderComparison::add_plane(const Reduction2D& reduction, const LineRecord* record) {
  if (!record) return rule_.add_plane_again(reduction);
  for (const LineRecord::Strip& strip : record->strips(0)) {
    if (strip.uniform) std::ranges::copy(record->positions(strip), recorded_.begin());
    add_strip(reduction, strip.interval, *record, strip, 1);
  }
  rule_.add_walls(reduction, 1);
}

// `recorded_` has the crossings at the nodes of the recorded rule.
void OrderComparison::add_strip(const Reduction2D& section, const SmoothInterval& interval,
                                const LineRecord& record, const LineRecord::Strip& strip,
                                double weight) {
  const ActiveSet& active = section.active();
  const std::span<const LineCrossing> crossings = record.crossings(strip);
  for (int i = 0; i < gauss_.size(); ++i) {
    const LineSegment line = section.line(interval.at(gauss_.nodes[i]));
    const double line_weight = weight * interval.length() * gauss_.weights[i];
    if (strip.uniform) {
      for (int c = 0; c < strip.crossing_count; ++c) {
        double position = 0;
        for (int k = 0; k < from_; ++k)
          position += transfer_[i * from_ + k] * recorded_[k * strip.crossing_count + c];
        positions_[c] = position;
      }
      if (follow(active, line, crossings)) {
        add_followed(active, line, crossings, strip.starts_inside, line_weight);
        continue;
      }
    }
    rule_.add_line(active, section.vertical(), line, line_weight);
  }
}

// Newton's method, with the gradient from the last step but one: it is off by as much as that step
// was long. False where the crossings are not found on the line in this order.
bool OrderComparison::follow(const ActiveSet& active, const LineSegment& line,
                             std::span<const LineCrossing> crossings) {
  constexpr double settled = 1e-12, rounding = 1e-12;
  constexpr int most_steps = 4;
  const double length = line.high - line.low;
  double before = line.low;
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const Surface& surface = *active.surfaces[crossings[c].surface];
    work_done += surface.cost().crossing;
    Point point = line.at(std::clamp(positions_[c], line.low, line.high));
    double& t = point[line.axis];
    double slope = 0;
    t -= surface.value_and_slope(point, line.axis, slope) / slope;
    double change = length;
    for (int step = 0; step < most_steps && std::fabs(change) > settled * length; ++step) {
      change = -surface.value_and_gradient(point, gradients_[c]) / gradients_[c][line.axis];
      t += change;
    }
    // Also where something is not a number.
    if (!(std::fabs(change) <= settled * length && t >= before - rounding * length &&
          t <= line.high + rounding * length))
      return false;
    before = positions_[c] = std::clamp(t, before, line.high);
  }
  return true;
}

void OrderComparison::add_followed(const ActiveSet& active, const LineSegment& line,
                                   std::span<const LineCrossing> crossings, bool starts_inside,
                                   double weight) {
  bool inside = starts_inside;
  double from = line.low;
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const LineCrossing& crossing = crossings[c];
    const double to = positions_[c];
    if (inside) sink_.line_part(line, from, to - from, weight, gauss_);
    sink_.surface_point(active, crossing.surface, line.at(to), gradients_[c], line.axis, weight);
    inside = crossing.interface || crossing.begins;
    from = to;
  }
  if (inside) sink_.line_part(line, from, line.high - from, weight, gauss_);
}

void OrderComparison::add_space(Reduction3D& reduction, const LineRecord* record) {
  if (!record) return rule_.add_space(reduction);
  for (const LineRecord::Block& block : record->blocks()) {
    const bool uniform = record->is_uniform(block);
    for (int i = 0; i < gauss_.size(); ++i) {
      const Reduction2D& section = reduction.section(block.interval.at(gauss_.nodes[i]));
      const double weight = block.interval.length() * gauss_.weights[i];
      if (uniform && find_intervals(section, *record, block, i))
        add_section(section, *record, block, i, weight);
      else
        rule_.add_plane(section, weight);
    }
  }
  rule_.add_walls(reduction);
}

// The intervals of a section at node `node` that correspond to the recorded strips: between the
// breakpoints with the same causes, where they are to be expected.
bool OrderComparison::find_intervals(const Reduction2D& section, const LineRecord& record,
                                     const LineRecord::Block& block, int node) {
  constexpr double near = 0.01;
  intervals_.clear();
  const std::size_t count = record.strips(block.first_section).size();
  const auto found = [&](auto end, std::size_t strip) -> const Reduction2D::Breakpoint* {
    double expected = 0;
    for (int k = 0; k < from_; ++k)
      expected += transfer_[node * from_ + k] *
                  (record.strips(block.first_section + k)[strip].interval.*end).position;
    const int cause = (record.strips(block.first_section)[strip].interval.*end).cause;
    const Reduction2D::Breakpoint* nearest = nullptr;
    double distance = near * section.plane().base_length();
    for (const Reduction2D::Breakpoint& breakpoint : section.breakpoints()) {
      if (breakpoint.cause != cause || std::fabs(breakpoint.position - expected) > distance)
        continue;
      nearest = &breakpoint;
      distance = std::fabs(breakpoint.position - expected);
    }
    return nearest;
  };
  for (std::size_t s = 0; s < count; ++s) {
    const auto low = found(&SmoothInterval::low, s), high = found(&SmoothInterval::high, s);
    if (!low || !high || !(low->position <= high->position)) return false;
    intervals_.push_back({*low, *high});
  }
  return true;
}

void OrderComparison::add_section(const Reduction2D& section, const LineRecord& record,
                                  const LineRecord::Block& block, int node, double weight) {
  for (std::size_t s = 0; s < intervals_.size(); ++s) {
    const LineRecord::Strip& first = record.strips(block.first_section)[s];
    std::fill_n(recorded_.begin(), from_ * first.crossing_count, 0.0);
    for (int k = 0; k < from_; ++k) {
      const double share = transfer_[node * from_ + k];
      const std::span<const double> positions =
          record.positions(record.strips(block.first_section + k)[s]);
      for (std::size_t i = 0; i < positions.size(); ++i) recorded_[i] += share * positions[i];
    }
    add_strip(section, intervals_[s], record, first, weight);
  }
  rule_.add_walls(section, weight);
}

}  // namespace rfm
