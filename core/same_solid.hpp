#pragma once

#include "core/region.hpp"

namespace rfm {

/// Whether two functions are multiples of each other, seen at a few points of `bounds`: the ratio
/// if they are (to 1e-11), 0 otherwise.
double ratio_of_multiples(const LevelFunction& f, const LevelFunction& g, const Box& bounds);

/// Whether two expressions of the primitives of a region are the same set up to boundaries: true
/// only where it is proved, so that holes and gaps of any width down to 2⁻⁴⁰ of the longest side
/// tell sets apart.
///
/// Boxes are halved until the two agree for all signs of the primitives that bounds leave open
/// there. Primitives that are multiples of each other have one sign. Where three planes meet in a
/// line (four in a point, three lines in a point) combinations of signs are left out that a sum of
/// them with positive factors, which is a constant, excludes. Curved primitives that meet three at
/// a time get no such proof.
bool same_solid(const BooleanExpression& a, const BooleanExpression& b,
                const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
