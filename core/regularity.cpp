#include "core/regularity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/boolean_simplification.hpp"
#include "core/diagnosis.hpp"
#include "core/intersection.hpp"
#include "core/least_side.hpp"
#include "core/quadric.hpp"
#include "core/r_functions.hpp"
#include "core/surroundings.hpp"

namespace rfm {
namespace {

// Whether a function has one sign all over space: a square, a definite polynomial of degree 2,
// −|x|.
bool has_one_sign(const LevelFunction& level, const Field& field, double size) {
  const Interval& range = level.range();
  if (range.low >= 0 || range.high <= 0) return true;
  const std::optional<Quadric> quadric = as_quadric(field, level.dimension());
  if (!quadric || quadric->is_affine()) return false;
  const auto& [xx, xy, xz, yy, yz, zz] = quadric->square;
  const double most =
      std::max({std::fabs(xx), std::fabs(yy), std::fabs(zz), std::numeric_limits<double>::min()});
  // About its centre, where the value is 0 to rounding.
  for (const double slope : quadric->linear)
    if (std::fabs(slope) > 1e-14 * most * size) return false;
  if (std::fabs(quadric->constant) > 1e-14 * most * size * size) return false;
  // All principal minors, of A or of −A.
  const double determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const bool minors = xx * yy >= xy * xy && xx * zz >= xz * xz && yy * zz >= yz * yz;
  return minors && ((xx >= 0 && yy >= 0 && zz >= 0 && determinant >= 0) ||
                    (xx <= 0 && yy <= 0 && zz <= 0 && determinant <= 0));
}

/// The search for places where the sign of Φ depends on several primitives that vanish together.
class IrregularitySearch {
 public:
  IrregularitySearch(const RegionEvaluator& region, const Box& bounds)
      : region_(region),
        bounds_(bounds),
        smallest_(std::max((bounds.dimension == 3 ? 0x1p-5 : 0x1p-10) * bounds.longest_side(),
                           least_side(bounds))),
        signs_(region.primitive_count(), Truth::unknown) {
    for (int k = 0; k < region.primitive_count(); ++k)
      has_one_sign_.push_back(has_one_sign(region.level(k), region.region().primitives()[k]->level,
                                           bounds.longest_side()));
  }

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
  // depends on one primitive that changes its sign and is proved to be nowhere flat.
  std::vector<int> undecided(const Part& part) {
    std::vector<int> open;
    for (const BooleanExpression::Node& node : part.expression.nodes())
      if (node.kind == BooleanExpression::Kind::variable) open.push_back(node.first);
    std::ranges::sort(open);
    open.erase(std::unique(open.begin(), open.end()), open.end());
    if (open.size() == 1 && decides(open[0], part.expression) && !may_be_flat(open[0], part.box))
      open.clear();
    return open;
  }

  // Whether one side of a primitive, the only one of `expression`, is inside and the other outside,
  // and it has two sides.
  bool decides(int primitive, const BooleanExpression& expression) {
    if (has_one_sign_[primitive]) return false;
    signs_[primitive] = Truth::yes;
    const Truth above = expression.evaluate(signs_);
    signs_[primitive] = Truth::no;
    return above != expression.evaluate(signs_);
  }

  // Double zeros, and kinks of |f|, are where the gradient may be zero.
  bool may_be_flat(int primitive, const Box& box) const {
    const FunctionBounds bounds = region_.level(primitive).bounds(box);
    for (int axis = 0; axis < box.dimension; ++axis)
      if (bounds.gradient[axis].excludes_zero()) return false;
    return true;
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
      consider(double_zero(level(i), center), box);  // as isolated points are
      if (bounds_.dimension == 1) continue;
      for (std::size_t j = 0; j < i; ++j) {
        consider(common_zero(level(i), level(j), center), box);
        if (bounds_.dimension == 2) continue;
        for (std::size_t k = 0; k < j; ++k)
          consider(common_zero(level(i), level(j), level(k), center), box);
      }
    }
  }

  void consider(std::optional<Point> point, const Box& box) {
    if (!point) return;
    for (double& coordinate : *point)  // rounding beside 0
      if (std::fabs(coordinate) <= 1e-13 * bounds_.longest_side()) coordinate = 0;
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
    // One point, found from several boxes.
    if (result.extent.longest_side() <= 1e-9 * bounds_.longest_side())
      result.extent.low = result.extent.high = result.place;
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
  std::vector<bool> has_one_sign_;
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
  if (extent.longest_side() == 0) return "at " + point_text(irregularity.place, extent.dimension);
  return "between " + point_text(extent.low, extent.dimension) + " and " +
         point_text(extent.high, extent.dimension) + ", as at " +
         point_text(irregularity.place, extent.dimension);
}

}  // namespace

std::vector<Irregularity> irregularities(const RegionEvaluator& region, const Box& bounds) {
  return IrregularitySearch(region, bounds).run();
}

std::string describe(const Irregularity& irregularity, const RegionEvaluator& region,
                     bool in_weight) {
  const std::string names = names_of(irregularity.primitives, region.region());
  const std::string where = place_text(irregularity);
  const std::string vanish = irregularity.primitives.size() == 1 ? " vanishes" : " vanish together";
  if (irregularity.kind == Irregularity::Kind::dangling)
    return "the domain has a dangling piece " + where + ", where " + names + vanish +
           ": it has no interior, or is thinner than 1e-9 of the domain; integrals and "
           "conditions may not see it";
  const std::string zero =
      "the function of the domain is zero inside it " + where + ", where " + names + vanish;
  if (!in_weight) return zero + ": omega(domain) is, the weight of the structure is not";
  return zero +
         ": values prescribed by structure hold there, too; remedy: join a shape that covers the "
         "place, or take 0.5*(omega(A) - omega(B)) with B an independent expression of the "
         "complement of A as a shape";
}

bool are_formal_complements(const Region& a, const Region& b) {
  constexpr std::size_t most = 16;
  const Region either = a ^ b;
  const std::size_t count = either.primitives().size();
  if (count > most || count != a.primitives().size() || count != b.primitives().size())
    return false;
  std::array<bool, most> signs{};
  for (std::size_t bits = 0; bits < std::size_t(1) << count; ++bits) {
    for (std::size_t k = 0; k < count; ++k) signs[k] = (bits >> k & 1) != 0;
    if (!either.expression().evaluate(std::span<const bool>(signs.data(), count))) return false;
  }
  return true;
}

Field signed_function(const Region& region, const Region& complement) {
  return 0.5 * (implicit(region) - implicit(complement));
}

}  // namespace rfm
