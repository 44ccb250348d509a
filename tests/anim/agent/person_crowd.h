#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/character_rigs.h"
#include "engine/anim/kernel/limb/joint_chain.h"

namespace throng::anim {

/// Returns a person of 1.75 m with two clips of a second: 0 marches on the spot, 1 stands and sways. The bone levels
/// are all bones, trunk and head, and hips alone.
const Model& marching_person();
const CharacterRigs& person_rigs();
std::shared_ptr<const Character> person();

inline constexpr Ticks frame_at_60_hz = ticks_per_second / 60;

/// A crowd of people that march, each at another place of the clip.
class PersonCrowd {
 public:
  explicit PersonCrowd(const SystemOptions& options = {}, std::uint32_t agents = 1);

  AnimationSystem& system() { return *system_; }
  const RigKinds& kinds() const { return kinds_; }

  /// Makes frames at 60 Hz in which all are posed.
  void step(int frames = 1, std::uint8_t level = 0);

  // Only the schedule `levels` keeps poses.
  PoseView pose(std::uint32_t agent = 0) const;
  JointMotion joint(std::string_view bone, std::uint32_t agent = 0) const;
  /// Returns the model-space origins of all bones.
  std::vector<glm::dvec3> joints(std::uint32_t agent = 0) const;

 private:
  std::unique_ptr<AnimationSystem> system_;
  RigKinds kinds_;
};

/// Returns options of every schedule with 1 and 3 PUs and tiles of 1, 4 and 16.
std::vector<SystemOptions> many_options();

}  // namespace throng::anim
