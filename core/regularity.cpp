#include "core/regularity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/boolean_simplification.hpp"
#include "core/diagnosis.hpp"
#include "core/intersection.hpp"
#include "core/least_side.hpp"
#include "core/r_functions.hpp"
#include "core/surroundings.hpp"

namespace rfm {
namespace {

/// The search for places where the sign of Φ depends on several primitives that vanish together.
class IrregularitySearch {
 public:
  IrregularitySearch(const RegionEvaluator& region, const Box& bounds)
      : region_(region),
        bounds_(bounds),
        smallest_(std::max((bounds.dimension == 3 ? 0x1p-5 : 0x1p-10) * bounds.longest_side(),
                           least_side(bounds))),
        signs_(region.primitive_count(), Truth::unknown) {}

  std::vector<Irregularity> run() {
    Box start = bounds_;  // enlarged, so that what lies on its sides is inside
    for (int axis = 0; axis < bounds_.dimension; ++axis) {
      start.low[axis] -= 1.3e-3 * bounds_.longest_side();
      start.high[axis] += 1.7e-3 * bounds_.longest_side();
    }
    std::vector<Part> pending{{start, region_.region().expression()}};
    while (!pending.empty()) {
      const Part part = narrowed(pending.back());
      pending.pop_back();
      const std::vector<int> open = undecided(part);
      if (open.empty()) continue;
      if (part.box.longest_side() <= smallest_) {
        look_at(part.box, open);
        continue;
      }
      for (const Box& half : bisect(part.box, part.box.longest_axis()))
        pending.push_back({half, part.expression});
    }
    std::vector<Irregularity> list;
    for (const auto& [key, points] : found_) list.push_back(gathered(key, points));
    const std::vector<Irregularity> all = list;
    std::erase_if(list, [&](const Irregularity& one) {
      return std::ranges::any_of(all, [&](const auto& other) { return ends(one, other); });
    });
    return list;
  }

 private:
  using Key = std::pair<Irregularity::Kind, std::vector<int>>;

  // A box, and Φ over it: in the primitives that are not decided there.
  struct Part {
    Box box;
    BooleanExpression expression;
  };

  // With what bounds over the box decide, those of second order where the quick ones leave Φ open.
  Part narrowed(Part part) {
    for (const bool tight : {false, true}) {
      for (const BooleanExpression::Node& node : part.expression.nodes()) {
        if (node.kind != BooleanExpression::Kind::variable) continue;
        const LevelFunction& level = region_.level(node.first);
        const Interval range = tight ? level.bounds(part.box).value : level.value_bounds(part.box);
        signs_[node.first] = range.low > 0    ? Truth::yes
                             : range.high < 0 ? Truth::no
                                              : Truth::unknown;
      }
      part.expression = with_known_signs(part.expression, signs_);
    }
    return part;
  }

  // The primitives on which the sign of Φ over a box may depend; none where it is proved, or
  // depends on one primitive that changes its sign.
  std::vector<int> undecided(const Part& part) {
    std::vector<int> open;
    for (const BooleanExpression::Node& node : part.expression.nodes())
      if (node.kind == BooleanExpression::Kind::variable) open.push_back(node.first);
    std::ranges::sort(open);
    open.erase(std::unique(open.begin(), open.end()), open.end());
    if (open.size() == 1 && decides(open[0], part.expression)) open.clear();
    return open;
  }

  // Whether one side of a primitive, the only one of `expression`, is inside and the other outside,
  // and it has two sides.
  bool decides(int primitive, const BooleanExpression& expression) {
    const Interval& range = region_.level(primitive).range();
    if (range.low >= 0 || range.high <= 0) return false;
    signs_[primitive] = Truth::yes;
    const Truth above = expression.evaluate(signs_);
    signs_[primitive] = Truth::no;
    return above != expression.evaluate(signs_);
  }

  void look_at(const Box& box, const std::vector<int>& open) {
    constexpr std::size_t most = 12;  // that may vanish together; more are looked at in part
    const std::size_t count = std::min(open.size(), most);
    const auto level = [&](std::size_t i) -> const LevelFunction& {
      return region_.level(open[i]);
    };
    const Point center = box.center();
    for (std::size_t i = 0; i < count; ++i) {
      consider(nearest_zero(level(i), center), box);
      if (bounds_.dimension == 1) continue;
      for (std::size_t j = 0; j < i; ++j) {
        consider(common_zero(level(i), level(j), center), box);
        if (bounds_.dimension == 2) continue;
        for (std::size_t k = 0; k < j; ++k)
          consider(common_zero(level(i), level(j), level(k), center), box);
      }
    }
  }

