#pragma once

#include <string>

#include "problems/document.hpp"

namespace rfm {

/// A document as YAML. Reading the text gives the same document again, up to places and quotes.
std::string document_text(const DocumentNode& root);

}  // namespace rfm
