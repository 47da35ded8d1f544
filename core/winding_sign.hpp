#pragma once

#include <vector>

#include "core/field_source.hpp"
#include "core/thin_set.hpp"

namespace rfm {

/// 1 inside closed boundaries that are known only piece by piece, −1 outside: by the parity of the
/// winding number, so that loops may run either way and lie within each other (triangles of one
/// closed surface must all be turned alike). Its derivatives are 0; on the boundary itself either
/// sign. In the plane of segments and arcs (full circles, too), in space of triangles.
class WindingSign final : public FieldSource {
 public:
  /// Throws `InvalidArgument` if a piece is neither segment nor arc (triangle in space), or if the
  /// pieces do not close: an end (an edge) that is not shared by two. Ends are the same within 10⁻⁹
  /// of the size of all.
  explicit WindingSign(const std::vector<ThinSet>& pieces);

  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  /// One sign in boxes that no piece comes near.
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override;

  bool is_inside(const Point& point) const;

 private:
  struct Piece {
    std::array<Point, 3> corners{};
    double bulge = 0;  ///< of an arc: the tangent of a quarter of its angle, positive to the left
  };
  void check_edges(double tolerance) const;
  double distance_below(const Piece& piece, const Point& point) const;

  int dimension_;
  std::vector<Piece> pieces_;
};

/// The pieces of closed boundaries joined by R-equivalence ~p, times the winding sign: positive
/// inside, normalised, and smooth across the pieces but at their ends.
Field signed_function(const std::vector<ThinSet>& pieces, int p = 2);

}  // namespace rfm
