#pragma once

#include "quadrature/active_set.hpp"
#include "quadrature/line_neighbours.hpp"

namespace rfm {

/// Surfaces whose sign at an end of a segment is known although they may touch it: by their values,
/// zero up to rounding, it would be chance.
struct EndSigns {
  SurfaceSigns known = 0;
  SurfaceSigns positive = 0;

  Truth of(int surface) const {
    if (!(known >> surface & 1)) return Truth::unknown;
    return positive >> surface & 1 ? Truth::yes : Truth::no;
  }
};

/// The segment of a line parallel to `axis` through `through`.
struct LineSegment {
  Point through{};
  int axis = 0;
  double low = 0;
  double high = 0;
  /// At `low` and at `high`.
  std::array<EndSigns, 2> ends{};
  /// Tells whether surfaces that meet the line in one place are one surface; if null, they are.
  const LineNeighbours* neighbours = nullptr;

  Point at(double t) const {
    Point point = through;
    point[axis] = t;
    return point;
  }
};

/// Roots of a segment that are nearer than this are in one place.
inline double same_height(const LineSegment& line) { return 1e-13 * (line.high - line.low); }

/// Where a surface crosses a segment on which it is monotone; where it does not, the end nearer to
/// zero.
struct Crossing {
  double position = 0;
  bool exists = false;
  /// Sign at the low end.
  bool starts_positive = false;
  /// The surface passes an end of the segment within rounding: on which side of it is chance.
  bool at_end = false;
};
/// `low` and `high` tell whether the surface is positive at the ends where that is known.
Crossing find_crossing(const Surface& surface, const LineSegment& line, Truth low = Truth::unknown,
                       Truth high = Truth::unknown);

/// The same, but for the position, which is that of an end.
Crossing find_end_signs(const Surface& surface, const LineSegment& line, Truth low, Truth high);

/// The crossings of all surfaces with a segment, ascending, and the signs at its low end.
struct LineRoots {
  int count = 0;
  SurfaceSigns start = 0;
  /// Some surface passes an end of the segment within rounding.
  bool at_end = false;
  /// The first `count` have meaning.
  std::array<double, ActiveSet::capacity> positions;
  std::array<int, ActiveSet::capacity> surfaces;
  /// Bit k is set if root k is of one cluster with root k − 1: nearer than `same_height` to the
  /// first one, of a surface that is the same as far as neighbouring lines tell.
  SurfaceSigns joined = 0;

