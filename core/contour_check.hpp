#pragma once

#include <utility>
#include <vector>

#include "core/curve_division.hpp"
#include "core/curved_contour.hpp"
#include "core/region.hpp"

namespace rfm {

/// Whether a point lies within an odd number of contours of links: within the polygon of the chords
/// or, but not and, between chords and curves. Independent of any Boolean expression; exact but for
/// points within rounding of a curve.
class ContourParity {
 public:
  ContourParity(const std::vector<std::vector<ContourLink>>& contours,
                const std::vector<CurvedEdge>& edges);
  bool is_inside(const Point& point) const;

 private:
  std::vector<std::vector<Point>> chords_;
  std::vector<std::pair<CurvePiece, double>> curves_;  ///< with the radius, or 0 for a conic
};

/// The links (contour and number) beside which a region is not what its contours say: membership is
/// compared with `ContourParity` on both sides of three points of each. Empty if none.
std::vector<std::pair<std::size_t, std::size_t>> wrong_links(
    const RegionEvaluator& region, const std::vector<std::vector<ContourLink>>& contours,
    const std::vector<CurvedEdge>& edges);

}  // namespace rfm
