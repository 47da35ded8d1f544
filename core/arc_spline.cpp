#include "core/arc_spline.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"

namespace rfm {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point unit(const Point& v) {
  const double length = std::hypot(v[0], v[1]);
  return {v[0] / length, v[1] / length};
}

// Points that differ from the one before, and their numbers.
struct Nodes {
  std::vector<Point> points;
  std::vector<int> numbers;

  Nodes(const std::vector<Point>& given, bool closed) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      const Point& point = given[i];
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
        throw InvalidArgument("the coordinates of point " + std::to_string(i + 1) +
                              " are not finite");
      if (!points.empty() && points.back() == point) {
        numbers.back() = static_cast<int>(i);
        continue;
      }
      points.push_back(point);
      numbers.push_back(static_cast<int>(i));
    }
    while (closed && points.size() > 1 && points.back() == points.front()) {
      points.pop_back();
      numbers.pop_back();
    }
    const std::size_t needed = closed ? 3 : 2;
    if (points.size() < needed)
      throw InvalidArgument(closed ? "a closed spline needs three different points"
                                   : "a spline needs two different points");
  }
};

// At b, of the circle through a, b, c: an inversion about b makes it a line.
Point tangent(const Point& a, const Point& b, const Point& c, int number) {
  const Point in = minus(b, a), out = minus(c, b);
  const double before = dot(in, in), after = dot(out, out);
  const Point along{in[0] / before + out[0] / after, in[1] / before + out[1] / after};
  if (std::hypot(along[0], along[1]) <= 1e-9 / std::sqrt(std::min(before, after)))
    throw InvalidArgument("the points turn back at point " + std::to_string(number + 1));
  return unit(along);
}

// The tangent at the other end of a chord of a circle.
Point mirrored(const Point& direction, const Point& chord) {
  const Point c = unit(chord);
  const double along = 2 * dot(direction, c);
  return {along * c[0] - direction[0], along * c[1] - direction[1]};
}

std::vector<Point> tangents_of(const Nodes& nodes, bool closed) {
  const auto& p = nodes.points;
  const std::size_t count = p.size();
  if (count == 2) return std::vector<Point>(2, unit(minus(p[1], p[0])));
  std::vector<Point> tangents(count);
  for (std::size_t i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i)
    tangents[i] = tangent(p[(i + count - 1) % count], p[i], p[(i + 1) % count], nodes.numbers[i]);
  if (!closed) {
    tangents[0] = mirrored(tangents[1], minus(p[1], p[0]));
    tangents[count - 1] = mirrored(tangents[count - 2], minus(p[count - 1], p[count - 2]));
  }
  return tangents;
}

// From `from` along t to `to` along u.
std::vector<CircularEdge> biarc(const Point& from, const Point& t, const Point& to,
                                const Point& u) {
  const CircularEdge single = CircularEdge::leaving(from, t, to);
  const Point arrives = single.end_direction();
  if (std::fabs(arrives[0] * u[1] - arrives[1] * u[0]) <= 1e-12 && dot(arrives, u) > 0 &&
      std::fabs(single.bulge) <= 1)
    return {single};
  // Both arcs have tangents of length d: |to − d u − (from + d t)| = 2d.
  const Point v = minus(to, from), sum{t[0] + u[0], t[1] + u[1]};
  const double across = dot(v, sum), opening = 2 * (1 - dot(t, u));
  const double d = dot(v, v) / (across + std::sqrt(across * across + opening * dot(v, v)));
  const Point joint{(from[0] + d * t[0] + to[0] - d * u[0]) / 2,
                    (from[1] + d * t[1] + to[1] - d * u[1]) / 2};
  const Point back{-u[0], -u[1]};
  return {CircularEdge::leaving(from, t, joint), CircularEdge::leaving(to, back, joint).reversed()};
}

}  // namespace

ArcSpline arc_spline(const std::vector<Point>& points, bool closed) {
  const Nodes nodes(points, closed);
  const auto& p = nodes.points;
  const std::vector<Point> tangents = tangents_of(nodes, closed);
  ArcSpline spline;
  for (std::size_t i = 0; i < (closed ? p.size() : p.size() - 1); ++i) {
    const std::size_t next = (i + 1) % p.size();
    for (const CircularEdge& edge : biarc(p[i], tangents[i], p[next], tangents[next])) {
      spline.edges.push_back(edge);
      spline.spans.push_back(nodes.numbers[i]);
    }
  }
  return spline;
}

}  // namespace rfm
