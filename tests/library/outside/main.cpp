#include <cstdio>
#include <memory>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

using namespace throng::anim;

int main() {
  const auto character = std::make_shared<const Character>(bake_character(synthetic_model(30, 2)));
  const auto system = AnimationSystem::create(character, {.pus = 2});
  if (!system) return std::fprintf(stderr, "%s\n", system.error().message.c_str()), 1;
  (*system)->set_agent_count(1);
  (*system)->agent(0).play({.clip = 1});

  const AgentUpdate update{.agent = {0}};
  (*system)->advance(ticks_per_second / 60);
  (*system)->update({&update, 1});
  std::printf("pose hash %016llx\n", static_cast<unsigned long long>((*system)->figures().pose_hash()));
}
