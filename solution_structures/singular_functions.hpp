#pragma once

#include "core/box.hpp"
#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

// What smooth bases cannot follow, as factors of undetermined functions (Shapiro 2007, §7.3).

/// A corner in the plane: θ runs from `first` counter-clockwise over `opening`, both in radians.
struct Corner {
  Point vertex{};
  double first = 0;
  double opening = 0;
};
/// r^α sin αθ, harmonic for every α; zero on both sides for α = kπ/opening. The angle jumps outside
/// of the corner, opposite to its middle. Its derivatives do not exist at the vertex for α < 1.
/// Throws `InvalidArgument` unless 0 < opening ≤ 2π and α > 0.
Field corner_sine(const Corner& corner, double alpha);
/// r^α cos αθ.
Field corner_cosine(const Corner& corner, double alpha);

/// A function that jumps across the crack {γ = 0, λ ≥ 0}, changing its sign there, and is smooth
/// elsewhere: √r sin(θ/2) in the plane of (λ, γ),
///
///     sign(γ) √((√(λ² + γ²) + λ)/2).
///
/// λ vanishes at the tip with slope 1; two tips a distance d apart have λ = (d²/4 − s²)/d with s
/// from the middle. Where λ is not linear the field next to the tip is √r sin(θ/2) to first order.
/// On the crack it has the values of the side γ > 0.
Field crack_function(const Field& gamma, const Field& lambda);
/// u = Ψ1 + χ Ψ2: displacements that jump freely across a crack, with the opening √r at its tip.
Structure cracked(const Field& gamma, const Field& lambda,
                  const Structure& psi1 = Structure::undetermined(0),
                  const Structure& psi2 = Structure::undetermined(1));

/// `structure` + `factor` s Ψ: a singular function with a smooth amplitude. `factor` vanishes where
/// s does not satisfy the conditions, to the order in which they are prescribed.
Structure enriched(const Structure& structure, const Field& factor, const Field& singular,
                   const Structure& psi);

/// `structure` + `factor` ω₁^{m+1} H(ω₁) Ψ₁: more freedom within {ω₁ > 0}, m times differentiable
/// across its edge (Tsukanov and Shapiro 2007). `factor` vanishes with the conditions of the
/// boundary. Windows may overlap, meet the boundary and be nested. Throws `InvalidArgument` for a
/// negative m.
Structure windowed(const Structure& structure, const Field& factor, const Field& omega, int m,
                   const Structure& psi);

}  // namespace rfm
