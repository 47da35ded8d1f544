// Shapes made of other shapes: extrusions and revolutions of plane profiles, similarities; of the
// sets around them; and of coefficients.

#include <cmath>
#include <numbers>

#include "core/mapped_region.hpp"
#include "core/primitives.hpp"
#include "core/profile_bodies.hpp"
#include "problems/described_solids.hpp"
#include "problems/result_scope.hpp"
#include "problems/shape_reader.hpp"

namespace rfm {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

// The region with the names of its sides as they are within the shape `of`: `left` for `of.left`.
// The name of a shape without sides is kept if `keep_plain`.
Region with_own_names(const Region& region, const std::string& of, bool keep_plain) {
  const Region result = mapped_region(region, [&](const Primitive& primitive) {
    Primitive renamed = primitive;
    if (renamed.name == of && !keep_plain) renamed.name.clear();
    if (renamed.name.starts_with(of + ".")) renamed.name.erase(0, of.size() + 1);
    return MappedPrimitive(Region(std::move(renamed), region.dimension()));
  });
  return region.enclosure() ? result.within(*region.enclosure()) : result;
}

}  // namespace

// Profiles have a reader of their own: plane shapes, whose formulas know x and y.
struct ShapeReader::Profiles {
  Profiles(const DocumentNode& root, ValueReader plane, SetReader& sets)
      : values(std::move(plane)), shapes(root, values, sets, "profiles") {}
  ValueReader values;
  ShapeReader shapes;
};

void ShapeReader::read_profiles() {
  const DocumentNode* geometry = values_.find(root_, "geometry");
  if (list_ != "shapes" || !geometry || !values_.find(*geometry, "profiles")) return;
  ValueReader plane = values_;
  plane.dimension = 2;
  plane.scope.refuse("z", "is not a coordinate of a profile: x and y are");
  profiles_ = std::make_shared<Profiles>(root_, std::move(plane), sets_);
}

void ShapeReader::report_unused_profiles() {
  if (!profiles_) return;
  profiles_->shapes.read_all();  // mistakes of those that nothing names
  profiles_->shapes.report_unused();
}

Region ShapeReader::derived_shape(const std::string& kind, const DocumentNode& node) {
  if (kind == "extrusion") return build_extrusion(node);
  if (kind == "revolution") return build_revolution(node);
  return build_transform(node);
}

std::optional<Region> ShapeReader::profile(const DocumentNode& node) {
  const DocumentNode* text = values_.find(node, "profile");
  if (!text) return std::nullopt;
  if (!profiles_) {
    values_.mistakes.add("a profile names a plane shape of 'geometry.profiles'", text->place);
    return std::nullopt;
  }
  std::optional<Region> region = profiles_->shapes.region(*text);
  if (region && profiles_->shapes.shapes().contains(text->text))
    region = with_own_names(*region, text->text, true);
  return region;
}

Region ShapeReader::build_extrusion(const DocumentNode& node) {
  const std::optional<Region> plane = profile(node);
  const DocumentNode *from = values_.find(node, "from"), *to = values_.find(node, "to");
  const auto low = from ? values_.number(*from) : std::nullopt;
  const auto high = to ? values_.number(*to) : std::nullopt;
  if (plane && low && high && *low < *high) return extrusion(*plane, *low, *high);
  if (low && high && !(*low < *high))
    values_.mistakes.add("'to' must be larger than 'from'", to->place);
  return stand_in_shape(3);
}

Region ShapeReader::build_revolution(const DocumentNode& node) {
  const std::optional<Region> plane = profile(node);
  const DocumentNode *center = values_.find(node, "center"), *axis = values_.find(node, "axis");
  const Point middle = center ? values_.point(*center).value_or(Point{}) : Point{};
  const Point along = axis ? values_.point(*axis).value_or(Point{0, 0, 1}) : Point{0, 0, 1};
  if (along == Point{}) values_.mistakes.add("an axis of length 0 has no direction", axis->place);
  if (!plane || along == Point{}) return stand_in_shape(3);
  try {
    return revolution(*plane, middle, along);
  } catch (const InvalidArgument&) {
    values_.mistakes.add("the profile has no points at x > 0, or holds all of them",
                         values_.find(node, "profile")->place);
    return stand_in_shape(3);
  }
}

Region ShapeReader::build_quadric(const DocumentNode& node) {
  const int dimension = values_.dimension;
  const std::size_t expected = dimension == 2 ? 6 : 10;
  const std::optional<std::vector<double>> coefficients = values_.numbers(node);
  if (!coefficients) return stand_in_shape(dimension);
  if (coefficients->size() != expected) {
    values_.mistakes.add("expected " + std::to_string(expected) + " coefficients but found " +
                             std::to_string(coefficients->size()),
                         node.place);
    return stand_in_shape(dimension);
  }
  try {
    return quadric(*coefficients, dimension);
  } catch (const InvalidArgument& mistake) {
    values_.mistakes.add(mistake.what(), node.place);
    return stand_in_shape(dimension);
  }
}

Region ShapeReader::build_enclosed(const DocumentNode& list) {
  const auto solid = read_described_solid(list, values_, sets_);
  if (!solid) return stand_in_shape(values_.dimension);
  add_sides(solid->sides);
  described_.emplace(building_.back(), *solid);
  return solid->region;
}

Region ShapeReader::build_transform(const DocumentNode& node) {
  const int dimension = values_.dimension;
  Similarity similarity;
  const DocumentNode* of = values_.find(node, "of");
  const std::optional<Region> shape =
      of ? values_.guarded<Region>(*of,
                                   [&] {
                                     return this->shape({of->text, 0});
                                   })
         : std::nullopt;
  if (const DocumentNode* scale = values_.find(node, "scale"))
    similarity.scale = values_.number(*scale).value_or(1);
  if (const DocumentNode* rotate = values_.find(node, "rotate")) {
    const DocumentNode* angle = rotate->is_map() ? values_.find(*rotate, "angle") : rotate;
    if (angle) similarity.angle = values_.number(*angle).value_or(0) * radians_per_degree;
    const DocumentNode* axis = rotate->is_map() ? values_.find(*rotate, "axis") : nullptr;
    if (axis) similarity.axis = values_.point(*axis).value_or(similarity.axis);
    if (similarity.axis == Point{}) {
      values_.mistakes.add("an axis of length 0 has no direction", axis->place);
      return stand_in_shape(dimension);
    }
    if ((dimension == 3) != rotate->is_map() && similarity.angle != 0)
      values_.mistakes.add(dimension == 3 ? "in space a rotation is {axis: [..], angle: ..}"
                                          : "only in space a rotation has an axis",
                           rotate->place);
  }
  if (const DocumentNode* move = values_.find(node, "translate"); move && !move->is_scalar())
    similarity.translation = values_.point(*move).value_or(Point{});
  else if (move && values_.number(*move).value_or(0) != 0)
    values_.mistakes.add("expected one number for each dimension for 'translate'", move->place);
  if (const DocumentNode* about = values_.find(node, "about"); about && !about->is_scalar())
    similarity.about = values_.point(*about).value_or(Point{});
  else if (about && about->text != "origin")
    values_.mistakes.add("expected a point or 'origin' for 'about'", about->place);
  if (!shape) return stand_in_shape(dimension);
  if (const auto exact = distances_.find(of->text); exact != distances_.end()) {
    const Region moved =
        transformed(Region(Primitive{"", exact->second, exact->second}, dimension), similarity);
    distances_.emplace(building_.back(), moved.primitives()[0]->function);
  }
  return with_own_names(transformed(*shape, similarity), of->text, false);
}

}  // namespace rfm
