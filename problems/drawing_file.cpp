#include "problems/drawing_file.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "problems/text_files.hpp"

namespace rfm {
namespace {

// A group: its code, what stands behind it, and the line of that.
struct Group {
  std::string code, text;
  int line = 0;
};

// What is between two groups 0: the name of the entity and its groups.
struct Entity {
  std::string name;
  int line = 0;
  std::vector<Group> groups;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// What a drawing may hold beside outlines without changing the shape that it shows.
bool draws_nothing(const std::string& entity) {
  for (const char* name :
       {"ATTDEF", "ATTRIB", "DIMENSION", "LEADER", "MTEXT", "POINT", "SEQEND", "TEXT", "VIEWPORT"})
    if (entity == name) return true;
  return false;
}

class DrawingReader {
 public:
  explicit DrawingReader(const std::string& name) : name_(name) {}

  std::vector<PointList> read(std::string_view rest) {
    Entity entity;
    for (int line = 1; const auto code_line = next_line(rest); line += 2) {
      const auto value = next_line(rest);
      const std::string_view code = trimmed(*code_line);
      if (code.empty() && !value) break;
      if (!number_of(code) || !value) refuse(line, "expected a group code and a value");
      const Group group{std::string(code), std::string(trimmed(*value)), line + 1};
      if (code != "0") {
        entity.groups.push_back(group);
        continue;
      }
      finish(entity);
      entity = {group.text, group.line, {}};
    }
    finish(entity);
    finish_polyline();
    return std::move(lists_);
  }

 private:
  [[noreturn]] void refuse(int line, const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(line) + ": " + what, 0);
  }

  double number(const Group& group) const {
    const auto number = number_of(group.text);
    if (!number) refuse(group.line, "expected a number but found '" + group.text + "'");
    return *number;
  }
  // The last value of a code.
  double value(const Entity& entity, std::string_view code, double otherwise) const {
    for (const Group& group : entity.groups)
      if (group.code == code) otherwise = number(group);
    return otherwise;
  }
  int flags(const Entity& entity) const { return static_cast<int>(value(entity, "70", 0)); }
  static std::string text(const Entity& entity, std::string_view code) {
    for (const Group& group : entity.groups)
      if (group.code == code) return group.text;
    return "";
  }

  void finish(const Entity& entity) {
    if (entity.name == "SECTION") section_ = text(entity, "2");
    if (entity.name == "ENDSEC") section_.clear();
    if (section_ == "TABLES" && entity.name == "LAYER" &&
        (flags(entity) % 2 != 0 || value(entity, "62", 1) < 0))
      unseen_layers_.insert(text(entity, "2"));
    if (section_ != "ENTITIES" || entity.name == "SECTION") return;
    if (entity.name == "VERTEX") return add_vertex(entity);
    finish_polyline();
    if (draws_nothing(entity.name)) return;
    const bool is_seen = value(entity, "60", 0) == 0 && value(entity, "67", 0) == 0 &&
                         !unseen_layers_.contains(text(entity, "8"));
    if (entity.name == "POLYLINE") {
      polyline_ = entity;
      polyline_is_seen_ = is_seen;
    } else if (is_seen && entity.name == "LWPOLYLINE") {
      add_light_polyline(entity);
    } else if (is_seen && entity.name == "CIRCLE") {
      add_circle(entity);
    } else if (is_seen) {
      refuse(entity.line, "expected LWPOLYLINE, POLYLINE or CIRCLE but found " + entity.name +
                              ", which would be left out: join what it draws into a polyline");
    }
  }

  PointList& new_list(const Entity& entity) {
    PointList& list = lists_.emplace_back();
    list.line = entity.line - 1;
    return list;
  }

  static void add_point(PointList& list, const Point& point, double bulge) {
    list.points.push_back(point);
    list.bulges.push_back(bulge);
  }

  void add_light_polyline(const Entity& entity) {
    PointList& list = new_list(entity);
    list.is_open = flags(entity) % 2 == 0;
    for (const Group& group : entity.groups) {
      if (group.code == "10") add_point(list, {number(group), 0, 0}, 0);
      if (list.points.empty()) continue;
      if (group.code == "20") list.points.back()[1] = number(group);
      if (group.code == "42") list.bulges.back() = number(group);
    }
    look_from_above(entity, list);
  }

  void add_circle(const Entity& entity) {
    const double radius = value(entity, "40", 0);
    if (!(radius > 0)) refuse(entity.line, "this circle has no radius");
    PointList& list = new_list(entity);
    for (const double side : {-1.0, 1.0})
      add_point(list, {value(entity, "10", 0) + side * radius, value(entity, "20", 0)},
                1);  // half a turn
    look_from_above(entity, list);
  }

  void add_vertex(const Entity& entity) {
    if (polyline_.name.empty()) refuse(entity.line, "this vertex belongs to no polyline");
    vertices_.push_back(entity);
  }

  // A polyline ends with its last vertex.
  void finish_polyline() {
    const Entity entity = std::exchange(polyline_, {});
    const std::vector<Entity> vertices = std::exchange(vertices_, {});
    if (entity.name.empty() || !polyline_is_seen_) return;
    const int kind = flags(entity);
    constexpr int closed = 1, in_space = 8, mesh = 16 | 64, of_the_frame = 16;
    if (kind & mesh) refuse(entity.line, "this polyline is a mesh and no outline");
    PointList& list = new_list(entity);
    list.is_open = !(kind & closed);
    for (const Entity& vertex : vertices) {
      if (flags(vertex) & of_the_frame) continue;  // pulls at the curve without being on it
      const Point point{value(vertex, "10", 0), value(vertex, "20", 0)};
      add_point(list, point, value(vertex, "42", 0));
      if ((kind & in_space) && value(vertex, "30", 0) != value(vertices[0], "30", 0))
        refuse(vertex.line, "the heights of this polyline differ");
    }
    if (list.points.empty()) refuse(entity.line, "this polyline has no points of its curve");
    if (!(kind & in_space)) look_from_above(entity, list);
  }

  // Coordinates are those of the plane of the entity: seen from below, x runs the other way.
  void look_from_above(const Entity& entity, PointList& list) const {
    const double x = value(entity, "210", 0), y = value(entity, "220", 0),
                 z = value(entity, "230", 1);
    if (!(std::hypot(x, y) <= 1e-9 * std::fabs(z)))
      refuse(entity.line,
             "the plane of this " + entity.name + " is inclined to that of the drawing");
    if (z > 0) return;
    for (Point& point : list.points) point[0] = -point[0];
    for (double& bulge : list.bulges) bulge = -bulge;
  }

  const std::string& name_;
  std::vector<PointList> lists_;
  std::string section_;
  std::set<std::string> unseen_layers_;
  Entity polyline_;  // whose vertices are being read
  std::vector<Entity> vertices_;
  bool polyline_is_seen_ = false;
};

}  // namespace

bool is_drawing(std::string_view text) {
  while (const auto code = next_line(text)) {
    const auto value = next_line(text);
    if (!value) return false;
    if (trimmed(*code) == "999") continue;
    return trimmed(*code) == "0" && trimmed(*value) == "SECTION";
  }
  return false;
}

std::vector<PointList> outlines_of_drawing(std::string_view text, const std::string& name) {
  return DrawingReader(name).read(text);
}

}  // namespace rfm
