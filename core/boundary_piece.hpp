#pragma once

#include <string>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// What primitive k contributes to the boundary of a region: {γ_k = 0} ∩ Λ_k, where
/// Λ_k = Φ[k := true] xor Φ[k := false] is the Boolean derivative of the region's expression Φ (the
/// places where the primitive's sign decides membership).
struct BoundaryPiece {
  int primitive = 0;
  std::string name;
  /// Zero exactly on the piece and positive elsewhere in the region: ±γ_k where its whole zero set
  /// in the closed region belongs to the piece (|γ_k| where it has both signs within, as in a union
  /// of parts that do not meet), otherwise the trim (see `trim`). Normalised.
  Field function;
  /// The same in the region and smooth across the piece: derivatives of structures may be taken at
  /// points of it that rounding puts on either side (within 10⁻⁹ of the size of the bounds). Where
  /// the region lies on both sides of the primitive there is no such function, and this is
  /// `function`.
  Field from_inside;
  /// Whether the whole zero set belongs to the piece.
  bool whole = true;
};

/// On which side of a primitive's boundary the region lies.
enum class Side {
  positive,  ///< where the primitive is positive, all along its piece
  negative,  ///< where it is negative: it is subtracted
  both       ///< here this, there that, as in an exclusive or
};
/// Decided by how the primitive occurs once negations stand on primitives only.
Side side_of(int primitive, const RegionEvaluator& region);

/// What turns the gradient of a primitive outwards on its piece: −1, or 1 where the region lies on
/// its negative side, chosen point by point where it lies on both.
Field outward_sign(int primitive, const RegionEvaluator& region);

/// The outward unit normal of a primitive's piece as fields: −∇γ/|∇γ|, the opposite where the
/// region lies on its negative side, chosen point by point where it lies on both.
std::vector<Field> outward_normal(int primitive, const RegionEvaluator& region);

/// The piece of primitive `primitive`. Whether the piece is empty is not decided here (its measure
/// tells).
BoundaryPiece boundary_piece(int primitive, const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
