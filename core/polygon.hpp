#pragma once

#include "core/contour.hpp"
#include "core/outline.hpp"

namespace rfm {

/// The inside of simple polygons, which may lie in each other: a contour within another is a hole,
/// one within a hole an island, and so on. Each contour may run either way round. The region is a
/// Boolean expression in which the half-plane of every edge, an exact signed distance, occurs once
/// (`chain_expression`).
///
/// Sides are `edge1`, `edge2`, … with the prefix of their contour: edge i joins point i and point
/// i + 1. Repeated points are merged; their edges of length zero do not exist. Points on a straight
/// edge divide it into sides that share a primitive (see `Outline`). The contour of a prefix that
/// ends in `_` is a side as a whole, without the `_`.
///
/// Throws `InvalidArgument` for a contour of fewer than three points or without area, and for edges
/// that cross or touch each other, with their names: touching contours are not simple.
Outline polygon(const std::vector<Contour>& contours);

/// A single polygon.
Region polygon(const std::vector<Point>& points);

}  // namespace rfm
