#pragma once

#include "core/separators.hpp"
#include "problems/set_reader.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads a shape that is given by the sets that its boundary is made of: a list of names. Nothing,
/// with a mistake, if they do not close, or do not describe a solid.
std::optional<DescribedSolid> read_described_solid(const DocumentNode& list, ValueReader& values,
                                                   SetReader& sets);

/// What was needed to tell the inside of a shape from its outside, for people: a line, or two where
/// its own pieces did not suffice.
std::vector<std::string> description_lines(const std::string& shape, const DescribedSolid& solid);

}  // namespace rfm
