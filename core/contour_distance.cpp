#include "core/contour_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/dynamic_jet.hpp"
#include "core/jet_functions.hpp"

namespace rfm {
namespace {

using Edge = ContourDistance::Edge;
constexpr double infinite = std::numeric_limits<double>::infinity();

Point start_of(const Edge& edge) {
  if (const auto* arc = std::get_if<CircularEdge>(&edge)) return arc->from;
  return std::get<ConicEdge>(edge).piece().from;
}

Point direction_of(const Edge& edge, bool at_start) {
  if (const auto* arc = std::get_if<CircularEdge>(&edge))
    return at_start ? arc->start_direction() : arc->end_direction();
  const CurvePiece& piece = std::get<ConicEdge>(edge).piece();
  return at_start ? piece.start_direction() : piece.end_direction();
}

Box box_of(const Edge& edge) {
  if (const auto* arc = std::get_if<CircularEdge>(&edge)) return arc->bounding_box();
  const auto corners = std::get<ConicEdge>(edge).piece().hull();
  Box box{2, corners[0], corners[0]};
  for (const Point& corner : corners)
    for (int axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], corner[axis]);
      box.high[axis] = std::max(box.high[axis], corner[axis]);
    }
  return box;
}

std::vector<Box> boxes_of(const std::vector<std::vector<Edge>>& contours) {
  std::vector<Box> boxes;
  for (const auto& contour : contours)
    for (const Edge& edge : contour) boxes.push_back(box_of(edge));
  return boxes;
}

Edge reversed(const Edge& edge) {
  if (const auto* arc = std::get_if<CircularEdge>(&edge)) return arc->reversed();
  return ConicEdge(std::get<ConicEdge>(edge).piece().reversed());
}

std::vector<Edge> reversed(const std::vector<Edge>& contour) {
  std::vector<Edge> back;
  for (auto edge = contour.rbegin(); edge != contour.rend(); ++edge)
    back.push_back(reversed(*edge));
  return back;
}

// Counter-clockwise.
std::vector<Edge> edges_of(const CurvedContour& contour) {
  std::vector<CurvedEdge> given;
  const bool runs_back = cleaned(contour, given).front().edge != 0;
  std::vector<Edge> edges;
  const std::size_t count = contour.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point &from = contour.points[i], &to = contour.points[(i + 1) % count];
    if (from == to) continue;
    const EdgeCurve curve = i < contour.edges.size() ? contour.edges[i] : EdgeCurve{};
    if (curve.conic)
      edges.emplace_back(
          ConicEdge(CurvePiece::conic(from, curve.conic->control, curve.conic->weight, to, 0)));
    else
      edges.emplace_back(CircularEdge{from, to, curve.bulge});
  }
  return runs_back ? reversed(edges) : edges;
}

}  // namespace

ContourDistance::ContourDistance(const std::vector<std::vector<Edge>>& contours)
    : tree_(boxes_of(contours)) {
  for (const auto& contour : contours) {
    const int first = static_cast<int>(edges_.size()), count = static_cast<int>(contour.size());
    for (int i = 0; i < count; ++i) {
      edges_.push_back(contour[i]);
      before_.push_back(first + (i + count - 1) % count);
      after_.push_back(first + (i + 1) % count);
    }
  }
}

ContourDistance::Foot ContourDistance::foot_on(int edge, const Point& point) const {
  using At = Foot::At;
  if (const auto* arc = std::get_if<CircularEdge>(&edges_[edge])) {
    if (arc->holds_foot(point))
      return {edge, std::fabs(arc->signed_distance(point[0], point[1])), At::within, 0};
    const double start = std::hypot(point[0] - arc->from[0], point[1] - arc->from[1]);
    const double end = std::hypot(point[0] - arc->to[0], point[1] - arc->to[1]);
    return {edge, std::min(start, end), start <= end ? At::start : At::end, 0};
  }
  const ConicEdge::Foot foot = std::get<ConicEdge>(edges_[edge]).foot(point);
  const At at = !foot.is_end ? At::within : foot.parameter == 0 ? At::start : At::end;
  return {edge, foot.distance, at, foot.parameter};
}

ContourDistance::Foot ContourDistance::foot(const Point& point) const {
  Foot best{0, infinite, Foot::At::within, 0};
  tree_.walk(
      point,
      [&](int edge) {
        const Foot found = foot_on(edge, point);
        if (found.distance < best.distance) best = found;
      },
      // A hair farther, so that of an edge and its corner both are seen.
      [&] { return best.distance * best.distance * (1 + 1e-12); });
  return best;
}

