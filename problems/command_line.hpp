#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rfm {

/// What the user asked `rfm-solve` for.
struct CommandLine {
  enum class Command {
    solve,    ///< solve `files`
    check,    ///< validate `files` and, with `picture`, draw them; no solve
    explain,  ///< explain `key`
    schema,   ///< print the JSON Schema
    print,    ///< nothing to do but to print `text`: help, version, or what is wrong
  };
  Command command = Command::solve;
  std::vector<std::string> files;
  /// "path=value", in order.
  std::vector<std::string> overrides;
  /// Folder of results; nothing: results/NAME under the current folder.
  std::optional<std::string> output;
  /// Nothing: as the file says, else all cores.
  std::optional<int> threads;
  /// Number of grids, each with twice the cells of the one before.
  int converge = 1;
  bool picture = false;
  bool quiet = false;
  bool json = false;
  bool verify = true;
  /// Of `explain`.
  std::string key;
  /// Of `print`: what to print and how to exit (2 for a wrong command line, whose text goes to the
  /// error stream).
  std::string text;
  int exit_status = 0;
};

/// Parses the arguments of the program, without its name.
CommandLine parse_command_line(std::vector<std::string> arguments);

}  // namespace rfm
