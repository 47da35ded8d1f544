#include "problems/document.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "problems/scalar_places.hpp"

namespace rfm {
namespace {

constexpr std::size_t deepest_nesting = 100;
constexpr std::uintmax_t largest_file = 16 << 20;

/// Builds the tree from the parser's events. Containers that are not complete stand on a stack.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::shared_ptr<const SourceText> source) : source_(std::move(source)) {}

  std::optional<DocumentNode> root;
  /// Where the innermost container begins that is not complete, if there is one.
  std::optional<Place> innermost() const {
    return open_.empty() ? std::nullopt : std::optional(open_.back().node.place);
  }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    DocumentNode node;
    node.place = place(mark, 1);
    complete(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(
        "aliases are not supported: name the value under 'parameters' or 'fields' (quote a text "
        "that begins with '*')",
        mark);
  }

  void OnAnchor(const YAML::Mark& mark, const std::string&) override {
    refuse("anchors are not supported (quote a text that begins with '&')", mark);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    check_tag(mark, tag);
    DocumentNode node;
    node.kind = DocumentNode::Kind::scalar;
    node.quoted = tag == "!";
    node.text = value;
    // A scalar is underlined as far as its first line goes, with its quotes.
    const std::size_t first_line = std::min(value.find('\n'), value.size());
    node.place = place(mark, static_cast<int>(first_line) + (node.quoted ? 2 : 0));
    complete(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(DocumentNode::Kind::list, mark, tag);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(DocumentNode::Kind::map, mark, tag);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    DocumentNode node;
    std::optional<DocumentNode> key;  // of a map: read, its value still to come
  };

  Place place(const YAML::Mark& mark, int length) const {
    return {source_, mark.line + 1, mark.column + 1, std::max(length, 1)};
  }

  [[noreturn]] void refuse(const std::string& message, const YAML::Mark& mark) const {
    throw ProblemFileErrors({{message, place(mark, 1)}});
  }

  void check_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!")
      refuse("tags are not supported (quote a text that begins with '!')", mark);
  }

  void open(DocumentNode::Kind kind, const YAML::Mark& mark, const std::string& tag) {
    check_tag(mark, tag);
    if (open_.size() == deepest_nesting)
      refuse("nested more than " + std::to_string(deepest_nesting) + " levels deep", mark);
    DocumentNode node;
    node.kind = kind;
    node.place = place(mark, 1);
    open_.push_back({std::move(node), {}});
  }

  void close() {
    DocumentNode node = std::move(open_.back().node);
    open_.pop_back();
    complete(std::move(node));
  }

  void complete(DocumentNode node) {
    if (open_.empty()) {
      root = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.node.is_list()) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.key) {
      if (!node.is_scalar()) throw ProblemFileErrors({{"a key must be a name", node.place}});
      parent.key = std::move(node);
    } else {
      // The parser places a missing value at whatever follows: its key is where one looks.
      if (node.kind == DocumentNode::Kind::empty) node.place = parent.key->place;
      parent.node.entries.push_back({parent.key->text, parent.key->place, std::move(node)});
      parent.key.reset();
    }
  }

  std::shared_ptr<const SourceText> source_;
  std::vector<Open> open_;
};

bool has_tab_in_indentation(std::string_view line) {
  const std::size_t text = line.find_first_not_of(" \t");
  return line.substr(0, text).find('\t') != std::string_view::npos &&
         text != std::string_view::npos;
}