template <class Number>
Number ContourDistance::distance_at(const Foot& foot, const Number& x, const Number& y,
                                    const Point& point, int order) const {
  if (foot.at == Foot::At::within) {
    if (const auto* arc = std::get_if<CircularEdge>(&edges_[foot.edge]))
      return arc->signed_distance(x, y);
    Number t = x;  // of the same shape
    t = t * Number(0.0) + Number(foot.parameter);
    return std::get<ConicEdge>(edges_[foot.edge]).signed_distance(x, y, t, order);
  }
  // A corner: the side on which the sum of the normals of its edges lies.
  const bool at_start = foot.at == Foot::At::start;
  const int second = at_start ? foot.edge : after_[foot.edge], first = before_[second];
  const Point corner = start_of(edges_[second]);
  const Point in = direction_of(edges_[first], false), out = direction_of(edges_[second], true);
  const double side =
      (point[1] - corner[1]) * (in[0] + out[0]) - (point[0] - corner[0]) * (in[1] + out[1]);
  const Number dx = x - Number(corner[0]), dy = y - Number(corner[1]);
  using std::sqrt;
  const Number distance = sqrt(dx * dx + dy * dy);
  return side < 0 ? Number(-1.0) * distance : distance;
}

double ContourDistance::value(const Point& point) const {
  return distance_at(foot(point), point[0], point[1], point, 0);
}

void ContourDistance::evaluate(const std::array<const double*, 3>& coordinates, int count,
                               int variables, int order, double* jets, int stride) const {
  using Number = DynamicJet<double>;
  const JetShape& shape = JetShape::get(variables, order);
  for (int i = 0; i < count; ++i) {
    const Point point{coordinates[0][i], coordinates[1][i]};
    if (order == 0) {
      jets[i] = value(point);
      continue;
    }
    const Number x = Number::variable(shape, 0, point[0]);
    const Number y = variables > 1 ? Number::variable(shape, 1, point[1]) : Number(point[1]);
    const Number result = distance_at(foot(point), x, y, point, order);
    for (int c = 0; c < shape.size(); ++c)
      jets[std::ptrdiff_t(c) * stride + i] = coefficient(result, c);
  }
}

FunctionBounds ContourDistance::bounds(const Box& box) const {
  const Point center = box.center();
  const auto half = [&](int axis) {
    return std::max(box.high[axis] - center[axis], center[axis] - box.low[axis]);
  };
  const double reach = std::hypot(half(0), half(1));
  FunctionBounds bounds;
  for (int axis = 0; axis < 2; ++axis) bounds.gradient[axis] = Interval(-1, 1);
  bounds.smooth = false;
  if (!std::isfinite(reach)) {
    bounds.value = Interval::entire();
    return bounds;
  }
  const Foot found = foot(center);
  const double here = distance_at(found, center[0], center[1], center, 0);
  const double rounding =
      1e-13 * (std::fabs(here) + std::fabs(center[0]) + std::fabs(center[1]) + reach);
  bounds.value = Interval(here - reach - rounding, here + reach + rounding);
  // Smooth where one edge alone is the nearest, and the centre of its circle is not near.
  int near = 0;
  const double farthest = found.distance + 2 * reach + rounding;
  tree_.walk(
      center, [&](int edge) { near += foot_on(edge, center).distance <= farthest ? 1 : 0; },
      [&] { return farthest * farthest; });
  if (near == 1 && found.at == Foot::At::within)
    if (const auto* arc = std::get_if<CircularEdge>(&edges_[found.edge]))
      bounds.smooth =
          arc->bulge == 0 || found.distance + reach + rounding < 1 / std::fabs(arc->curvature());
  return bounds;
}

std::vector<double> ContourDistance::breakpoints(int) const { return {}; }

Box ContourDistance::valid() const {
  return {2, {-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
}

Field contour_distance(const std::vector<CurvedContour>& contours) {
  std::vector<std::vector<Edge>> edges;
  for (const CurvedContour& contour : contours) edges.push_back(edges_of(contour));
  std::vector<int> depth(edges.size(), 0);
  for (std::size_t outer = 0; outer < edges.size(); ++outer) {
    const ContourDistance alone({edges[outer]});
    for (std::size_t inner = 0; inner < edges.size(); ++inner)
      if (inner != outer && alone.value(start_of(edges[inner][0])) > 0) ++depth[inner];
  }
  for (std::size_t c = 0; c < edges.size(); ++c)
    if (depth[c] % 2 == 1) edges[c] = reversed(edges[c]);
  return field(std::make_shared<const ContourDistance>(edges));
}

}  // namespace rfm
