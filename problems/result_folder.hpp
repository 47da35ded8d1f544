#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rfm {

/// The folder of a result. Every file is written under a temporary name and appears under its own
/// only when all are complete: a result is there as a whole or not at all. Temporary files are
/// removed by the destructor, and when the program is interrupted (`remove_temporary_files`).
class ResultFolder {
 public:
  /// Makes the folder if need be. Throws `ComputationError` if it cannot.
  explicit ResultFolder(std::string path);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  const std::string& path() const { return path_; }
  /// Calls `writer` with a temporary path for the file `name`.
  void write(const std::string& name, const std::function<void(const std::string&)>& writer);
  void write_text(const std::string& name, const std::string& text);
  /// Gives all files their names.
  void commit();

 private:
  std::string path_;
  std::vector<std::string> names_;
};

/// Throws `ComputationError` if a folder cannot be made or written at `path`, so that no work is
/// lost. Makes nothing.
void require_writable(const std::string& path);

/// From now on Ctrl-C (SIGINT) and SIGTERM remove temporary files before they end the program.
void clean_up_on_interrupt();

}  // namespace rfm
