#pragma once

#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace rfm {

/// A line for each material whose conductivity is another than around it although no interface
/// (`{at: shape, interface: {jump: 0}}`) lets the slope of u jump there: splines smooth the kink
/// over, and errors fall slowly whatever their degree. Of parts of the boundary of a material
/// those that are in the domain's own expression are taken to be on the boundary of the domain if
/// others are interfaces.
std::vector<std::string> kink_notes(const Problem& problem);

}  // namespace rfm
