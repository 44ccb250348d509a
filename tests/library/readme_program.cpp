#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/import/import.h"

using namespace throng;

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return 2;
  const auto file = import::import_file(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const auto character = std::make_shared<const anim::Character>(anim::bake_character(file->models.front()));

  auto created = anim::AnimationSystem::create(character, {.pus = 2});
  if (!created) return std::fprintf(stderr, "%s\n", created.error().message.c_str()), 1;
  anim::AnimationSystem& system = **created;

  constexpr std::uint32_t agents = 1000;
  system.set_agent_count(agents);
  const int clips = static_cast<int>(character->clips.size());
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    system.play(agent, {.clip = static_cast<int>(agent) % clips});
  }
  system.play(0, {.clip = clips - 1, .fade = anim::to_ticks(0.25)});  // eases in over a quarter of a second

  // A palette an agent, each on cache lines of its own, as far apart as they are written fastest.
  const auto entries = static_cast<std::size_t>(character->skeleton.palette_count());
  const std::size_t stride = anim::palette_stride(entries, anim::PaletteFormat::matrices);
  const anim::AlignedBytes palettes = anim::allocate_aligned(agents * stride);
  std::vector<anim::AgentUpdate> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    updates.push_back({.agent = agent, .palette = anim::PaletteDestination(palettes.get() + agent * stride)});
  }

  for (int frame = 0; frame < 60; ++frame) {
    system.advance(anim::ticks_per_second / 60);
    system.update(updates);  // returns when every palette is written
  }
  std::printf("pose hash %016llx\n", static_cast<unsigned long long>(system.pose_hash()));
}
