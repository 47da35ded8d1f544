#include "core/set_description.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/intersection.hpp"
#include "core/least_side.hpp"
#include "core/point_algebra.hpp"
#include "core/surroundings.hpp"

namespace rfm {
namespace {

/// Collects samples of all cells of the arrangement of primitives.
class CellSampler {
 public:
  CellSampler(const std::vector<Field>& primitives, const Membership& membership, const Box& bounds,
              const std::vector<std::vector<Point>>& pieces,
              std::vector<SetDescription::Sample>& samples)
      : membership_(membership), samples_(samples), dimension_(bounds.dimension) {
    for (const Field& primitive : primitives) levels_.emplace_back(primitive, dimension_);
    box_ = bounds;
    scale_ = bounds.longest_side();
    for (int axis = 0; axis < dimension_; ++axis) {
      box_.low[axis] -= 0.4871 * scale_;
      box_.high[axis] += 0.5132 * scale_;
    }
    for (const std::vector<Point>& points : pieces) add_detail(points);
  }

  void run() {
    for (const Detail& detail : details_) add_both_sides(detail);
    std::vector<Box> pending{box_};
    while (!pending.empty()) {
      const Box box = pending.back();
      pending.pop_back();
      const std::vector<int> open = undecided(box);
      if (open.empty() || box.longest_side() <= smallest_side(box)) {
        add(box.center());
        add_zeros(box, open);
        continue;
      }
      for (const Box& half : bisect(box, box.longest_axis())) pending.push_back(half);
    }
    for (const double distance : {2.0, 10.0, 100.0})
      for (const Point& d : directions()) add(moved(box_.center(), d, distance * scale_));
  }

 private:
  // A piece of the boundary: points of it, and the box that they span.
  struct Detail {
    std::vector<Point> points;
    Box box;
    double size = 0;
  };

  void add_detail(const std::vector<Point>& points) {
    if (points.empty()) return;
    Detail detail{points, {dimension_, points[0], points[0]}};
    for (const Point& point : points)
      for (int axis = 0; axis < dimension_; ++axis) {
        detail.box.low[axis] = std::min(detail.box.low[axis], point[axis]);
        detail.box.high[axis] = std::max(detail.box.high[axis], point[axis]);
      }
    detail.size = detail.box.longest_side();
    details_.push_back(std::move(detail));
  }

  // How far boxes are halved: by the resolution of the whole, or of a small piece that is near.
  double smallest_side(const Box& box) const {
    double smallest = resolution() * box_.longest_side();
    for (const Detail& detail : details_) {
      const double side = (dimension_ == 3 ? 0.25 : 0.125) * detail.size;
      if (side < smallest && is_near(box, detail.box, 0.5 * detail.size)) smallest = side;
    }
    return std::max(smallest, least_side(box_));
  }
  double resolution() const { return dimension_ == 3 ? 0x1p-5 : 0x1p-7; }

  bool is_near(const Box& box, const Box& other, double distance) const {
    for (int axis = 0; axis < dimension_; ++axis)
      if (box.low[axis] > other.high[axis] + distance ||
          other.low[axis] - distance > box.high[axis])
        return false;
    return true;
  }

  void add_both_sides(const Detail& detail) {
    for (const Point& point : detail.points)
      for (const LevelFunction& level : levels_) {
        Point normal;
        const double value = level.value_and_gradient(point, normal), slope = norm(normal);
        if (!(slope > 0) || std::fabs(value) > 1e-9 * detail.size * slope) continue;
        for (const double distance : {1e-1, 1e-2, 1e-3, 1e-5, 1e-7})
          for (const double side : {distance, -distance})
            add(along(point, side * detail.size / slope, normal));
      }
  }

  std::vector<int> undecided(const Box& box) const {
    std::vector<int> open;
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      const Interval range = levels_[k].value_bounds(box);
      if (range.contains(0)) open.push_back(static_cast<int>(k));
    }
    return open;
  }

  std::vector<Point> directions() const {
    std::vector<Point> list;
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < 64; ++i) {
      const double angle = dimension_ == 2 ? 0.05 + 2 * std::numbers::pi * i / 64 : golden * i;
      const double z = dimension_ == 3 ? 1 - (2 * i + 1) / 64.0 : 0, r = std::sqrt(1 - z * z);
      if (dimension_ == 1)
        list.push_back({i % 2 == 0 ? 1.0 : -1.0, 0, 0});
      else
        list.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
    return list;
  }

  Point moved(Point point, const Point& direction, double distance) const {
    for (int axis = 0; axis < dimension_; ++axis) point[axis] += distance * direction[axis];
    return point;
  }

  void add_zeros(const Box& box, const std::vector<int>& open) {
    // In proportion to the box: that of a small piece is small.
    const double scale = box.longest_side() / (resolution() * box_.longest_side()) * scale_;
    const auto is_near = [&](const std::optional<Point>& zero) {
      if (!zero) return false;
      for (int axis = 0; axis < dimension_; ++axis)
        if (std::fabs((*zero)[axis] - box.center()[axis]) > box.length(axis)) return false;
      return true;
    };
    for (const int k : open) {
      const auto zero = nearest_zero(levels_[k], box.center());
      if (!is_near(zero)) continue;
      add(*zero);
      // What lies on both sides: cells smaller than the box, as a small hole.
      Point normal;
      levels_[k].value_and_gradient(*zero, normal);
      const double slope = norm(normal);
      if (!(slope > 0)) continue;
      for (const double side : {1e-3, -1e-3, 1e-5, -1e-5})
        add(along(*zero, side * scale / slope, normal));
    }
    const auto consider = [&](const std::optional<Point>& zero) {
      if (!is_near(zero)) return;
      add(*zero);
      for (const double distance : {1e-3, 1e-5})
        for (const Point& d : directions()) add(moved(*zero, d, distance * scale));
    };
    for (std::size_t i = 0; i < open.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const LevelFunction &f = levels_[open[i]], &g = levels_[open[j]];
        consider(common_zero(f, g, box.center()));
        if (dimension_ == 2) continue;
        for (std::size_t k = 0; k < j; ++k)
          consider(common_zero(f, g, levels_[open[k]], box.center()));
      }
  }

