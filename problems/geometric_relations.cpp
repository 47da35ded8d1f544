#include "problems/geometric_relations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/bounding_box.hpp"
#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/relations.hpp"
#include "problems/reserved_names.hpp"

namespace rfm {
namespace {

using Kind = GeometricRelation::Kind;

[[noreturn]] void refuse(const GeometricRelation& relation, const std::string& message) {
  throw ProblemFileErrors({Mistake{message, relation.place}});
}

// Nothing for an empty shape, and for one without bounds an error.
struct Extent {
  std::optional<Box> box;
  std::string objection;  ///< why there is no box of a shape that is not empty
};
Extent extent_of(const RegionEvaluator& region, const std::optional<Box>& bounds) {
  if (bounds) return {bounds, {}};
  try {
    return {bounding_box(region), {}};
  } catch (const InvalidArgument& error) {
    const std::string what = error.what();
    return {std::nullopt, what.find("empty") == std::string::npos ? what : ""};
  }
}

void ask_for_bounds(const GeometricRelation& relation, const Extent& extent) {
  refuse(relation, extent.objection +
                       ": relations need bounded shapes, or geometry.bounds: "
                       "{min: [..], max: [..]}");
}

RelationAnswer from(const GeometricRelation& relation, const Relation& found) {
  RelationAnswer answer{&relation, found.answer, {}, {}};
  if (found.witness) answer.points = {*found.witness};
  if (found.answer == Truth::unknown && found.undecided)
    answer.points = {found.undecided->center()};
  return answer;
}

RelationAnswer intersection(const GeometricRelation& relation, const std::optional<Box>& bounds) {
  const Region &a = relation.regions[0], &b = relation.regions[1];
  const Extent first = extent_of(RegionEvaluator(a), bounds);
  const Extent second = first.objection.empty() ? Extent{} : extent_of(RegionEvaluator(b), bounds);
  if (!first.objection.empty() && !second.objection.empty()) ask_for_bounds(relation, second);
  const std::optional<Box>& box = first.objection.empty() ? first.box : second.box;
  if (!box) return {&relation, Truth::no, {}, {}};
  return from(relation, intersects(a, b, *box));
}

RelationAnswer inclusion(const GeometricRelation& relation, const std::optional<Box>& bounds) {
  const Extent inner = extent_of(RegionEvaluator(relation.regions[0]), bounds);
  if (!inner.objection.empty()) ask_for_bounds(relation, inner);
  if (!inner.box) return {&relation, Truth::yes, {}, {}};  // of nothing
  return from(relation, lies_in(relation.regions[0], relation.regions[1], *inner.box));
}

RelationAnswer distance(const GeometricRelation& relation, const std::optional<Box>& bounds) {
  std::vector<RegionEvaluator> regions;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < 2; ++i) {
    regions.emplace_back(relation.regions[i]);
    const Extent extent = extent_of(regions[i], bounds);
    if (!extent.objection.empty()) ask_for_bounds(relation, extent);
    if (!extent.box) refuse(relation, "'" + relation.texts[i] + "' is empty: it has no distance");
    boxes.push_back(*extent.box);
  }
  const double size = std::max(boxes[0].longest_side(), boxes[1].longest_side());
  const RegionDistance found = distance_between(regions[0], boxes[0], regions[1], boxes[1],
                                                relation.tolerance.value_or(1e-6 * size));
  return {&relation, Truth::unknown, found.distance, {found.first, found.second}};
}

RelationAnswer answer_of(const GeometricRelation& relation, const std::optional<Box>& bounds) {
  switch (relation.kind) {
    case Kind::intersect:
      return intersection(relation, bounds);
    case Kind::inside:
      return inclusion(relation, bounds);
    case Kind::distance:
      return distance(relation, bounds);
    default:
      return {&relation, membership(RegionEvaluator(relation.regions[0]), relation.point), {}, {}};
  }
}

class RelationReader {
 public:
  RelationReader(ValueReader& values, ShapeReader& shapes) : values_(values), shapes_(shapes) {}

