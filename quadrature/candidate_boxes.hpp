#pragma once

#include <functional>

#include "quadrature/surface_candidates.hpp"

namespace rfm {

/// Two primitives on whose zero sets an edge or a corner may lie: numbers among the variables of a
/// truth table.
struct PrimitivePair {
  int first;
  int second;
};

/// A small box in which the region depends on two primitives or more.
struct CandidateBox {
  Box box;
  /// The region as a function of `primitives` there.
  TruthTable table;
  std::vector<int> primitives;
  /// Of each variable: the first primitive with the same zero set.
  std::vector<int> surfaces;
  /// Pairs of different surfaces on both of which the region depends at once.
  std::vector<PrimitivePair> pairs;
};

/// Halves the box of a region until its parts are at most `longest` long, and visits those with
/// pairs. The parts lie aslant to the box (their sides are moved by some percent), so that faces
/// and edges of a region that is aligned with it do not lie on their sides. Returns how many parts
/// were left out because more primitives met there than a truth table holds, even 2⁻¹⁰ as large.
int visit_candidate_boxes(const RegionEvaluator& region, const Box& box, double longest,
                          const std::function<void(const CandidateBox&)>& visit);

/// Whether two primitives have the same zero set: polynomials of degree ≤ 2 that are multiples of
/// each other up to rounding (1e-13), or the same expression up to its sign.
bool is_same_surface(const LevelFunction& a, const LevelFunction& b, const Field& field_a,
                     const Field& field_b, const Box& box);

}  // namespace rfm
