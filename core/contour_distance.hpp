#pragma once

#include <variant>
#include <vector>

#include "core/box_tree.hpp"
#include "core/circular_edge.hpp"
#include "core/conic_edge.hpp"
#include "core/curved_contour.hpp"
#include "core/field.hpp"
#include "core/field_source.hpp"

namespace rfm {

/// The signed Euclidean distance from closed contours of segments, arcs and conics, positive on
/// their left. The nearest edge is found by a tree of boxes; the distance from it is a closed form
/// (`CircularEdge`) or by Newton's method (`ConicEdge`), with jets of every order. |∇| = 1 off the
/// contours' skeleton, where two feet are equally near: there it has kinks, and derivatives are
/// those of one side. Derivatives of the second order jump where the foot passes from an edge to a
/// corner or to an edge of another curvature.
class ContourDistance final : public FieldSource {
 public:
  using Edge = std::variant<CircularEdge, ConicEdge>;

  /// Edges of each contour in order, each beginning where the one before it ends.
  explicit ContourDistance(const std::vector<std::vector<Edge>>& contours);

  double value(const Point& point) const;

  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  /// By the value at the centre: slopes are at most 1.
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override;

 private:
  struct Foot {
    int edge = 0;
    double distance = 0;
    enum class At { start, end, within } at = At::within;
    double parameter = 0;  ///< of a conic
  };
  Foot foot_on(int edge, const Point& point) const;
  Foot foot(const Point& point) const;
  template <class Number>
  Number distance_at(const Foot& foot, const Number& x, const Number& y, const Point& point,
                     int order) const;

  std::vector<Edge> edges_;
  std::vector<int> before_, after_;
  BoxTree tree_;
};

/// The signed distance of the shape that `curved_polygon` makes of the contours, positive inside.
/// Contours that do not meet are taken for granted. Throws `InvalidArgument` as `cleaned` does.
Field contour_distance(const std::vector<CurvedContour>& contours);

}  // namespace rfm