  void consider(const std::optional<Point>& point, const Box& box) {
    if (!point) return;
    for (int axis = 0; axis < box.dimension; ++axis)
      if (std::fabs((*point)[axis] - box.center()[axis]) > box.length(axis)) return;
    const double scale = bounds_.longest_side();
    // Once, however many boxes and pairs of primitives it is found from.
    std::array<double, 3> rounded{};
    for (int axis = 0; axis < box.dimension; ++axis)
      rounded[axis] = std::round((*point)[axis] / (1e-10 * scale));
    if (!seen_.insert(rounded).second) return;
    Surroundings around = surroundings(region_, *point, 1e-9 * scale, 1e-5 * scale);
    if (region_.region().expression().evaluate(around.signs) != Truth::unknown) return;
    if (around.any_inside && around.any_outside) return;
    const auto kind =
        around.any_inside ? Irregularity::Kind::interior_zero : Irregularity::Kind::dangling;
    found_[{kind, std::move(around.vanishing)}].push_back(*point);
  }

  // Whether `one` is an end of the line or face `other`, where further primitives vanish.
  bool ends(const Irregularity& one, const Irregularity& other) const {
    if (one.kind != other.kind || other.primitives.size() >= one.primitives.size() ||
        !std::ranges::includes(one.primitives, other.primitives))
      return false;
    for (int axis = 0; axis < bounds_.dimension; ++axis)
      if (one.place[axis] < other.extent.low[axis] - 4 * smallest_ ||
          one.place[axis] > other.extent.high[axis] + 4 * smallest_)
        return false;
    return true;
  }

  Irregularity gathered(const Key& key, const std::vector<Point>& points) const {
    Irregularity result{key.first, key.second, points[0],
                        Box{bounds_.dimension, points[0], points[0]}};
    for (const Point& point : points)
      for (int axis = 0; axis < bounds_.dimension; ++axis) {
        result.extent.low[axis] = std::min(result.extent.low[axis], point[axis]);
        result.extent.high[axis] = std::max(result.extent.high[axis], point[axis]);
      }
    const Point middle = result.extent.center();
    const auto distance = [&](const Point& p) {
      return std::hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]);
    };
    result.place = *std::ranges::min_element(points, {}, distance);
    return result;
  }

  const RegionEvaluator& region_;
  const Box& bounds_;
  double smallest_;
  std::vector<Truth> signs_;  // of the primitives of the part looked at
  std::map<Key, std::vector<Point>> found_;
  std::set<std::array<double, 3>> seen_;
};

std::string names_of(const std::vector<int>& primitives, const Region& region) {
  std::string text;
  for (std::size_t i = 0; i < primitives.size(); ++i)
    text += (i == 0                       ? ""
             : i + 1 == primitives.size() ? " and "
                                          : ", ") +
            region.primitives()[primitives[i]]->name;
  return text;
}

// "at (1, 0.5)", "from (1, 0) to (1, 1)".
std::string place_text(const Irregularity& irregularity) {
  const Box& extent = irregularity.extent;
  if (extent.longest_side() < 1e-6) return "at " + point_text(irregularity.place, extent.dimension);
  return "between " + point_text(extent.low, extent.dimension) + " and " +
         point_text(extent.high, extent.dimension) + ", as at " +
         point_text(irregularity.place, extent.dimension);
}

}  // namespace

std::vector<Irregularity> irregularities(const RegionEvaluator& region, const Box& bounds) {
  return IrregularitySearch(region, bounds).run();
}

std::string describe(const Irregularity& irregularity, const RegionEvaluator& region) {
  const std::string names = names_of(irregularity.primitives, region.region());
  const std::string where = place_text(irregularity);
  const std::string vanish = irregularity.primitives.size() == 1 ? " vanishes" : " vanish together";
  if (irregularity.kind == Irregularity::Kind::dangling)
    return "the domain has a dangling piece " + where + ", where " + names + vanish +
           ": it has no interior, and neither integrals nor conditions see it";
  return "the function of the domain is zero inside it " + where + ", where " + names + vanish +
         ": values prescribed by structure hold there, too; remedy: join a shape that covers the "
         "place, or take 0.5*(omega(A) - omega(B)) with B an independent expression of the "
         "complement of A as a shape";
}

Field signed_function(const Region& region, const Region& complement) {
  return 0.5 * (implicit(region) - implicit(complement));
}

}  // namespace rfm
