// A plug-in's way in: it poses one agent with a library that is linked into it.
#include <cstdint>
#include <memory>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

#if defined(_WIN32)
#define PLUG_IN_API __declspec(dllexport)
#else
#define PLUG_IN_API __attribute__((visibility("default")))
#endif

extern "C" PLUG_IN_API std::uint64_t posed_agent_hash() {
  using namespace throng::anim;
  const auto character = std::make_shared<const Character>(bake_character(synthetic_model(30, 2)));
  const auto created = AnimationSystem::create(character, {.pus = 1});
  if (!created) return 0;
  AnimationSystem& system = **created;
  system.set_agent_count(1);
  system.agent(0).play({.clip = 0});
  const throng::PoseRequest update{.agent = {0}};
  system.advance(throng::ticks_per_second / 60);
  system.update({&update, 1});
  return system.figures().pose_hash();
}