  std::optional<GeometricRelation> read(const DocumentNode::Entry& entry) {
    GeometricRelation relation;
    relation.name = entry.key;
    relation.place = entry.key_place;
    const std::pair<const char*, Kind> kinds[] = {
        {"intersect", Kind::intersect}, {"inside", Kind::inside}, {"distance", Kind::distance}};
    for (const auto& [key, kind] : kinds)
      if (const DocumentNode* pair = values_.find(entry.value, key)) {
        relation.kind = kind;
        if (pair->items.size() != 2)
          values_.mistakes.add(
              "expected two shapes but found " + std::to_string(pair->items.size()), pair->place);
        for (const DocumentNode& item : pair->items) add_shape(item, relation);
        if (relation.regions.size() != 2) return std::nullopt;
      }
    if (const DocumentNode* point = values_.find(entry.value, "point")) {
      relation.kind = Kind::point;
      const std::optional<Point> at = values_.point(*point);
      if (const DocumentNode* in = values_.find(entry.value, "in")) add_shape(*in, relation);
      if (!at || relation.regions.size() != 1) return std::nullopt;
      relation.point = *at;
    }
    if (const DocumentNode* tolerance = values_.find(entry.value, "tolerance"))
      relation.tolerance = values_.number(*tolerance);
    if (relation.regions.empty()) return std::nullopt;
    return relation;
  }

 private:
  void add_shape(const DocumentNode& node, GeometricRelation& relation) {
    if (!values_.fits(node)) return;
    if (auto region = shapes_.region(node)) {
      relation.texts.push_back(node.text);
      relation.regions.push_back(std::move(*region));
    }
  }

  ValueReader& values_;
  ShapeReader& shapes_;
};

}  // namespace

std::vector<GeometricRelation> read_relations(const DocumentNode& root, ValueReader& values,
                                              ShapeReader& shapes) {
  std::vector<GeometricRelation> list;
  const DocumentNode* relations = values.find(root, "relations");
  if (!relations) return list;
  RelationReader reader(values, shapes);
  for (const DocumentNode::Entry& entry : relations->entries) {
    if (!values.fits(entry.value)) continue;
    const std::string objection = objection_to_name(entry.key);
    if (!objection.empty()) values.mistakes.add(objection, entry.key_place);
    if (auto relation = reader.read(entry)) list.push_back(std::move(*relation));
  }
  return list;
}

std::vector<RelationAnswer> answered(const std::vector<GeometricRelation>& relations,
                                     const std::optional<Box>& bounds) {
  std::vector<RelationAnswer> answers;
  for (const GeometricRelation& relation : relations)
    answers.push_back(answer_of(relation, bounds));
  return answers;
}

// As it was given, to the last digit.
static std::string exact_text(const Point& point, int dimension) {
  std::vector<std::string> coordinates;
  for (int axis = 0; axis < dimension; ++axis)
    coordinates.push_back(fmt::format("{}", point[axis]));
  return fmt::format("({})", fmt::join(coordinates, ", "));
}

std::string relation_text(const RelationAnswer& answer, int dimension) {
  const GeometricRelation& relation = *answer.relation;
  const std::vector<std::string>& texts = relation.texts;
  if (answer.distance)
    return fmt::format(
        "{}: the distance of {} from {} is at least {:.12g}, at most {:.12g}, "
        "from {} to {}",
        relation.name, texts[0], texts[1], answer.distance->low, answer.distance->high,
        point_text(answer.points[0], dimension), point_text(answer.points[1], dimension));
  std::string text = relation.name + ": ";
  if (relation.kind == Kind::point)
    text += exact_text(relation.point, dimension) + " lies in " + texts[0];
  else if (relation.kind == Kind::inside)
    text += texts[0] + " lies in " + texts[1];
  else
    text += texts[0] + " and " + texts[1] + " intersect";
  text += answer.truth == Truth::yes ? ": yes" : answer.truth == Truth::no ? ": no" : ": undecided";
  if (relation.kind == Kind::point && answer.truth == Truth::unknown) text += " (on its boundary)";
  if (answer.points.empty()) return text;
  return text + (answer.truth == Truth::unknown ? ", near " : ", as at ") +
         point_text(answer.points[0], dimension);
}

nlohmann::ordered_json relations_json(const std::vector<RelationAnswer>& answers, int dimension) {
  const auto list = [&](const Point& point) {
    return std::vector<double>(point.begin(), point.begin() + dimension);
  };
  nlohmann::ordered_json json;
  for (const RelationAnswer& answer : answers) {
    nlohmann::ordered_json& entry = json[answer.relation->name];
    if (answer.distance) {
      entry = {{"distance", answer.distance->high},
               {"at_least", answer.distance->low},
               {"from", list(answer.points[0])},
               {"to", list(answer.points[1])}};
      continue;
    }
    entry["truth"] = nullptr;
    if (answer.truth != Truth::unknown) entry["truth"] = answer.truth == Truth::yes ? 1 : 0;
    if (!answer.points.empty())
      entry[answer.truth == Truth::unknown ? "near" : "witness"] = list(answer.points[0]);
  }
  return json;
}

}  // namespace rfm
