#include "problems/shape_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/field_source.hpp"
#include "core/graph_walk.hpp"
#include "core/named_source.hpp"
#include "core/nearest_name.hpp"
#include "core/primitives.hpp"
#include "core/r_functions.hpp"
#include "core/regularity.hpp"
#include "core/sector_sides.hpp"
#include "core/source_breakpoints.hpp"
#include "problems/exact_shapes.hpp"
#include "problems/outline_reader.hpp"
#include "problems/reserved_names.hpp"

namespace rfm {
namespace {

constexpr std::size_t deepest_shapes = 100;

template <class Value>
std::vector<std::string> keys_of(const std::map<std::string, Value>& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

bool has_side(const Region& region, const std::string& name) {
  return std::ranges::any_of(region.primitives(),
                             [&](const auto& primitive) { return primitive->name == name; });
}

std::string shape_of_side(const std::string& name) { return name.substr(0, name.find('.')); }

// A level of a result of another problem lies in the box of that problem, beyond which it is no
// number.
std::optional<Box> box_of_results(const Field& function) {
  if (any_node(function,
               [](const Field& part) { return part.node().operation == Operation::select; }))
    return std::nullopt;
  std::optional<Box> shared;
  for (const Field::Node* node : sources_of(function)) {
    if (!node->arguments.empty() || !dynamic_cast<const NamedSource*>(node->source.get())) continue;
    const Box box = node->source->valid();
    if (!shared) shared = box;
    for (int axis = 0; axis < box.dimension; ++axis) {
      shared->low[axis] = std::max(shared->low[axis], box.low[axis]);
      shared->high[axis] = std::min(shared->high[axis], box.high[axis]);
    }
  }
  return shared;
}

}  // namespace

Region stand_in_shape(int dimension) {
  Field inside = 1.0;
  for (int axis = 0; axis < dimension; ++axis)
    inside = inside - coordinate(axis) * coordinate(axis);
  return level_set(inside, dimension);
}

Field ShapeReader::omega_of(const Region& region, const std::string& name,
                            const std::map<std::string, Field>& distances) {
  if (const auto exact = distances.find(name); exact != distances.end()) return exact->second;
  for (const auto& primitive : region.primitives())
    if (primitive->name == name) return primitive->function;
  return implicit(region);
}

ShapeReader::ShapeReader(const DocumentNode& root, ValueReader& values, SetReader& sets,
                         std::string list)
    : root_(root), values_(values), sets_(sets), list_(std::move(list)) {
  values_.scope.define_function("omega", omega());
  const DocumentNode* geometry = values_.find(root_, "geometry");
  const DocumentNode* shapes = geometry ? values_.find(*geometry, list_) : nullptr;
  if (!shapes) return;
  for (const DocumentNode::Entry& entry : shapes->entries) {
    const std::string objection = objection_to_name(entry.key);
    if (!objection.empty()) values_.mistakes.add(objection, entry.key_place);
    nodes_.emplace(entry.key, &entry.value);
    key_places_.emplace(entry.key, entry.key_place);
  }
  read_profiles();
}

// Formulas of the file keep no way back to this reader.
ShapeReader::~ShapeReader() { values_.scope.define_function("omega", final_omega()); }

void ShapeReader::read_all() {
  for (const std::string& name : keys_of(nodes_)) {
    DocumentNode named;
    named.text = name;
    named.place = key_places_.at(name);
    values_.guarded<bool>(named, [&] {
      built(name, 0);
      return true;
    });
  }
  const DocumentNode* geometry = values_.find(root_, "geometry");
  const DocumentNode* text =
      geometry && list_ == "shapes" ? values_.find(*geometry, "domain") : nullptr;
  if (text) domain_ = region(*text);
  if (text && distances_.contains(text->text))
    distances_.emplace("domain", distances_.at(text->text));
}

Region ShapeReader::shape(const BooleanText::Name& name) {
  mark_used(name.name);
  return built(name.name, name.offset);
}

void ShapeReader::mark_used(const std::string& shape) {
  names_in_[building_.empty() ? "" : building_.back()].insert(shape);
}

std::optional<Region> ShapeReader::region(const DocumentNode& node) {
  if (!values_.fits(node) || !node.is_scalar()) return std::nullopt;
  return values_.guarded<Region>(node, [&] {
    return BooleanText(node.text).region(
        [&](const BooleanText::Name& name) { return shape(name); });
  });
}

const Region& ShapeReader::built(const std::string& name, std::size_t offset) {
  if (const auto known = built_.find(name); known != built_.end()) return known->second;
  const auto node = nodes_.find(name);
  if (node == nodes_.end()) {
    const std::string shape = shape_of_side(name);
    if (shape != name && nodes_.contains(shape))
      throw InputError("'" + name + "' is a side of '" + shape + "': a shape is needed here",
                       offset, name.size());
    throw InputError("unknown shape '" + name + "'" + did_you_mean(name, keys_of(nodes_)), offset,
                     name.size());
  }
  if (const auto outer = std::ranges::find(building_, name); outer != building_.end()) {
    std::string cycle;
    for (auto step = outer; step != building_.end(); ++step) cycle += *step + " -> ";
    throw InputError("a shape that contains itself: " + cycle + name, offset, name.size());
  }
  if (building_.size() == deepest_shapes)
    throw InputError("shapes name each other more than " + std::to_string(deepest_shapes) + " deep",
                     offset, name.size());
  building_.push_back(name);
  Region region = build(name, *node->second);
  building_.pop_back();
  return built_.emplace(name, std::move(region)).first->second;
}

Region ShapeReader::build(const std::string& name, const DocumentNode& node) {
  if (values_.fits(node))
    for (const DocumentNode::Entry& entry : node.entries)
      if (values_.fits(entry.value)) {
        const Region region = with_exact_distance(build_kind(entry.key, entry.value), entry.key,
                                                  entry.value, values_);
        if (const auto whole = whole_distance(entry.key, entry.value, values_))
          distances_.emplace(name, *whole);
        // Sides keep the names of the shapes they come from.
        return entry.key == "combine" ? region : region.named(name);
      }
  return stand_in_shape(values_.dimension).named(name);
}

Region ShapeReader::build_kind(const std::string& kind, const DocumentNode& node) {
  const auto number = [&](const char* key, double otherwise) {
    const DocumentNode* value = values_.find(node, key);
    return value ? values_.number(*value).value_or(otherwise) : otherwise;
  };
  const auto point = [&](const char* key, const Point& otherwise) {
    const DocumentNode* value = values_.find(node, key);
    return value ? values_.point(*value).value_or(otherwise) : otherwise;
  };
  const auto direction = [&](const DocumentNode& map, const char* key) {
    const DocumentNode* value = values_.find(map, key);
    const Point given = value ? values_.point(*value).value_or(Point{1, 0, 0}) : Point{1, 0, 0};
    if (given != Point{0, 0, 0}) return given;
    values_.mistakes.add(std::string(key == std::string("axis") ? "an axis" : "a normal") +
                             " of length 0 has no direction",
                         value->place);
    return Point{1, 0, 0};
  };
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (OutlineReader::reads(kind)) {
    const auto outline = OutlineReader(values_).read(kind, node);
    if (!outline) return stand_in_shape(2);
    if (outline->distance) distances_.emplace(building_.back(), *outline->distance);
    add_sides(outline->sides);
    return outline->region;
  }
  if (kind == "strip")
    return strip(point("point", {0, 0}), direction(node, "normal"), number("width", 1));
  if (kind == "sector") {
    const double radius = number("radius", 1), inner = number("inner_radius", 0);
    const double from = number("from", 0), to = number("to", 90);
    if (inner >= radius)
      values_.mistakes.add("the inner radius of a sector must be smaller than its radius",
                           values_.find(node, "inner_radius")->place);
    else if (!(to > from && to < from + 360))
      values_.mistakes.add("a sector goes from one angle to a larger one, by less than 360 degrees",
                           values_.find(node, "to")->place);
    else {
      constexpr double degree = std::numbers::pi / 180;
      const Point center = point("center", {0, 0});
      add_sides(sector_sides(center, from * degree, to * degree));
      return sector(center, radius, from * degree, to * degree, inner);
    }
    return stand_in_shape(2);
  }
  if (kind == "half_plane") return half_plane(point("point", {0, 0}), direction(node, "normal"));
  if (kind == "half_space") return half_space(point("point", {0, 0}), direction(node, "normal"));
  if (kind == "sphere") return sphere(point("center", {0, 0}), number("radius", 1));
  if (kind == "ellipsoid") {
    const Point center = point("center", {0, 0}), radii = point("radii", {1, 1, 1});
    const DocumentNode* rotate = values_.find(node, "rotate");
    if (!rotate) return ellipsoid(center, radii);
    const DocumentNode* angle = values_.find(*rotate, "angle");
    return ellipsoid(center, radii, direction(*rotate, "axis"),
                     angle ? values_.number(*angle).value_or(0) * std::numbers::pi / 180 : 0.0);
  }
  if (kind == "cylinder")
    return cylinder(point("center", {0, 0}), direction(node, "axis"), number("radius", 1),
                    number("length", infinite));
  if (kind == "cone")
    return cone(point("apex", {0, 0}), direction(node, "axis"),
                number("angle", 45) * std::numbers::pi / 180, number("length", infinite));
  if (kind == "torus") {
    const double radius = number("radius", 2), tube = number("tube", 1);
    if (tube < radius) return torus(point("center", {0, 0}), direction(node, "axis"), radius, tube);
    values_.mistakes.add("the tube of a torus must be thinner than its radius",
                         values_.find(node, "tube")->place);
    return stand_in_shape(3);
  }
  if (kind == "capsule") {
    const Point from = point("from", {0, 0}), to = point("to", {1, 0});
    if (from != to) return capsule(from, to, number("radius", 1));
    values_.mistakes.add("the ends of a capsule must differ", values_.find(node, "to")->place);
    return stand_in_shape(3);
  }
  if (kind == "circle") return circle(point("center", {0, 0}), number("radius", 1));
  if (kind == "ellipse")
    return ellipse(point("center", {0, 0}), point("radii", {1, 1}),
                   number("angle", 0) * std::numbers::pi / 180);
  if (kind == "box") {
    const Box corners = values_.box(node).value_or(Box{values_.dimension, {0, 0, 0}, {1, 1, 1}});
    return box(corners.low, corners.high, values_.dimension);
  }
  if (kind == "expression") {
    const Field function = values_.field(node).value_or(x_coordinate());
    check_complements(node);
    const Region shape = level_set(function, values_.dimension);
    const std::optional<Box> box = box_of_results(function);
    return box ? shape.within(*box) : shape;
  }
  if (kind == "combine") {
    const std::optional<Region> combined = region(node);
    return combined ? *combined : stand_in_shape(values_.dimension).named(building_.back());
  }
  if (kind == "conic" || kind == "quadric") return build_quadric(node);
  if (kind == "enclosed_by") return build_enclosed(node);
  if (kind == "extrusion" || kind == "revolution" || kind == "transform")
    return derived_shape(kind, node);
  throw InvalidArgument("shapes of kind " + kind + " cannot be built");
}

const ThinSet* ShapeReader::set(const std::string& name) const {
  return sets_.contains(name) ? &sets_.built(name, 0) : nullptr;
}

void ShapeReader::add_sides(const std::vector<OutlineSide>& sides) {
  for (OutlineSide side : sides) {
    for (std::string& piece : side.pieces) piece = building_.back() + "." + piece;
    side.name = building_.back() + "." + side.name;
    sides_.emplace(side.name, side);
  }
}

const OutlineSide* ShapeReader::side(const std::string& name) const {
  const auto side = sides_.find(name);
  return side == sides_.end() ? nullptr : &side->second;
}

ExpressionFunction ShapeReader::omega() {
  const auto value = [this](std::span<const ExpressionArgument> arguments) -> ExpressionValue {
    const ExpressionArgument& argument = arguments[0];
    if (argument.text == "domain") {
      if (!building_.empty())
        throw InputError("a shape cannot name the domain it is part of", argument.offset,
                         argument.length);
      return domain_ ? omega_of(*domain_, "domain", distances_) : Field(1.0);
    }
    if (sets_.contains(argument.text)) return sets_.built(argument.text, argument.offset).function;
    const bool is_side = !nodes_.contains(argument.text);
    const std::string name = is_side ? shape_of_side(argument.text) : argument.text;
    mark_used(name);
    const Region& region = built(name, argument.offset);
    if (!building_.empty() && !is_side) functions_in_[building_.back()].insert(name);
    if (is_side && !has_side(region, argument.text))
      throw InputError("'" + name + "' has no side '" + argument.text.substr(name.size() + 1) + "'",
                       argument.offset, argument.length);
    return omega_of(region, argument.text, distances_);
  };
  return {1, 1, value, true};
}

ExpressionFunction ShapeReader::final_omega() const {
  const auto value = [shapes = built_, sets = sets_.sets(), domain = domain_, exact = distances_](
                         std::span<const ExpressionArgument> arguments) -> ExpressionValue {
    const std::string& name = arguments[0].text;
    if (name == "domain" && domain) return omega_of(*domain, name, exact);
    if (const auto set = sets.find(name); set != sets.end()) return set->second.function;
    const auto shape = shapes.find(shapes.contains(name) ? name : shape_of_side(name));
    if (shape == shapes.end())
      throw InputError("unknown shape '" + name + "'" + did_you_mean(name, keys_of(shapes)),
                       arguments[0].offset, arguments[0].length);
    return omega_of(shape->second, name, exact);
  };
  return {1, 1, value, true};
}

void ShapeReader::check_complements(const DocumentNode& formula) {
  const std::set<std::string>& names = functions_in_[building_.back()];
  for (auto a = names.begin(); a != names.end(); ++a)
    for (auto b = std::next(a); b != names.end(); ++b) {
      const Region &first = built_.at(*a), &second = built_.at(*b);
      if (first.primitives().size() < 2 || !are_formal_complements(first, second)) continue;
      values_.mistakes.add(
          "'" + *b + "' is the formal complement of '" + *a +
              "', made of the same primitives: the function of one is minus that of "
              "the other, with the same zeros inside; describe it by other shapes",
          formula.place);
    }
}

void ShapeReader::report_unused() {
  report_unused_profiles();
  std::set<std::string, std::less<>> used;
  std::vector<std::string> pending = {""};
  while (!pending.empty()) {
    const std::string user = pending.back();
    pending.pop_back();
    for (const std::string& name : names_in_[user])
      if (used.insert(name).second) pending.push_back(name);
  }
  if (!values_.mistakes.empty()) used.merge(words_of(root_));
  for (const auto& [name, place] : key_places_)
    if (!used.contains(name))
      values_.mistakes.add(
          (list_ == "shapes" ? "the shape '" : "the profile '") + name + "' is not used", place);
}

}  // namespace rfm
