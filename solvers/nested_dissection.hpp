#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"

namespace rfm {

/// An order of elimination for matrices of the given spaces, by nested dissection: a grid line
/// (plane) near the median of the functions separates those whose supports lie before it from
/// those behind it; they do not interact, and what straddles the line is eliminated last; and so on
/// in both halves. order[i] is the unknown eliminated at step i, unknowns being numbered space by
/// space.
///
/// Since the grid is known this costs O(n log n), against the graph orderings AMD (the plane) and
/// METIS (space), which take longer than the factorisation itself, and the fill is less. Source:
/// A. George, Nested dissection of a regular finite element mesh (1973).
std::vector<std::int64_t> nested_dissection(std::span<const TensorProductSpace> spaces);

}  // namespace rfm
