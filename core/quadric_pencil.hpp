#pragma once

#include <optional>

#include "core/box.hpp"
#include "core/quadric.hpp"

namespace rfm {

/// Where f has the sign `of_f` (true: f ≥ 0, false: f ≤ 0), g has the sign `of_g` and is not 0.
struct SignImplication {
  bool of_f;
  bool of_g;
};

/// What the sign of a quadric tells of that of another in a box: where h = g − λ f > 0 with λ ≥ 0,
/// f ≥ 0 implies g > 0, and so on for the other signs. The member h of the pencil is that whose
/// gradient is least in the middle of the box; nothing where it has no one sign there, and for
/// functions that are no quadrics (null). Rounded outwards.
std::optional<SignImplication> implied_signs(const Quadric* f, const Quadric* g, const Box& box);

/// Whether two quadrics are proved to vanish nowhere together in a box: where both are zero, so is
/// every f − λ g, and the member of this pencil whose gradient is least in the middle of the box
/// has one sign. Of concentric circles and spheres, coaxial cylinders and cones and parallel planes
/// it is a constant, so that they are told apart down to some 10⁻¹⁴ of the box, where bounds of
/// their slopes would need boxes as small as the gap. False where nothing is proved, and for
/// functions that are no quadrics (null). Rounded outwards.
bool are_apart(const Quadric* f, const Quadric* g, const Box& box);

}  // namespace rfm
