#pragma once

#include <vector>

#include "core/box.hpp"
#include "core/region.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

/// Euler's characteristic of a region of the plane, the number of its connected parts less that of
/// its holes, from the boundary alone (the theorem of Gauss and Bonnet): (∫ κ ds + Σ (π − θ)) / 2π,
/// κ the curvature, positive where the region is convex, and θ the interior angles at corners. A
/// whole number but for the accuracy of `rule`, where all corners can be resolved.
double euler_characteristic(const RegionEvaluator& region, const Box& bounds,
                            const DomainRule& rule, const std::vector<int>& bounding_primitives);

}  // namespace rfm
