// Models: a .glb or .gltf that is all of the file.

#include "engine/anim/import/import.h"

#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const throng::fuzz::ScratchFile file("input.glb");
  file.put(data, size);
  const auto imported = throng::import::import_skins(file.path(), {.channels = {{"_HAIR", 2}}});
  if (imported && imported->models.empty()) static_cast<void>(throng::import::import_clips(file.path()));
  return 0;
}
