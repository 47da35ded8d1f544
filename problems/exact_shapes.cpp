#include "problems/exact_shapes.hpp"

#include <numbers>

#include "core/exact_distances.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

/// Numbers and points that were read before without a mistake.
class Values {
 public:
  Values(const DocumentNode& node, const ValueReader& values) : node_(node), values_(values) {}

  std::optional<Field> distance(const std::string& kind) const {
    if (kind == "circle" || kind == "sphere")
      return ball_distance(point("center"), number("radius"), kind == "circle" ? 2 : 3);
    if (kind == "cylinder")
      return cylinder_distance(point("center"), point("axis"), number("radius"));
    if (kind == "cone")
      return cone_distance(point("apex"), point("axis"), number("angle") * radians_per_degree);
    if (kind == "torus")
      return torus_distance(point("center"), point("axis"), number("radius"), number("tube"));
    if (kind == "capsule") return capsule_distance(point("from"), point("to"), number("radius"));
    if (kind == "ellipse")
      return ellipsoid_distance(point("center"), point("radii"), {0, 0, 1},
                                number("angle") * radians_per_degree, 2);
    if (kind == "ellipsoid") {
      const DocumentNode* rotate = values_.find(node_, "rotate");
      if (!rotate) return ellipsoid_distance(point("center"), point("radii"), {0, 0, 1}, 0, 3);
      const Values turn(*rotate, values_);
      return ellipsoid_distance(point("center"), point("radii"), turn.point("axis"),
                                turn.number("angle") * radians_per_degree, 3);
    }
    return std::nullopt;
  }
  std::optional<Field> whole(const std::string& kind) const {
    if (kind == "box") {
      const std::optional<Box> box = values_.box(node_);
      return box ? box_distance(box->low, box->high, values_.dimension) : std::optional<Field>();
    }
    if (kind == "strip") return strip_distance(point("point"), point("normal"), number("width"));
    if (kind == "sector")
      return sector_distance(point("center"), number("radius"), number("from") * radians_per_degree,
                             number("to") * radians_per_degree, number("inner_radius"));
    return std::nullopt;
  }

 private:
  double number(const char* key) const {
    const DocumentNode* value = values_.find(node_, key);
    return value ? values_.number(*value).value_or(0) : 0;
  }
  Point point(const char* key) const {
    const DocumentNode* value = values_.find(node_, key);
    return value ? values_.point(*value).value_or(Point{}) : Point{};
  }

  const DocumentNode& node_;
  const ValueReader& values_;
};

bool asks_for_it(const DocumentNode& node, const ValueReader& values) {
  const DocumentNode* exact = node.is_map() ? values.find(node, "exact") : nullptr;
  return exact && exact->text == "true" && values.mistakes.empty();
}

}  // namespace

Region with_exact_distance(const Region& region, const std::string& kind, const DocumentNode& node,
                           const ValueReader& values) {
  if (!asks_for_it(node, values)) return region;
  if (kind == "sector") return with_exact_sides(region);
  const std::optional<Field> distance = Values(node, values).distance(kind);
  return distance ? with_function(region, *distance) : region;
}

std::optional<Field> whole_distance(const std::string& kind, const DocumentNode& node,
                                    const ValueReader& values) {
  if (!asks_for_it(node, values)) return std::nullopt;
  return Values(node, values).whole(kind);
}

}  // namespace rfm
