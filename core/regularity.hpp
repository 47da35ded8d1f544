#pragma once

#include <string>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// Points where the R-function of a region does not say what the region is.
///
/// R-functions count zero as both signs: where primitives vanish together, ω is zero if Φ in
/// three-valued logic (zero is "unknown") is unknown, although all points around may be inside, as
/// on the side that two rectangles share, or where three disks meet in one point of their union. A
/// weight with such a zero prescribes values inside the domain. And Φ may be true on a stratum
/// alone, with nothing but outside around it: a dangling piece, which has no interior and which
/// integrals do not see.
struct Irregularity {
  enum class Kind {
    interior_zero,  ///< ω = 0, but all points around are inside
    dangling        ///< in the region, but all points around are outside
  };
  Kind kind = Kind::interior_zero;
  /// Those that vanish there.
  std::vector<int> primitives;
  /// One of its points, near the middle.
  Point place{};
  /// The box of all its points that were found; without extent for a single point.
  Box extent;
};

/// Interior zeros and dangling pieces of a region within `bounds`, one for each set of primitives
/// that vanish together.
///
/// Boxes where the sign of Φ is proved, or where it depends on one primitive with two signs only,
/// are left out; the others are halved to 2⁻¹⁰ of the longest side (2⁻⁵ in space). In those left
/// over, common zeros of the primitives that matter are found by Newton's method, and the cells
/// around each are looked at: sectors between tangents, and 64 (128) directions. Double zeros of
/// one primitive, as isolated points are, are found in the same way. Not found are places where
/// several primitives touch without crossing and that Newton's method misses, and sectors that only
/// curvature opens.
std::vector<Irregularity> irregularities(const RegionEvaluator& region, const Box& bounds);

/// What is wrong and what can be done about it, in two sentences: for `check` and the log.
/// `in_weight`: whether the weight of a solution structure has the zero, too.
std::string describe(const Irregularity& irregularity, const RegionEvaluator& region,
                     bool in_weight = true);

/// Whether two regions are made of the same primitives (16 at most) and complements of each other
/// for all of their signs: then −ω of one is an ω of the other, with zeros in the same places.
bool are_formal_complements(const Region& a, const Region& b);

/// ½(ω_Φ − ω_Υ) for a region Φ and an expression Υ of its complement: zero on the common boundary
/// only, positive inside. ω_Φ is not positive outside and ω_Υ not inside, so that each removes the
/// interior zeros of the other. Υ must be an independent expression (with separators where it needs
/// them, see core/set_description.hpp): for the formal complement ω_Υ = −ω_Φ and nothing is gained.
/// Normalised to order 1 where both are (V. Shapiro, Acta Numerica 16 (2007), §5.3).
Field signed_function(const Region& region, const Region& complement);

}  // namespace rfm
