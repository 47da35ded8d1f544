#include "problems/schema_check.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "core/nearest_name.hpp"

namespace rfm {
namespace {

constexpr unsigned scalar_types = number_value | integer_value | boolean_value | text_value |
                                  word_value | name_value | expression_value | result_value |
                                  shapes_value | file_value;
constexpr unsigned list_types = vector_value | numbers_value | matrix_value | list_value;
constexpr unsigned map_types = map_value | named_map_value | functions_value;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

const char* kind_text(DocumentNode::Kind kind) {
  switch (kind) {
    case DocumentNode::Kind::empty:
      return "nothing";
    case DocumentNode::Kind::scalar:
      return "a single value";
    case DocumentNode::Kind::list:
      return "a list";
    case DocumentNode::Kind::map:
      return "a map";
  }
  return "";
}

/// Paths of keys of this name anywhere in the table, without repetition.
void find_elsewhere(const SchemaKey& key, const std::string& name, std::set<std::string>& parents) {
  for (const auto* children : {&key.keys, &key.items, &key.named})
    for (const SchemaKey& child : *children) {
      if (child.name == "profiles") continue;  // the same keys as shapes
      if (child.name == name && child.status == Status::works)
        parents.insert(key.path.empty() ? "the top level" : key.path);
      if (child.status == Status::works) find_elsewhere(child, name, parents);
    }
}

class StructureCheck {
 public:
  StructureCheck(MistakeList& mistakes, SchemaMatch& match) : mistakes_(mistakes), match_(match) {}

  void check_document(DocumentNode& root) {
    if (const DocumentNode* dimension = root.find("dimension"))
      if (dimension->text == "1" || dimension->text == "2" || dimension->text == "3")
        dimension_ = dimension->text;
    check(root, schema(), "", root.place);
  }

 private:
  // `label` names the value in messages; `owner` is where it is looked for: its key, if it has one.
  void check(DocumentNode& node, const SchemaKey& key, const std::string& label,
             const Place& owner) {
    if (key.status == Status::later) return refuse_later(label.empty() ? key.name : label, owner);
    const unsigned types = node.is_scalar() ? scalar_types
                           : node.is_list() ? list_types
                           : node.is_map()  ? map_types
                                            : 0u;
    if (!key.takes(types)) {
      const std::string what = key.path.empty() ? "a problem file" : "'" + label + "'";
      return mistakes_.add(
          "expected " + expected_text(key) + " for " + what + " but found " + kind_text(node.kind),
          node.place);
    }
    const bool fits = node.is_scalar() ? check_scalar(node, key, label)
                      : node.is_list() ? check_list(node, key, label)
                                       : check_map(node, key, label, owner);
    if (fits) match_[&node] = &key;
  }

  static std::string expected_text(const SchemaKey& key) {
    if (key.types == word_value) return "one of: " + joined(working_words(key));
    return type_text(key);
  }

  void refuse_later(const std::string& name, const Place& place) {
    mistakes_.add("'" + name + "' is not supported yet", place);
  }

  static std::vector<std::string> working_words(const SchemaKey& key) {
    std::vector<std::string> words;
    for (const SchemaKey& word : key.words)
      if (word.status == Status::works) words.push_back(word.name);
    return words;
  }

  bool check_scalar(const DocumentNode& node, const SchemaKey& key, const std::string& label) {
    if (key.takes(word_value)) {
      const auto word = std::ranges::find(key.words, node.text, &SchemaKey::name);
      if (word != key.words.end() && word->status == Status::later) {
        const bool is_telling = is_letter(node.text);
        refuse_later(is_telling ? node.text : label + " " + node.text, node.place);
        return false;
      }
      if (word == key.words.end() && !key.takes(scalar_types & ~word_value)) {
        const std::vector<std::string> words = working_words(key);
        mistakes_.add("'" + node.text + "' cannot be the value of '" + label + "'" +
                          did_you_mean(node.text, words) + "; expected: " + joined(words),
                      node.place);
        return false;
      }
    }
    if (key.takes(boolean_value) && !key.takes(scalar_types & ~boolean_value) &&
        node.text != "true" && node.text != "false") {
      mistakes_.add("expected true or false for '" + label + "' but found '" + node.text + "'",
                    node.place);
      return false;
    }
    return true;
  }

  static bool is_letter(const std::string& text) {
    return !text.empty() && (text[0] < '0' || text[0] > '9');
  }

