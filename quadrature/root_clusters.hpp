#pragma once

#include "quadrature/line_roots.hpp"

namespace rfm {

/// Finds which of the roots of a line, ascending, are in one place, and divides these into clusters
/// of surfaces that are one as far as neighbouring lines tell: sets `roots.joined`, and puts
/// surfaces that only touch into the order in which neighbouring lines meet them. A cluster in
/// which something of a length that is more than rounding is inside, without effect on what is
/// beyond, is noted as a loss.
void form_clusters(const ActiveSet& active, const LineSegment& line, LineRoots& roots);

}  // namespace rfm
