#include "core/arc_spline.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/coordinate_rounding.hpp"
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

double size_of(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& p : points)
    size = std::max({size, std::fabs(p[0] - points[0][0]), std::fabs(p[1] - points[0][1])});
  return size;
}

// Of a point to the left of the line from `from` to `to`.
double height(const Point& from, const Point& to, const Point& point) {
  const Point along = unit(minus(to, from)), v = minus(point, from);
  return along[0] * v[1] - along[1] * v[0];
}

// What lies between two points is straight as far as their digits tell: see `arc_spline`.
class Straightening {
 public:
  Straightening(std::vector<std::vector<CircularEdge>>& spans, double tolerance, bool closed)
      : spans_(spans), tolerance_(tolerance), closed_(closed) {}

  void run() {
    std::vector<bool> flat;
    for (auto& span : spans_) {
      flat.push_back(is_flat(span));
      if (flat.back()) span = {{span.front().from, span.back().to, 0}};
    }
    const std::size_t count = spans_.size();
    // A run does not begin in the middle of a straight part.
    const auto bent = std::ranges::find(flat, false);
    const std::size_t start = closed_ && bent != flat.end() ? bent - flat.begin() : 0;
    for (std::size_t i = 0; i < count;) {
      std::size_t length = 0;
      while (i + length < count && flat[(start + i + length) % count] &&
             is_straight(start + i, length + 1))
        ++length;
      if (length > 1) put_on_a_line(start + i, length);
      i += std::max<std::size_t>(length, 1);
    }
  }

 private:
  static constexpr double gentle_ = 1e-3;  // heights over chords

  bool is_flat(const std::vector<CircularEdge>& span) const {
    const Point &from = span.front().from, &to = span.back().to;
    double off = 0, sagitta = 0;
    for (const CircularEdge& edge : span) {
      off = std::max(off, std::fabs(height(from, to, edge.to)));
      sagitta = std::max(sagitta, std::fabs(edge.bulge) * edge.chord() / 2);
    }
    const Point chord = minus(to, from);
    return off + sagitta <= std::min(tolerance_, gentle_ * std::hypot(chord[0], chord[1]));
  }

  CircularEdge& chord(std::size_t span) { return spans_[span % spans_.size()].front(); }

  // Whether the points between `length` chords lie near the line through the ends of all.
  bool is_straight(std::size_t first, std::size_t length) {
    const Point from = chord(first).from, to = chord(first + length - 1).to;
    if (from == to) return false;
    const Point along = unit(minus(to, from));
    for (std::size_t i = first; i < first + length; ++i) {
      const Point step = unit(minus(chord(i).to, chord(i).from));
      if (std::fabs(height(from, to, chord(i).to)) > tolerance_ ||
          dot(step, along) < 1 - 32 * gentle_ * gentle_)
        return false;
    }
    return true;
  }

  void put_on_a_line(std::size_t first, std::size_t length) {
    const Point from = chord(first).from, to = chord(first + length - 1).to;
    const Point along = unit(minus(to, from));
    for (std::size_t i = first; i + 1 < first + length; ++i) {
      const double reach = dot(minus(chord(i).to, from), along);
      chord(i).to = {from[0] + reach * along[0], from[1] + reach * along[1]};
      chord(i + 1).from = chord(i).to;
    }
  }

  std::vector<std::vector<CircularEdge>>& spans_;
  double tolerance_;
  bool closed_;
};

}  // namespace

ArcSpline arc_spline(const std::vector<Point>& points, bool closed) {
  const Nodes nodes(points, closed);
  const auto& p = nodes.points;
  const std::vector<Point> tangents = tangents_of(nodes, closed);
  std::vector<std::vector<CircularEdge>> spans;
  for (std::size_t i = 0; i < (closed ? p.size() : p.size() - 1); ++i) {
    const std::size_t next = (i + 1) % p.size();
    spans.push_back(biarc(p[i], tangents[i], p[next], tangents[next]));
  }
  Straightening(spans, std::min(1.5 * coordinate_rounding(p), 1e-4 * size_of(p)), closed).run();
  ArcSpline spline;
  for (std::size_t i = 0; i < spans.size(); ++i)
    for (const CircularEdge& edge : spans[i]) {
      spline.edges.push_back(edge);
      spline.spans.push_back(nodes.numbers[i]);
    }
  return spline;
}

}  // namespace rfm