  bool check_list(DocumentNode& node, const SchemaKey& key, const std::string& label) {
    if (key.items.empty()) return true;
    for (std::size_t i = 0; i < node.items.size(); ++i)
      check(node.items[i], key.items[0], label + "[" + std::to_string(i) + "]",
            node.items[i].place);
    return true;
  }

  bool check_map(DocumentNode& node, const SchemaKey& key, const std::string& label,
                 const Place& owner) {
    report_duplicates(node);
    if (key.takes(functions_value)) return true;
    if (key.takes(named_map_value)) {
      for (DocumentNode::Entry& entry : node.entries)
        check(entry.value, key.named[0], entry.key, entry.key_place);
      return true;
    }
    if (!check_type_word(node, key, label, owner)) return false;
    const std::set<std::string> active = active_words(node, key);
    const std::set<std::string> enclosing = std::exchange(enclosing_words_, active);
    check_entries(node, key, label, owner, active);
    enclosing_words_ = enclosing;
    return true;
  }

  void check_entries(DocumentNode& node, const SchemaKey& key, const std::string& label,
                     const Place& owner, const std::set<std::string>& active) {
    const std::size_t given = node.entries.size();
    add_defaults(node, key, active);
    std::set<std::string> taken_for;  // keys that a misspelt one probably means
    for (std::size_t i = 0; i < node.entries.size(); ++i) {
      DocumentNode::Entry& entry = node.entries[i];
      const SchemaKey* child = find_applicable(key, entry.key, active);
      if (child)
        check(entry.value, *child, entry.key, entry.key_place);
      else if (i < given)
        taken_for.insert(refuse_key(entry, key, label, active));
    }
    check_presence(node, key, label, owner, active, taken_for);
  }

  void report_duplicates(const DocumentNode& node) {
    std::unordered_map<std::string_view, const Place*> first;
    for (const DocumentNode::Entry& entry : node.entries) {
      const auto [known, is_new] = first.emplace(entry.key, &entry.key_place);
      if (!is_new)
        mistakes_.add("duplicate key '" + entry.key + "'", entry.key_place,
                      {{"first given here", *known->second}});
    }
  }

  // The `type` of a map decides which keys it has: where it is wrong, they are not judged.
  bool check_type_word(DocumentNode& node, const SchemaKey& key, const std::string& label,
                       const Place& owner) {
    const auto type = std::ranges::find(key.keys, "type", &SchemaKey::name);
    if (type == key.keys.end() || type->words.empty()) return true;
    DocumentNode* value = node.find("type");
    if (!value) {
      if (type->presence.kind != Presence::Kind::required) return true;
      mistakes_.add("missing key 'type' in " + label, owner);
      return false;
    }
    check(*value, *type, "type", value->place);
    return match_.contains(value);
  }

  std::set<std::string> active_words(const DocumentNode& node, const SchemaKey& key) const {
    // What goes with the type of physics does so in its materials, too.
    std::set<std::string> active = enclosing_words_;
    for (const std::string dimension : {"1", "2", "3"})
      if (dimension_.empty() || dimension_ == dimension) active.insert(dimension + "D");
    for (const SchemaKey& child : key.keys) {
      const DocumentNode* value = node.find(child.name);
      if (child.name == "type" || child.name == "rule") {
        const std::string standard(child.presence.standard);
        active.insert(value && value->is_scalar() ? value->text : standard);
      }
      const bool is_standard = !child.presence.standard.empty() && !has_alternative(node, key);
      if (child.presence.kind == Presence::Kind::alternative && (value || is_standard))
        active.insert(child.name);
    }
    return active;
  }

  static bool applies(const SchemaKey& key, const std::set<std::string>& active) {
    return key.when.empty() || std::ranges::any_of(key.when, [&](const std::string& word) {
             return active.contains(word);
           });
  }

  static const SchemaKey* find_applicable(const SchemaKey& parent, const std::string& name,
                                          const std::set<std::string>& active) {
    for (const SchemaKey& child : parent.keys)
      if (child.name == name && applies(child, active)) return &child;
    return nullptr;
  }

  void add_defaults(DocumentNode& node, const SchemaKey& key, const std::set<std::string>& active) {
    for (const SchemaKey& child : key.keys) {
      if (child.presence.standard.empty() || node.find(child.name) || !applies(child, active) ||
          child.status == Status::later ||
          (!child.presence.unless.empty() && node.find(child.presence.unless)))
        continue;
      if (child.presence.kind == Presence::Kind::alternative && has_alternative(node, key))
        continue;
      const auto source =
          make_source("default of " + child.path, std::string(child.presence.standard), false);
      node.entries.push_back({child.name, {source}, parse_document(source)});
    }
  }

