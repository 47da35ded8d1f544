#include "core/boundary_piece.hpp"

#include "core/boolean_derivative.hpp"
#include "core/contact.hpp"
#include "core/r_functions.hpp"
#include "core/trim.hpp"

namespace rfm {

Side side_of(int primitive, const RegionEvaluator& region) {
  const BooleanExpression expression = region.region().expression().negations_at_leaves();
  const auto& nodes = expression.nodes();
  std::vector<bool> negated(nodes.size(), false);
  for (const auto& node : nodes)
    if (node.kind == BooleanExpression::Kind::negation) negated[node.first] = true;
  bool plain = false, subtracted = false;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].kind == BooleanExpression::Kind::variable && nodes[i].first == primitive)
      (negated[i] ? subtracted : plain) = true;
  return plain && subtracted ? Side::both : subtracted ? Side::negative : Side::positive;
}

Field outward_sign(int primitive, const RegionEvaluator& region) {
  const Side side = side_of(primitive, region);
  if (side != Side::both) return side == Side::negative ? 1.0 : -1.0;
  // Positive inside the region means that the others make it true with this one and false without.
  const BooleanExpression& whole = region.region().expression();
  const BooleanExpression inward =
      whole.restricted(primitive, true) & (!whole.restricted(primitive, false));
  return 1.0 - 2.0 * step(implicit(inward.negations_at_leaves(), region.region(), RAlpha{1}));
}

std::vector<Field> outward_normal(int primitive, const RegionEvaluator& region) {
  const Field& level = region.region().primitives()[primitive]->level;
  std::vector<Field> normal = gradient(level, region.dimension());
  Field square = 0.0;
  for (const Field& component : normal) square = square + component * component;
  const Field sign = outward_sign(primitive, region);
  for (Field& component : normal) component = sign * component / sqrt(square);
  return normal;
}

BoundaryPiece boundary_piece(int primitive, const RegionEvaluator& region, const Box& bounds) {
  const Primitive& source = *region.region().primitives()[primitive];
  BoundaryPiece piece{primitive, source.name, source.function, source.function, true};
  const Side side = side_of(primitive, region);
  if (side == Side::negative) piece.function = piece.from_inside = -source.function;
  SignTree tree(region, bounds);
  piece.whole = side != Side::both && !extends_beyond_piece(primitive, tree);
  // In another part of a union the primitive has the other sign; nowhere in the region is it 0.
  if (piece.whole && !has_sign_within(primitive, side == Side::negative, tree)) return piece;
  const BooleanExpression decides = boolean_derivative(region.region().expression(), primitive);
  const Field where = implicit(decides.negations_at_leaves(), region.region());
  if (side != Side::both) {
    // Other pieces lie on {where = 0}, on either side by rounding: away from its own surface the
    // function is positive there, too.
    const Field across =
        select(apply(Operation::less, {piece.from_inside, -1e-9 * bounds.longest_side()}),
               -piece.from_inside, piece.from_inside);
    piece.from_inside = trim_from_inside(across, where, bounds.longest_side());
  }
  piece.function =
      piece.whole ? abs(source.function) : trim(source.function, where, bounds.longest_side());
  if (side == Side::both) piece.from_inside = piece.function;
  return piece;
}

}  // namespace rfm
