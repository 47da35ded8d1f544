#include "problems/holes.hpp"

#include <numbers>

#include "core/boundary_piece.hpp"
#include "quadrature/vertices.hpp"
#include "solvers/integrate.hpp"

namespace rfm {

double euler_characteristic(const RegionEvaluator& region, const Box& bounds,
                            const DomainRule& rule, const std::vector<int>& bounding_primitives) {
  double turning = 0;
  for (const int primitive : bounding_primitives) {
    const std::vector<Field> normal = outward_normal(primitive, region);
    const Field curvature = partial(normal[0], 0) + partial(normal[1], 1);
    if (!curvature.is_constant(0))
      turning += integrate(curvature, rule, {Contribution::Place::boundary, {primitive}});
  }
  for (const Vertex& corner : find_vertices(region, bounds).vertices)
    turning += std::numbers::pi * corner.edges / 2 - corner.angle;
  return turning / (2 * std::numbers::pi);
}

}  // namespace rfm
