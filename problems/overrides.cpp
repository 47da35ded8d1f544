#include "problems/overrides.hpp"

#include <algorithm>
#include <charconv>

namespace rfm {
namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> steps;
  std::size_t begin = 0;
  for (std::size_t end = path.find('.'); end != std::string::npos; end = path.find('.', begin)) {
    steps.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  steps.push_back(path.substr(begin));
  return steps;
}

class Override {
 public:
  Override(const std::string& text, MistakeList& mistakes) : mistakes_(mistakes) {
    const std::size_t equals = text.find('=');
    has_value_ = equals != std::string::npos && equals + 1 < text.size();
    path_ = text.substr(0, equals);
    source_ = make_source("--set " + text, has_value_ ? text.substr(equals + 1) : "", false);
  }

  void apply(DocumentNode& root) {
    if (!has_value_ || path_.empty()) return refuse("expected path=value");
    DocumentNode value = parse_document(source_);
    DocumentNode* node = &root;
    for (const std::string& step : split(path_)) {
      if (step.empty()) return refuse("a path is made of names and numbers, joined by dots");
      node = descend(*node, step);
      if (!node) return;
    }
    *node = std::move(value);
  }

 private:
  DocumentNode* descend(DocumentNode& node, const std::string& step) {
    if (node.is_list()) return item(node, step);
    if (node.is_scalar()) {
      refuse("'" + walked_ + "' is a single value and has no '" + step + "'");
      return nullptr;
    }
    walked_ += (walked_.empty() ? "" : ".") + step;
    if (node.kind == DocumentNode::Kind::empty) node.kind = DocumentNode::Kind::map;
    const auto entry = std::ranges::find(node.entries, step, &DocumentNode::Entry::key);
    if (entry != node.entries.end()) return &entry->value;
    DocumentNode created;
    created.place = {source_};
    node.entries.push_back({step, {source_}, std::move(created)});
    return &node.entries.back().value;
  }

  DocumentNode* item(DocumentNode& node, const std::string& step) {
    std::size_t index = 0;
    const char* end = step.data() + step.size();
    const auto [stop, status] = std::from_chars(step.data(), end, index);
    if (status != std::errc() || stop != end || index >= node.items.size()) {
      const std::size_t count = node.items.size();
      refuse("'" + walked_ + "' is a list of " + std::to_string(count) +
             (count == 0   ? " items"
              : count == 1 ? " item: expected the number 0"
                           : " items: expected a number from 0 to " + std::to_string(count - 1)) +
             " but found '" + step + "'");
      return nullptr;
    }
    walked_ += "." + step;
    return &node.items[index];
  }

  void refuse(const std::string& message) { mistakes_.add(message, {source_}); }

  MistakeList& mistakes_;
  bool has_value_ = false;
  std::string path_;
  std::string walked_;
  std::shared_ptr<const SourceText> source_;
};

}  // namespace

void apply_overrides(DocumentNode& root, const std::vector<std::string>& overrides,
                     MistakeList& mistakes) {
  for (const std::string& text : overrides) {
    try {
      Override(text, mistakes).apply(root);
    } catch (const ProblemFileErrors& errors) {
      for (const Mistake& mistake : errors.mistakes) mistakes.add(mistake.message, mistake.place);
    }
  }
}

}  // namespace rfm
