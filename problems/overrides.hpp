#pragma once

#include <string>
#include <vector>

#include "problems/document.hpp"

namespace rfm {

/// Sets values of a document: `discretization.basis.cells=32`, `conditions.0.value=3`. The path may
/// lead to a key that the document leaves out; maps on the way are made. The value is YAML.
/// Mistakes are placed at "--set path=value", also those found later in what was set.
void apply_overrides(DocumentNode& root, const std::vector<std::string>& overrides,
                     MistakeList& mistakes);

}  // namespace rfm
