#include "core/same_solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/boolean_simplification.hpp"
#include "core/point_algebra.hpp"

namespace rfm {
namespace {

constexpr std::size_t most_open = 8;  // primitives all of whose signs are tried
constexpr int most_boxes = 1 << 18;

struct Sides {
  Point gradient{};  // of a plane; zero for what is curved
  int leader = 0;    // the first primitive that this one is a multiple of
  bool opposite = false;
};

/// The comparison of two expressions box by box.
class Comparison {
 public:
  Comparison(const RegionEvaluator& region, const Box& bounds) : region_(region), box_(bounds) {
    scale_ = bounds.longest_side();
    for (int axis = 0; axis < bounds.dimension; ++axis) {
      box_.low[axis] -= 1.3e-3 * scale_;
      box_.high[axis] += 1.7e-3 * scale_;
    }
    for (int k = 0; k < region.primitive_count(); ++k) {
      Sides sides;
      sides.leader = k;
      for (int j = 0; j < k && sides.leader == k; ++j)
        if (const double ratio = ratio_of_multiples(region.level(k), region.level(j), bounds)) {
          sides.leader = j;
          sides.opposite = ratio < 0;
        }
      Point low, high;
      region.level(k).value_and_gradient(box_.low, low);
      region.level(k).value_and_gradient(box_.high, high);
      if (region.level(k).is_quadric() && norm(difference(low, high)) <= 1e-14 * norm(low))
        sides.gradient = low;
      sides_.push_back(sides);
    }
    signs_.resize(sides_.size());
  }

  bool run(const BooleanExpression& a, const BooleanExpression& b) {
    struct Part {
      Box box;
      BooleanExpression a, b;
    };
    std::vector<Part> pending{{box_, a, b}};
    for (int boxes = 0; !pending.empty(); ++boxes) {
      Part part = pending.back();
      pending.pop_back();
      const std::vector<int> open = bound(part.box);
      part.a = with_known_signs(part.a, signs_);
      part.b = with_known_signs(part.b, signs_);
      if (open.size() <= most_open && agree(part.a, part.b, open, part.box)) continue;
      if (open.empty() || part.box.longest_side() <= 0x1p-40 * scale_ || boxes >= most_boxes)
        return false;
      for (const Box& half : bisect(part.box, part.box.longest_axis()))
        pending.push_back({half, part.a, part.b});
    }
    return true;
  }

 private:
  // Signs over a box into `signs_`; the leaders that are open.
  std::vector<int> bound(const Box& box) {
    std::vector<int> open;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      if (sides_[k].leader != static_cast<int>(k)) {
        follow(k);
        continue;
      }
      const Interval range = region_.level(k).value_bounds(box);
      signs_[k] = range.low > 0 ? Truth::yes : range.high < 0 ? Truth::no : Truth::unknown;
      if (signs_[k] == Truth::unknown) open.push_back(static_cast<int>(k));
    }
    return open;
  }

  void follow(std::size_t k) {
    const Truth sign = signs_[sides_[k].leader];
    signs_[k] = sign == Truth::unknown || !sides_[k].opposite ? sign
                : sign == Truth::yes                          ? Truth::no
                                                              : Truth::yes;
  }

  // Whether a and b have the same value for all signs of the open primitives that may occur.
  bool agree(const BooleanExpression& a, const BooleanExpression& b, const std::vector<int>& open,
             const Box& box) {
    for (unsigned choice = 0; choice < 1u << open.size(); ++choice) {
      for (std::size_t i = 0; i < open.size(); ++i)
        signs_[open[i]] = (choice >> i & 1) != 0 ? Truth::yes : Truth::no;
      for (std::size_t k = 0; k < sides_.size(); ++k)
        if (sides_[k].leader != static_cast<int>(k)) follow(k);
      if (a.evaluate(signs_) != b.evaluate(signs_) && !is_excluded(open, box)) return false;
    }
    return true;
  }

  // Whether no point has the signs of `signs_`: some of the planes, each counted positive on its
  // side, have a sum with positive factors that is nowhere positive.
  bool is_excluded(const std::vector<int>& open, const Box& box) const {
    std::vector<Point> normals;
    std::vector<double> values;
    for (const int k : open) {
      const double sign = signs_[k] == Truth::yes ? 1 : -1, slope = norm(sides_[k].gradient);
      if (!(slope > 0)) continue;
      const Point& g = sides_[k].gradient;
      normals.push_back({sign * g[0] / slope, sign * g[1] / slope, sign * g[2] / slope});
      values.push_back(sign * region_.level(k).value(box.center()) / slope);
    }
    const std::size_t count = normals.size();
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) {
          const Point line = cross(normals[i], normals[j]);
          if (excludes({i, j, k},
                       {dot(line, cross(normals[j], normals[k])),
                        dot(line, cross(normals[k], normals[i])), dot(line, line)},
                       normals, values))
            return true;
          for (std::size_t l = 0; l < k; ++l)
            if (excludes({i, j, k, l},
                         {dot(normals[j], cross(normals[k], normals[l])),
                          -dot(normals[i], cross(normals[k], normals[l])),
                          dot(normals[i], cross(normals[j], normals[l])), -dot(line, normals[k])},
                         normals, values))
              return true;
        }
    return false;
  }

  // Whether these factors are all positive (or all negative), and the sum is a constant and not
  // positive.
  bool excludes(const std::vector<std::size_t>& which, const std::vector<double>& factors,
                const std::vector<Point>& normals, const std::vector<double>& values) const {
    Point slope{};
    double sum = 0, size = 0;
    for (std::size_t m = 0; m < which.size(); ++m) {
      const double factor = factors[0] < 0 ? -factors[m] : factors[m];
      if (!(factor > 1e-12)) return false;
      for (int axis = 0; axis < 3; ++axis) slope[axis] += factor * normals[which[m]][axis];
      sum += factor * values[which[m]];
      size += factor;
    }
    return norm(slope) <= 1e-12 * size && sum <= 1e-11 * size * scale_;
  }

  const RegionEvaluator& region_;
  Box box_;
  double scale_;
  std::vector<Sides> sides_;
  std::vector<Truth> signs_;
};

}  // namespace

double ratio_of_multiples(const LevelFunction& f, const LevelFunction& g, const Box& bounds) {
  const auto ratio = [&](double s) {
    Point at = bounds.low;
    for (int axis = 0; axis < bounds.dimension; ++axis)
      at[axis] += bounds.length(axis) * std::fmod(s * (axis + 1.37), 1.0);
    return f.value(at) / g.value(at);
  };
  const double first = ratio(0.217);
  if (!std::isfinite(first)) return 0;
  const bool constant = std::ranges::all_of(std::array{0.381, 0.533, 0.741, 0.917}, [&](double s) {
    return std::fabs(ratio(s) - first) <= 1e-11 * std::fabs(first);
  });
  return constant ? first : 0;
}

bool same_solid(const BooleanExpression& a, const BooleanExpression& b,
                const RegionEvaluator& region, const Box& bounds) {
  return Comparison(region, bounds).run(a, b);
}

}  // namespace rfm
