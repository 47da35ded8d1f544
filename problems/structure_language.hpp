#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "problems/boundary_conditions.hpp"
#include "solution_structures/structure.hpp"
#include "solution_structures/structure_text.hpp"

namespace rfm {

/// How large the cells of a grid are, along each axis (on average), and the grid.
struct CellSides {
  int dimension = 2;
  Point side{};
  double whole = 1;
};
CellSides cell_sides(const Grid& grid);

/// What formulas of a problem's structures may use: everything that the file defines, what
/// `define_structures` adds for so many undetermined functions, and
///
///     level(hole)      the function of the sign of omega(hole) that products are made of: a
///                      polynomial where there is one, not normalised (core/region.hpp)
///     near(omega, c)   `faded` with a width of c cells
///
/// unless the file has functions of these names.
ExpressionScope structure_scope(const Problem& problem, int unknowns, const CellSides& cell);
/// exp(−(d/c)²) with c = `cells` and d² = ω²/Σ(hᵢ ∂ᵢω)², how many cells with sides hᵢ it is to ω =
/// 0 to first order: 1 where ω = 0, with no slope there, below 10⁻⁶ from 3.7 c on. Corrections of
/// structures near the boundary are multiplied by it. It fades in cells of any shape as slowly as
/// rules of p + 3 points can resolve with c = 1.5 (exp(−(d/c)⁴) with the same reach does not), and
/// away from primitives that level off near their boundary, as that of a slender ellipse does.
Field faded(const Field& omega, double cells, const CellSides& cell);
/// The shortest side of a cell.
double cell_side(const Grid& grid);

/// A structure of the problem as one line that, put under `discretization.structure`, is read as
/// the same structure. Functions of shapes and data of `conditions` are written as the file names
/// them where these names have their meaning in `structure_scope`, functions of `calls` as these;
/// everything else is written out. Nothing where the line would be longer than 100,000 characters
/// or cannot be written.
std::optional<std::string> structure_line(const Structure& structure, const Problem& problem,
                                          const std::vector<PieceCondition>& conditions,
                                          const CellSides& cell,
                                          const std::vector<Structure::Call>& calls = {});

}  // namespace rfm
