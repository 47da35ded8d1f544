#pragma once

#include <vector>

#include "quadrature/domain_rule.hpp"

namespace rfm {

/// How far a rule fails the divergence theorem in each of the cells that its report lists, in the
/// unit of its measure: where, when the defect of the whole rule says that something is wrong.
///
/// With φ the piecewise multilinear function that is 1 at one node of the grid and 0 at the others,
///
///     D = ∮ φ n ds − ∫ ∇φ dx,
///
/// a vector that is zero for exact rules, whatever the region, and knows only of the cells around
/// the node. As x is the sum of nodes times their φ, the defect of the whole rule about a point c
/// is |Σ (node − c) · D| / d. That of a node is Σ |D along an axis| · (side of a cell along it) /
/// d, that of a cell the largest of its nodes'. Cells of polynomials of degree d − 1 are integrated
/// exactly by 2 points in the plane and 3 in space also where faces are slanted.
///
/// Costs two sums of 2^d moments over the points and some look-ups; one thread.
std::vector<double> divergence_defects(const DomainRule& rule);

}  // namespace rfm
