#include "core/contact.hpp"

#include <cmath>
#include <vector>

#include "core/intersection.hpp"

namespace rfm {
namespace {

// What is known of all primitives over a box.
class Signs {
 public:
  Signs(const RegionEvaluator& region, const Box& box) : signs_(region.primitive_count()) {
    for (int k = 0; k < region.primitive_count(); ++k) {
      Interval bounds = region.level(k).value_bounds(box);
      if (bounds.contains(0)) bounds = region.level(k).bounds(box).value;
      // Not ≥ 0 but > 0: a zero on the very edge of the box counts as a contact.
      signs_[k] = bounds.low > 0 ? Truth::yes : bounds.high < 0 ? Truth::no : Truth::unknown;
    }
  }
  Truth of(int primitive) const { return signs_[primitive]; }
  Truth of(const BooleanExpression& expression) const { return expression.evaluate(signs_); }
  std::vector<Truth>& all() { return signs_; }

 private:
  std::vector<Truth> signs_;
};

// Visits the boxes that `undecided` keeps, halved down to `resolution` of the bounds; `leaf` looks
// at those left over and stops the search by returning false.
template <class Undecided, class Leaf>
void branch(const Box& bounds, double resolution, const Undecided& undecided, const Leaf& leaf) {
  // Enlarged a little, so that contacts on the sides of the bounding box are inside.
  Box start = bounds;
  for (int axis = 0; axis < bounds.dimension; ++axis) {
    const double margin = 1.7e-3 * bounds.longest_side();
    start.low[axis] -= margin;
    start.high[axis] += 1.1 * margin;
  }
  const double smallest = resolution * start.longest_side();
  std::vector<Box> pending{start};
  while (!pending.empty()) {
    const Box box = pending.back();
    pending.pop_back();
    if (!undecided(box)) continue;
    if (box.longest_side() <= smallest) {
      if (!leaf(box)) return;
      continue;
    }
    for (const Box& half : bisect(box, box.longest_axis())) pending.push_back(half);
  }
}

double resolution_for(int dimension) { return dimension == 3 ? 0x1p-6 : 0x1p-10; }

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

Contact contact(const Factor& a, const Factor& b, const RegionEvaluator& region,
                const Box& bounds) {
  Contact found = Contact::none;
  // Inward normals that open by at least 90° mean an interior angle of at most 90°.
  constexpr double right_angle = 1e-8;
  const double scale = bounds.longest_side();
  const auto compare = [&](const Factor::Literal& p, const Factor::Literal& q) {
    if (p.primitive == q.primitive) {
      found = Contact::obtuse;
      return;
    }
    branch(
        bounds, resolution_for(bounds.dimension),
        [&](const Box& box) {
          const Signs signs(region, box);
          return signs.of(p.primitive) == Truth::unknown &&
                 signs.of(q.primitive) == Truth::unknown &&
                 signs.of(a.expression) == Truth::unknown &&
                 signs.of(b.expression) == Truth::unknown &&
                 signs.of(region.region().expression()) != Truth::no;
        },
        [&](const Box& box) {
          const auto zero =
              common_zero(region.level(p.primitive), region.level(q.primitive), box.center());
          // Without a common zero nearby the curves touch, or pass each other closely: judged by
          // their directions.
          const Point at = zero ? *zero : box.center();
          if (zero && !inside_enlarged(box, at)) return true;
          if (zero && !region.contains(at, 1e-9 * scale)) return true;
          found = Contact::acute;
          if (cosine(p, q, region, at) > right_angle) found = Contact::obtuse;
          return found != Contact::obtuse;
        });
  };
  for (const auto& p : a.literals)
    for (const auto& q : b.literals) {
      compare(p, q);
      if (found == Contact::obtuse) return found;
    }
  return found;
}

bool meets_region(const Factor& factor, const RegionEvaluator& region, const Box& bounds) {
  bool may_meet = false;
  branch(
      bounds, resolution_for(bounds.dimension),
      [&](const Box& box) {
        const Signs signs(region, box);
        return signs.of(factor.expression) == Truth::unknown &&
               signs.of(region.region().expression()) != Truth::no;
      },
      [&](const Box&) {
        may_meet = true;
        return false;
      });
  return may_meet;
}

bool extends_beyond_piece(int primitive, const RegionEvaluator& region, const Box& bounds) {
  const BooleanExpression& whole = region.region().expression();
  const BooleanExpression both =
      whole.restricted(primitive, true) & whole.restricted(primitive, false);
  if (both.is_constant(false)) return false;
  bool may_extend = false;
  branch(
      bounds, resolution_for(bounds.dimension),
      [&](const Box& box) {
        const Signs signs(region, box);
        return signs.of(primitive) == Truth::unknown && signs.of(both) != Truth::no;
      },
      [&](const Box&) {
        may_extend = true;
        return false;
      });
  return may_extend;
}

bool has_sign_within(int primitive, bool positive, const RegionEvaluator& region,
                     const Box& bounds) {
  const BooleanExpression there = region.region().expression().restricted(primitive, positive);
  if (there.is_constant(false)) return false;
  bool may_have = false;
  branch(
      bounds, resolution_for(bounds.dimension),
      [&](const Box& box) {
        const Signs signs(region, box);
        return signs.of(primitive) != (positive ? Truth::no : Truth::yes) &&
               signs.of(there) != Truth::no;
      },
      [&](const Box&) {
        may_have = true;
        return false;
      });
  return may_have;
}

bool may_cross_within(int first, int second, const RegionEvaluator& region, const Box& bounds) {
  const BooleanExpression& whole = region.region().expression();
  BooleanExpression always = BooleanExpression::constant(true);
  for (const bool a : {false, true})
    for (const bool b : {false, true})
      always = always & whole.restricted(first, a).restricted(second, b);
  if (always.is_constant(false)) return false;
  bool may_cross = false;
  branch(
      bounds, resolution_for(bounds.dimension),
      [&](const Box& box) {
        const Signs signs(region, box);
        return signs.of(first) == Truth::unknown && signs.of(second) == Truth::unknown &&
               signs.of(always) != Truth::no;
      },
      [&](const Box&) {
        may_cross = true;
        return false;
      });
  return may_cross;
}

bool may_vanish_within(const LevelFunction& function, const RegionEvaluator& region,
                       const Box& bounds) {
  bool may_vanish = false;
  branch(
      bounds, resolution_for(bounds.dimension),
      [&](const Box& box) {
        return function.bounds(box).value.low <= 0 && region.contains(box) != Truth::no;
      },
      [&](const Box&) {
        may_vanish = true;
        return false;
      });
  return may_vanish;
}

}  // namespace rfm
