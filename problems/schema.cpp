#include "problems/schema.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <utility>

#include "core/error.hpp"

namespace rfm {
namespace {

std::string number_text(double value) {
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%g", value);
  return buffer.data();
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

SchemaKey key_of(const SchemaRow& row, std::string name) {
  SchemaKey key;
  key.name = std::move(name);
  key.path = row.path;
  key.types = row.types;
  key.presence = row.presence;
  key.doc = row.doc;
  key.status = row.status;
  key.range = row.range;
  key.when = words_of(row.when);
  return key;
}

/// Puts a row into the tree: follows its path, whose parents stand before it in the table, and
/// appends it to the right list of its parent.
class TreeBuilder {
 public:
  explicit TreeBuilder(SchemaKey& root) : root_(root) {}

  void add(const SchemaRow& row) {
    SchemaKey* parent = &root_;
    std::string_view rest = row.path;
    std::string name;
    std::vector<SchemaKey>* siblings = nullptr;
    while (!rest.empty()) {
      if (siblings) parent = find(*siblings, name, row.path);
      siblings = &step(*parent, rest, name);
    }
    siblings->push_back(key_of(row, name));
  }

 private:
  // Cuts one step off the path: the list of `parent` it leads to, and the name in it.
  static std::vector<SchemaKey>& step(SchemaKey& parent, std::string_view& rest,
                                      std::string& name) {
    if (rest.starts_with("[]")) {
      rest.remove_prefix(2);
      name = "[]";
      return parent.items;
    }
    const bool is_word = rest.starts_with('=');
    if (is_word || rest.starts_with('.')) rest.remove_prefix(1);
    const std::size_t end =
        is_word ? rest.size() : std::min(rest.find_first_of(".[="), rest.size());
    name = rest.substr(0, end);
    rest.remove_prefix(end);
    return is_word ? parent.words : name == "*" ? parent.named : parent.keys;
  }

  static SchemaKey* find(std::vector<SchemaKey>& siblings, const std::string& name,
                         std::string_view path) {
    const auto found = std::ranges::find(siblings, name, &SchemaKey::name);
    if (found == siblings.end())
      throw InvalidArgument("the table of keys lacks the parent of " + std::string(path));
    return &*found;
  }

  SchemaKey& root_;
};

SchemaKey* find_key(SchemaKey& parent, std::string_view name) {
  return &*std::ranges::find(parent.keys, name, &SchemaKey::name);
}

SchemaKey child_of(const SchemaKey& parent, const std::string& name, unsigned types,
                   const Presence& presence, const std::string& doc) {
  SchemaKey key;
  key.name = name;
  key.path = parent.path + (name == "[]" ? "" : ".") + name;
  key.types = types;
  key.presence = presence;
  key.doc = doc;
  return key;
}

// {interpolate: [{at: .., value: ..}, ..]}: a coefficient graded between sets.
SchemaKey interpolation_of(const SchemaKey& coefficient) {
  SchemaKey list = child_of(coefficient, "interpolate", list_value, alternative,
                            "Values on sets, shapes and sides, joined by transfinite "
                            "interpolation: a graded material.");
  SchemaKey item = child_of(list, "[]", map_value, required, "Data on one or several of them.");
  SchemaKey at = child_of(item, "at", name_value | list_value, required,
                          "A set, a side, a shape that bounds the domain, or one inside it, whose "
                          "points all are meant.");
  at.items = {child_of(at, "[]", name_value, required, "A set, side or shape.")};
  SchemaKey exponent = child_of(item, "exponent", integer_value, optional,
                                "How flat the coefficient is next to it.");
  exponent.range = between(1, 16);
  item.keys = {std::move(at), child_of(item, "value", expression_value, required, "The value."),
               child_of(item, "normal_derivative", expression_value, optional,
                        "Its derivative along the outward normal."),
               std::move(exponent)};
  list.items = {std::move(item)};
  return list;
}

// Coefficients may be given per material, may come from another problem, and be graded.
void extend_coefficients(SchemaKey& physics) {
  SchemaKey& material = find_key(physics, "materials")->items[0];
  for (SchemaKey& key : physics.keys) {
    if (!key.takes(expression_value)) continue;
    key.types |= map_value;
    key.keys = {child_of(key, "from", file_value, alternative,
                         "Another problem file, which is solved first."),
                child_of(key, "field", name_value, required, "The result of that problem."),
                interpolation_of(key)};
    key.keys[1].when = {"from"};
    SchemaKey in_material = key;
    in_material.path.replace(0, physics.path.size(), material.path);
    in_material.presence = optional;
    material.keys.push_back(std::move(in_material));
  }
}

void move_to(SchemaKey& key, const std::string& from, const std::string& to) {
  key.path.replace(0, from.size(), to);
  for (auto* children : {&key.keys, &key.items, &key.named, &key.words})
    for (SchemaKey& child : *children) move_to(child, from, to);
}

// Profiles are shapes of the plane, whatever the dimension of the problem.
void extend_profiles(SchemaKey& geometry) {
  const SchemaKey& shape = find_key(geometry, "shapes")->named[0];
  SchemaKey& profile = find_key(geometry, "profiles")->named[0];
  for (SchemaKey key : shape.keys) {
    if (!key.when.empty() && std::ranges::find(key.when, "2D") == key.when.end()) continue;
    key.when.clear();
    move_to(key, shape.path, profile.path);
    profile.keys.push_back(std::move(key));
  }
}

SchemaKey build() {
  SchemaKey root;
  root.doc = "A problem file.";
  TreeBuilder builder(root);
  for (const auto rows : {document_rows(), shape_rows(), geometry_rows(), condition_rows(),
                          physics_rows(), run_rows()})
    for (const SchemaRow& row : rows) builder.add(row);
  extend_coefficients(*find_key(root, "physics"));
  extend_profiles(*find_key(root, "geometry"));
  return root;
}

}  // namespace

bool Range::contains(double value) const {
  return (low_excluded ? value > low : value >= low) && value <= high;
}

std::string Range::text() const {
  const bool has_low = low != Range{}.low, has_high = high != Range{}.high;
  if (low == high) return number_text(low);
  if (has_low && has_high && !low_excluded)
    return "from " + number_text(low) + " to " + number_text(high);
  std::string text;
  if (has_low) text = (low_excluded ? "greater than " : "at least ") + number_text(low);
  if (has_high) text += (has_low ? " and at most " : "at most ") + number_text(high);
  return text;
}

const SchemaKey& schema() {
  static const SchemaKey root = build();
  return root;
}

std::string type_text(const SchemaKey& key) {
  constexpr std::array<std::pair<unsigned, std::string_view>, 17> names = {{
      {number_value, "a number"},
      {integer_value, "a whole number"},
      {boolean_value, "true or false"},
      {text_value, "a text"},
      {word_value, "a word"},
      {name_value, "a name"},
      {expression_value, "a number or formula"},
      {result_value, "a formula"},
      {shapes_value, "an expression of shapes"},
      {file_value, "a file name"},
      {vector_value, "a list of coordinates"},
      {numbers_value, "a list of numbers"},
      {matrix_value, "a matrix"},
      {list_value, "a list"},
      {map_value, "a map"},
      {named_map_value, "a map of names"},
      {functions_value, "a map of functions"},
  }};
  std::vector<std::string> parts;
  for (const auto& [type, name] : names) {
    // {from: file} of coefficients is an exotic form: not offered to somebody in error.
    const bool offered = type != map_value || key.keys.empty() || key.keys[0].name != "from";
    if (key.takes(type) && offered) parts.emplace_back(name);
  }
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " or " : ", ") + parts[i];
  return text;
}

}  // namespace rfm
