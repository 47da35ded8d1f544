#include "core/contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/intersection.hpp"

namespace rfm {
namespace {

// Cosine of the angle between the gradients, with the signs that the literals have in their
// factors.
double cosine(const Factor::Literal& a, const Factor::Literal& b, const RegionEvaluator& region,
              const Point& point) {
  Point p, q;
  region.level(a.primitive).value_and_gradient(point, p);
  region.level(b.primitive).value_and_gradient(point, q);
  const double sign = a.negated == b.negated ? 1 : -1;
  const double product = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  return sign * product / (std::hypot(p[0], p[1], p[2]) * std::hypot(q[0], q[1], q[2]));
}

bool inside_enlarged(const Box& box, const Point& point) {
  for (int axis = 0; axis < box.dimension; ++axis)
    if (point[axis] < box.low[axis] - box.length(axis) ||
        point[axis] > box.high[axis] + box.length(axis))
      return false;
  return true;
}

}  // namespace

Contact contact(const Factor& a, const Factor& b, SignTree& tree) {
  const RegionEvaluator& region = tree.region();
  Contact found = Contact::none;
  // Inward normals that open by at least 90° mean an interior angle of at most 90°.
  constexpr double right_angle = 1e-8;
  const double scale = tree.bounds().longest_side();
  const auto compare = [&](const Factor::Literal& p, const Factor::Literal& q, const Box& box) {
    const auto zero =
        common_zero(region.level(p.primitive), region.level(q.primitive), box.center());
    // Without a common zero nearby the curves touch, or pass each other closely: judged by their
    // directions.
    const Point at = zero ? *zero : box.center();
    if (zero && (!inside_enlarged(box, at) || !region.contains(at, 1e-9 * scale))) return;
    found =
        cosine(p, q, region, at) > right_angle ? Contact::obtuse : std::max(found, Contact::acute);
  };
  for (const auto& p : a.literals)
    for (const auto& q : b.literals)
      if (p.primitive == q.primitive) return Contact::obtuse;
  // One search for all pairs: of the literals of a large factor few are undecided in a box.
  const auto undecided = [](const Factor& factor, const SignTree::Node& node) {
    std::vector<Factor::Literal> literals;
    for (const Factor::Literal& literal : factor.literals)
      if (node.of(literal.primitive) == Truth::unknown) literals.push_back(literal);
    return literals;
  };
  tree.search(
      [&](const SignTree::Node& node) {
        return node.inside != Truth::no && node.of(a.expression) == Truth::unknown &&
               node.of(b.expression) == Truth::unknown;
      },
      [&](const SignTree::Node& node) {
        for (const auto& p : undecided(a, node))
          for (const auto& q : undecided(b, node)) {
            compare(p, q, node.box);
            if (found == Contact::obtuse) return false;
          }
        return true;
      });
  return found;
}

bool meets_region(const Factor& factor, SignTree& tree) {
  bool may_meet = false;
  tree.search(
      [&](const SignTree::Node& node) {
        return node.inside != Truth::no && node.of(factor.expression) == Truth::unknown;
      },
      [&](const SignTree::Node&) {
        may_meet = true;
        return false;
      });
  return may_meet;
}

bool extends_beyond_piece(int primitive, SignTree& tree) {
  const BooleanExpression& whole = tree.region().region().expression();
  const BooleanExpression both =
      whole.restricted(primitive, true) & whole.restricted(primitive, false);
  if (both.is_constant(false)) return false;
  bool may_extend = false;
  tree.search(
      [&](const SignTree::Node& node) {
        return node.of(primitive) == Truth::unknown && node.of(both) != Truth::no;
      },
      [&](const SignTree::Node&) {
        may_extend = true;
        return false;
      });
  return may_extend;
}

bool has_sign_within(int primitive, bool positive, SignTree& tree) {
  const BooleanExpression there =
      tree.region().region().expression().restricted(primitive, positive);
  if (there.is_constant(false)) return false;
  bool may_have = false;
  tree.search(
      [&](const SignTree::Node& node) {
        return node.of(primitive) != (positive ? Truth::no : Truth::yes) &&
               node.of(there) != Truth::no;
      },
      [&](const SignTree::Node&) {
        may_have = true;
        return false;
      });
  return may_have;
}

bool may_cross_within(int first, int second, SignTree& tree) {
  const BooleanExpression& whole = tree.region().region().expression();
  BooleanExpression always = BooleanExpression::constant(true);
  for (const bool a : {false, true})
    for (const bool b : {false, true})
      always = always & whole.restricted(first, a).restricted(second, b);
  if (always.is_constant(false)) return false;
  bool may_cross = false;
  tree.search(
      [&](const SignTree::Node& node) {
        return node.of(first) == Truth::unknown && node.of(second) == Truth::unknown &&
               node.of(always) != Truth::no;
      },
      [&](const SignTree::Node&) {
        may_cross = true;
        return false;
      });
  return may_cross;
}

bool may_vanish_within(const LevelFunction& function, SignTree& tree) {
  bool may_vanish = false;
  tree.search(
      [&](const SignTree::Node& node) {
        return node.inside != Truth::no && function.bounds(node.box).value.low <= 0;
      },
      [&](const SignTree::Node&) {
        may_vanish = true;
        return false;
      });
  return may_vanish;
}

}  // namespace rfm
