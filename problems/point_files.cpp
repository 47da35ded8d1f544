#include "problems/point_files.hpp"

#include <utility>

#include "core/error.hpp"
#include "problems/drawing_file.hpp"
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
    if (content->find(',') != content->npos && content->find(';') != content->npos)
      refuse(name, line,
             "this line has commas and semicolons, which both separate numbers; expected decimal "
             "points, as in 4.5; 1");
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

}  // namespace

std::vector<PointList> parse_points(const std::string& text, const std::string& name) {
  std::vector<PointList> lists =
      is_drawing(text) ? outlines_of_drawing(text, name) : parse_columns(text, name);
  std::erase_if(lists, [](const PointList& list) { return list.points.empty(); });
  if (lists.empty()) throw InputError(name + ": the file holds no points", 0);
  return lists;
}

}  // namespace rfm