  /// One after the last root of the cluster that begins with `first`.
  int cluster_end(int first) const {
    int end = first + 1;
    while (end < count && joined >> end & 1) ++end;
    return end;
  }
};
/// Surfaces of `parallel` do not depend on the coordinate along the line: their sign is taken at
/// its middle. Where surfaces touch, so that roots are the same up to rounding, they come in the
/// order that they have on neighbouring lines.
LineRoots find_line_roots(const ActiveSet& active, SurfaceSigns parallel, const LineSegment& line);

/// An end of a part of a line: at a surface of the active set, or at an end of the segment.
struct LineEnd {
  static constexpr int segment_end = -1;
  double position = 0;
  int surface = segment_end;
};
/// A place on a line where the region begins or ends, or where an interface crosses its inside.
struct LineCrossing {
  double position = 0;
  int surface = 0;
  bool interface = false;
  /// Whether the region begins here, going up.
  bool begins = false;
  /// Whether the inside is where the surface is positive (true at interfaces).
  bool inside_is_positive = true;
};

/// Of the surfaces of a cluster of roots, `first` ≤ i < `last`, one that is a piece of the boundary
/// and bounds the region at its side `inner`; `side` if there is none. Where a curve touches the
/// side of a turned box it is the boundary: taken for the side, a length of the order of the root
/// of the rounding would be lost. In the box beyond, the region ends or begins on both at once.
inline int bounding_piece(const ActiveSet& active, const LineRoots& roots, int first, int last,
                          SurfaceSigns inner, int side) {
  for (int i = first; i < last; ++i) {
    const int surface = roots.surfaces[i];
    if (!active.is_interface(surface) && active.numbers[surface] != ActiveSet::no_piece &&
        !active.inside(inner ^ 1u << surface))
      return surface;
  }
  return side;
}

/// Walks along a segment and looks up what is inside: `on_part(LineEnd, LineEnd)` for each maximal
/// part inside that no interface cuts, `on_crossing(LineCrossing)` for each crossing, in ascending
/// order. Of a cluster of roots the total effect counts: coincident surfaces appear once, w and −w
/// leave no crack. Parts of length zero at an end still
/// count as states, so that with sign(0) = + a face on a side shared by cells is met exactly once.
template <class OnPart, class OnCrossing>
void walk_line(const ActiveSet& active, const LineRoots& roots, const LineSegment& line,
               OnPart&& on_part, OnCrossing&& on_crossing) {
  SurfaceSigns signs = roots.start;
  bool inside = active.inside(signs);
  LineEnd from{line.low, LineEnd::segment_end};
  const auto finish = [&](const LineEnd& to) {
    if (inside && to.position > from.position) on_part(from, to);
  };
  for (int next = 0; next < roots.count;) {
    const int first = next, end = roots.cluster_end(first);
    const double position = roots.positions[first];
    int decisive = -1, interface = -1;
    SurfaceSigns after = signs;
    for (; next < end; ++next) {
      const int surface = roots.surfaces[next];
      after ^= 1u << surface;
      if (active.is_interface(surface)) interface = surface;
      if (decisive < 0 && active.inside(after) != inside) decisive = surface;
    }
    const bool inside_after = active.inside(after);
    if (inside_after != inside) {
      if (active.numbers[decisive] == ActiveSet::no_piece)
        decisive = bounding_piece(active, roots, first, next, inside ? signs : after, decisive);
      finish({position, decisive});
      on_crossing(LineCrossing{position, decisive, false, inside_after,
                               inside_after == static_cast<bool>(after >> decisive & 1)});
      from = {position, decisive};
    } else if (inside && interface >= 0 && ((signs ^ after) >> interface & 1)) {
      finish({position, interface});
      on_crossing(LineCrossing{position, interface, true, true, true});
      from = {position, interface};
    }
    signs = after;
    inside = inside_after;
  }
  finish({line.high, LineEnd::segment_end});
}

/// A part of a line in a surface that is parallel to the line, on which the region begins or ends.
struct WallPart {
  LineEnd from;
  LineEnd to;
  int surface = 0;
  double length() const { return to.position - from.position; }
  bool inside_is_positive = true;
};

/// Walks along a segment within surfaces that are parallel to it: `left` and `right` are the signs
/// of the surfaces `parallel` on both sides, and `on_part(WallPart)` is called where the two states
/// differ or where an interface stands inside. `roots` are the crossings of the other surfaces.
template <class OnPart>
void walk_wall(const ActiveSet& active, const LineRoots& roots, SurfaceSigns parallel,
               const LineSegment& line, SurfaceSigns left, SurfaceSigns right, OnPart&& on_part) {
  SurfaceSigns signs = roots.start & ~parallel;
  const auto part = [&](const LineEnd& from, const LineEnd& to) {
    if (!(to.position > from.position)) return;
    SurfaceSigns current = signs | left;
    const bool inside_left = active.inside(current), inside_right = active.inside(signs | right);
    for (int surface = 0; surface < active.count; ++surface) {
      if (!((left ^ right) >> surface & 1)) continue;
      current ^= 1u << surface;
      if (inside_left != inside_right && active.inside(current) != inside_left)
        return on_part(
            WallPart{from, to, surface, inside_right == static_cast<bool>(right >> surface & 1)});
      if (inside_left && inside_right && active.is_interface(surface))
        return on_part(WallPart{from, to, surface, true});
    }
  };
  LineEnd from{line.low, LineEnd::segment_end};
  for (int i = 0; i < roots.count; ++i) {
    const LineEnd to{roots.positions[i], roots.surfaces[i]};
    part(from, to);
    signs ^= 1u << roots.surfaces[i];
    from = to;
  }
  part(from, {line.high, LineEnd::segment_end});
}

}  // namespace rfm