  void add(const Point& point) {
    Cube signs;
    for (const LevelFunction& level : levels_) {
      Point gradient;
      const double value = level.value_and_gradient(point, gradient);
      const double slope = std::hypot(gradient[0], gradient[1], gradient[2]);
      const double unit = scale_ * std::max(slope, 1e-9 * scale_);
      const bool zero = std::fabs(value) <= 1e-11 * unit;
      // Neither on the surface nor clearly beside it: what belongs to the solid there depends on
      // another tolerance than the sign.
      if (!zero && std::fabs(value) <= 1e-9 * unit) return;
      signs.push_back(zero ? Truth::unknown : value > 0 ? Truth::yes : Truth::no);
    }
    if (!seen_[0].contains(signs) || !seen_[1].contains(signs)) {
      const Truth belongs = membership_(point);
      if (belongs == Truth::unknown) return;
      const bool inside = belongs == Truth::yes;
      if (seen_[inside].insert(signs).second) samples_.push_back({point, std::move(signs), inside});
    }
  }

  const Membership& membership_;
  std::vector<SetDescription::Sample>& samples_;
  int dimension_;
  std::vector<LevelFunction> levels_;
  Box box_;
  std::vector<Detail> details_;
  double scale_ = 1;
  std::array<std::set<Cube>, 2> seen_;
};

}  // namespace

Membership solid_membership(const RegionEvaluator& region) {
  // Of the size of the region, in any unit of length.
  const std::optional<Box>& known = region.region().enclosure();
  const double size = known && known->longest_side() > 0 ? known->longest_side() : 0.0;
  return [&region, size](const Point& point) {
    const double scale = size > 0 ? size : 1 + std::hypot(point[0], point[1], point[2]);
    const Surroundings around = surroundings(region, point, 1e-10 * scale, 1e-6 * scale);
    return around.any_inside == around.any_outside ? Truth::unknown
           : around.any_inside                     ? Truth::yes
                                                   : Truth::no;
  };
}

SetDescription::SetDescription(const std::vector<Field>& primitives, const Membership& membership,
                               const Box& bounds, const std::vector<std::vector<Point>>& pieces)
    : used_(primitives.size(), true), dimension_(bounds.dimension) {
  CellSampler(primitives, membership, bounds, pieces, samples_).run();
}

SetDescription SetDescription::restricted(const std::vector<bool>& used) const {
  SetDescription result;
  result.used_ = used;
  result.dimension_ = dimension_;
  std::array<std::set<Cube>, 2> seen;
  for (Sample sample : samples_) {
    for (std::size_t k = 0; k < used.size(); ++k)
      if (!used[k]) sample.signs[k] = Truth::unknown;
    if (seen[sample.inside].insert(sample.signs).second) result.samples_.push_back(sample);
  }
  return result;
}

SetDescription SetDescription::complement() const {
  SetDescription result = *this;
  for (Sample& sample : result.samples_) sample.inside = !sample.inside;
  return result;
}

bool SetDescription::is_in_a_cell(const Sample& sample) const {
  for (std::size_t k = 0; k < used_.size(); ++k)
    if (used_[k] && sample.signs[k] == Truth::unknown) return false;
  return true;
}

std::optional<std::pair<Point, Point>> SetDescription::conflict() const {
  for (const Sample& in : samples_) {
    if (!in.inside || !is_in_a_cell(in)) continue;
    for (const Sample& out : samples_)
      if (!out.inside && covers(in.signs, out.signs)) return std::pair(in.point, out.point);
  }
  return std::nullopt;
}

void SetDescription::require_describable() const {
  if (const auto points = conflict())
    throw InvalidArgument("the primitives do not describe the set: their signs do not separate " +
                          point_text(points->first, dimension_) + ", which belongs to it, from " +
                          point_text(points->second, dimension_) + ", which does not");
}

BooleanExpression SetDescription::canonical_form() const {
  require_describable();
  std::vector<Cube> products;
  for (const Sample& sample : samples_)
    if (sample.inside && is_in_a_cell(sample)) products.push_back(sample.signs);
  return sum_of_products(products);
}

BooleanExpression SetDescription::minimal_form() const {
  require_describable();
  std::vector<Cube> on, off;
  for (const Sample& sample : samples_)
    if (!sample.inside) off.push_back(sample.signs);
  // Common zeros inside shall be inside of some product, unless they are in the closure of the
  // outside for all that the signs say.
  for (const Sample& sample : samples_) {
    const auto touches = [&](const Cube& signs) { return covers(sample.signs, signs); };
    if (sample.inside && std::ranges::none_of(off, touches)) on.push_back(sample.signs);
  }
  return sum_of_products(*minimal_cover(on, off));
}

std::vector<bool> without_needless_separators(const SetDescription& description,
                                              int first_separator) {
  description.canonical_form();  // throws
  std::vector<bool> used(description.samples()[0].signs.size(), true);
  for (std::size_t k = first_separator; k < used.size(); ++k) {
    used[k] = false;
    if (description.restricted(used).conflict()) used[k] = true;
  }
  return used;
}

}  // namespace rfm
