#pragma once

#include "problems/problem.hpp"
#include "problems/shape_reader.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads a region that geometry chooses among all pieces of the boundary: `{touching: shape}`,
/// `{normal: direction, within: degrees}`, `{near: what, within: length}` with a point, a set or an
/// STL file in `folder`. Pieces of which it certainly holds nothing are left out;
/// a region without any is a mistake.
void read_chosen_by_geometry(const DocumentNode& map, ValueReader& values, ShapeReader& shapes,
                             const std::string& folder, BoundaryTarget& region);

}  // namespace rfm
