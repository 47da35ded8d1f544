#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "problems/boundary_conditions.hpp"
#include "solution_structures/structure.hpp"
#include "solution_structures/structure_text.hpp"

namespace rfm {

/// What formulas of a problem's structures may use: everything that the file defines, what
/// `define_structures` adds for so many undetermined functions, and
///
///     level(hole)      the function of the sign of omega(hole) that products are made of: a
///                      polynomial where there is one, not normalised (core/region.hpp)
///     near(omega, c)   `faded` with a width of c sides of a cell
///
/// unless the file has functions of these names. `cell` is the shortest side of a cell.
ExpressionScope structure_scope(const Problem& problem, int unknowns, double cell);
/// exp(−(ω/w)²): 1 where ω = 0, with no slope there, below 10⁻⁶ from 3.7 w on. Corrections of
/// structures near the boundary are multiplied by it. With w of one and a half cells rules of
/// p + 3 points resolve it, which they do not where exp(−(ω/w)⁴) has the same reach.
Field faded(const Field& omega, double width);
/// The shortest side of a cell.
double cell_side(const Grid& grid);

/// A structure of the problem as one line that, put under `discretization.structure`, is read as
/// the same structure. Functions of shapes and data of `conditions` are written as the file names
/// them where these names have their meaning in `structure_scope`, functions of `calls` as these;
/// everything else is written out. Nothing where the line would be longer than 100,000 characters
/// or cannot be written.
std::optional<std::string> structure_line(const Structure& structure, const Problem& problem,
                                          const std::vector<PieceCondition>& conditions,
                                          double cell,
                                          const std::vector<Structure::Call>& calls = {});

}  // namespace rfm
