#pragma once

#include <string>
#include <unordered_map>

#include "problems/document.hpp"
#include "problems/mistakes.hpp"
#include "problems/schema.hpp"

namespace rfm {

/// How the values of a document were understood: the row of each value that fits the table. What is
/// missing here has a mistake that is already reported; readers skip it.
using SchemaMatch = std::unordered_map<const DocumentNode*, const SchemaKey*>;

/// Checks the structure of a document against the table of keys (unknown, duplicate, missing and
/// exclusive keys, kinds of values, words, what is not supported yet) and adds the defaults of keys
/// that were left out, so that readers find every key that has one. Formulas and names are not
/// looked at. Pointers in the result are valid as long as the document is not changed.
SchemaMatch check_structure(DocumentNode& root, MistakeList& mistakes);

}  // namespace rfm
