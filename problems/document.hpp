#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "problems/mistakes.hpp"

namespace rfm {

/// A value of a YAML text with its place. Nothing is interpreted: `1e-3`, `yes` and `2*r` are
/// scalars with that text. Keys may repeat: whoever reads the map reports it.
struct DocumentNode {
  enum class Kind { empty, scalar, list, map };
  struct Entry;

  Kind kind = Kind::empty;
  Place place;
  /// The text of a scalar, its quotes and escapes resolved.
  std::string text;
  bool quoted = false;
  std::vector<DocumentNode> items;
  std::vector<Entry> entries;

  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_list() const { return kind == Kind::list; }
  bool is_map() const { return kind == Kind::map; }
  /// The value of the first entry with this key, or null.
  const DocumentNode* find(std::string_view key) const;
  DocumentNode* find(std::string_view key);
  /// The place of `length` bytes from `offset` of a scalar's text, as far as its first line goes:
  /// exact in texts of one and of several lines, with quotes and escapes. Of a text that no file
  /// holds, the place of the scalar.
  Place place_within(std::size_t offset, std::size_t length) const;
};

struct DocumentNode::Entry {
  std::string key;
  Place key_place;
  DocumentNode value;
};

/// The words (letters, digits and `_`) of all scalars of a tree.
std::set<std::string, std::less<>> words_of(const DocumentNode& root);

/// Parses YAML into a tree. Anchors, aliases, tags and several documents in one text are refused.
/// Throws `ProblemFileErrors` with one mistake on text that is not YAML, not UTF-8, or nested more
/// than 100 levels deep.
DocumentNode parse_document(std::shared_ptr<const SourceText> source);

/// Reads a file into memory. Throws `ProblemFileErrors` where it cannot be read or is larger than
/// 16 MB.
std::shared_ptr<const SourceText> read_source(const std::string& path);
/// A text with a name, for tests and `--set`.
std::shared_ptr<const SourceText> make_source(std::string name, std::string text,
                                              bool is_file = true);

}  // namespace rfm
