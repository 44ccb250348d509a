#include "tests/soak/process_figures.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include <malloc.h>
#include <unistd.h>

namespace throng::soak {
namespace {

namespace fs = std::filesystem;

int entries_of(const fs::path& folder) {
  std::error_code error;
  int count = 0;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) ++count;
  return count;
}

double seconds_computed(const fs::path& folder) {
  std::ifstream stat(folder / "stat");
  std::string text;
  std::getline(stat, text);
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream rest(text.substr(name_end + 1));
  std::string skipped;
  for (int field = 0; field < 11; ++field) rest >> skipped;
  double user = 0, system = 0;
  rest >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

ProcessFigures figures_of(pid_t process) {
  const fs::path folder = fs::path("/proc") / std::to_string(process);
  ProcessFigures figures;
  std::ifstream status(folder / "status");
  for (std::string word; status >> word;) {
    if (word == "VmRSS:" && status >> figures.resident) figures.resident *= 1024;
    if (word == "Threads:") status >> figures.threads;
  }
  figures.descriptors = entries_of(folder / "fd");
  figures.computed = seconds_computed(folder);
  return figures;
}

std::uint64_t heap_in_use() {
  malloc_trim(0);
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace throng::soak
