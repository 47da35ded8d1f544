#pragma once

#include <optional>

#include "core/level_function.hpp"

namespace rfm {

/// A common zero of two functions near `start`, by Newton's method with the shortest step (in 3D
/// the point of the curve of intersection that is nearest to first order). Empty if it does not
/// converge to rounding, as at a tangency.
std::optional<Point> common_zero(const LevelFunction& f, const LevelFunction& g,
                                 const Point& start);

/// The common zero of three functions in space near `start`, in the same way.
std::optional<Point> common_zero(const LevelFunction& f, const LevelFunction& g,
                                 const LevelFunction& h, const Point& start);

/// The zero of one function along its gradient from `start`; empty if it does not converge.
std::optional<Point> nearest_zero(const LevelFunction& f, const Point& start);

}  // namespace rfm
