#include "core/parameters.hpp"

#include <algorithm>
#include <array>

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/expression_tokens.hpp"
#include "core/nearest_name.hpp"

namespace rfm {

Parameters::Parameters(std::initializer_list<std::pair<std::string, double>> named) {
  for (const auto& [name, value] : named) add(name, value);
}

Field Parameters::add(const std::string& name, double value) {
  if (!is_name(name))
    throw InvalidArgument("'" + name + "' cannot name a parameter: names are a letter, then " +
                          "letters, digits and '_'");
  constexpr std::array<std::string_view, 4> coordinates{"x", "y", "z", "t"};
  if (is_reserved_in_expressions(name) || std::ranges::find(coordinates, name) != coordinates.end())
    throw InvalidArgument("'" + name + "' cannot name a parameter: it has a meaning in formulas");
  if (contains(name)) throw InvalidArgument("there is a parameter '" + name + "' already");
  names_.push_back(name);
  values_.push_back(value);
  fields_.push_back(parameter(static_cast<int>(fields_.size()), name));
  return fields_.back();
}

Field Parameters::operator[](std::string_view name) const { return fields_[place_of(name)]; }
double Parameters::value(std::string_view name) const { return values_[place_of(name)]; }
void Parameters::set(std::string_view name, double value) { values_[place_of(name)] = value; }

bool Parameters::contains(std::string_view name) const {
  return std::ranges::find(names_, name) != names_.end();
}

std::size_t Parameters::place_of(std::string_view name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end())
    throw InvalidArgument("there is no parameter '" + std::string(name) + "'" +
                          did_you_mean(std::string(name), names_));
  return static_cast<std::size_t>(found - names_.begin());
}

Field with_values(const Field& f, const Parameters& parameters) {
  return with_leaves(f, [&](const Field& leaf) -> Field {
    const Field::Node& node = leaf.node();
    const bool known =
        node.operation == Operation::parameter && node.index < static_cast<int>(parameters.size());
    return known ? parameters.values()[static_cast<std::size_t>(node.index)] : leaf;
  });
}

}  // namespace rfm
