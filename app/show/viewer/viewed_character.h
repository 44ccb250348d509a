#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/source.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::app {

/// Names a pose of a character.
struct ViewedPose {
  int clip = 0;
  double seconds = 0;     ///< in the clip
  int blended = no_clip;  ///< a second clip; no_clip: none
  double blended_seconds = 0;
  float weight = 0;  ///< of the second clip, 0 to 1
  bool bind_pose = false;
  std::uint8_t bone_level = 0;
};

/// The room that a character takes in all of its clips, in model space, in metres: a sphere, and an upright cylinder
/// about the same middle.
struct ViewedRoom {
  glm::vec3 centre{0.0F};
  float radius = 1.0F;                      ///< of the sphere
  float across = 1.0F, half_height = 1.0F;  ///< radius and half the height of the cylinder
};

/// One agent of a character, in an animation system of its own, which gives a pose in each frame.
class ViewedCharacter {
 public:
  /// `source` outlives it. Errors: as AnimationSystem::create().
  static Result<std::unique_ptr<ViewedCharacter>> create(const CharacterSource& source, anim::StreamKind stream);

  void pose(const ViewedPose& wanted);
  /// Returns the room of the points that stand for its surface, at several times of each clip.
  ViewedRoom surroundings();

  /// Returns the palette of the last pose; entries that its bone level lacks are left as they were.
  std::span<const anim::PaletteMatrix> palette() const;
  /// Returns the bytes that a palette of the character takes.
  std::size_t palette_bytes() const {
    return anim::palette_stride(character().level_entries.front(), PaletteFormat::matrices);
  }
  /// Returns where a joint is in the last pose, in model space; nothing for a bone that no skin uses, or that the bone
  /// level lacks.
  std::optional<glm::vec3> joint(int bone) const;
  /// Adds the weights of morphs of the last pose. Returns whether there are any.
  bool add_morph_weights(std::span<float> weights) const;

  const anim::Character& character() const { return *source_->character; }
  const CharacterSource& source() const { return *source_; }

 private:
  explicit ViewedCharacter(const CharacterSource& source);
  std::vector<glm::vec3> surface_at_many_times();
  void add_surface(std::vector<glm::vec3>& points) const;

  const CharacterSource* source_;
  std::unique_ptr<anim::AnimationSystem> system_;
  AgentId agent_;
  anim::AlignedBytes palette_;
  std::vector<anim::PaletteMatrix> bind_;  // the palette of the bind pose
  std::vector<anim::JointPlace> joints_;   // [bone]
  std::size_t entries_ = 0;                // of the last pose
  bool shows_bind_ = false;
};

}  // namespace throng::app
