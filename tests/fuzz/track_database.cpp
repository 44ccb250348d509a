// Trajectories in a database, through its pages and through SQLite.

#include <cstring>
#include <string>

#include "engine/tracks/read.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("input.sqlite");
  static constexpr char magic[] = "SQLite format 3";
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.size() >= sizeof(magic)) std::memcpy(bytes.data(), magic, sizeof(magic));  // else it is a text
  file.put(std::as_bytes(std::span(bytes)));
  static_cast<void>(read_trajectories(file.path(), {}));
  static_cast<void>(read_trajectories(file.path(), {.walls = file.path(), .lenient = true}));
  return 0;
}
