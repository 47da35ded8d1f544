#pragma once

#include <string>

namespace rfm {

/// What the table says of a key: what it takes, whether it must be there, its default, range and
/// keys. `key` is a path or its end: `geometry.shapes.circle.radius`, `circle.radius`, `radius`,
/// `conditions.0.value`. Throws `InputError` for a key that does not exist, with a suggestion.
std::string explain_key(const std::string& key);

/// The table as a JSON Schema (draft 2020-12), for editors. Keys that are not supported yet are
/// left out, so that an editor marks them as the reader does.
std::string json_schema_text();

}  // namespace rfm
