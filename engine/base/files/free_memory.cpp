#include "engine/base/files/free_memory.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#if defined(_WIN32)
#include <windows.h>
#else
#include <sys/resource.h>
#endif

#include "engine/base/files/input_file.h"

namespace throng {
namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

/// Reads the number that follows `name` in a file of the system; nothing where there is none, or no limit: "max".
std::optional<std::uint64_t> number_in(const char* file, std::string_view name = "") {
  constexpr std::size_t most_bytes = 1U << 16U;
  const auto text = read_text(file, "a text", most_bytes);
  if (!text) return {};
  const std::size_t at = text->find(name);
  const std::size_t begin = at == std::string::npos ? at : text->find_first_not_of(" \t", at + name.size());
  if (begin == std::string::npos) return {};
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text->data() + begin, text->data() + text->size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

std::optional<std::uint64_t> left_of(std::optional<std::uint64_t> most, std::optional<std::uint64_t> taken) {
  if (!most || !taken) return {};
  return *most - std::min(*most, *taken);
}

std::optional<std::uint64_t> in_bytes(std::optional<std::uint64_t> kibibytes) {
  return kibibytes ? std::optional(*kibibytes * 1024) : std::nullopt;
}

// A container may have less than its machine.
std::optional<std::uint64_t> of_container() {
  return left_of(number_in("/sys/fs/cgroup/memory.max"), number_in("/sys/fs/cgroup/memory.current"));
}

#if defined(_WIN32)
std::optional<std::uint64_t> of_machine() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof(status);
  return GlobalMemoryStatusEx(&status) != 0 ? std::optional<std::uint64_t>(status.ullAvailPhys) : std::nullopt;
}

std::optional<std::uint64_t> limit_of_addresses() { return {}; }
#else
std::optional<std::uint64_t> of_machine() { return in_bytes(number_in("/proc/meminfo", "MemAvailable:")); }

std::optional<std::uint64_t> limit_of_addresses() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  return limit.rlim_cur;
}
#endif

std::optional<std::uint64_t> of_address_space() {
  const auto limit = limit_of_addresses();
  return limit ? left_of(limit, in_bytes(number_in("/proc/self/status", "VmSize:"))) : limit;
}

}  // namespace

std::uint64_t free_memory() {
  return std::min({of_machine().value_or(unknown), of_container().value_or(unknown), free_address_space()});
}

bool address_space_has_a_limit() { return limit_of_addresses().has_value(); }

std::uint64_t free_address_space() { return of_address_space().value_or(unknown); }

}  // namespace throng
