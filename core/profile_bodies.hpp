#pragma once

#include "core/region.hpp"

namespace rfm {

/// The plane region `profile` drawn along z from `from` to `to`: its own sides, and the flat ends
/// `start` and `end`. Exact wherever the profile is, and normalised as it is. Throws
/// `InvalidArgument` unless the profile is plane and from < to.
Region extrusion(const Region& profile, double from, double to);

/// The plane region `profile` turned about the line through `center` along `axis`: its x is the
/// distance ρ from that line (what lies at x < 0 does not count), its y runs along `axis` from
/// `center`. Sides are those of the profile.
///
/// A side that is a polynomial of degree 2, P = E + xO with E and O even in x, has no kink on the
/// axis: E + ρO ≥ 0 is written with ρ² alone, as the primitive ρ²O² − E² and the signs of E and O,
/// which select only. Where O = 0 (P even in x) it is E; where E² − ρ²O² is not needed, as in a
/// torus, signs are left out. The same holds for every function whose expression shows the two
/// parts (`even_and_odd`): polynomials of any degree, functions of x². Others (sin x), and those
/// with an odd part of a profile that keeps off the axis, take ρ itself, whose gradient does not
/// exist on the axis. Normalised to first order, by eq. (4.9) where squares were taken. Throws
/// `InvalidArgument` unless the profile is plane and the axis has a direction.
Region revolution(const Region& profile, const Point& center = {0, 0, 0},
                  const Point& axis = {0, 0, 1});

}  // namespace rfm
