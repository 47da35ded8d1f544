#include "core/expression_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <unordered_set>

#include "core/error.hpp"
#include "core/expression_tokens.hpp"
#include "core/expression_writer.hpp"

namespace rfm {
namespace {

FieldNames given_names(const ExpressionTextOptions& options) {
  FieldNames names;
  for (const auto& [name, field] : options.names) names.emplace(&field.node(), name);
  return names;
}

/// Nodes of a graph, arguments before users, with how often each is used and how deep it is.
struct Census {
  struct Entry {
    int uses = 0;
    std::size_t depth = 0;
  };
  std::vector<const Field::Node*> order;
  std::unordered_map<const Field::Node*, Entry> entries;
};

Census take_census(const Field::Node& root) {
  Census census;
  std::vector<std::pair<const Field::Node*, bool>> pending{{&root, false}};
  while (!pending.empty()) {
    const auto [node, done] = pending.back();
    pending.pop_back();
    if (done) {
      census.order.push_back(node);
      continue;
    }
    if (!census.entries.try_emplace(node).second) continue;
    pending.emplace_back(node, true);
    for (const Field& argument : node->arguments) pending.emplace_back(&argument.node(), false);
  }
  for (const Field::Node* node : census.order)
    for (const Field& argument : node->arguments) ++census.entries[&argument.node()].uses;
  return census;
}

}  // namespace

std::string number_text(double value) {
  if (std::isnan(value)) return "0/0";
  if (std::isinf(value)) return value > 0 ? "1/0" : "-1/0";
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string to_text(const Field& field, const ExpressionTextOptions& options) {
  const FieldNames names = given_names(options);
  if (const auto name = names.find(&field.node()); name != names.end()) return name->second;
  return written(field.node(), options, names);
}

DefinitionsText to_definitions(const Field& field, const std::string& prefix,
                               const ExpressionTextOptions& options) {
  constexpr std::size_t deepest_part = 100;
  FieldNames names = given_names(options);
  std::unordered_set<std::string> taken(options.parameters.begin(), options.parameters.end());
  for (const auto& [node, name] : names) taken.insert(name);
  if (!is_name(prefix)) throw InvalidArgument("'" + prefix + "' cannot begin the name of a part");
  Census census = take_census(field.node());
  for (const Field::Node* node : census.order)
    if (node->name) taken.insert(*node->name);
  DefinitionsText text;
  int number = 0;
  for (const Field::Node* node : census.order) {
    if (node == &field.node() || node->arguments.empty() || names.contains(node)) continue;
    Census::Entry& entry = census.entries[node];
    for (const Field& argument : node->arguments)
      entry.depth = std::max(entry.depth, census.entries[&argument.node()].depth + 1);
    if (entry.uses < 2 && entry.depth < deepest_part) continue;
    std::string name;
    do name = prefix + std::to_string(++number);
    while (taken.contains(name));
    text.definitions.emplace_back(name, written(*node, options, names));
    names.emplace(node, std::move(name));
    entry.depth = 0;
  }
  const auto name = names.find(&field.node());
  text.formula = name != names.end() ? name->second : written(field.node(), options, names);
  return text;
}

}  // namespace rfm
