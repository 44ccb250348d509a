// Crowd files: what is read is written again, and reads as the same; a small character becomes what the file says.

#include "app/show/request/crowd_file.h"

#include <cstdlib>
#include <utility>

#include "engine/anim/asset/synthetic_model.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

namespace throng::fuzz {
namespace {

app::CharacterSource small_character() {
  anim::ImportedFile file;
  file.models.push_back(anim::synthetic_model(5, 3));
  auto made = app::make_character(file, 0, {.path = "small.glb", .name = "small"});
  if (!made) std::abort();
  return std::move(*made);
}

// Names of files may come back in other words.
bool are_same(const app::CrowdSetup& one, const app::CrowdSetup& other) {
  return one.characters.size() == other.characters.size() && one.preset.tuning == other.preset.tuning &&
         one.preset.camera == other.preset.camera && one.camera_name == other.camera_name &&
         one.trajectories.part == other.trajectories.part &&
         one.trajectories.reading.fps == other.trajectories.reading.fps && one.pair == other.pair &&
         one.bookmarks == other.bookmarks;
}

}  // namespace
}  // namespace throng::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("input.throng"), written("written.throng");
  static const app::CharacterSource small = fuzz::small_character();
  file.put(data, size);
  const auto setup = app::read_crowd_file(file.path());
  if (!setup) return 0;
  static_cast<void>(app::entries_of(setup->characters));
  for (const app::ChosenCharacter& wanted : setup->characters) {
    app::CharacterSource character = small;
    static_cast<void>(app::become(wanted, character));
  }
  if (!app::write_crowd_file(written.path(), *setup)) std::abort();
  const auto again = app::read_crowd_file(written.path());
  if (!again || !fuzz::are_same(*setup, *again)) std::abort();
  return 0;
}