  static bool has_alternative(const DocumentNode& node, const SchemaKey& key) {
    return std::ranges::any_of(key.keys, [&](const SchemaKey& child) {
      return child.presence.kind == Presence::Kind::alternative && node.find(child.name);
    });
  }

  static std::vector<std::string> applicable_keys(const SchemaKey& key,
                                                  const std::set<std::string>& active,
                                                  bool alternatives_only = false) {
    std::vector<std::string> names;
    for (const SchemaKey& child : key.keys)
      if (child.status == Status::works && applies(child, active) &&
          (!alternatives_only || child.presence.kind == Presence::Kind::alternative))
        names.push_back(child.name);
    return names;
  }

  // Reports a key that the map does not have; returns the key that it probably means.
  std::string refuse_key(const DocumentNode::Entry& entry, const SchemaKey& key,
                         const std::string& label, const std::set<std::string>& active) {
    if (mistakes_.is_full()) return {};
    const std::string in = label.empty() ? "" : " in " + label;
    const std::vector<std::string> known = applicable_keys(key, active);
    const std::string expected = "; expected: " + joined(known);
    const auto other = std::ranges::find(key.keys, entry.key, &SchemaKey::name);
    if (other != key.keys.end()) {
      mistakes_.add(
          "key '" + entry.key + "'" + in + " goes with " + joined(other->when) + " only" + expected,
          entry.key_place);
      return {};
    }
    // Keys that are not supported yet are not offered, but a misspelt one is recognised.
    std::vector<std::string> candidates = known;
    for (const SchemaKey& child : key.keys)
      if (applies(child, active)) candidates.push_back(child.name);
    std::string hint = did_you_mean(entry.key, candidates);
    if (hint.empty()) {
      std::set<std::string> parents;
      find_elsewhere(schema(), entry.key, parents);
      if (parents.size() == 1) hint = " (it is a key of " + *parents.begin() + ")";
    }
    mistakes_.add("unknown key '" + entry.key + "'" + in + hint + expected, entry.key_place);
    return nearest_name(entry.key, candidates).empty() ? "?" : nearest_name(entry.key, candidates);
  }

  void check_presence(const DocumentNode& node, const SchemaKey& key, const std::string& label,
                      const Place& owner, const std::set<std::string>& active,
                      const std::set<std::string>& taken_for) {
    const std::string in = label.empty() ? "" : " in " + label;
    std::vector<const DocumentNode::Entry*> alternatives;
    bool has_alternatives = false;
    for (const SchemaKey& child : key.keys) {
      if (!applies(child, active)) continue;
      const auto given = std::ranges::find(node.entries, child.name, &DocumentNode::Entry::key);
      const bool is_given = given != node.entries.end();
      const std::string unless(child.presence.unless);
      const bool has_other = !unless.empty() && node.find(unless);
      if (child.presence.kind == Presence::Kind::alternative) {
        has_alternatives = true;
        if (is_given && !has_other) alternatives.push_back(&*given);
      } else if (child.presence.kind == Presence::Kind::required) {
        if (!is_given && !has_other && !taken_for.contains(child.name))
          mistakes_.add("missing key '" + child.name + "'" + in, owner);
      } else if (is_given && has_other && child.name < unless) {
        mistakes_.add("'" + child.name + "' and '" + unless + "' exclude each other" + in,
                      given->key_place);
      }
    }
    if (!has_alternatives) return;
    if (alternatives.empty() && taken_for.empty())
      mistakes_.add((label.empty() ? "this" : label) +
                        " needs one of: " + joined(applicable_keys(key, active, true)),
                    owner);
    if (alternatives.size() > 1) {
      std::ranges::sort(alternatives);  // entries are in the order of the text
      mistakes_.add("'" + alternatives[1]->key + "' and '" + alternatives[0]->key +
                        "' exclude each other" + in,
                    alternatives[1]->key_place, {{"first given here", alternatives[0]->key_place}});
    }
  }

  MistakeList& mistakes_;
  SchemaMatch& match_;
  std::string dimension_;
  std::set<std::string> enclosing_words_;  // active in the maps around
};

}  // namespace

SchemaMatch check_structure(DocumentNode& root, MistakeList& mistakes) {
  SchemaMatch match;
  StructureCheck(mistakes, match).check_document(root);
  return match;
}

}  // namespace rfm
