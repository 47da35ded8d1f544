#include "quadrature/segment_rule.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/closed_along.hpp"
#include "core/error.hpp"
#include "quadrature/gauss_legendre.hpp"

namespace rfm {
namespace {

// Intervals of t in [0, 1] on which the line is inside, ascending.
class InsideParts {
 public:
  InsideParts(const RegionEvaluator& region, const Line& line) : region_(region), line_(line) {
    divide(Interval(0, 1));
  }
  const std::vector<Interval>& parts() const { return parts_; }

 private:
  static constexpr double smallest = 0x1p-50;

  void divide(const Interval& range) {
    switch (membership(range)) {
      case Truth::no:
        return;
      case Truth::yes:
        return add(range);
      case Truth::unknown:
        break;
    }
    if (range.width() <= smallest) {
      if (region_.contains(line_.at(range.middle()))) add(range);
      return;
    }
    divide(Interval(range.low, range.middle()));
    divide(Interval(range.middle(), range.high));
  }

  Truth membership(const Interval& range) const {
    std::vector<Truth> signs;
    for (int k = 0; k < region_.primitive_count(); ++k) {
      const Interval value = region_.level(k).bounds(line_, range).value;
      signs.push_back(value.low >= 0 ? Truth::yes : value.high < 0 ? Truth::no : Truth::unknown);
    }
    return region_.region().expression().evaluate(signs);
  }

  void add(const Interval& range) {
    if (!parts_.empty() && parts_.back().high == range.low)
      parts_.back().high = range.high;
    else
      parts_.push_back(range);
  }

  const RegionEvaluator& region_;
  Line line_;
  std::vector<Interval> parts_;
};

// The primitives that vanish all along a line: of these only rounding is left, and bounds would be
// halved everywhere.
std::vector<int> vanishing_along(const RegionEvaluator& region, const Line& line, double length) {
  constexpr int samples = 9;
  std::vector<int> list;
  for (int k = 0; k < region.primitive_count(); ++k) {
    bool vanishes = true;
    for (int i = 0; i < samples && vanishes; ++i) {
      Point gradient;
      const double value =
          region.level(k).value_and_gradient(line.at((i + 0.5) / samples), gradient);
      vanishes =
          std::fabs(value) <= 1e-9 * length * std::hypot(gradient[0], gradient[1], gradient[2]);
    }
    if (vanishes) list.push_back(k);
  }
  return list;
}

Box around(const Point& from, const Point& to, int dimension, double length) {
  Box box{dimension, from, from};
  for (int axis = 0; axis < dimension; ++axis) {
    box.low[axis] = std::min(from[axis], to[axis]) - length;
    box.high[axis] = std::max(from[axis], to[axis]) + length;
  }
  return box;
}

}  // namespace

VolumePoints make_segment_rule(const RegionEvaluator& region, const Point& from, const Point& to,
                               double spacing, int points) {
  if (!(spacing > 0)) throw InvalidArgument("the spacing of a rule must be positive");
  const Line line{from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]}};
  const double length = std::hypot(line.direction[0], line.direction[1], line.direction[2]);
  const GaussRule& gauss = gauss_legendre(points);
  const std::vector<int> vanishing = vanishing_along(region, line, length);
  std::optional<RegionEvaluator> along;
  if (!vanishing.empty())
    along.emplace(closed_along(region, vanishing, around(from, to, region.dimension(), length)));
  const InsideParts inside(along ? *along : region, line);
  VolumePoints rule;
  for (const Interval& part : inside.parts()) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(part.width() * length / spacing)));
    const double step = part.width() / pieces;
    for (int i = 0; i < pieces; ++i)
      for (int k = 0; k < gauss.size(); ++k)
        rule.add(region.dimension(), line.at(part.low + step * (i + gauss.nodes[k])),
                 step * length * gauss.weights[k]);
  }
  return rule;
}

}  // namespace rfm
