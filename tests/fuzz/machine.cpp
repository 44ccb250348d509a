// State machines: the text, and the machine that a character with clips "clip_0" to "clip_2" makes of it.

#include <string_view>

#include "engine/anim/agent/channel/state_machine.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/import/machine/machine_file.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const throng::anim::Character character = throng::anim::bake_character(throng::anim::synthetic_model(5, 3, 1));
  const auto read = throng::import::read_machine({reinterpret_cast<const char*>(data), size});
  if (read) static_cast<void>(throng::anim::StateMachine::create(*read, character));
  return 0;
}
