#include "problems/set_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "core/error.hpp"
#include "problems/reserved_names.hpp"
#include "problems/stl_reader.hpp"

namespace rfm {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

// Every value of its function visits all parts of a set.
void refuse_many(std::size_t parts, const std::string& of) {
  constexpr std::size_t most = 2000;
  if (parts > most)
    throw InvalidArgument(std::to_string(parts) + " " + of + ": a set has at most " +
                          std::to_string(most) + " parts");
}

ThinSet stand_in(int dimension) { return point_set({}, dimension); }

}  // namespace

SetReader::SetReader(const DocumentNode& root, ValueReader& values) : values_(values) {
  const DocumentNode* sets = values_.find(root, "sets");
  if (!sets) return;
  const DocumentNode* geometry = values_.find(root, "geometry");
  const DocumentNode* shapes = geometry ? values_.find(*geometry, "shapes") : nullptr;
  for (const DocumentNode::Entry& entry : sets->entries) {
    std::string objection = objection_to_name(entry.key);
    if (objection.empty() && shapes && shapes->find(entry.key))
      objection = "the name '" + entry.key + "' is already that of a shape";
    if (!objection.empty()) values_.mistakes.add(objection, entry.key_place);
    nodes_.emplace(entry.key, &entry.value);
    key_places_.emplace(entry.key, entry.key_place);
  }
}

std::vector<std::string> SetReader::names() const {
  std::vector<std::string> names;
  for (const auto& [name, node] : nodes_) names.push_back(name);
  return names;
}

void SetReader::read_all() {
  for (const auto& [name, node] : nodes_) built(name, 0);
}

const ThinSet& SetReader::built(const std::string& name, std::size_t offset) {
  if (const auto known = built_.find(name); known != built_.end()) return known->second;
  if (std::ranges::find(building_, name) != building_.end())
    throw InputError("a set that contains itself: " + name, offset, name.size());
  building_.push_back(name);
  ThinSet set = build(*nodes_.at(name));
  building_.pop_back();
  return built_.emplace(name, std::move(set)).first->second;
}

ThinSet SetReader::build(const DocumentNode& node) {
  if (values_.fits(node))
    for (const DocumentNode::Entry& entry : node.entries) {
      if (!values_.fits(entry.value)) continue;
      try {
        if (entry.key == "point")
          return point_set(values_.point(entry.value).value_or(Point{}), values_.dimension);
        if (entry.key == "segment") return segment(entry.value);
        if (entry.key == "arc") return arc(entry.value);
        if (entry.key == "curve") return curve(entry.value);
        if (entry.key == "triangle") return triangle(entry.value);
        if (entry.key == "polyline") return polyline(entry.value);
        if (entry.key == "mesh") return mesh(entry.value);
      } catch (const InvalidArgument& mistake) {
        values_.mistakes.add(mistake.what(), entry.value.place);
      }
    }
  return stand_in(values_.dimension);
}

ThinSet SetReader::segment(const DocumentNode& map) {
  std::vector<Point> ends;
  for (const char* key : {"from", "to"})
    if (const DocumentNode* end = values_.find(map, key))
      if (const auto point = values_.point(*end)) ends.push_back(*point);
  return ends.size() == 2 ? segment_set(ends[0], ends[1], values_.dimension)
                          : stand_in(values_.dimension);
}

ThinSet SetReader::arc(const DocumentNode& map) {
  const auto number = [&](const char* key) -> std::optional<double> {
    const DocumentNode* node = values_.find(map, key);
    return node ? values_.number(*node) : std::nullopt;
  };
  const DocumentNode* center = values_.find(map, "center");
  const auto middle = center ? values_.point(*center) : std::nullopt;
  const auto radius = number("radius"), from = number("from"), to = number("to");
  if (!middle || !radius || !from || !to) return stand_in(2);
  return arc_set(*middle, *radius, *from * radians_per_degree, *to * radians_per_degree);
}

ThinSet SetReader::curve(const DocumentNode& map) {
  const DocumentNode* of = values_.find(map, "of");
  const auto function = of ? values_.field(*of) : std::nullopt;
  const DocumentNode* where = values_.find(map, "where");
  const auto part = where ? values_.field(*where) : std::nullopt;
  if (!function || (where && !part)) return stand_in(values_.dimension);
  if (function->is_constant()) throw InvalidArgument("a constant has no curve on which it is zero");
  return level_curve_set(*function, part, values_.dimension);
}

ThinSet SetReader::triangle(const DocumentNode& list) {
  if (list.items.size() != 3)
    throw InvalidArgument("expected the three corners of a triangle but found " +
                          std::to_string(list.items.size()) + " points");
  std::vector<Point> corners;
  for (const DocumentNode& corner : list.items)
    if (const auto point = values_.point(corner)) corners.push_back(*point);
  return corners.size() == 3 ? triangle_set(corners[0], corners[1], corners[2]) : stand_in(3);
}

ThinSet SetReader::polyline(const DocumentNode& map) {
  const DocumentNode *list = values_.find(map, "points"), *closed = values_.find(map, "closed");
  std::vector<Point> points;
  if (list)
    for (const DocumentNode& item : list->items)
      if (const auto point = values_.point(item)) points.push_back(*point);
  if (!list || points.size() != list->items.size()) return stand_in(values_.dimension);
  if (points.size() < 2) throw InvalidArgument("a polyline has at least two points");
  if (closed && closed->text == "true" && points.back() != points.front())
    points.push_back(points.front());
  refuse_many(points.size() - 1, "segments of a polyline");
  std::vector<ThinSet> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i] == points[i + 1])
      throw InvalidArgument("points " + std::to_string(i + 1) + " and " + std::to_string(i + 2) +
                            " of a polyline are the same");
    segments.push_back(segment_set(points[i], points[i + 1], values_.dimension));
  }
  return composite_set(std::move(segments));
}

ThinSet SetReader::mesh(const DocumentNode& file) {
  const std::string name = file.place.source ? file.place.source->name : std::string();
  const auto triangles = values_.guarded<std::vector<Triangle>>(file, [&] {
    return read_stl(std::filesystem::path(name).parent_path().string(), file.text);
  });
  if (!triangles) return stand_in(3);
  refuse_many(triangles->size(), "triangles in '" + file.text + "'");
  std::vector<ThinSet> parts;
  for (const auto& [a, b, c] : *triangles) parts.push_back(triangle_set(a, b, c));
  return composite_set(std::move(parts));
}

}  // namespace rfm
