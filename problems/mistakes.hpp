#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace rfm {

/// A text that a user wrote: a file, or one `--set path=value` of the command line.
struct SourceText {
  /// As messages name it: the file as the user wrote it, or "--set path=value".
  std::string name;
  std::string text;
  bool is_file = true;

  /// Line `number` (from 1) without its end, or nothing beyond the last.
  std::string_view line(int number) const;
  /// Where line `number` begins, as an offset into the text.
  std::size_t line_begin(int number) const;
  /// The number of the line that holds an offset.
  int line_of(std::size_t offset) const;
  /// Line beginnings, found once: `index_lines` must be called after `text` is set.
  void index_lines();

 private:
  std::vector<std::size_t> line_begins_;
};

/// Where something stands: `column` and `length` count bytes, from 1.
struct Place {
  std::shared_ptr<const SourceText> source;
  int line = 1;
  int column = 1;
  int length = 1;

  /// "plate.yaml:14:9", with the column counted in characters; "--set path=value" has no line.
  std::string text() const;
  /// The line and a caret below, each line ended; empty where there is no line to show. Only the
  /// part about the caret is shown of a long line.
  std::string excerpt() const;
};

/// Something wrong in the input. `others` are further places that matter, each with its remark.
struct Mistake {
  std::string message;
  Place place;
  struct Other {
    std::string remark;
    Place place;
  };
  std::vector<Other> others = {};

  /// "plate.yaml:14:9: message", then the line with a caret, then the other places.
  std::string text() const;
};

/// The mistakes of a file, collected so that all are reported at once.
class MistakeList {
 public:
  /// The same mistake at the same place counts once; beyond a thousand, none are kept.
  void add(std::string message, const Place& place, std::vector<Mistake::Other> others = {});
  bool empty() const { return mistakes_.empty(); }
  /// Whether nothing more is kept: then messages need not be made.
  bool is_full() const;
  /// In the order of the text, those of the command line last.
  std::vector<Mistake> sorted() const;
  /// Throws `ProblemFileErrors` if there is any.
  void throw_if_any() const;

 private:
  std::vector<Mistake> mistakes_;
};

/// The input is wrong (exit status 2): every mistake that was found in it. `what()` is all of them
/// as text, at most 100 in full.
struct ProblemFileErrors : Error {
  explicit ProblemFileErrors(std::vector<Mistake> mistakes);
  std::vector<Mistake> mistakes;
};

}  // namespace rfm
