#pragma once

#include "core/curve_piece.hpp"

namespace rfm {

/// The arc of a conic as a curve C(t), 0 ≤ t ≤ 1, for distances from it. The foot of a point x is a
/// zero of the quartic W³ (C − x)·C' (W the denominator of C), whose zeros in [0, 1] are isolated
/// by the signs of its Bernstein coefficients; derivatives of the foot by Newton's method on jets.
class ConicEdge {
 public:
  explicit ConicEdge(const CurvePiece& piece) : piece_(piece) {}

  const CurvePiece& piece() const { return piece_; }
  struct Foot {
    double parameter = 0;
    double distance = 0;
    bool is_end = false;
  };
  Foot foot(const Point& point) const;

  /// (x − C) × C' / |C'| at the foot of parameter t, positive on the left: for jets of a given
  /// order (0 for numbers).
  template <class Number>
  Number signed_distance(const Number& x, const Number& y, const Number& parameter,
                         int order) const {
    Number t = parameter;
    for (int right = 1; right <= order; right *= 2) t = t - step(x, y, t);
    const auto r = offset(x, y, t), q = tangent(t);
    using std::sqrt;
    return (r[0] * q[1] - r[1] * q[0]) / sqrt(q[0] * q[0] + q[1] * q[1]) / denominator(t);
  }

 private:
  // W (C − x), W² C' / 2 and W.
  template <class Number>
  Number blend(const Number& t, double a, double b, double c) const {
    const Number s = Number(1.0) - t;
    return Number(a) * s * s + Number(2 * b) * s * t + Number(c) * t * t;
  }
  template <class Number>
  Number denominator(const Number& t) const {
    return blend(t, 1, piece_.weight, 1);
  }
  template <class Number>
  std::array<Number, 2> offset(const Number& x, const Number& y, const Number& t) const {
    const Number w = denominator(t);
    const Point &p = piece_.from, &r = piece_.to, &q = piece_.weighted_control;
    return {blend(t, p[0], q[0], r[0]) - w * x, blend(t, p[1], q[1], r[1]) - w * y};
  }
  template <class Number>
  std::array<Number, 2> tangent(const Number& t) const {
    const auto q = tangent_points();
    return {blend(t, q[0][0], q[1][0], q[2][0]), blend(t, q[0][1], q[1][1], q[2][1])};
  }
  std::array<Point, 3> tangent_points() const;
  // Newton's correction of t.
  template <class Number>
  Number step(const Number& x, const Number& y, const Number& t) const {
    const auto r = offset(x, y, t), q = tangent(t);
    // d/dt of W (C − x) is (W² C' + W' W (C − x)) / W.
    const auto points = tangent_points();
    const Number w = denominator(t), s = Number(1.0) - t;
    const Number dw = Number(2 * (piece_.weight - 1)) * (s - t);
    std::array<Number, 2> dr{Number(0.0), Number(0.0)}, dq{Number(0.0), Number(0.0)};
    for (int axis = 0; axis < 2; ++axis) {
      dr[axis] = (Number(2.0) * q[axis] + dw * r[axis]) / w;
      dq[axis] = Number(2.0) * (Number(points[1][axis] - points[0][axis]) * s +
                                Number(points[2][axis] - points[1][axis]) * t);
    }
    return (r[0] * q[0] + r[1] * q[1]) /
           (dr[0] * q[0] + dr[1] * q[1] + r[0] * dq[0] + r[1] * dq[1]);
  }

  CurvePiece piece_;
};

}  // namespace rfm
