#pragma once

#include <optional>

#include "core/combine_rule.hpp"
#include "core/region.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `geometry.combine`: how the Boolean expression of the domain becomes the weight. Names of
/// corner scales are those of the pieces of `domain` (not checked where the domain has a mistake).
WeightOptions read_combine(const DocumentNode& combine, ValueReader& values,
                           const std::optional<Region>& domain);

}  // namespace rfm
