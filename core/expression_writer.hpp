#pragma once

#include <string>
#include <unordered_map>

#include "core/expression_text.hpp"

namespace rfm {

/// Fields that are written by name, as nodes.
using FieldNames = std::unordered_map<const Field::Node*, std::string>;

/// One formula: `root` written out, also where it has a name itself, and what it is made of down to
/// fields with names. Throws as `to_text` does.
std::string written(const Field::Node& root, const ExpressionTextOptions& options,
                    const FieldNames& names);

}  // namespace rfm
