#pragma once

#include "problems/output/field_mesh.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

/// The points of a rule as points of a mesh without cells, to be looked at: `weight`, `piece` (the
/// number of a primitive on the boundary, −1 inside, −2 on an interface) and `normal` (outward; 0
/// inside). First all points inside, cell by cell, then those of the boundary, then interfaces. The
/// sum of the weights of piece k is its measure, that of piece −1 the measure of the domain.
///
/// Each point tells what the report says of its `cell`: `order_difference` (of the boundary at
/// points on it, in all of the cell), `divergence_defect` and `uncertified` measure.
FieldMesh rule_points(const DomainRule& rule);

}  // namespace rfm
