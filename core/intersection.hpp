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

/// A zero that is an extreme, where f does not change its sign: a zero of the gradient, by the
/// steps of J. Barzilai and J. M. Borwein (1988), which need no second derivatives. Empty if they
/// do not converge to rounding, or to no zero.
std::optional<Point> double_zero(const LevelFunction& f, const Point& start);

}  // namespace rfm
