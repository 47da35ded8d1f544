#include "core/boundary_piece.hpp"

#include "core/contact.hpp"
#include "core/r_functions.hpp"

namespace rfm {

Field trim(const Field& gamma, const Field& lambda) {
  const Field root = sqrt(lambda * lambda + pow(gamma, 4));
  const Field on_piece =
      abs(gamma) * sqrt(1.0 + pow(gamma, 6) / (4.0 * pow(root + lambda, 2)));
  const Field beyond = sqrt(gamma * gamma + pow(root - lambda, 2) / 4.0);
  return select(apply(Operation::less, {0.0, lambda}), on_piece, beyond);
}

BoundaryPiece boundary_piece(int primitive, const RegionEvaluator& region, const Box& bounds) {
  const BooleanExpression& whole = region.region().expression();
  const BooleanExpression with = whole.restricted(primitive, true);
  const BooleanExpression without = whole.restricted(primitive, false);
  const Primitive& source = *region.region().primitives()[primitive];
  BoundaryPiece piece{primitive, source.name, source.function, true};
  if (extends_beyond_piece(primitive, region, bounds)) {
    piece.whole = false;
    const BooleanExpression decides = (with & !without) | ((!with) & without);
    piece.function =
        trim(source.function, implicit(decides.negations_at_leaves(), region.region()));
    return piece;
  }
  // A primitive that is subtracted is negative in the region.
  if (with.is_constant(false)) piece.function = -source.function;
  return piece;
}

}  // namespace rfm
