#pragma once

#include <optional>

#include "problems/output/image.hpp"
#include "problems/verification.hpp"

namespace rfm {

/// A convergence study as a picture: errors in L2 and of the gradient (or, without an exact
/// solution, the change of u from grid to grid) over the number of cells, both logarithmic, with
/// the observed order of the last pair stated and a triangle of the nearest whole order beside it.
/// Nothing if there are not two errors to join.
std::optional<Image> draw_convergence(const std::vector<ConvergenceRow>& rows,
                                      const std::string& title, int width);

}  // namespace rfm
