#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace rfm {

/// What a run tells: each line goes to the terminal (unless quiet) and into `log.txt`.
class RunLog {
 public:
  explicit RunLog(bool quiet) : quiet_(quiet) {}

  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
    text_ += text;
    if (!quiet_) std::fputs(text.c_str(), stdout);
  }
  const std::string& text() const { return text_; }

 private:
  bool quiet_;
  std::string text_;
};

}  // namespace rfm
