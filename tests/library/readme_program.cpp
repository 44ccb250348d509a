#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/import/import.h"
#include "engine/anim/lod/level_of_detail.h"

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
    system.agent(agent).play({.clip = static_cast<int>(agent) % clips});
  }
  system.agent(0).play({.clip = clips - 1, .fade = anim::to_ticks(0.25)});  // eases in over a quarter of a second

  // A palette an agent, each on cache lines of its own, as far apart as they are written fastest.
  const auto entries = static_cast<std::size_t>(character->skeleton.palette_count());
  const std::size_t stride = anim::palette_stride(entries, anim::PaletteFormat::matrices);
  const anim::AlignedBytes palettes = anim::allocate_aligned(agents * stride);

  // They stand in a row that leads away from the camera: those far off are posed more seldom, with fewer bones.
  std::vector<glm::vec3> positions(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) positions[agent].z = -0.1F * static_cast<float>(agent);
  const std::vector<float> scales(agents, 1.0F);
  anim::LevelOfDetail lod;
  lod.set_characters({anim::lod_character(*character)});
  lod.reset(agents, {});
  anim::LodRequest request;      // has the camera, the rules and the budget
  request.rules.smooth = false;  // nothing here blends from pose to pose
  request.frame_step = anim::ticks_per_second / 60;

  for (int frame = 0; frame < 60; ++frame) {
    system.advance(request.frame_step);
    request.now = system.clock();
    lod.select({.positions = positions, .scales = scales}, request, system.executor(), 2);
    for (anim::AgentUpdate& update : lod.updates()) {
      update.palette = anim::PaletteDestination(palettes.get() + update.agent.number * stride);
    }
    system.update(lod.updates());  // returns when every palette is written
    lod.settle(system.figures().report().predicted_nanoseconds);
  }
  std::printf("pose hash %016llx\n", static_cast<unsigned long long>(system.figures().pose_hash()));
}
