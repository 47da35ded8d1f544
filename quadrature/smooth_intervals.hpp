#pragma once

#include <cstdint>

#include "quadrature/reduction_3d.hpp"

namespace rfm {

/// An interval of a base or outer axis over which integrals along lines (over sections) are smooth.
struct SmoothInterval {
  Reduction2D::Breakpoint low, high;
  /// Names the surfaces that bound what is inside; `unknown` if this was not asked or is left open.
  std::uint64_t signature = unknown;
  static constexpr std::uint64_t unknown = 0;

  double length() const { return high.position - low.position; }
  double at(double t) const { return low.position + length() * t; }
};

/// Finds the intervals over which an iterated Gauss rule is to be applied.
///
/// Not every breakpoint of a reduction matters: a surface may enter the box, or two surfaces may
/// cross, where the region does not depend on them. Across a breakpoint at which the inside parts
/// of lines keep the surfaces that bound them, the integral along lines is analytic, because each
/// of these surfaces is a graph on both sides; such neighbours are one interval, but in space not
/// across a place where surfaces touch. Intervals over
/// which nothing is inside are left out. In a cell where many surfaces cross this saves most of the
/// points. Where a surface lies on a side of the box up to rounding intervals stay as they are: the
/// boxes on both sides then see it at the same places, and it is counted once.
class SmoothIntervals {
 public:
  /// The intervals of the base axis; the reference is valid until the next call.
  const std::vector<SmoothInterval>& of_plane(const Reduction2D& reduction);
  /// Those that were found last.
  const std::vector<SmoothInterval>& of_last_plane() const { return plane_; }
  /// The intervals of the outer axis. Changes the section of `reduction`.
  const std::vector<SmoothInterval>& of_space(Reduction3D& reduction);

 private:
  using Signature = std::uint64_t;

  const std::vector<SmoothInterval>& with_signatures(const Reduction2D& reduction);
  Signature section_signature(const Reduction2D& section);

  std::vector<SmoothInterval> plane_, space_;
};

}  // namespace rfm