// What the parser's messages mean to somebody who wrote a problem file. Begins of messages, since
// some end in a detail.
struct Translation {
  std::string_view parsers;
  std::string_view ours;
};
constexpr std::array<Translation, 24> translations = {{
    {"end of map not found", "this line does not belong to the map above: check its indentation"},
    {"end of map flow not found", "a '{' is not closed: expected ',' or '}'"},
    {"end of sequence not found",
     "this line does not belong to the list above: check its indentation"},
    {"end of sequence flow not found", "a '[' is not closed: expected ',' or ']'"},
    {"illegal tab when looking for indentation", "a tab in the indentation: indent with spaces"},
    {"illegal flow end", "a closing bracket without its opening one"},
    {"illegal block entry", "a list item '-' cannot stand here: put it on a line of its own"},
    {"illegal map key", "a key cannot stand here: check the indentation and the brackets above"},
    {"illegal map value",
     "a ':' cannot stand here: check the indentation, or quote a text that contains ': '"},
    {"illegal EOF in scalar", "a quotation is not closed"},
    {"illegal document indicator in scalar", "a quotation is not closed"},
    {"illegal character in scalar", "a character that is not allowed in a text"},
    {"alias not found after *", "aliases are not supported (quote a text that begins with '*')"},
    {"illegal character found while scanning alias",
     "aliases are not supported (quote a text that begins with '*')"},
    {"the referenced anchor is not defined",
     "aliases are not supported (quote a text that begins with '*')"},
    {"anchor not found after &", "anchors are not supported (quote a text that begins with '&')"},
    {"illegal character found while scanning anchor",
     "anchors are not supported (quote a text that begins with '&')"},
    {"cannot assign multiple", "a text that begins with '!', '&' or '*' must be quoted"},
    {"unknown escape character", "an unknown escape after '\\' in a text in double quotes"},
    {"bad character found while scanning hex number", "an escape that is not a hexadecimal number"},
    {"invalid unicode", "an escape that is not a character"},
    {"unexpected character in block scalar", "unexpected character after '|' or '>'"},
    {"cannot set zero indentation", "a text after '|' or '>' must be indented"},
    {"unknown token", "a character that no value can begin with: quote the text"},
}};

Mistake translated(const YAML::Exception& exception, const std::optional<Place>& innermost,
                   std::shared_ptr<const SourceText> source) {
  Place place{source, std::max(exception.mark.line + 1, 1), std::max(exception.mark.column + 1, 1)};
  // The parser reports tabs, unclosed brackets and quotations as many other things.
  if (has_tab_in_indentation(source->line(place.line))) {
    place.column = static_cast<int>(source->line(place.line).find('\t')) + 1;
    return {"a tab in the indentation: indent with spaces", place};
  }
  const std::string_view message = exception.msg;
  for (const Translation& translation : translations)
    if (message.starts_with(translation.parsers)) {
      Mistake mistake{std::string(translation.ours), place};
      const bool is_unclosed = message.find("flow not found") != std::string_view::npos;
      if (is_unclosed && innermost) mistake.others.push_back({"it begins here", *innermost});
      return mistake;
    }
  if (message.find("irective") != std::string_view::npos ||
      message.find("VERSION") != std::string_view::npos)
    return {"directives (lines that begin with '%') are not supported", place};
  if (message.find("tag") != std::string_view::npos ||
      message.find("TAG") != std::string_view::npos)
    return {"tags are not supported (quote a text that begins with '!')", place};
  return {"this is not YAML: check quotes, brackets and indentation", place};
}

// The length of the UTF-8 character at `i`, or 0 if there is none.
std::size_t valid_character(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead < 0xC2   ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xC0u) != 0x80u) return 0;
  // Overlong forms, surrogates and what lies beyond U+10FFFF.
  if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F) ||
      (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F))
    return 0;
  return length;
}

void check_characters(const std::shared_ptr<const SourceText>& source) {
  const std::string_view text = source->text;
  const auto refuse = [&](const char* message, std::size_t at) {
    const std::string_view before = text.substr(0, at);
    const auto line = std::ranges::count(before, '\n');
    const std::size_t begin = before.rfind('\n') + 1;  // npos + 1 = 0: the first line
    throw ProblemFileErrors(
        {{message, {source, static_cast<int>(line) + 1, static_cast<int>(at - begin) + 1}}});
  };
  for (std::size_t i = 0; i < text.size();) {
    const auto code = static_cast<unsigned char>(text[i]);
    if (code < 0x20 && code != '\n' && code != '\r' && code != '\t')
      refuse("a control character in the text", i);
    const std::size_t length = valid_character(text, i);
    if (length == 0) refuse("the text is not UTF-8 here", i);
    i += length;
  }
}

}  // namespace

