#include "problems/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "core/nearest_name.hpp"

#ifndef RFM_VERSION
#define RFM_VERSION "0.1.0"
#endif

namespace rfm {
namespace {

void add_run_options(CLI::App& app, CommandLine& line) {
  app.add_option("FILE", line.files, "Problem files")->type_name("");
  app.add_option("--set", line.overrides,
                 "Set a key of the file: path=value, as discretization.basis.cells=32 or "
                 "conditions.0.value=3; may be repeated")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
}

void add_output_option(CLI::App& app, CommandLine& line) {
  app.add_option("--output", line.output,
                 "Folder of the results (of several files: a folder in it for each)")
      ->type_name("DIR");
}

void add_solve_options(CLI::App& app, CommandLine& line) {
  app.add_option("--threads", line.threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  app.add_option("--converge", line.converge,
                 "Solve on N grids, each with twice the cells of the one before")
      ->check(CLI::Range(1, 12))
      ->type_name("N");
  app.add_flag("--picture", line.picture, "Draw a picture of the solution");
  app.add_flag("--quiet", line.quiet, "Print errors only");
  app.add_flag("--json", line.json, "Print summary.json");
  app.add_flag_callback(
      "--no-verify", [&line] { line.verify = false; }, "Skip what the file asks to verify");
}

CommandLine printed(std::string text, int exit_status) {
  CommandLine line;
  line.command = CommandLine::Command::print;
  line.text = std::move(text);
  line.exit_status = exit_status;
  return line;
}

CommandLine refused(const std::string& message) {
  return printed(message + "\nTry 'rfm-solve --help'.\n", 2);
}

std::string unknown_options(const std::vector<std::string>& extras) {
  const std::vector<std::string> known = {"--set",     "--output", "--threads", "--converge",
                                          "--picture", "--quiet",  "--json",    "--no-verify",
                                          "--version", "--help"};
  std::string message;
  for (const std::string& extra : extras)
    message += (message.empty() ? "" : "\n") + std::string("unexpected argument '") + extra + "'" +
               did_you_mean(extra, known);
  return message;
}

}  // namespace

CommandLine parse_command_line(std::vector<std::string> arguments) {
  CommandLine line;
  CLI::App app("Solves the boundary value problems of problem files with R-functions.",
               "rfm-solve");
  app.set_version_flag("--version", "rfm-solve " RFM_VERSION);
  app.footer(
      "Exit status: 0 solved and every expectation holds; 1 an expectation is missed; 2 the input "
      "is\nwrong; 3 the computation failed.");
  app.allow_extras();
  add_run_options(app, line);
  add_output_option(app, line);
  add_solve_options(app, line);
  CLI::App* check = app.add_subcommand("check", "Validate problem files without solving them");
  add_run_options(*check, line);
  add_output_option(*check, line);
  check->add_flag("--picture", line.picture,
                  "Draw the domain, the pieces of its boundary and the grid");
  CLI::App* explain = app.add_subcommand("explain", "Explain a key of problem files");
  explain
      ->add_option(
          "KEY", line.key,
          "A path or its end, as conditions.flux or radius; operations for those of formulas")
      ->required();
  CLI::App* schema = app.add_subcommand("schema", "Print the JSON Schema of problem files");
  CLI::App* fresh = app.add_subcommand("new", "Print a template (not supported yet)");
  fresh->allow_extras();
  for (CLI::App* command : {check, explain, schema}) command->allow_extras();

  std::ranges::reverse(arguments);  // as CLI11 takes them
  try {
    app.parse(arguments);
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream text, ignored;
    app.exit(success, text, ignored);
    return printed(text.str(), 0);
  } catch (const CLI::ParseError& error) {
    return refused(error.what());
  }
  if (app.got_subcommand(fresh)) return refused("'new' is not supported yet");
  if (const std::vector<std::string> extras = app.remaining(true); !extras.empty())
    return refused(unknown_options(extras));
  if (app.got_subcommand(explain)) line.command = CommandLine::Command::explain;
  if (app.got_subcommand(schema)) line.command = CommandLine::Command::schema;
  if (app.got_subcommand(check)) line.command = CommandLine::Command::check;
  const bool needs_files =
      line.command == CommandLine::Command::solve || line.command == CommandLine::Command::check;
  if (needs_files && line.files.empty()) return refused("expected a problem file");
  return line;
}

}  // namespace rfm
