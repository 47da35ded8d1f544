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

// What a drawing may hold beside outlines without changing the shape that it shows.
bool draws_nothing(const std::string& entity) {
  for (const char* name :
       {"ATTDEF", "ATTRIB", "DIMENSION", "LEADER", "MTEXT", "POINT", "SEQEND", "TEXT", "VIEWPORT"})
    if (entity == name) return true;
  return false;
}

// The entities of a drawing: pairs of lines, a group code and its value.
class DrawingReader {
 public:
  explicit DrawingReader(const std::string& name) : name_(name) {}

  std::vector<PointList> read(std::string_view rest) {
    for (line_ = 1; const auto code_line = next_line(rest); line_ += 2) {
      const auto value_line = next_line(rest);
      const auto code = words_of_line(*code_line);
      if (code.empty() && !value_line) break;
      if (code.size() != 1 || !number_of(code[0]) || !value_line)
        refuse(name_, line_, "expected a group code and a value");
      const auto value = words_of_line(*value_line);
      group(code[0], std::string(value.empty() ? std::string_view() : value[0]));
    }
    end();
    return std::move(lists_);
  }

 private:
  void group(std::string_view code, const std::string& word) {
    if (code == "0") return begin(word);
    if (entity_ == "SECTION" && code == "2") is_drawing_ = word == "ENTITIES";
    if (lists_.empty()) return;
    PointList& list = lists_.back();
    const bool light = entity_ == "LWPOLYLINE", vertex = entity_ == "VERTEX";
    if ((light || entity_ == "POLYLINE") && code == "70")
      list.is_open = static_cast<int>(number(word)) % 2 == 0;
    if (light && code == "10") add_point();
    if (entity_ == "CIRCLE") {
      if (code == "10") center_[0] = number(word);
      if (code == "20") center_[1] = number(word);
      if (code == "40") radius_ = number(word);
    }
    if (!(light || vertex) || list.points.empty()) return;
    if (code == "10") list.points.back()[0] = number(word);
    if (code == "20") list.points.back()[1] = number(word);
    if (code == "42") list.bulges.back() = number(word);
  }

  void begin(const std::string& entity) {
    end();
    entity_ = entity;
    if (entity == "ENDSEC") is_drawing_ = false;
    if (!is_drawing_ || draws_nothing(entity)) {
      if (entity != "SECTION") entity_.clear();
      return;
    }
    if (entity == "LWPOLYLINE" || entity == "POLYLINE" || entity == "CIRCLE") {
      lists_.emplace_back().line = line_;
      lists_.back().is_open = entity != "CIRCLE";  // unless its flag says otherwise
    } else if (entity == "VERTEX" && !lists_.empty()) {
      add_point();
    } else {
      refuse(name_, line_ + 1,
             "expected LWPOLYLINE, POLYLINE or CIRCLE but found " + entity +
                 ", which would be left out: join what it draws into a polyline");
    }
  }

  void end() {
    if (entity_ != "CIRCLE") return;
    if (!(radius_ > 0)) refuse(name_, line_, "this circle has no radius");
    for (const double side : {-1.0, 1.0}) {
      add_point();
      lists_.back().points.back() = {center_[0] + side * radius_, center_[1]};
      lists_.back().bulges.back() = 1;  // half a turn
    }
    radius_ = 0;
  }

  void add_point() {
    lists_.back().points.push_back({});
    lists_.back().bulges.push_back(0);
  }
  double number(const std::string& word) const { return number_in(word, name_, line_ + 1); }

  const std::string& name_;
  std::vector<PointList> lists_;
  std::string entity_;
  bool is_drawing_ = false;  // within the section of entities
  Point center_{};
  double radius_ = 0;
  int line_ = 1;
};

bool is_dxf(std::string_view text) {
  const auto code = next_line(text), value = next_line(text);
  return code && value && words_of_line(*code) == std::vector<std::string_view>{"0"} &&
         words_of_line(*value) == std::vector<std::string_view>{"SECTION"};
}

}  // namespace

std::vector<PointList> parse_points(const std::string& text, const std::string& name) {
  std::vector<PointList> lists =
      is_dxf(text) ? DrawingReader(name).read(text) : parse_columns(text, name);
  std::erase_if(lists, [](const PointList& list) { return list.points.empty(); });
  if (lists.empty()) throw InputError(name + ": the file holds no points", 0);
  return lists;
}

}  // namespace rfm
