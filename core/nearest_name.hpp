#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rfm {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment), letters of either case being equal. Time and memory are those of the
/// product of the lengths.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate that a misspelt name most likely means: the nearest at distance ≤ 2 (≤ 1 for names
/// of two or three letters, 0 for one letter), the first of equals; empty if there is none.
///
///     nearest_name("raduis", {"center", "radius"})   →   "radius"
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// " (did you mean 'radius'?)", or nothing: for the end of a message about an unknown name.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

}  // namespace rfm
