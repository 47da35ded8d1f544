#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "core/region.hpp"
#include "problems/structure_options.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// A part of the domain with splines of its own, of finer cells (V. Tsukanov and V. Shapiro, 2007):
///
///     u = u₀ + ω ω₁^{m+1} H(ω₁) Ψ₁ ,
///
/// ω the factor of the boundary's values and ω₁ the weight of the window's shape (a product or an
/// R-function, as of a domain). What it adds vanishes at its edge with m derivatives, and at values
/// of the boundary that it meets. Windows may overlap and be nested.
struct Window {
  WindowOption option;
  Box box;           ///< around the shape's part of the domain
  Field factor;      ///< ω₁^{m+1} H(ω₁), with ω₁ divided by a length
  int finer = 1;     ///< so many of its cells lie along one of the domain
  int function = 0;  ///< the first of its undetermined functions, one for each unknown
};

/// The windows that the file asks for, with functions numbered from `function` on, which is
/// advanced by the number of unknowns for each; those that are solved with the domain come first.
/// `finer` is the least power of two that gives as many cells on `grid` as the file says: lines of
/// one window are then lines of a finer one. Throws `ProblemFileErrors` where a window lies outside
/// of the domain. `bounds` is the box of the domain.
std::vector<Window> windows(const Problem& problem, const Grid& grid, const Box& bounds,
                            int unknowns, int& function);

/// The cells of `grid` that hold a window, each divided along every axis.
Grid window_grid(const Window& window, const Grid& grid);

/// The grid with the lines of all windows: every function is a polynomial, times the factors of its
/// structure, in each cell. The grid itself where there are no windows.
Grid common_grid(const Grid& grid, std::span<const Window> windows);

/// The splines of a function on a grid of its own: those with a cell that has a flagged one of the
/// common grid in it.
TensorProductSpace own_space(const Grid& own, const Grid& common, int degree,
                             std::span<const std::uint8_t> common_cells);

}  // namespace rfm
