#include "core/region.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rfm {

Region::Region(Primitive primitive, int dimension)
    : Region(dimension, {std::make_shared<const Primitive>(std::move(primitive))},
             BooleanExpression::variable(0)) {}

Region::Region(int dimension, std::vector<std::shared_ptr<const Primitive>> primitives,
               BooleanExpression expression)
    : dimension_(dimension),
      primitives_(std::move(primitives)),
      expression_(std::move(expression)) {
  if (dimension < 1 || dimension > 3)
    throw InvalidArgument("a region has 1 to 3 dimensions, got " + std::to_string(dimension));
  if (expression_.variable_count() > static_cast<int>(primitives_.size()))
    throw InvalidArgument("an expression of " + std::to_string(expression_.variable_count()) +
                          " variables for " + std::to_string(primitives_.size()) + " primitives");
}

Region Region::named(const std::string& name) const {
  Region region = *this;
  for (auto& primitive : region.primitives_) {
    Primitive copy = *primitive;
    copy.name = copy.name.empty() ? name : name + "." + copy.name;
    primitive = std::make_shared<const Primitive>(std::move(copy));
  }
  return region;
}

Region Region::with_expression(BooleanExpression expression) const {
  if (expression.variable_count() > static_cast<int>(primitives_.size()))
    throw InvalidArgument("an expression of " + std::to_string(expression.variable_count()) +
                          " variables for a region of " + std::to_string(primitives_.size()) +
                          " primitives");
  return Region(dimension_, primitives_, std::move(expression));
}

Region Region::within(const Box& box) const {
  Region region = *this;
  region.enclosure_ = box;
  return region;
}

template <class Operator>
Region Region::combined(const Region& a, const Region& b, Operator&& combine) {
  if (a.dimension_ != b.dimension_)
    throw InvalidArgument("regions of different dimension cannot be combined");
  // A primitive that occurs in both (the same object) remains one primitive.
  std::vector<std::shared_ptr<const Primitive>> primitives = a.primitives_;
  std::vector<int> number_in_union;
  for (const auto& primitive : b.primitives_) {
    const auto known = std::ranges::find(primitives, primitive);
    number_in_union.push_back(static_cast<int>(known - primitives.begin()));
    if (known == primitives.end()) primitives.push_back(primitive);
  }
  return Region(a.dimension_, std::move(primitives),
                combine(a.expression_, b.expression_.renamed(number_in_union)));
}

namespace {

// The smallest box that holds both, or the part that they share (with negative sides if none is).
Box joined(Box a, const Box& b) {
  for (int axis = 0; axis < a.dimension; ++axis) {
    a.low[axis] = std::min(a.low[axis], b.low[axis]);
    a.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return a;
}
Box shared(Box a, const Box& b) {
  for (int axis = 0; axis < a.dimension; ++axis) {
    a.low[axis] = std::max(a.low[axis], b.low[axis]);
    a.high[axis] = std::min(a.high[axis], b.high[axis]);
  }
  return a;
}
std::optional<Box> of_union(const Region& a, const Region& b) {
  if (!a.enclosure() || !b.enclosure()) return {};
  return joined(*a.enclosure(), *b.enclosure());
}

}  // namespace

Region operator&(const Region& a, const Region& b) {
  Region region = Region::combined(a, b, [](const auto& p, const auto& q) { return p & q; });
  region.enclosure_ = a.enclosure_ && b.enclosure_ ? shared(*a.enclosure_, *b.enclosure_)
                      : a.enclosure_               ? a.enclosure_
                                                   : b.enclosure_;
  return region;
}
Region operator|(const Region& a, const Region& b) {
  Region region = Region::combined(a, b, [](const auto& p, const auto& q) { return p | q; });
  region.enclosure_ = of_union(a, b);
  return region;
}
Region operator-(const Region& a, const Region& b) {
  Region region = Region::combined(a, b, [](const auto& p, const auto& q) { return p & !q; });
  region.enclosure_ = a.enclosure_;
  return region;
}
Region operator^(const Region& a, const Region& b) {
  Region region = Region::combined(a, b, [](const auto& p, const auto& q) { return p ^ q; });
  region.enclosure_ = of_union(a, b);
  return region;
}
Region operator!(const Region& a) { return Region(a.dimension_, a.primitives_, !a.expression_); }

RegionEvaluator::RegionEvaluator(const Region& region) : region_(region) {
  for (const auto& primitive : region.primitives())
    levels_.emplace_back(primitive->level, region.dimension());
}

bool RegionEvaluator::contains(const Point& point, double tolerance) const {
  // With a margin a primitive near zero may count as either, so that !a is closed as well.
  std::vector<Truth> signs(levels_.size());
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    if (tolerance == 0) {
      signs[k] = levels_[k].value(point) >= 0 ? Truth::yes : Truth::no;
      continue;
    }
    Point gradient;
    const double value = levels_[k].value_and_gradient(point, gradient);
    double margin = tolerance * std::hypot(gradient[0], gradient[1], gradient[2]);
    if (!std::isfinite(margin)) margin = 0;
    // Where the function is undefined the point is outside.
    signs[k] = value > margin ? Truth::yes : value >= -margin ? Truth::unknown : Truth::no;
  }
  return region_.expression().evaluate(signs) != Truth::no;
}

Truth RegionEvaluator::contains(const Box& box) const {
  std::vector<Truth> signs(levels_.size());
  const auto sign = [](const Interval& bounds) {
    return bounds.low >= 0 ? Truth::yes : bounds.high < 0 ? Truth::no : Truth::unknown;
  };
  for (std::size_t k = 0; k < levels_.size(); ++k) signs[k] = sign(levels_[k].value_bounds(box));
  const Truth quick = region_.expression().evaluate(signs);
  if (quick != Truth::unknown) return quick;
  // Bounds of second order where plain intervals are undecided.
  for (std::size_t k = 0; k < levels_.size(); ++k)
    if (signs[k] == Truth::unknown) signs[k] = sign(levels_[k].bounds(box).value);
  return region_.expression().evaluate(signs);
}

}  // namespace rfm
