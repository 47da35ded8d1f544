#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>

#include "core/error.hpp"
#include "core/freed_memory.hpp"
#include "problems/check.hpp"
#include "problems/command_line.hpp"
#include "problems/mistakes.hpp"
#include "problems/result_folder.hpp"
#include "problems/run.hpp"
#include "problems/schema_text.hpp"
#include "solvers/blas_threads.hpp"

namespace {

enum ExitStatus { solved = 0, expectation_missed = 1, wrong_input = 2, computation_failed = 3 };

// Calls `action`; what it throws becomes a message and an exit status.
template <class Action>
int guarded(const Action& action) {
  try {
    return action();
  } catch (const rfm::ProblemFileErrors& errors) {
    std::fprintf(stderr, "%s\n", errors.what());
    return wrong_input;
  } catch (const rfm::InputError& error) {
    std::fprintf(stderr, "rfm-solve: %s\n", error.what());
    return wrong_input;
  } catch (const rfm::InvalidArgument& error) {
    std::fprintf(stderr, "rfm-solve: %s\n", error.what());
    return wrong_input;
  } catch (const rfm::Error& error) {
    std::fprintf(stderr, "rfm-solve: the computation failed: %s\n", error.what());
    return computation_failed;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "rfm-solve: the computation failed: it needs more memory than there is\n");
    return computation_failed;
  } catch (const std::length_error&) {
    std::fprintf(stderr, "rfm-solve: the computation failed: the grid is larger than memory\n");
    return computation_failed;
  } catch (const std::exception& error) {  // of a library
    std::fprintf(stderr, "rfm-solve: the computation failed: %s\n", error.what());
    return computation_failed;
  }
}

std::string result_folder(const rfm::CommandLine& command, const std::string& file) {
  const std::string name = std::filesystem::path(file).stem().string();
  if (!command.output) return "results/" + name;
  return command.files.size() == 1 ? *command.output : *command.output + "/" + name;
}

// Says so if two files would write to one folder.
bool have_folders_of_their_own(const rfm::CommandLine& command) {
  std::set<std::string> folders;
  for (const std::string& file : command.files)
    if (!folders.insert(result_folder(command, file)).second) {
      std::fprintf(stderr, "rfm-solve: two files would write to %s\n",
                   result_folder(command, file).c_str());
      return false;
    }
  return true;
}

int solve_all(const rfm::CommandLine& command) {
  rfm::clean_up_on_interrupt();
  if (!have_folders_of_their_own(command)) return wrong_input;
  int status = solved;
  for (const std::string& file : command.files) {
    rfm::RunOptions options;
    options.overrides = command.overrides;
    options.output = result_folder(command, file);
    options.verify = command.verify;
    options.converge = command.converge;
    options.picture = command.picture;
    options.json = command.json;
    options.quiet = command.quiet;
    status = std::max(status, guarded([&] { return rfm::run_problem(file, options); }));
  }
  return status;
}

int check_all(const rfm::CommandLine& command) {
  rfm::clean_up_on_interrupt();
  if (command.picture && !have_folders_of_their_own(command)) return wrong_input;
  int status = solved;
  for (const std::string& file : command.files)
    status = std::max(status, guarded([&] {
                        return rfm::check_problem(file, {command.overrides, command.picture,
                                                         result_folder(command, file)});
                      }));
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  rfm::keep_freed_memory();
  rfm::use_one_thread_in_blas();
  const rfm::CommandLine command = rfm::parse_command_line({argv + 1, argv + argc});
  std::optional<tbb::global_control> threads;
  if (command.threads)
    threads.emplace(tbb::global_control::max_allowed_parallelism, *command.threads);
  switch (command.command) {
    case rfm::CommandLine::Command::solve:
      return solve_all(command);
    case rfm::CommandLine::Command::check:
      return check_all(command);
    case rfm::CommandLine::Command::explain:
      return guarded([&] {
        std::puts(rfm::explain_key(command.key).c_str());
        return 0;
      });
    case rfm::CommandLine::Command::schema:
      std::puts(rfm::json_schema_text().c_str());
      return solved;
    case rfm::CommandLine::Command::print:
      std::fputs(command.text.c_str(), command.exit_status == 0 ? stdout : stderr);
      return command.exit_status;
  }
  return solved;
}
