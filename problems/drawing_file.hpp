#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problems/point_files.hpp"

namespace rfm {

/// Whether a text is a drawing in the format DXF; comments (group code 999) may stand first.
bool is_drawing(std::string_view text);

/// The outlines of a drawing that are seen in the model: LWPOLYLINE, POLYLINE (of a smoothed one
/// the points of the curve and not of its frame) and CIRCLE, as two half turns. Entities that are
/// invisible, on paper or on a layer that is frozen or off are passed over, and so are texts,
/// dimensions and points. Entities that are seen from below, as by a mirrored extrusion, are
/// mirrored. Throws `InputError` with the line for what else draws a line: other entities, planes
/// that are inclined, polylines whose heights differ, meshes.
std::vector<PointList> outlines_of_drawing(std::string_view text, const std::string& name);

}  // namespace rfm
