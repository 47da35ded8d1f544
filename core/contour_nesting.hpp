#pragma once

#include <vector>

#include "core/boolean.hpp"
#include "core/box.hpp"

namespace rfm {

/// Contours that do not meet, each with the expression of its inside, as one expression: a contour
/// within another one is a hole, one within a hole an island, and so on.
BooleanExpression nested_expression(const std::vector<std::vector<Point>>& contours,
                                    const std::vector<BooleanExpression>& expressions);

}  // namespace rfm
