// A program that links nothing but throng::anim: what its headers and its target need, they bring along.
#include <cstdint>
#include <cstdio>
#include <memory>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/lod/lod.h"

using namespace throng;

int main() {
  const auto character = std::make_shared<const anim::Character>(anim::bake_character(anim::synthetic_model(30, 2)));
  const auto created = anim::AnimationSystem::create(character, {.pus = 2});
  if (!created) return std::fprintf(stderr, "%s\n", created.error().message.c_str()), 1;
  anim::AnimationSystem& system = **created;
  system.set_agent_count(1);
  system.agent(0).play({.clip = 0});

  anim::LodState state;
  anim::LodSelection selection;
  state.resize(1, selection);
  const glm::vec3 position(0.0F);
  const float scale = 1.0F;
  anim::LodFrame frame;
  frame.rules.rule = LodRule::distance;
  frame.positions = {&position, 1};
  frame.scales = {&scale, 1};
  anim::select_for_update(frame, state, selection);
  if (selection.due.size() != 1) return 1;

  const PoseRequest update{.agent = {selection.due[0]}};
  system.advance(ticks_per_second / 60);
  system.update({&update, 1});
  std::printf("pose hash %016llx\n", static_cast<unsigned long long>(system.figures().pose_hash()));
}
