#pragma once

#include "core/sign_tree.hpp"

namespace rfm {

/// Part of a Boolean expression as a set of its own, for questions of where its boundary lies.
struct Factor {
  BooleanExpression expression;
  /// The primitives that occur, each with whether it occurs negated.
  struct Literal {
    int primitive;
    bool negated;
  };
  std::vector<Literal> literals;
};

/// How the boundaries of two factors of a conjunction meet in the closed region.
enum class Contact {
  none,    ///< proved not to meet
  acute,   ///< they meet, at interior angles of at most 90° wherever they do
  obtuse,  ///< they meet at an interior angle beyond 90°, or tangentially from the same side
};

/// Decided by branch and bound: boxes of the tree where neither a sign nor the region's membership
/// is proved are halved, and common zeros near those left over are found by Newton's method.
Contact contact(const Factor& a, const Factor& b, SignTree& tree);

/// Whether the boundary of a factor may meet the closed region (false is proved).
bool meets_region(const Factor& factor, SignTree& tree);

/// A point in the closed region and on {primitive = 0} where the region's membership does not
/// depend on that primitive's sign may exist (false is proved): then the primitive's zero set goes
/// on into the region beyond the piece of boundary that it contributes.
bool extends_beyond_piece(int primitive, SignTree& tree);

/// Whether the primitive may be positive (`positive`) or negative (not) somewhere in the region
/// (false is proved).
bool has_sign_within(int primitive, bool positive, SignTree& tree);

/// Whether the zero sets of two primitives may meet inside the region, where its membership depends
/// on neither (false is proved).
bool may_cross_within(int first, int second, SignTree& tree);

/// Whether `function` may be zero or negative somewhere in the region (false is proved).
bool may_vanish_within(const LevelFunction& function, SignTree& tree);

}  // namespace rfm
