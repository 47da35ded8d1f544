#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rfm {

/// The text of the file `name` in `folder` or below it. Throws `InputError` where it lies
/// elsewhere, cannot be read, or is larger than 16 MB; `what` says whose file it is: "a table".
std::string read_text_beside(const std::string& folder, const std::string& name,
                             const std::string& what);

/// The next line of `rest`, cut off from it; nothing at the end.
std::optional<std::string_view> next_line(std::string_view& rest);

/// What stands between commas, semicolons and blanks.
std::vector<std::string_view> words_of_line(std::string_view line);

/// A finite number, as a whole word; nothing for one that a double does not hold, as 1e999.
std::optional<double> number_of(std::string_view word);
/// Whether the word is written as a number, one that a double does not hold included: what is not
/// may be a title.
bool is_written_as_number(std::string_view word);

}  // namespace rfm
