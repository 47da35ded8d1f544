#include "problems/result_folder.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace rfm {
namespace {

// Names of temporary files where a signal handler can reach them: it may neither allocate nor lock.
constexpr std::size_t longest_name = 4096;
struct Slot {
  std::atomic<bool> used{false};
  std::array<char, longest_name> name{};
};
std::array<Slot, 64> slots;

void register_temporary(const std::string& name) {
  if (name.size() + 1 > longest_name) return;
  for (Slot& slot : slots) {
    if (slot.used.load()) continue;
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.used.store(true);
    return;
  }
}

void forget_temporary(const std::string& name) {
  for (Slot& slot : slots)
    if (slot.used.load() && name == slot.name.data()) slot.used.store(false);
}

extern "C" void remove_and_end(int signal) {
  for (Slot& slot : slots)
    if (slot.used.load()) ::unlink(slot.name.data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::string temporary_name(const std::string& folder, const std::string& name) {
  // The ending stays, for writers that look at it.
  return folder + "/.partial-" + std::to_string(::getpid()) + "-" + name;
}

}  // namespace

ResultFolder::ResultFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error || !std::filesystem::is_directory(path_))
    throw ComputationError("cannot make the folder " + path_ +
                           (error ? " (" + error.message() + ")" : ""));
}

ResultFolder::~ResultFolder() {
  for (const std::string& name : names_) {
    const std::string temporary = temporary_name(path_, name);
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    forget_temporary(temporary);
  }
}

void ResultFolder::write(const std::string& name,
                         const std::function<void(const std::string&)>& writer) {
  const std::string temporary = temporary_name(path_, name);
  register_temporary(temporary);
  names_.push_back(name);
  writer(temporary);
}

void ResultFolder::write_text(const std::string& name, const std::string& text) {
  write(name, [&](const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw ComputationError("cannot write " + path_ + "/" + name);
  });
}

void ResultFolder::commit() {
  for (const std::string& name : names_) {
    const std::string temporary = temporary_name(path_, name);
    std::error_code error;
    std::filesystem::rename(temporary, path_ + "/" + name, error);
    if (error) throw ComputationError("cannot write " + path_ + "/" + name);
    forget_temporary(temporary);
  }
  names_.clear();
}

void require_writable(const std::string& path) {
  std::error_code ignored;
  std::filesystem::path existing = std::filesystem::absolute(path, ignored);
  while (!std::filesystem::exists(existing, ignored) && existing.has_parent_path() &&
         existing != existing.parent_path())
    existing = existing.parent_path();
  if (!std::filesystem::is_directory(existing, ignored) || ::access(existing.c_str(), W_OK) != 0)
    throw ComputationError("cannot write results in " + path);
}

void clean_up_on_interrupt() {
  std::signal(SIGINT, remove_and_end);
  std::signal(SIGTERM, remove_and_end);
}

}  // namespace rfm
