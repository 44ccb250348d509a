#include "tests/anim/agent/crowd_rig.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {
namespace {

std::size_t palette_entries() {
  return static_cast<std::size_t>((test_character()->skeleton.palette_count() + 3) / 4 * 4);
}

}  // namespace

std::shared_ptr<const Character> test_character() {
  static const auto character = std::make_shared<const Character>(bake_character(synthetic_model(40, 5)));
  return character;
}

CrowdRig::CrowdRig(const SystemOptions& options, std::uint32_t agents)
    : palettes(allocate_aligned(agents * palette_entries() * sizeof(PaletteMatrix))) {
  auto created = AnimationSystem::create(test_character(), options);
  EXPECT_TRUE(created.has_value()) << created.error().message;
  system = std::move(*created);
  system->set_agent_count(agents);
}

const PaletteMatrix* CrowdRig::palette(std::uint32_t agent) const {
  return reinterpret_cast<const PaletteMatrix*>(palettes.get()) + agent * palette_entries();
}

void CrowdRig::step(int frames) {
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < system->agent_count(); ++agent) {
    updates.push_back({.agent = {agent}, .palette = memory_of(palette(agent))});
  }
  for (int i = 0; i < frames; ++i) {
    system->advance(frame_ticks);
    system->update(updates);
  }
}

std::vector<glm::vec3> CrowdRig::joints(std::uint32_t agent) const {
  std::vector<glm::vec3> joints;
  for (int bone = 0; bone < test_character()->skeleton.bone_count(); ++bone) {
    const JointPlace place = joint_place(test_character()->skeleton, bone);
    const auto& rows = palette(agent)[place.entry].rows;
    const glm::vec3 at(place.position);
    glm::vec3 joint;
    for (int axis = 0; axis < 3; ++axis) {
      joint[axis] = rows[axis][0] * at.x + rows[axis][1] * at.y + rows[axis][2] * at.z + rows[axis][3];
    }
    joints.push_back(joint);
  }
  return joints;
}

std::vector<int> CrowdRig::bones_unlike(const CrowdRig& other, std::uint32_t agent) const {
  std::vector<int> unlike;
  for (int bone = 0; bone < test_character()->skeleton.bone_count(); ++bone) {
    if (std::memcmp(palette(agent) + bone, other.palette(agent) + bone, sizeof(PaletteMatrix)) != 0) {
      unlike.push_back(bone);
    }
  }
  return unlike;
}

std::size_t CrowdRig::depth(std::uint32_t agent) const {
  const std::vector<PoseStep>& steps = system->agent(agent).program().steps;
  std::array<std::size_t, PoseProgram::max_steps> depths{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    depths[i] = 1;
    for (std::size_t k = 0; k < steps[i].source_count; ++k) {
      depths[i] = std::max(depths[i], depths[steps[i].sources[k]] + 1);
    }
  }
  return steps.empty() ? 0 : depths[steps.size() - 1];
}

bool FixedChannel::update(const EntityBuilder& build) {
  if (!made_.empty()) return false;
  made_ = make_(build);
  return true;
}

void FixedChannel::visit_handles(const std::function<void(Handle&)>& visit) {
  for (Handle& handle : made_) visit(handle);
}

void FixedChannel::destroy_entities(const EntityBuilder& build) {
  for (const Handle handle : made_) build.destroy(handle);
  made_.clear();
}

}  // namespace throng::anim
