#include "problems/table_reader.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/table.hpp"
#include "problems/text_files.hpp"

namespace rfm {
namespace {

class TableFiles {
 public:
  explicit TableFiles(std::string folder) : folder_(std::move(folder)) {}

  ExpressionValue call(std::span<const ExpressionArgument> arguments) {
    // The quotes belong to the text of the argument.
    const std::string name = arguments[0].text.substr(1, arguments[0].text.size() - 2);
    const ExpressionArgument& argument = arguments[1];
    try {
      const TablePoints& points = read(name);
      if (argument.value.is_vector)
        throw InputError("table takes a function, not a vector: choose a component with [0]",
                         argument.offset, argument.length);
      const Field& at = argument.value.components[0];
      if (at.is_constant()) return number(points, at.constant(), argument);
      return table(points.abscissae, points.values, at);
    } catch (const InputError& mistake) {
      if (mistake.offset != 0) throw;
      throw InputError(mistake.what(), arguments[0].offset, arguments[0].length);
    } catch (const InvalidArgument& mistake) {
      throw InputError(mistake.what(), argument.offset, argument.length);
    }
  }

 private:
  static ExpressionValue number(const TablePoints& points, double at,
                                const ExpressionArgument& argument) {
    const double value = Table(points.abscissae, points.values).taylor(at)[0];
    if (std::isfinite(value)) return value;
    std::ostringstream message;
    message << at << " lies outside the table, which goes from " << points.abscissae.front()
            << " to " << points.abscissae.back();
    throw InputError(message.str(), argument.offset, argument.length);
  }

  const TablePoints& read(const std::string& name) {
    const auto known = files_.find(name);
    if (known != files_.end()) return known->second;
    const std::string text = read_text_beside(folder_, name, "a table");
    return files_.emplace(name, parse_table(text, name)).first->second;
  }

  std::string folder_;
  std::map<std::string, TablePoints> files_;
};

}  // namespace

TablePoints parse_table(const std::string& text, const std::string& name) {
  TablePoints points;
  bool may_be_titles = true;
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // written by some spreadsheets
  for (int line = 1; const auto content = next_line(rest); ++line) {
    const std::vector<std::string_view> words = words_of_line(*content);
    if (words.empty() || words[0].starts_with('#')) continue;
    const auto refuse = [&](const std::string& what) {
      throw InputError(name + ":" + std::to_string(line) + ": " + what, 0);
    };
    if (std::exchange(may_be_titles, false) && !is_written_as_number(words[0])) continue;
    if (words.size() != 2)
      refuse("expected two numbers but found " + std::to_string(words.size()) +
             (words.size() == 1 ? " entry" : " entries"));
    std::array<double, 2> numbers{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::optional<double> value = number_of(words[i]);
      if (!value) refuse("expected a number but found '" + std::string(words[i]) + "'");
      numbers[i] = *value;
    }
    if (!points.abscissae.empty() && !(numbers[0] > points.abscissae.back()))
      refuse("the first column must ascend, but '" + std::string(words[0]) +
             "' is not larger than the number above it");
    points.abscissae.push_back(numbers[0]);
    points.values.push_back(numbers[1]);
  }
  if (points.abscissae.size() < 2)
    throw InputError(name + ": a table needs at least two lines of two numbers", 0);
  return points;
}

ExpressionFunction table_function(const std::string& folder) {
  ExpressionFunction function;
  function.least_arguments = function.most_arguments = 2;
  function.text_arguments = 1;
  function.call = [files = std::make_shared<TableFiles>(folder)](
                      std::span<const ExpressionArgument> arguments) {
    return files->call(arguments);
  };
  return function;
}

}  // namespace rfm
