#pragma once

#include "core/field.hpp"

namespace rfm {

/// The simplest function within f that is positive, zero and negative where f is: what is left when
/// increasing odd functions (odd powers, cube roots, hyperbolic and inverse tangents and sines, the
/// error function), factors that are positive everywhere (constants, exp, cosh) and negations in
/// pairs are taken off from outside. f itself if it is none of these.
///
///     cbrt(1 − r²) → 1 − r²        (1 − r²)³ → 1 − r²        2 y exp(x) → y
///
/// A level function whose zeros are simple is as good as another of the same sign, while one whose
/// slope is 0 or infinite on the boundary has neither normals nor bounds there.
Field simplest_of_same_sign(const Field& f);

}  // namespace rfm
