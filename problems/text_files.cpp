#include "problems/text_files.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.hpp"

namespace rfm {
namespace {

constexpr std::uintmax_t largest_file = 16 << 20;

// Whether a path stays in the folder that it is relative to.
bool is_inside(const std::filesystem::path& path) {
  if (path.empty() || path.has_root_path()) return false;
  return std::ranges::find(path, "..") == path.end();
}

}  // namespace

std::string read_text_beside(const std::string& folder, const std::string& name,
                             const std::string& what) {
  if (!is_inside(name))
    throw InputError("the file of " + what + " must lie in the folder of the problem file", 0);
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  std::ifstream stream(path, std::ios::binary);
  if (failure || !stream)
    throw InputError("cannot read the file '" + name + "' beside the problem file", 0);
  if (size > largest_file) throw InputError("the file '" + name + "' is larger than 16 MB", 0);
  std::ostringstream text;
  text << stream.rdbuf();
  std::string content = text.str();
  if (content.starts_with("\xEF\xBB\xBF")) content.erase(0, 3);  // written by some spreadsheets
  return content;
}

std::optional<std::string_view> next_line(std::string_view& rest) {
  if (rest.empty()) return std::nullopt;
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return line;
}

std::vector<std::string_view> words_of_line(std::string_view line) {
  constexpr std::string_view separators = " \t\r,;";
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(separators);
    if (begin == std::string_view::npos) return words;
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    line.remove_prefix(end);
  }
}

namespace {

std::errc read_number(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_whole = end == word.data() + word.size() && std::isfinite(value);
  return is_whole ? status : std::errc::invalid_argument;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
  double value = 0;
  return read_number(word, value) == std::errc() ? std::optional(value) : std::nullopt;
}

bool is_written_as_number(std::string_view word) {
  double value = 0;  // stays so where the number is out of range
  return read_number(word, value) != std::errc::invalid_argument;
}

}  // namespace rfm
