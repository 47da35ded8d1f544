#include "problems/outline_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/arc_spline.hpp"
#include "core/contour.hpp"
#include "core/contour_distance.hpp"
#include "core/curved_polygon.hpp"
#include "core/error.hpp"
#include "core/exact_distances.hpp"
#include "core/polygon.hpp"
#include "core/stroke.hpp"
#include "core/stroke_region.hpp"
#include "problems/text_files.hpp"

namespace rfm {
namespace {

// Lists of points of one shape: the first is its outline.
class PointReader {
 public:
  PointReader(const ValueReader& values, const DocumentNode& node) : values_(values), node_(node) {}

  std::optional<std::vector<PointList>> read() const {
    if (const DocumentNode* file = values_.find(node_, "file")) return from_file(*file);
    const DocumentNode* points = values_.find(node_, "points");
    if (!points) return std::nullopt;
    std::vector<PointList> lists;
    if (!add(*points, lists)) return std::nullopt;
    return lists;
  }

  bool add(const DocumentNode& list, std::vector<PointList>& lists) const {
    PointList& added = lists.emplace_back();
    for (const DocumentNode& item : list.items) {
      const DocumentNode* at = item.is_map() ? values_.find(item, "at") : &item;
      const auto point = at ? values_.point(*at) : std::nullopt;
      if (!point) return false;
      added.points.push_back(*point);
      const DocumentNode* bulge = item.is_map() ? values_.find(item, "bulge") : nullptr;
      added.bulges.push_back(bulge ? values_.number(*bulge).value_or(0) : 0);
    }
    return true;
  }

 private:
  std::optional<std::vector<PointList>> from_file(const DocumentNode& file) const {
    const auto read = [&] {
      const std::string& name = file.place.source ? file.place.source->name : std::string();
      const auto folder = std::filesystem::path(name).parent_path().string();
      return parse_points(read_text_beside(folder, file.text, "a shape"), file.text);
    };
    try {
      return read();
    } catch (const InputError& mistake) {
      values_.mistakes.add(mistake.what(), file.place);
      return std::nullopt;
    }
  }

