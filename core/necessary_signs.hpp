#pragma once

#include <vector>

#include "core/region.hpp"

namespace rfm {

/// A primitive that has one sign wherever the region has points in some box.
struct NecessarySign {
  int primitive;
  double sign;  ///< 1: its function is ≥ 0 there; −1: it is < 0
};

/// The signs that points of the region in `box` must have, of primitives that have both signs in
/// the box: all undecided ones of a conjunction, those of a disjunction once its other parts are
/// excluded.
std::vector<NecessarySign> necessary_signs(const RegionEvaluator& region, const Box& box);

}  // namespace rfm
