#pragma once

#include "core/field.hpp"

namespace rfm {

/// A density of energy, with unknowns as symbols, without its loads: the terms of its sum that are
/// linear in the unknowns, as −f u of ½ |∇u|² − f u; factors and divisors without unknowns are
/// multiplied in first. What is left is the energy that is stored. Terms are told by the formula:
/// a load hidden in a square, as in (u − f)², belongs to what is stored.
Field without_loads(const Field& density);

}  // namespace rfm
