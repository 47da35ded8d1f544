#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/boolean.hpp"
#include "core/box.hpp"
#include "core/field.hpp"
#include "core/level_function.hpp"

namespace rfm {

/// A smooth function that is positive inside, with a name. The same set is described twice:
/// `function` is normalised to first order (|∇| = 1 on the boundary) for R-functions, structures
/// and `omega(name)`; `level` is the simplest function of the same sign (a polynomial where there
/// is one), for quadrature and product weights.
struct Primitive {
  std::string name;
  Field function;
  Field level;
  /// It chooses a part and bounds nothing: its zero set meets what it helps to describe in single
  /// points at most, as the plane through the apex that chooses one nappe of a cone.
  bool selects_only = false;
  /// Its piece of the boundary goes on in another one with a common tangent. R-functions of two
  /// surfaces that touch change their slope from 1 to 2 + √2 in a layer that gets thinner towards
  /// the joint, so that quotients by them are rough.
  bool joins_smoothly = false;
};

/// A Boolean combination of primitives; a point belongs to the region where the expression is true,
/// a primitive being true where its function is ≥ 0. A value: cheap to copy.
///
///     Region ring = circle({0, 0}, 1).named("outer") - circle({0, 0}, 0.4).named("inner");
class Region {
 public:
  Region(Primitive primitive, int dimension);
  /// Many primitives at once; variable v of the expression is the sign of primitives[v]. Throws
  /// `InvalidArgument` if the expression has more variables than there are primitives.
  Region(int dimension, std::vector<std::shared_ptr<const Primitive>> primitives,
         BooleanExpression expression);

  int dimension() const { return dimension_; }
  const std::vector<std::shared_ptr<const Primitive>>& primitives() const { return primitives_; }
  const BooleanExpression& expression() const { return expression_; }
  /// The region with its primitives named after `name`: a primitive without a name gets `name`,
  /// a side `left` becomes `name.left`.
  Region named(const std::string& name) const;
  /// The same primitives, combined otherwise. Throws `InvalidArgument` if the expression has more
  /// variables than there are primitives.
  Region with_expression(BooleanExpression expression) const;
  /// The same region, of which it is known that it lies in `box`; what is known is passed on by
  /// & | - ^. Where many primitives bound a region together, as the edges of a polygon do, finding
  /// its bounding box from afar is expensive.
  Region within(const Box& box) const;
  const std::optional<Box>& enclosure() const { return enclosure_; }

  friend Region operator&(const Region& a, const Region& b);
  friend Region operator|(const Region& a, const Region& b);
  friend Region operator-(const Region& a, const Region& b);
  friend Region operator!(const Region& a);
  friend Region operator^(const Region& a, const Region& b);

 private:
  template <class Operator>
  static Region combined(const Region& a, const Region& b, Operator&& combine);

  int dimension_;
  std::vector<std::shared_ptr<const Primitive>> primitives_;
  BooleanExpression expression_;
  std::optional<Box> enclosure_;
};

Region operator&(const Region& a, const Region& b);
Region operator|(const Region& a, const Region& b);
/// a & !b.
Region operator-(const Region& a, const Region& b);
Region operator!(const Region& a);
/// Points of exactly one of the two.
Region operator^(const Region& a, const Region& b);

/// A region ready for geometric questions: the level functions of its primitives compiled. Shared
/// by quadrature, weights and bounding boxes.
class RegionEvaluator {
 public:
  explicit RegionEvaluator(const Region& region);

  const Region& region() const { return region_; }
  int dimension() const { return region_.dimension(); }
  int primitive_count() const { return static_cast<int>(levels_.size()); }
  const LevelFunction& level(int primitive) const { return levels_[primitive]; }

  /// Membership with a margin: a primitive counts as true where level ≥ −tolerance · |∇level|
  /// (a distance to first order), so that points on the boundary are inside despite rounding.
  bool contains(const Point& point, double tolerance = 0) const;
  /// Membership of a whole box, by bounds: yes, no, or unknown.
  Truth contains(const Box& box) const;

 private:
  Region region_;
  std::vector<LevelFunction> levels_;
};

}  // namespace rfm
