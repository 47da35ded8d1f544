#pragma once

#include <vector>

#include "core/region.hpp"

namespace rfm {

/// Faces of flush shapes that look at each other: planes along the axes that are the same, with the
/// inside on opposite sides. Where such a face lies on a side of a box, the boxes on both sides of
/// it see a state of its own on it, in which both primitives are true, and a boundary about it that
/// is none: in a ^ b, or in a & b, of two boxes that share a face. Inside a box both are crossed at
/// once, and nothing is seen.
class FlushFaces {
 public:
  explicit FlushFaces(const RegionEvaluator& region);

  bool empty() const { return faces_.empty(); }
  /// Whether a point found on the zero set of `primitive` lies on a face of two such planes with
  /// the inside, or the outside, on both of its sides.
  bool is_crack(int primitive, const Point& point) const;

 private:
  struct Face {
    int primitive;
    int plane;  ///< of the same number if they are the same
    bool inside_above;
  };
  const RegionEvaluator& region_;
  std::vector<Face> faces_;    ///< of planes that occur with both senses
  std::vector<int> plane_of_;  ///< by primitive; −1 for others
};

}  // namespace rfm
