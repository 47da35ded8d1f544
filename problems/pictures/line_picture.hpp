#pragma once

#include "problems/pictures/shown_field.hpp"

namespace rfm {

/// A field over a domain on the line: a plot over x, broken where the domain is.
Image draw_line(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                std::vector<std::string>& remarks);

/// The intervals of a domain on the line within `bounds`, those shorter than 1/2000 of it excepted.
/// Their ends are found by bisection.
std::vector<Interval> intervals_of(const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
