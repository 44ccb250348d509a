#include "tests/import/memory/import_apart.h"

#include <array>
#include <cstdlib>
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

namespace throng::import::testing {
namespace {

/// Returns a number of /proc/self/status, in bytes.
std::uint64_t status_of_process(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key)) return std::strtoull(line.c_str() + key.size() + 1, nullptr, 10) * 1024;
  }
  return 0;
}

/// The first line is the peak, the rest the message.
std::string told_import(const std::filesystem::path& file, const ImportOptions& options) {
  const std::uint64_t before = status_of_process("VmRSS");
  const auto imported = import_file(file.string(), options);
  const std::uint64_t peak = status_of_process("VmHWM");
  return std::to_string(peak - before) + "\n" + (imported ? "" : imported.error().message);
}

}  // namespace

ImportApart import_apart(const std::filesystem::path& file, const ImportOptions& options) {
  std::array<int, 2> pipe_ends{};
  if (pipe(pipe_ends.data()) != 0) return {.message = "there is no pipe", .peak = 0};
  const pid_t child = fork();
  if (child == 0) {
    const std::string told = told_import(file, options);
    const bool is_whole = write(pipe_ends[1], told.data(), told.size()) == static_cast<ssize_t>(told.size());
    _exit(is_whole ? 0 : 1);
  }
  close(pipe_ends[1]);
  std::string told;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; (count = read(pipe_ends[0], part.data(), part.size())) > 0;) {
    told.append(part.data(), static_cast<std::size_t>(count));
  }
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  const std::size_t line = told.find('\n');
  if (status != 0 || line == std::string::npos) return {.message = "the process died", .peak = 0};
  return {.message = told.substr(line + 1), .peak = std::strtoull(told.c_str(), nullptr, 10)};
}

}  // namespace throng::import::testing
