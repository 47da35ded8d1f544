#include "core/edge_primitives.hpp"

#include <cmath>

#include "core/normalization_length.hpp"

namespace rfm {
namespace {

// Barycentric coordinates a, c with respect to the ends and b = 1 − a − c to the control point.
struct Barycentric {
  Field a, b, c;
  explicit Barycentric(const CurvePiece& piece) : a(0.0), b(0.0), c(0.0) {
    const Point p = piece.from, r = piece.to;
    const Point q{piece.weighted_control[0] / piece.weight,
                  piece.weighted_control[1] / piece.weight};
    const auto ratio = [&](const Point& u, const Point& v, const Point& one) {
      const double area = cross({v[0] - u[0], v[1] - u[1]}, {one[0] - u[0], one[1] - u[1]});
      return (v[0] - u[0]) / area * (y_coordinate() - u[1]) -
             (v[1] - u[1]) / area * (x_coordinate() - u[0]);
    };
    a = ratio(q, r, p);
    b = ratio(p, r, q);
    c = ratio(p, q, r);
  }
};

}  // namespace

Primitive disk_primitive(const CurvedEdge& edge) {
  const Point &p = edge.whole.from, &q = edge.whole.to;
  const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
  const double turn = edge.whole.turn, cosine = edge.whole.weight;
  const Field x = x_coordinate() - (p[0] + q[0]) / 2, y = y_coordinate() - (p[1] + q[1]) / 2;
  const Field height = (q[0] - p[0]) / length * y - (q[1] - p[1]) / length * x;
  const Field level =
      (length * length / 4 - x * x - y * y) * (0.5 / edge.radius) + turn * cosine * height;
  return {"", level, level};
}

Primitive conic_primitive(const CurvePiece& piece) {
  const Barycentric place(piece);
  const double w = piece.weight;
  const Field level = 4 * w * w * (place.a * place.c) - place.b * place.b;
  return {"", normalize_by_itself(level, 2), level};
}

Primitive branch_primitive(const CurvePiece& piece) {
  const Barycentric place(piece);
  const Field level = 1.0 - place.b;
  return {"", normalize_by_itself(level, 2), level, true};
}

Field part_of_curve(const CurvedEdge& edge) {
  const Field x = x_coordinate(), y = y_coordinate();
  const Point &p = edge.from, &q = edge.to;
  if (edge.center)  // of its circle, the part beyond the chord
    return ((y - p[1]) * (q[0] - p[0]) - (x - p[0]) * (q[1] - p[1])) *
           (edge.whole.turn > 0 ? -1.0 : 1.0);
  return (x - p[0]) * (q[0] - x) + (y - p[1]) * (q[1] - y);
}

}  // namespace rfm
