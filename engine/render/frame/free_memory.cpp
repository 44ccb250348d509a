#include "engine/render/frame/free_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace throng::render {
namespace {

/// Reads the number at the beginning of a file, or none where there is no file or no limit: "max".
std::optional<std::uint64_t> number_in(const char* file) {
  std::ifstream stream(file);
  std::uint64_t number = 0;
  if (!(stream >> number)) return std::nullopt;
  return number;
}

std::optional<std::uint64_t> of_machine() {
  std::ifstream stream("/proc/meminfo");
  std::string name, unit;
  for (std::uint64_t kibibytes = 0; stream >> name >> kibibytes; std::getline(stream, unit)) {
    if (name == "MemAvailable:") return kibibytes * 1024;
  }
  return std::nullopt;
}

// A container may have less than its machine.
std::optional<std::uint64_t> of_container() {
  const auto most = number_in("/sys/fs/cgroup/memory.max"), taken = number_in("/sys/fs/cgroup/memory.current");
  if (!most || !taken) return std::nullopt;
  return *most - std::min(*most, *taken);
}

}  // namespace

std::uint64_t free_memory() {
  constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();
  return std::min(of_machine().value_or(unknown), of_container().value_or(unknown));
}

}  // namespace throng::render
