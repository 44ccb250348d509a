#include "tests/soak/process_figures.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include <malloc.h>

namespace throng::soak {
namespace {

namespace fs = std::filesystem;

int entries_of(const fs::path& folder) {
  std::error_code error;
  int count = 0;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) ++count;
  return count;
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
  return figures;
}

std::uint64_t heap_in_use() {
  malloc_trim(0);
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace throng::soak
