#include "problems/point_files.hpp"

#include <utility>

#include "core/error.hpp"
#include "problems/text_files.hpp"

namespace rfm {
namespace {

[[noreturn]] void refuse(const std::string& name, int line, const std::string& what) {
  throw InputError(name + ":" + std::to_string(line) + ": " + what, 0);
}

double number_in(std::string_view word, const std::string& name, int line) {
  const auto number = number_of(word);
  if (!number) refuse(name, line, "expected a number but found '" + std::string(word) + "'");
  return *number;
}

std::vector<PointList> parse_columns(std::string_view rest, const std::string& name) {
  std::vector<PointList> lists;
  bool may_be_titles = true, begins = true;
  for (int line = 1; const auto content = next_line(rest); ++line) {
    const auto words = words_of_line(*content);
    if (words.empty()) begins = true;
    if (words.empty() || words[0].starts_with('#')) continue;
    if (std::exchange(may_be_titles, false) && !is_written_as_number(words[0])) continue;
    if (words.size() < 2 || words.size() > 3)
      refuse(name, line,
             "expected two numbers x, y or three with a bulge but found " +
                 std::to_string(words.size()) + (words.size() == 1 ? " entry" : " entries"));
    if (std::exchange(begins, false)) lists.emplace_back();
    lists.back().points.push_back(
        {number_in(words[0], name, line), number_in(words[1], name, line)});
    lists.back().bulges.push_back(words.size() > 2 ? number_in(words[2], name, line) : 0);
  }
  return lists;
}

// Pairs of lines: a group code and its value.
std::vector<PointList> parse_dxf(std::string_view rest, const std::string& name) {
  std::vector<PointList> lists;
  std::string entity;
  for (int line = 1; const auto code_line = next_line(rest); line += 2) {
    const auto value_line = next_line(rest);
    const auto code = words_of_line(*code_line);
    if (code.empty() && !value_line) break;
    if (code.size() != 1 || !number_of(code[0]) || !value_line)
      refuse(name, line, "expected a group code and a value");
    const auto value = words_of_line(*value_line);
    const std::string word(value.empty() ? std::string_view() : value[0]);
    if (code[0] == "0") {
      entity = word;
      if (word == "LWPOLYLINE" || word == "POLYLINE") lists.emplace_back();
      if (word == "VERTEX" && !lists.empty()) {
        lists.back().points.push_back({});
        lists.back().bulges.push_back(0);
      }
    }
    const bool light = entity == "LWPOLYLINE", vertex = entity == "VERTEX" && !lists.empty();
    if (!light && !vertex) continue;
    PointList& list = lists.back();
    if (light && code[0] == "10") {
      list.points.push_back({});
      list.bulges.push_back(0);
    }
    if (list.points.empty()) continue;
    if (code[0] == "10") list.points.back()[0] = number_in(word, name, line + 1);
    if (code[0] == "20") list.points.back()[1] = number_in(word, name, line + 1);
    if (code[0] == "42") list.bulges.back() = number_in(word, name, line + 1);
  }
  return lists;
}

bool is_dxf(std::string_view text) {
  const auto code = next_line(text), value = next_line(text);
  return code && value && words_of_line(*code) == std::vector<std::string_view>{"0"} &&
         words_of_line(*value) == std::vector<std::string_view>{"SECTION"};
}

}  // namespace

std::vector<PointList> parse_points(const std::string& text, const std::string& name) {
  std::vector<PointList> lists = is_dxf(text) ? parse_dxf(text, name) : parse_columns(text, name);
  std::erase_if(lists, [](const PointList& list) { return list.points.empty(); });
  if (lists.empty()) throw InputError(name + ": the file holds no points", 0);
  return lists;
}

}  // namespace rfm
