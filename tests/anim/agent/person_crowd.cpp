#include "tests/anim/agent/person_crowd.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/kernel/ragdoll/ragdoll_stage.h"

namespace throng::anim {
namespace {

constexpr int keys = 31;

/// Turns of bones about an axis, as functions of the phase, 0 to 1.
using Turns = std::map<std::string, std::pair<glm::vec3, float (*)(float)>>;

float wave(float phase) { return std::sin(2.0F * std::numbers::pi_v<float> * phase); }

/// Of a foot: in the air for half of the time.
float lift(float phase) { return std::max(0.0F, wave(phase)); }

Clip clip_of(const Skeleton& skeleton, const std::string& name, const Turns& turns) {
  Clip clip;
  clip.name = name;
  clip.duration = 1.0;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const auto turn = turns.find(skeleton.bones[static_cast<std::size_t>(bone)].name);
    if (turn == turns.end()) continue;
    BoneTracks tracks;
    tracks.bone = bone;
    for (int key = 0; key < keys; ++key) {
      const float phase = static_cast<float>(key) / static_cast<float>(keys - 1);
      tracks.rotation.times.push_back(phase);
      tracks.rotation.values.push_back(
          glm::angleAxis(turn->second.second(key == keys - 1 ? 0.0F : phase), turn->second.first));
    }
    clip.tracks.push_back(tracks);
  }
  return clip;
}

constexpr glm::vec3 across{1.0F, 0.0F, 0.0F};
constexpr glm::vec3 upright{0.0F, 1.0F, 0.0F};

Clip march(const Skeleton& skeleton) {
  return clip_of(skeleton, "march",
                 {{"thigh.L", {across, [](float phase) { return -0.8F * lift(phase); }}},
                  {"shin.L", {across, [](float phase) { return 1.1F * lift(phase); }}},
                  {"thigh.R", {across, [](float phase) { return -0.8F * lift(phase + 0.5F); }}},
                  {"shin.R", {across, [](float phase) { return 1.1F * lift(phase + 0.5F); }}},
                  {"upper_arm.L", {across, [](float phase) { return 0.5F * wave(phase); }}},
                  {"upper_arm.R", {across, [](float phase) { return -0.5F * wave(phase); }}},
                  {"middle.1.L", {across, [](float phase) { return 0.6F * wave(phase); }}},
                  {"spine", {upright, [](float phase) { return 0.1F * wave(phase); }}}});
}

Clip sway(const Skeleton& skeleton) {
  return clip_of(skeleton, "sway",
                 {{"spine", {upright, [](float phase) { return 0.3F * wave(phase); }}},
                  {"head", {across, [](float phase) { return 0.2F * wave(phase); }}}});
}

}  // namespace

const Model& marching_person() {
  static const Model model = [] {
    Model made = ragdoll_stage::person();
    made.skeleton.name = "person";
    made.skeleton.level_bone_counts = {made.skeleton.bone_count(), find_bone(made.skeleton, "head") + 1, 2};
    made.clips = {march(made.skeleton), sway(made.skeleton)};
    return made;
  }();
  return model;
}

const CharacterRigs& person_rigs() {
  static const CharacterRigs rigs(marching_person());
  return rigs;
}

std::shared_ptr<const Character> person() {
  static const auto character = std::make_shared<const Character>(bake_character(marching_person()));
  return character;
}

PersonCrowd::PersonCrowd(const SystemOptions& options, std::uint32_t agents)
    : system_(std::move(*AnimationSystem::create(person(), options))), kinds_(person_rigs().add_to(*system_)) {
  system_->set_agent_count(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    system_->agent(agent).play({.clip = 0, .start = to_ticks(0.07 * (agent % 13))});
  }
}

void PersonCrowd::step(int frames, std::uint8_t level) {
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < system_->agent_count(); ++agent) {
    updates.push_back({.agent = {agent}, .level = level});
  }
  for (int frame = 0; frame < frames; ++frame) {
    system_->advance(frame_at_60_hz);
    system_->update(updates);
  }
}

PoseView PersonCrowd::pose(std::uint32_t agent) const {
  return {const_cast<float*>(system_->agent(agent).pose().data()), rigid_components * packet_bones, rigid_components,
          marching_person().skeleton.bone_count()};
}

JointMotion PersonCrowd::joint(std::string_view bone, std::uint32_t agent) const {
  return joint_by_definition(marching_person().skeleton, pose(agent), bone);
}

std::vector<glm::dvec3> PersonCrowd::joints(std::uint32_t agent) const {
  return ragdoll_stage::bone_origins(marching_person().skeleton, pose(agent));
}

std::vector<SystemOptions> many_options() {
  std::vector<SystemOptions> all;
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const int pus : {1, 3}) {
      for (const int tile : {0, 1, 4, 16}) {
        all.push_back({.pus = pus, .local_store_bytes = 1024UL * 1024UL, .tile = tile, .schedule = schedule});
      }
    }
  }
  return all;
}

}  // namespace throng::anim
