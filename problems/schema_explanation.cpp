#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/operations_page.hpp"
#include "problems/schema.hpp"
#include "problems/schema_text.hpp"

namespace rfm {
namespace {

constexpr std::size_t most_explained_in_full = 5;

/// A key with the names on the way to it; names of the user's choice and list items are not among
/// them.
struct NamedKey {
  const SchemaKey* key;
  std::vector<std::string> names;
  bool is_word = false;
  bool is_supported = true;
};

void collect(const SchemaKey& key, const std::vector<std::string>& names, bool is_supported,
             std::vector<NamedKey>& all) {
  for (const auto* children : {&key.keys, &key.words}) {
    for (const SchemaKey& child : *children) {
      std::vector<std::string> longer = names;
      longer.push_back(child.name);
      const bool works = is_supported && child.status == Status::works;
      all.push_back({&child, longer, children == &key.words, works});
      collect(child, longer, works, all);
    }
  }
  // A map of names and a list pass their own names on.
  for (const auto* children : {&key.items, &key.named})
    for (const SchemaKey& child : *children)
      collect(child, names, is_supported && child.status == Status::works, all);
}

std::vector<std::string> names_of(const std::string& path) {
  std::vector<std::string> names;
  std::string name;
  for (const char letter : path + ".") {
    if (letter != '.' && letter != '[' && letter != ']' && letter != '=') {
      name += letter;
    } else if (!name.empty()) {
      const bool is_index = name.find_first_not_of("0123456789") == std::string::npos;
      if (!is_index && name != "*") names.push_back(name);
      name.clear();
    }
  }
  return names;
}

bool is_subsequence(const std::vector<std::string>& part, const std::vector<std::string>& whole) {
  auto next = part.begin();
  for (const std::string& name : whole)
    if (next != part.end() && *next == name) ++next;
  return next == part.end();
}

// Either the end of a path as the table has it, or a whole path as in a file, where names of the
// user's choice stand in between.
bool matches(const std::vector<std::string>& asked, const std::vector<std::string>& names) {
  if (asked.empty()) return false;
  const bool is_end =
      asked.size() <= names.size() && std::equal(asked.rbegin(), asked.rend(), names.rbegin());
  return is_end || (asked.front() == names.front() && asked.back() == names.back() &&
                    is_subsequence(names, asked));
}

// Profiles have the keys of shapes: they are shown where they are asked for.
bool repeats_shapes(const std::vector<std::string>& asked, const std::vector<std::string>& names) {
  return names.size() > 2 && names[1] == "profiles" &&
         std::ranges::find(asked, "profiles") == asked.end();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string readable(std::string path) {
  for (std::size_t at = path.find('*'); at != std::string::npos; at = path.find('*'))
    path.replace(at, 1, "NAME");
  return path;
}

std::string names_in(const std::vector<SchemaKey>& keys, Status status) {
  std::vector<std::string> names;
  for (const SchemaKey& key : keys)
    if (key.status == status) names.push_back(key.name);
  return joined(names);
}

std::string line(const std::string& label, const std::string& text) {
  return text.empty() ? "" : "  " + label + ": " + text + "\n";
}

std::string presence_text(const SchemaKey& key) {
  switch (key.presence.kind) {
    case Presence::Kind::required:
      return key.presence.unless.empty()
                 ? "required"
                 : "required unless given in " + std::string(key.presence.unless);
    case Presence::Kind::alternative:
      return "exactly one of its kind must be given";
    case Presence::Kind::optional:
      return "optional";
  }
  return "";
}

std::string explanation(const NamedKey& named) {
  const SchemaKey& key = *named.key;
  std::string text = readable(key.path) + (named.is_supported ? "" : "  (not supported yet)") +
                     "\n  " + key.doc + "\n";
  if (named.is_word) return text;
  text += line("takes", type_text(key));
  text += line("range", key.range.text());
  text += line("presence", presence_text(key));
  text += line("default", std::string(key.presence.standard));
  text += line("goes with", joined(key.when));
  text += line("words", names_in(key.words, Status::works));
  text += line("words not supported yet", names_in(key.words, Status::later));
  const std::vector<SchemaKey>& inner = !key.named.empty()   ? key.named[0].keys
                                        : !key.items.empty() ? key.items[0].keys
                                                             : key.keys;
  text += line("keys", names_in(inner, Status::works));
  text += line("keys not supported yet", names_in(inner, Status::later));
  return text;
}

}  // namespace

std::string explain_key(const std::string& key) {
  if (key == "operations") return operations_page();
  std::vector<NamedKey> all;
  collect(schema(), {}, true, all);
  const std::vector<std::string> asked = names_of(key);
  std::vector<const NamedKey*> found;
  for (const NamedKey& candidate : all)
    if (matches(asked, candidate.names) && !repeats_shapes(asked, candidate.names))
      found.push_back(&candidate);
  if (found.empty()) {
    std::vector<std::string> known;
    for (const NamedKey& candidate : all) known.push_back(candidate.names.back());
    const std::string last = asked.empty() ? key : asked.back();
    throw InputError("unknown key '" + key + "'" + did_you_mean(last, known), 0, key.size());
  }
  std::string text;
  const bool in_full = found.size() <= most_explained_in_full;
  for (const NamedKey* match : found)
    text += in_full ? (text.empty() ? "" : "\n") + explanation(*match)
                    : readable(match->key->path) + "\n  " + match->key->doc + "\n";
  return text;
}

}  // namespace rfm
