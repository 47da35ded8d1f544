#pragma once

#include <optional>
#include <vector>

#include "problems/document.hpp"

namespace rfm {

/// Where each byte of a scalar's text stands in the source, as offsets into it; one more for the
/// end of the text. YAML joins lines (plain and quoted texts, `>`), strips indentation (`>`, `|`)
/// and resolves escapes, so that texts of several lines do not stand in the file as they are.
/// Nothing if the source at the place of the scalar does not read as its text.
std::optional<std::vector<std::size_t>> byte_places(const DocumentNode& scalar);

}  // namespace rfm
