#include "problems/mistakes.hpp"

#include <algorithm>
#include <tuple>

namespace rfm {
namespace {

constexpr std::size_t widest_excerpt = 100;
constexpr std::size_t most_mistakes_kept = 1000;
constexpr std::size_t most_mistakes_shown = 100;

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

std::size_t character_count(std::string_view bytes) {
  return static_cast<std::size_t>(
      std::ranges::count_if(bytes, [](char byte) { return !continues_character(byte); }));
}

// What a terminal would obey rather than show becomes '?'; tabs keep their width in both lines.
std::string printable(std::string_view line) {
  std::string shown(line);
  for (char& byte : shown) {
    const auto code = static_cast<unsigned char>(byte);
    if (byte == '\t') byte = ' ';
    if (code < 0x20 && byte != ' ') byte = '?';
    if (code == 0x7F) byte = '?';
  }
  return shown;
}

std::string all_texts(const std::vector<Mistake>& mistakes) {
  std::string text;
  for (std::size_t i = 0; i < std::min(mistakes.size(), most_mistakes_shown); ++i)
    text += mistakes[i].text();
  if (mistakes.size() > most_mistakes_shown)
    text += "and " + std::to_string(mistakes.size() - most_mistakes_shown) + " more mistakes\n";
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

void SourceText::index_lines() {
  line_begins_ = {0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') line_begins_.push_back(i + 1);
}

std::string_view SourceText::line(int number) const {
  const auto index = static_cast<std::size_t>(number - 1);
  if (number < 1 || index >= line_begins_.size()) return {};
  const std::size_t begin = line_begins_[index];
  std::size_t end = text.find('\n', begin);
  if (end == std::string::npos) end = text.size();
  if (end > begin && text[end - 1] == '\r') --end;
  return std::string_view(text).substr(begin, end - begin);
}

std::size_t SourceText::line_begin(int number) const {
  const auto index = static_cast<std::size_t>(number - 1);
  return number < 1 || index >= line_begins_.size() ? text.size() : line_begins_[index];
}

int SourceText::line_of(std::size_t offset) const {
  return static_cast<int>(std::ranges::upper_bound(line_begins_, offset) - line_begins_.begin());
}

std::string Place::text() const {
  if (!source->is_file) return source->name;
  const std::string_view before =
      source->line(line).substr(0, static_cast<std::size_t>(column - 1));
  // A column beyond the line (its end) still counts.
  const std::size_t beyond = static_cast<std::size_t>(column - 1) - before.size();
  return source->name + ":" + std::to_string(line) + ":" +
         std::to_string(character_count(before) + beyond + 1);
}

std::string Place::excerpt() const {
  if (!source->is_file || source->text.empty()) return {};
  const std::string_view whole = source->line(line);
  std::size_t caret = std::min(static_cast<std::size_t>(column - 1), whole.size());
  std::size_t begin = 0, end = whole.size();
  if (whole.size() > widest_excerpt) {
    begin = caret > widest_excerpt / 2 ? caret - widest_excerpt / 2 : 0;
    end = std::min(begin + widest_excerpt, whole.size());
    while (begin < end && continues_character(whole[begin])) ++begin;
    while (end < whole.size() && end > begin && continues_character(whole[end])) --end;
  }
  caret = std::max(caret, begin);
  const std::string_view shown = whole.substr(begin, end - begin);
  const std::string number = std::to_string(line);
  const std::string left = "    " + number + " | " + (begin > 0 ? "..." : "");
  std::string excerpt = left + printable(shown) + (end < whole.size() ? "..." : "") + "\n";
  const std::size_t indent = character_count(whole.substr(begin, caret - begin));
  const std::string_view marked =
      whole.substr(caret, std::min(static_cast<std::size_t>(std::max(length, 1)), end - caret));
  const std::size_t width = std::max<std::size_t>(character_count(marked), 1);
  excerpt += std::string(4 + number.size() + 1, ' ') + "| " +
             std::string(left.size() - number.size() - 7 + indent, ' ') + "^" +
             std::string(width - 1, '~') + "\n";
  return excerpt;
}

std::string Mistake::text() const {
  std::string text = place.text() + ": " + message + "\n" + place.excerpt();
  for (const Other& other : others)
    text += "  " + other.place.text() + ": " + other.remark + "\n" + other.place.excerpt();
  return text;
}

bool MistakeList::is_full() const { return mistakes_.size() >= most_mistakes_kept; }

void MistakeList::add(std::string message, const Place& place, std::vector<Mistake::Other> others) {
  if (is_full()) return;
  for (const Mistake& known : mistakes_) {
    const Place& at = known.place;
    if (at.source == place.source && at.line == place.line && at.column == place.column &&
        known.message == message)
      return;
  }
  mistakes_.push_back({std::move(message), place, std::move(others)});
}

std::vector<Mistake> MistakeList::sorted() const {
  std::vector<Mistake> sorted = mistakes_;
  std::ranges::stable_sort(sorted, [](const Mistake& a, const Mistake& b) {
    const auto key = [](const Mistake& m) {
      return std::tuple(!m.place.source->is_file, m.place.line, m.place.column);
    };
    return key(a) < key(b);
  });
  return sorted;
}

void MistakeList::throw_if_any() const {
  if (!empty()) throw ProblemFileErrors(sorted());
}

ProblemFileErrors::ProblemFileErrors(std::vector<Mistake> mistakes)
    : Error(all_texts(mistakes)), mistakes(std::move(mistakes)) {}

}  // namespace rfm
