#include "core/reach.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace rfm {
namespace {

constexpr double nowhere = -std::numeric_limits<double>::infinity();

// A function within a box by its mean value form f(c) + Σ g_i (x_i − c_i).
struct LinearBounds {
  Interval center;
  std::array<Interval, 3> gradient;
};

LinearBounds operator-(const LinearBounds& f) {
  return {-f.center, {-f.gradient[0], -f.gradient[1], -f.gradient[2]}};
}

// f + factor · g.
LinearBounds combination(const LinearBounds& f, double factor, const LinearBounds& g) {
  LinearBounds sum{f.center + Interval(factor) * g.center, {}};
  for (int i = 0; i < 3; ++i) sum.gradient[i] = f.gradient[i] + Interval(factor) * g.gradient[i];
  return sum;
}

// The search along one axis of one box; s = ± the coordinate, so that `reach` is the largest s.
class BoxReach {
 public:
  BoxReach(const RegionEvaluator& region, const Box& box, int axis, bool upper)
      : region_(region), box_(box), axis_(axis), upper_(upper), center_(box.center()) {
    near_ = upper ? box.low[axis] : -box.high[axis];
    far_ = upper ? box.high[axis] : -box.low[axis];
    middle_ = upper ? center_[axis] : -center_[axis];
  }

  double run() {
    const int count = region_.primitive_count();
    signs_.resize(count);
    for (int k = 0; k < count; ++k) {
      const Interval value = region_.level(k).value_bounds(box_);
      signs_[k] = value.low >= 0 ? Truth::yes : value.high < 0 ? Truth::no : Truth::unknown;
    }
    const BooleanExpression& expression = region_.region().expression();
    const Truth known = expression.evaluate(signs_);
    if (known == Truth::yes) return far_;
    if (known == Truth::no) return nowhere;
    const std::unique_ptr<bool[]> relevant(new bool[count]());
    expression.mark_relevant(signs_, {relevant.get(), static_cast<std::size_t>(count)});
    for (int k = 0; k < count; ++k)
      if (relevant[k]) add_undecided(k);
    double farthest = of_expression(expression);
    if (undecided_.size() == 2) farthest = std::min(farthest, of_pair(expression));
    return farthest;
  }

 private:
  struct Undecided {
    int primitive;
    bool smooth;
    LinearBounds bounds;
    double inside, outside;  // reach of the points where the primitive is true, and where not
  };

  void add_undecided(int primitive) {
    const LevelFunction& level = region_.level(primitive);
    const FunctionBounds bounds = level.bounds(box_);
    Box point = box_;
    point.low = point.high = center_;
    const auto& slopes = bounds.gradient;
    Undecided known{primitive,
                    bounds.smooth,
                    {level.value_bounds(point), {slopes[0], slopes[1], slopes[2]}},
                    far_,
                    far_};
    if (bounds.smooth) {
      known.inside = of_positive(known.bounds);
      known.outside = of_positive(-known.bounds);
    }
    if (bounds.value.low >= 0) known.outside = nowhere;
    if (bounds.value.high < 0) known.inside = nowhere;
    undecided_.push_back(known);
  }

  // The largest s at which f ≥ 0 is possible.
  double of_positive(const LinearBounds& f) const {
    Interval across = f.center;  // f at s = middle_
    for (int i = 0; i < box_.dimension; ++i)
      if (i != axis_) across = across + f.gradient[i] * (box_.interval(i) - Interval(center_[i]));
    const Interval slope = upper_ ? f.gradient[axis_] : -f.gradient[axis_];
    const Interval high(across.high);
    if (!((high + Interval(slope.high) * (Interval(far_) - Interval(middle_))).high < 0))
      return far_;
    if (across.high >= 0)  // falls below zero beyond the middle
      return std::min(far_, (Interval(middle_) + high / Interval(-slope.high)).high);
    if ((high + Interval(slope.low) * (Interval(near_) - Interval(middle_))).high < 0)
      return nowhere;
    return (Interval(middle_) - high / Interval(slope.low)).high;
  }

  // Conjunctions reach as far as the shorter, disjunctions as the longer of their parts.
  double of_expression(const BooleanExpression& expression) const {
    struct Reach {
      double inside, outside;
    };
    std::vector<Reach> primitives(signs_.size()), nodes;
    for (std::size_t k = 0; k < signs_.size(); ++k)
      primitives[k] = {signs_[k] == Truth::no ? nowhere : far_,
                       signs_[k] == Truth::yes ? nowhere : far_};
    for (const Undecided& known : undecided_)
      primitives[known.primitive] = {known.inside, known.outside};
    using Kind = BooleanExpression::Kind;
    for (const BooleanExpression::Node& node : expression.nodes()) {
      Reach reach{};
      if (node.kind == Kind::constant) {
        reach = node.first ? Reach{far_, nowhere} : Reach{nowhere, far_};
      } else if (node.kind == Kind::variable) {
        reach = primitives[node.first];
      } else {
        const Reach a = nodes[node.first];
        if (node.kind == Kind::negation) {
          reach = {a.outside, a.inside};
        } else {
          const Reach b = nodes[node.second];
          reach = node.kind == Kind::conjunction
                      ? Reach{std::min(a.inside, b.inside), std::max(a.outside, b.outside)}
                      : Reach{std::max(a.inside, b.inside), std::min(a.outside, b.outside)};
        }
      }
      nodes.push_back(reach);
    }
    return nodes.back().inside;
  }

  // Where the region is a conjunction f ≥ 0 and g ≥ 0 of the two undecided primitives or their
  // negations, f + μ g ≥ 0 holds too, for the μ > 0 that leaves its gradient along the axis.
  double of_pair(const BooleanExpression& expression) {
    const Undecided &f = undecided_[0], &g = undecided_[1];
    if (!f.smooth || !g.smooth) return far_;
    int combinations = 0;
    bool f_is_true = false, g_is_true = false;
    for (const bool a : {false, true})
      for (const bool b : {false, true}) {
        signs_[f.primitive] = a ? Truth::yes : Truth::no;
        signs_[g.primitive] = b ? Truth::yes : Truth::no;
        if (expression.evaluate(signs_) == Truth::no) continue;
        ++combinations;
        f_is_true = a;
        g_is_true = b;
      }
    if (combinations != 1) return far_;
    const LinearBounds positive_f = f_is_true ? f.bounds : -f.bounds;
    const LinearBounds positive_g = g_is_true ? g.bounds : -g.bounds;
    double product = 0, square = 0;
    for (int i = 0; i < box_.dimension; ++i) {
      if (i == axis_) continue;
      const double slope = positive_g.gradient[i].middle();
      product += positive_f.gradient[i].middle() * slope;
      square += slope * slope;
    }
    if (!(product < 0)) return far_;
    return of_positive(combination(positive_f, -product / square, positive_g));
  }

  const RegionEvaluator& region_;
  const Box& box_;
  int axis_;
  bool upper_;
  Point center_;
  double near_, far_, middle_;
  std::vector<Truth> signs_;
  std::vector<Undecided> undecided_;
};

}  // namespace

std::optional<double> reach(const RegionEvaluator& region, const Box& box, int axis, bool upper) {
  const double farthest = BoxReach(region, box, axis, upper).run();
  if (farthest == nowhere) return {};
  return upper ? farthest : -farthest;
}

}  // namespace rfm
