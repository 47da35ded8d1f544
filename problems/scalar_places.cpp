#include "problems/scalar_places.hpp"

#include <algorithm>

namespace rfm {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_space(char c) { return is_blank(c) || c == '\n'; }

// Bytes of the UTF-8 character that begins with `lead`.
std::size_t character_length(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

/// Walks along the source and the text that YAML made of it. Only space differs between the two,
/// and what stands for a quote or an escape.
class Alignment {
 public:
  Alignment(std::string_view source, std::size_t begin, std::string_view text)
      : source_(source), at_(begin), text_(text) {
    style_ = at_ < source_.size() ? source_[at_] : '\0';
    if (style_ == '|' || style_ == '>')
      at_ = std::min(source_.find('\n', at_), source_.size());
    else if (style_ == '"' || style_ == '\'')
      ++at_;
  }

  std::optional<std::vector<std::size_t>> places() {
    std::size_t end = at_;
    while (places_.size() < text_.size()) {
      const char next = text_[places_.size()];
      if (style_ == '"') skip_continuation();
      if (style_ == '"' && here() == '\\') {
        escape();
      } else if (is_space(next)) {
        places_.push_back(at_);
        if (is_blank(here()) || (next == '\n' && here() == '\n')) ++at_;
        continue;
      } else {
        while (at_ < source_.size() && is_space(here())) ++at_;
        if (style_ == '"' && here() == '\\') continue;
        if (here() != next) return std::nullopt;
        places_.push_back(at_);
        at_ += style_ == '\'' && next == '\'' ? 2 : 1;
      }
      end = at_;
    }
    places_.push_back(end);
    return std::move(places_);
  }

 private:
  char here() const { return at_ < source_.size() ? source_[at_] : '\0'; }

  // A backslash at the end of a line joins it to the next.
  void skip_continuation() {
    while (here() == '\\' && at_ + 1 < source_.size() &&
           (source_[at_ + 1] == '\n' || source_[at_ + 1] == '\r')) {
      ++at_;
      while (is_space(here())) ++at_;
    }
  }

  void escape() {
    const char kind = at_ + 1 < source_.size() ? source_[at_ + 1] : '\0';
    const std::size_t bytes =
        std::min(character_length(text_[places_.size()]), text_.size() - places_.size());
    places_.insert(places_.end(), bytes, at_);
    at_ += kind == 'x' ? 4 : kind == 'u' ? 6 : kind == 'U' ? 10 : 2;
  }

  std::string_view source_;
  std::size_t at_;
  std::string_view text_;
  char style_;
  std::vector<std::size_t> places_;
};

}  // namespace

std::optional<std::vector<std::size_t>> byte_places(const DocumentNode& scalar) {
  const SourceText& source = *scalar.place.source;
  const std::size_t begin = source.line_begin(scalar.place.line);
  return Alignment(source.text, begin + static_cast<std::size_t>(scalar.place.column - 1),
                   scalar.text)
      .places();
}

}  // namespace rfm
