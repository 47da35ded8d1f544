#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/field.hpp"

namespace rfm {

/// How fields are written, and what the names in the text stand for.
struct ExpressionTextOptions {
  /// Names of parameters by their number.
  std::vector<std::string> parameters;
  /// Names of sources, and of other fields that shall appear by name. The name must not be taken
  /// by anything else in the scope in which the text is read.
  std::vector<std::pair<std::string, Field>> names;
  /// A graph with shared nodes is a tree as text and may be exponentially longer.
  std::size_t longest = 1'000'000;
  /// For messages to people rather than for reading back: what is too long ends in "…", and what
  /// has no name is described.
  bool abbreviated = false;
};

/// A field as a formula: the text that `to_field(Expression(text), scope)` reads back as the same
/// function, node by node, when `scope` holds the coordinates, derivatives (`dx(f)`, …) and the
/// names given. Only the parentheses that are needed; numbers with as many digits as needed to be
/// the same number again. Throws `InvalidArgument` where a source or parameter has no name, the
/// text would be longer than `options.longest`, or nested more deeply than the parser allows; then
/// `to_definitions` helps.
std::string to_text(const Field& field, const ExpressionTextOptions& options = {});

/// A field as a list of named formulas, each of which uses only names before it: nodes that occur
/// more than once are written once, so that the text is as long as the graph, and deeply nested
/// formulas are cut into pieces.
struct DefinitionsText {
  /// Name and formula; names are `prefix` and a number.
  std::vector<std::pair<std::string, std::string>> definitions;
  std::string formula;
};
DefinitionsText to_definitions(const Field& field, const std::string& prefix = "part",
                               const ExpressionTextOptions& options = {});

/// The shortest decimal number that is read back as `value`.
std::string number_text(double value);

}  // namespace rfm
