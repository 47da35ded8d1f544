#include "quadrature/smooth_intervals.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

using Signature = std::uint64_t;
using Breakpoint = Reduction2D::Breakpoint;

constexpr Signature something_inside = 2;

// A step of a hash: different sequences of numbers have different signatures in practice.
void extend(Signature& signature, int number) {
  signature = (signature ^ static_cast<std::uint32_t>(number)) * 0x9e3779b97f4a7c15;
  signature ^= signature >> 29;
}

// Joins an interval to the one before it if both have the same signature and nothing stands
// between them.
template <class Stands>
void add_interval(std::vector<SmoothInterval>& intervals, const SmoothInterval& next,
                  double negligible, Stands&& stands_between) {
  if (!intervals.empty()) {
    SmoothInterval& last = intervals.back();
    const double from = last.high.position, to = next.low.position;
    if (next.signature != SmoothInterval::unknown && last.signature == next.signature &&
        to - from <= negligible && !stands_between(from - negligible, to + negligible)) {
      last.high = next.high;
      return;
    }
  }
  intervals.push_back(next);
}

bool stands_between(const std::vector<Wall>& walls, double from, double to) {
  return std::ranges::any_of(
      walls, [&](const Wall& wall) { return from <= wall.position && wall.position <= to; });
}

bool lies_between(const std::vector<double>& places, double from, double to) {
  return std::ranges::any_of(places, [&](double place) { return from <= place && place <= to; });
}

constexpr Signature nothing_inside = 1;

// Of the line over an interval. Of one surface the signs at the ends of the line tell all.
Signature line_signature(const Reduction2D& reduction, const LineSegment& line) {
  const ActiveSet& active = reduction.active();
  Signature signature = nothing_inside;
  if (active.count == 1 && reduction.vertical() == 0) {
    const Crossing crossing =
        find_end_signs(*active.surfaces[0], line, line.ends[0].of(0), line.ends[1].of(0));
    if (crossing.at_end) return SmoothInterval::unknown;
    const bool positive = crossing.starts_positive;
    if (active.inside(positive) || active.inside(positive != crossing.exists)) {
      signature = something_inside;
      extend(signature, positive);
      extend(signature, crossing.exists);
    }
    return signature;
  }
  const LineRoots roots = find_line_roots(active, reduction.vertical(), line);
  if (roots.at_end) return SmoothInterval::unknown;
  walk_line(
      active, roots, line,
      [&](const LineEnd& from, const LineEnd& to) {
        if (signature == nothing_inside) signature = something_inside;
        extend(signature, from.surface);
        extend(signature, to.surface);
      },
      // A face on the side of a box bounds no part of a line that has a length.
      [&](const LineCrossing& crossing) {
        if (signature == nothing_inside) signature = something_inside;
        extend(signature, crossing.surface);
      });
  return signature;
}

}  // namespace

const std::vector<SmoothInterval>& SmoothIntervals::of_plane(const Reduction2D& reduction) {
  const auto& breakpoints = reduction.breakpoints();
  if (breakpoints.size() > 2) return with_signatures(reduction);
  plane_.assign({{breakpoints.front(), breakpoints.back()}});
  return plane_;
}

const std::vector<SmoothInterval>& SmoothIntervals::with_signatures(const Reduction2D& reduction) {
  plane_.clear();
  const auto& breakpoints = reduction.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    SmoothInterval interval{breakpoints[i], breakpoints[i + 1]};
    if (interval.length() <= reduction.negligible_width()) continue;
    const Signature signature = line_signature(reduction, reduction.line(interval.at(0.5)));
    if (signature == nothing_inside) continue;
    interval.signature = signature;
    add_interval(plane_, interval, reduction.negligible_width(), [&](double from, double to) {
      return stands_between(reduction.walls(), from, to);
    });
  }
  return plane_;
}

// Of a section: the signatures of its intervals and walls, and the curves that bound them.
SmoothIntervals::Signature SmoothIntervals::section_signature(const Reduction2D& section) {
  Signature signature = nothing_inside;
  for (const SmoothInterval& interval : with_signatures(section)) {
    if (interval.signature == SmoothInterval::unknown) return SmoothInterval::unknown;
    if (signature == nothing_inside) signature = something_inside;
    extend(signature, interval.low.cause);
    extend(signature, interval.high.cause);
    extend(signature, static_cast<int>(interval.signature));
  }
  for (const Wall& wall : section.walls()) {
    const LineSegment line = section.line(wall.position);
    const LineRoots roots = find_line_roots(section.active(), section.vertical(), line);
    if (roots.at_end) return SmoothInterval::unknown;
    walk_wall(section.active(), roots, section.vertical(), line, wall.left, wall.right,
              [&](const WallPart& part) {
                if (signature == nothing_inside) signature = something_inside;
                extend(signature, part.surface);
                extend(signature, part.from.surface);
                extend(signature, part.to.surface);
              });
  }
  return signature;
}

const std::vector<SmoothInterval>& SmoothIntervals::of_space(Reduction3D& reduction) {
  space_.clear();
  const auto& breakpoints = reduction.breakpoints();
  // Where one surface is alone every breakpoint matters.
  const bool all_matter = reduction.active().count == 1 || breakpoints.size() == 2;
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    SmoothInterval interval{{breakpoints[i]}, {breakpoints[i + 1]}};
    if (interval.length() <= reduction.negligible_width()) continue;
    if (all_matter) {
      space_.push_back(interval);
      continue;
    }
    interval.signature = section_signature(reduction.section(interval.at(0.5)));
    if (interval.signature == nothing_inside) continue;
    add_interval(space_, interval, reduction.negligible_width(), [&](double from, double to) {
      return stands_between(reduction.walls(), from, to) ||
             lies_between(reduction.contacts(), from, to);
    });
  }
  return space_;
}

}  // namespace rfm