const DocumentNode* DocumentNode::find(std::string_view key) const {
  const auto found = std::ranges::find(entries, key, &Entry::key);
  return found == entries.end() ? nullptr : &found->value;
}

DocumentNode* DocumentNode::find(std::string_view key) {
  return const_cast<DocumentNode*>(std::as_const(*this).find(key));
}

Place DocumentNode::place_within(std::size_t offset, std::size_t length) const {
  const std::string_view line = place.source->line(place.line);
  const auto begin = static_cast<std::size_t>(place.column - 1) + (quoted ? 1 : 0);
  Place within = place;
  if (begin <= line.size() && line.substr(begin).starts_with(text)) {
    within.column = static_cast<int>(begin + offset) + 1;
    within.length = static_cast<int>(std::max<std::size_t>(length, 1));
    return within;
  }
  const auto places = byte_places(*this);
  if (!places || !place.source->is_file) return place;
  // Beyond the text, or in the space at its end, is just after it.
  const std::size_t first = std::min((*places)[std::min(offset, text.size())], places->back());
  const std::size_t last =
      (*places)[std::min(offset + std::max<std::size_t>(length, 1) - 1, text.size())];
  within.line = place.source->line_of(first);
  const std::size_t line_begin = place.source->line_begin(within.line);
  within.column = static_cast<int>(first - line_begin) + 1;
  const std::size_t line_end = line_begin + place.source->line(within.line).size();
  within.length = static_cast<int>(std::max(std::min(last + 1, line_end), first + 1) - first);
  return within;
}

std::set<std::string, std::less<>> words_of(const DocumentNode& root) {
  const auto is_part = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  std::set<std::string, std::less<>> words;
  for (auto begin = root.text.begin(); begin != root.text.end();) {
    begin = std::find_if(begin, root.text.end(), is_part);
    const auto end = std::find_if_not(begin, root.text.end(), is_part);
    if (begin != end) words.emplace(begin, end);
    begin = end;
  }
  for (const DocumentNode& item : root.items) words.merge(words_of(item));
  for (const DocumentNode::Entry& entry : root.entries) words.merge(words_of(entry.value));
  return words;
}

DocumentNode parse_document(std::shared_ptr<const SourceText> source) {
  check_characters(source);
  std::istringstream stream(source->text);
  TreeBuilder builder(source), rest(source);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder) || !builder.root)
      throw ProblemFileErrors({{"the file is empty", {source}}});
    if (parser.HandleNextDocument(rest))
      throw ProblemFileErrors(
          {{"several documents in one file: '---' may only begin it", rest.root->place}});
  } catch (const YAML::Exception& exception) {
    throw ProblemFileErrors({translated(exception, builder.innermost(), source)});
  }
  return std::move(*builder.root);
}

std::shared_ptr<const SourceText> make_source(std::string name, std::string text, bool is_file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  auto source = std::make_shared<SourceText>();
  source->name = std::move(name);
  source->text = std::move(text);
  source->is_file = is_file;
  source->index_lines();
  return source;
}

std::shared_ptr<const SourceText> read_source(const std::string& path) {
  const auto refuse = [&](const std::string& message) {
    throw ProblemFileErrors({{message, {make_source(path, "", false)}}});
  };
  std::error_code status;
  if (std::filesystem::is_directory(path, status)) refuse("this is a folder, not a problem file");
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse("the file does not exist or cannot be read");
  std::string text;
  std::array<char, 65536> block;
  while (file.read(block.data(), block.size()), file.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > largest_file) refuse("the file is larger than 16 MB");
  }
  return make_source(path, std::move(text));
}

}  // namespace rfm
