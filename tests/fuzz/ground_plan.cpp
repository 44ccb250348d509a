// Walls and floors: Well-Known Text and scenarios of Vadere.

#include "engine/tracks/file_plan.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("input.wkt");
  file.put(data, size);
  static_cast<void>(read_ground_plan(file.path(), {1.0, 2.0}));
  return 0;
}
