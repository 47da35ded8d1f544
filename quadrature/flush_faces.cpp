#include "quadrature/flush_faces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rfm {
namespace {

struct AxisPlane {
  int primitive;
  int axis;
  double position;
  bool inside_above;
};

std::optional<AxisPlane> axis_plane(const RegionEvaluator& region, int primitive) {
  const QuadricEvaluator* evaluator = region.level(primitive).quadric();
  if (!evaluator || !evaluator->is_affine()) return std::nullopt;
  const Quadric& quadric = *evaluator;
  int axis = -1;
  for (int i = 0; i < region.dimension(); ++i) {
    if (quadric.linear[i] == 0) continue;
    if (axis >= 0) return std::nullopt;
    axis = i;
  }
  if (axis < 0) return std::nullopt;
  return AxisPlane{primitive, axis, quadric.origin[axis] - quadric.constant / quadric.linear[axis],
                   quadric.linear[axis] > 0};
}

bool are_same(const AxisPlane& a, const AxisPlane& b) {
  constexpr double rounding = 1e-13;
  return a.axis == b.axis && std::fabs(a.position - b.position) <=
                                 rounding * std::max(std::fabs(a.position), std::fabs(b.position));
}

}  // namespace

FlushFaces::FlushFaces(const RegionEvaluator& region)
    : region_(region), plane_of_(static_cast<std::size_t>(region.primitive_count()), -1) {
  std::vector<AxisPlane> planes;
  for (int k = 0; k < region.primitive_count(); ++k)
    if (const auto plane = axis_plane(region, k)) planes.push_back(*plane);
  std::ranges::sort(planes, [](const AxisPlane& a, const AxisPlane& b) {
    return a.axis != b.axis ? a.axis < b.axis : a.position < b.position;
  });
  int number = 0;
  for (std::size_t first = 0, last = 0; first < planes.size(); first = last) {
    bool above = false, below = false;
    for (last = first; last < planes.size() && are_same(planes[first], planes[last]); ++last)
      (planes[last].inside_above ? above : below) = true;
    if (!above || !below) continue;
    for (std::size_t i = first; i < last; ++i) {
      faces_.push_back({planes[i].primitive, number, planes[i].inside_above});
      plane_of_[static_cast<std::size_t>(planes[i].primitive)] = number;
    }
    ++number;
  }
}

bool FlushFaces::is_crack(int primitive, const Point& point) const {
  const int plane = plane_of_[static_cast<std::size_t>(primitive)];
  if (plane < 0) return false;
  std::vector<Truth> signs(plane_of_.size());
  for (std::size_t k = 0; k < signs.size(); ++k)
    if (plane_of_[k] != plane)
      signs[k] = region_.level(static_cast<int>(k)).value(point) >= 0 ? Truth::yes : Truth::no;
  const auto is_inside = [&](bool above) {
    for (const Face& face : faces_)
      if (face.plane == plane)
        signs[static_cast<std::size_t>(face.primitive)] =
            face.inside_above == above ? Truth::yes : Truth::no;
    return region_.region().expression().evaluate(signs) == Truth::yes;
  };
  return is_inside(true) == is_inside(false);
}

}  // namespace rfm
