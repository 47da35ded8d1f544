#pragma once

#include <optional>
#include <span>

#include "core/field.hpp"

namespace rfm {

/// Ψ_k as a leaf of expressions, for k = 0, 1, …: formulas of structures are fields in which it
/// stands, so that everything that transforms and writes fields works on them. It has no values:
/// evaluated it is NaN, until `with_functions` puts a function in its place. Calls with the same k
/// are the same function. Throws `InvalidArgument` unless 0 ≤ k < 64.
Field undetermined_function(int unknown);

/// k if the node is Ψ_k.
std::optional<int> undetermined_index(const Field::Node& node);

/// Whether any Ψ occurs in `formula`.
bool has_undetermined(const Field& formula);

/// `formula` with functions[k] in the place of Ψ_k. Throws `InvalidArgument` if a Ψ_k occurs for
/// which none is given.
Field with_functions(const Field& formula, std::span<const Field> functions);

}  // namespace rfm