  const ValueReader& values_;
  const DocumentNode& node_;
};

// hole1_, hole2_, … of a map, contour2_, … of a file.
std::string prefix_of(std::size_t contour, bool of_file) {
  if (contour == 0) return "";
  return of_file ? "contour" + std::to_string(contour + 1) + "_"
                 : "hole" + std::to_string(contour) + "_";
}

CurvedContour curved(const PointList& list, std::string prefix) {
  CurvedContour contour{list.points, {}, std::move(prefix)};
  for (const double bulge : list.bulges) contour.edges.push_back({bulge, {}});
  return contour;
}

EdgeCurve edge_of(const DocumentNode& item, double bulge, const ValueReader& values) {
  EdgeCurve edge{bulge, {}};
  const DocumentNode* conic = item.is_map() ? values.find(item, "conic") : nullptr;
  if (!conic) return edge;
  if (bulge != 0) values.mistakes.add("an edge has a bulge or a conic, not both", conic->place);
  const DocumentNode* control = values.find(*conic, "control");
  const DocumentNode* weight = values.find(*conic, "weight");
  edge.conic = EdgeCurve::Conic{control ? values.point(*control).value_or(Point{}) : Point{},
                                weight ? values.number(*weight).value_or(1) : 1};
  return edge;
}

bool is_true(const DocumentNode* node) { return node && node->text == "true"; }

// With the Euclidean distance if `exact` is set.
Outline outline_of(const std::vector<CurvedContour>& contours, bool exact) {
  Outline outline = curved_polygon(contours);
  if (!exact) return outline;
  outline.region = with_exact_sides(outline.region);
  outline.distance = contour_distance(contours);
  return outline;
}

// What is near a chain. The distance needs an outline.
Outline stroke_of(const std::vector<CircularEdge>& chain, bool closed, double width, bool exact) {
  if (!exact) return stroke(chain, closed, width);
  try {
    return outline_of(stroke_outline(chain, closed, width), true);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(std::string(error.what()) +
                          " (without 'exact' such a stroke is the union of its parts)");
  }
}

// The inside of a closed spline. Its sides are the spans, edge i from point i to point i + 1.
std::vector<CurvedContour> filled(const ArcSpline& spline) {
  CurvedContour contour;
  std::map<int, int> arcs;
  for (std::size_t i = 0; i < spline.edges.size(); ++i) {
    const std::string span = "edge" + std::to_string(spline.spans[i] + 1);
    contour.points.push_back(spline.edges[i].from);
    contour.edges.push_back({spline.edges[i].bulge, {}});
    contour.names.push_back(span + "_arc" + std::to_string(++arcs[spline.spans[i]]));
    contour.groups.push_back(span);
  }
  return {contour};
}

}  // namespace

bool OutlineReader::reads(const std::string& kind) {
  return kind == "polygon" || kind == "curved_polygon" || kind == "polyline" || kind == "spline";
}

std::optional<Outline> OutlineReader::read(const std::string& kind,
                                           const DocumentNode& node) const {
  const DocumentNode* where = values_.find(node, values_.find(node, "file") ? "file" : "points");
  try {
    return kind == "polyline" || kind == "spline" ? read_stroke(kind, node)
                                                  : read_polygon(kind, node);
  } catch (const InvalidArgument& error) {
    values_.mistakes.add(error.what(), where->place);
    return std::nullopt;
  }
}

std::optional<Outline> OutlineReader::read_polygon(const std::string& kind,
                                                   const DocumentNode& node) const {
  const PointReader reader(values_, node);
  auto lists = reader.read();
  if (!lists) return std::nullopt;
  const bool of_file = values_.find(node, "file") != nullptr;
  const DocumentNode* holes = values_.find(node, "holes");
  if (holes)
    for (const DocumentNode& hole : holes->items) {
      if (!reader.add(hole, *lists)) return std::nullopt;
      if (!winds_around(lists->front().points,
                        lists->back().points.empty() ? Point{} : lists->back().points[0]) &&
          kind == "polygon") {
        values_.mistakes.add("this hole does not begin inside the polygon", hole.place);
        return std::nullopt;
      }
    }
  if (of_file && !is_closed_outline(kind, *lists, *values_.find(node, "file"))) return std::nullopt;
  const bool exact = is_true(values_.find(node, "exact"));
  std::vector<CurvedContour> curves;
  for (std::size_t c = 0; c < lists->size(); ++c)
    curves.push_back(curved((*lists)[c], prefix_of(c, of_file && !holes)));
  if (kind == "polygon") {
    std::vector<Contour> contours;
    for (CurvedContour& curve : curves) {
      contours.push_back({curve.points, curve.prefix});
      curve.edges.clear();
    }
    Outline outline = polygon(contours);
    if (exact) outline.distance = contour_distance(curves);
    return outline;
  }
  if (!of_file) {
    const auto& items = values_.find(node, "points")->items;
    for (std::size_t i = 0; i < items.size(); ++i)
      curves[0].edges[i] = edge_of(items[i], curves[0].edges[i].bulge, values_);
  }
  return outline_of(curves, exact);
}

// Whether lists of points of a file are what the kind of shape is made of.
bool OutlineReader::is_closed_outline(const std::string& kind, const std::vector<PointList>& lists,
                                      const DocumentNode& file) const {
  for (const PointList& list : lists)
    if (list.is_open && list.points.front() != list.points.back()) {
      values_.mistakes.add(fmt::format("the polyline of line {} of '{}' is open: its ends differ, "
                                       "and it is not flagged as closed",
                                       list.line, file.text),
                           file.place);
      return false;
    }
  return kind != "polygon" || has_straight_edges(kind, lists, file);
}

bool OutlineReader::has_straight_edges(const std::string& kind, const std::vector<PointList>& lists,
                                       const DocumentNode& file) const {
  for (const PointList& list : lists)
    if (std::ranges::any_of(list.bulges, [](double bulge) { return bulge != 0; })) {
      values_.mistakes.add(
          fmt::format(
              "'{}' has edges that are arcs, which a {} cannot have; expected bulges of 0{}",
              file.text, kind, kind == "polygon" ? ", or a curved_polygon" : ""),
          file.place);
      return false;
    }
  return true;
}

std::optional<Outline> OutlineReader::read_stroke(const std::string& kind,
                                                  const DocumentNode& node) const {
  const auto lists = PointReader(values_, node).read();
  if (!lists) return std::nullopt;
  const DocumentNode *given = values_.find(node, "width"), *loop = values_.find(node, "closed");
  const auto width = given ? values_.number(*given) : std::nullopt;
  if (given && !width) return std::nullopt;
  const DocumentNode* where = values_.find(node, values_.find(node, "file") ? "file" : "points");
  if (lists->size() > 1) {
    values_.mistakes.add("expected one curve but found " + std::to_string(lists->size()),
                         where->place);
    return std::nullopt;
  }
  if (values_.find(node, "file") && !has_straight_edges(kind, *lists, *where)) return std::nullopt;
  const std::vector<Point>& points = lists->front().points;
  const bool is_closed_drawing = lists->front().line > 0 && !lists->front().is_open;
  const bool closed = (loop ? is_true(loop) : is_closed_drawing) || !width ||
                      (points.size() > 2 && points.front() == points.back());
  const bool exact = is_true(values_.find(node, "exact"));
  if (kind == "polyline") return stroke_of(polyline_edges(points, closed), closed, *width, exact);
  const ArcSpline spline = arc_spline(points, closed);
  return width ? stroke_of(spline.edges, closed, *width, exact) : outline_of(filled(spline), exact);
}

}  // namespace rfm
