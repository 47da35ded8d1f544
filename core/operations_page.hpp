#pragma once

#include <string>

namespace rfm {

/// The table of operations as a Markdown table: name in text, formula, domain, where it is not
/// smooth. Part of docs/fields.md, and what `rfm-solve explain operations` prints.
std::string operations_page();

}  // namespace rfm
