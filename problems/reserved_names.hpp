#pragma once

#include <string>

namespace rfm {

/// Why `name` cannot be the name of a parameter, field, function, shape or region; empty if it can.
/// Names are a letter, then letters, digits and `_`; coordinates, results, functions and a few
/// words
/// (`pi rest all domain boundary`, …) are taken.
std::string objection_to_name(const std::string& name);

}  // namespace rfm
