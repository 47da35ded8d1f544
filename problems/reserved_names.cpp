#include "problems/reserved_names.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/expression.hpp"
#include "core/expression_tokens.hpp"

namespace rfm {
namespace {

constexpr std::array<std::string_view, 16> reserved = {
    "x",    "y",      "z",        "t", "n",        "pi",   "rest", "all",
    "free", "domain", "boundary", "u", "gradient", "flux", "true", "false"};

}  // namespace

std::string objection_to_name(const std::string& name) {
  if (!is_name(name))
    return "'" + name + "' is not a name: expected a letter, then letters, digits and '_'";
  if (std::ranges::find(reserved, name) != reserved.end() || name == "null")
    return "the name '" + name + "' is reserved";
  if (is_reserved_in_expressions(name)) return "the name '" + name + "' is that of a function";
  return {};
}

}  // namespace rfm
