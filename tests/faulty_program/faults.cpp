#include "tests/faulty_program/faults.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

extern "C" {
// The linker gives these names: --wrap=main calls ours, and ours the real one.
// NOLINTBEGIN(bugprone-reserved-identifier)
int __real_main(int argument_count, char** arguments);
int __wrap_main(int argument_count, char** arguments);
int __real_open(const char* path, int flags, ...);
ssize_t __real_write(int descriptor, const void* bytes, size_t count);
// NOLINTEND(bugprone-reserved-identifier)
}

namespace throng::test {
namespace {

std::array<std::atomic<std::uint64_t>, call_kinds> counts{};
std::atomic<bool> counting{false};
std::size_t failing_kind = call_kinds;  // none
std::uint64_t first_to_fail = 0;
bool all_that_follow = false;

void read_plan() {
  const char* const plan = std::getenv("THRONG_FAULT");
  const char* const colon = plan == nullptr ? nullptr : std::strchr(plan, ':');
  if (colon == nullptr) return;
  for (std::size_t kind = 0; kind < call_kinds; ++kind) {
    const std::size_t length = std::strlen(call_names[kind]);
    if (static_cast<std::size_t>(colon - plan) == length && std::strncmp(plan, call_names[kind], length) == 0) {
      failing_kind = kind;
    }
  }
  char* end = nullptr;
  first_to_fail = std::strtoull(colon + 1, &end, 10);
  all_that_follow = *end == '+';
}

void write_counts() {
  counting = false;
  const char* const file = std::getenv("THRONG_FAULT_COUNTS");
  const int descriptor = file == nullptr ? -1 : __real_open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (descriptor < 0) return;
  for (std::size_t kind = 0; kind < call_kinds; ++kind) {
    std::array<char, 64> line{};
    const int length = std::snprintf(line.data(), line.size(), "%s %llu\n", call_names[kind],
                                     static_cast<unsigned long long>(counts.at(kind).load()));
    static_cast<void>(__real_write(descriptor, line.data(), static_cast<std::size_t>(length)));
  }
  close(descriptor);
}

}  // namespace

bool must_fail(Call kind) {
  if (!counting.load(std::memory_order_relaxed)) return false;
  const auto index = static_cast<std::size_t>(kind);
  const std::uint64_t number = counts[index].fetch_add(1, std::memory_order_relaxed) + 1;
  if (index != failing_kind) return false;
  return number == first_to_fail || (all_that_follow && number > first_to_fail);
}

}  // namespace throng::test

// NOLINTNEXTLINE(bugprone-reserved-identifier)
int __wrap_main(int argument_count, char** arguments) {
  throng::test::read_plan();
  throng::test::counting = true;
  const int status = __real_main(argument_count, arguments);
  throng::test::write_counts();
  return status;
}
